//! The sampling disk on the rectangle: its radius, and how much of it the rectangle covers.

use crate::constants::{HALF_PI, PI};
use crate::rect::angle::circle_segment;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::RectGlossy;
use lobe_codegen::prelude::*;

/// Radius of the sampling disk.
///
/// `r_d = min(f m d, √(4 hx hy/π))`
/// Source: our own; [RectGlossy] leaves the radius to the user.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `factor` | `f`: 3 is a good choice | 0.1 ..= 10 | 1 |
/// | `alpha` | GGX alpha `m` of the rectangle | 0.001 ..= 1 | 1 |
/// | `dist` | from the shaded position to the peak, `d` | 1e-3 ..= 1e4 | m |
/// | `half_x`, `half_y` | half the rectangle's sides | 1e-3 ..= 100 | m |
///
/// Returns the radius in m: that of the lobe's foot, but no larger disk than the rectangle has area.
///
/// Without that limit rectangles that are small against the lobe come out at 0.08 to 0.26 of the integral, with it
/// at 0.91 to 1.05. The geometric mean of the error factor is 1.32 for 3 and 4, 1.48 for 2 and 1.52 for 8.
#[kernel(
    family = "rect",
    cite = "our own",
    domain(
        factor = 0.1..=10.0, alpha = 0.001..=1.0, dist = 1e-3..=1e4, half_x = 1e-3..=100.0, half_y = 1e-3..=100.0
    ),
    budget(2e-6 * result),
    measured
)]
pub fn rect_disk_radius(factor: f32, alpha: f32, dist: f32, half_x: f32, half_y: f32) -> f32 {
    min(factor * alpha * dist, sqrt(half_x * half_y * (2.0 / HALF_PI)))
}

/// Area of the unit disk beyond a corner of the first quadrant.
///
/// What lies right of `x` and above `y`: a right triangle with the legs `√(1 - y²) - x` and `√(1 - x²) - y`, and the
/// segment of the circle over its third side.
/// Source: elementary.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `x`, `y` | the corner | 0 ..= 1 | 1 |
///
/// Returns the area, in 0 ..= π/4; 0 for a corner outside the disk.
///
/// Numerics: two parts that are not negative. Where the root makes one leg uncertain, the other one is small.
#[kernel(family = "rect", cite = "elementary", domain(x = 0.0..=1.0, y = 0.0..=1.0), budget(2e-6), measured)]
pub fn disk_corner(x: f32, y: f32) -> f32 {
    let across = max(sqrt(max((1.0 - y) * (1.0 + y), 0.0)) - x, 0.0);
    let along = max(sqrt(max((1.0 - x) * (1.0 + x), 0.0)) - y, 0.0);
    0.5 * across * along + circle_segment(min(across * across + along * along, 2.0))
}

/// Area of the unit disk within the rectangle between the origin and a corner of the first quadrant.
///
/// The product for a corner in the disk; otherwise a quarter of the disk without what is beyond the two sides.
/// Source: elementary, by [`disk_corner`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `x`, `y` | the corner | 0 ..= 1 | 1 |
///
/// Returns the area, in 0 ..= π/4.
#[kernel(family = "rect", cite = "elementary", domain(x = 0.0..=1.0, y = 0.0..=1.0), budget(3e-6), measured)]
pub fn disk_block(x: f32, y: f32) -> f32 {
    let part = 0.5 * HALF_PI - disk_corner(x, 0.0) - disk_corner(0.0, y);
    select(part, x * y, x * x + y * y <= 1.0)
}

/// Area of a disk within a rectangle.
///
/// `S_I`, out of the blocks between the middle of the disk and the corners of the rectangle.
/// Source: [RectGlossy] eq. 36, exact.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `half_x`, `half_y` | half the rectangle's sides | 1e-3 ..= 100 | m |
/// | `center_x`, `center_y` | middle of the disk, seen from the middle of the rectangle | -1e4 ..= 1e4 | m |
/// | `radius` | of the disk | 1e-3 ..= 1e4 | m |
///
/// Returns the area in m², in 0 ..= π r².
///
/// Numerics: it errs by a few 1e-6 of `r²`, and by no more than a rectangle has that is small against the disk. The
/// area of a rectangle inside the disk is taken as it is.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 36",
    domain(
        half_x = 1e-3..=100.0, half_y = 1e-3..=100.0, center_x = -1e4..=1e4, center_y = -1e4..=1e4,
        radius = 1e-3..=1e4
    ),
    budget(1e-6 * result + min(8e-6 * radius * radius, 4.00001 * min(half_x, radius) * min(half_y, radius))),
    measured
)]
pub fn rect_disk_area(half_x: f32, half_y: f32, center_x: f32, center_y: f32, radius: f32) -> f32 {
    let scale = 1.0 / max(radius, 1e-12);
    let x0 = clamp((-half_x - center_x) * scale, -1.0, 1.0);
    let x1 = clamp((half_x - center_x) * scale, -1.0, 1.0);
    let y0 = clamp((-half_y - center_y) * scale, -1.0, 1.0);
    let y1 = clamp((half_y - center_y) * scale, -1.0, 1.0);
    let left = sign(x0) * (sign(y1) * disk_block(abs(x0), abs(y1)) - sign(y0) * disk_block(abs(x0), abs(y0)));
    let right =
        sign(x1) * (sign(y1) * disk_block(abs(x1), abs(y1)) - sign(y0) * disk_block(abs(x1), abs(y0)));
    let whole = clamp(x1 - x0, 0.0, 2.0 * half_x * scale) * clamp(y1 - y0, 0.0, 2.0 * half_y * scale);
    let part = clamp(right - left, 0.0, whole);
    let far_x = (abs(center_x) + half_x) * scale;
    let far_y = (abs(center_y) + half_y) * scale;
    select(radius * radius * part, 4.0 * (half_x * half_y), far_x * far_x + far_y * far_y <= 1.0)
}

/// Area of the rectangle around the part of a disk that lies within a rectangle.
///
/// `S_J`. Source: [RectGlossy] eq. 36 and its figure 6. Arguments and domain as of [`rect_disk_area`].
///
/// Returns the area in m², in 0 ..= 4 r², at least that of [`rect_disk_area`]: up to `4/π` of it for a disk inside.
///
/// Numerics: where disk and rectangle do not meet, one of the extents comes out negative and is taken for 0, without
/// a case of its own.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 36",
    domain(
        half_x = 1e-3..=100.0, half_y = 1e-3..=100.0, center_x = -1e4..=1e4, center_y = -1e4..=1e4,
        radius = 1e-3..=1e4
    ),
    budget(
        4e-6 * ((min(abs(center_x), half_x + radius) + min(half_x, radius)) * min(half_y, radius)
            + (min(abs(center_y), half_y + radius) + min(half_y, radius)) * min(half_x, radius))
    ),
    measured
)]
pub fn rect_disk_bounds(half_x: f32, half_y: f32, center_x: f32, center_y: f32, radius: f32) -> f32 {
    let gap_x = max(abs(center_x) - half_x, 0.0);
    let gap_y = max(abs(center_y) - half_y, 0.0);
    let reach_x = sqrt(max((radius - gap_y) * (radius + gap_y), 0.0));
    let reach_y = sqrt(max((radius - gap_x) * (radius + gap_x), 0.0));
    // From the middle of the disk to either side.
    let width = min(half_x - center_x, reach_x) + min(half_x + center_x, reach_x);
    let height = min(half_y - center_y, reach_y) + min(half_y + center_y, reach_y);
    max(width, 0.0) * max(height, 0.0)
}

/// Share of a disk that a rectangle covers.
///
/// `A = S_I/(π r²)`. Source: [RectGlossy] eq. 36, exact, by [`rect_disk_area`]; arguments and domain as there.
///
/// Returns the share, in 0 ..= 1.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 36",
    domain(
        half_x = 1e-3..=100.0, half_y = 1e-3..=100.0, center_x = -1e4..=1e4, center_y = -1e4..=1e4,
        radius = 1e-3..=1e4
    ),
    budget(2e-6 * result + min(3e-6, 1.3 * (min(half_x, radius) / radius) * (min(half_y, radius) / radius))),
    measured
)]
pub fn rect_coverage(half_x: f32, half_y: f32, center_x: f32, center_y: f32, radius: f32) -> f32 {
    let area = rect_disk_area(half_x, half_y, center_x, center_y, radius);
    min(area / (PI * max(radius * radius, 1e-24)), 1.0)
}

/// Share of a disk that a rectangle covers, by the rectangle around what they share.
///
/// `A ≈ min(S_J/(π r²), 1)`
/// Source: [RectGlossy] eq. 36, limited to the whole disk, by [`rect_disk_bounds`]; arguments and domain as there.
///
/// Returns the share, in 0 ..= 1. Over the 200 pairs of the oracle's table the root of its mean squared error is 0.048,
/// that of [`rect_coverage_paper`] 0.123.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 36",
    domain(
        half_x = 1e-3..=100.0, half_y = 1e-3..=100.0, center_x = -1e4..=1e4, center_y = -1e4..=1e4,
        radius = 1e-3..=1e4
    ),
    budget(
        2e-6 * result + 2e-6 * (min(half_x, radius) + min(half_y, radius)) / radius
            + 1.5e-6 * (min(abs(center_x), half_x + radius) / radius * (min(half_y, radius) / radius)
                + min(abs(center_y), half_y + radius) / radius * (min(half_x, radius) / radius))
    ),
    variant_of = rect_coverage,
    measured
)]
pub fn rect_coverage_bounds(half_x: f32, half_y: f32, center_x: f32, center_y: f32, radius: f32) -> f32 {
    min(rect_coverage_paper(half_x, half_y, center_x, center_y, radius), 1.0)
}

/// Share of a disk that a rectangle covers, as printed.
///
/// `A ≈ S_J/(π r²)`. Source: [RectGlossy] eq. 36. Arguments and domain as of [`rect_coverage_bounds`].
///
/// Returns the share, in 0 ..= 4/π: above 1 for a disk inside the rectangle.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 36",
    domain(
        half_x = 1e-3..=100.0, half_y = 1e-3..=100.0, center_x = -1e4..=1e4, center_y = -1e4..=1e4,
        radius = 1e-3..=1e4
    ),
    budget(
        2e-6 * result + 2e-6 * (min(half_x, radius) + min(half_y, radius)) / radius
            + 1.5e-6 * (min(abs(center_x), half_x + radius) / radius * (min(half_y, radius) / radius)
                + min(abs(center_y), half_y + radius) / radius * (min(half_x, radius) / radius))
    ),
    variant_of = rect_coverage,
    measured
)]
pub fn rect_coverage_paper(half_x: f32, half_y: f32, center_x: f32, center_y: f32, radius: f32) -> f32 {
    let area = rect_disk_bounds(half_x, half_y, center_x, center_y, radius);
    area / (PI * max(radius * radius, 1e-24))
}
