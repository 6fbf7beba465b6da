//! The anisotropic lobe that stands for the light from the sampling disk.

use crate::asg::Asg;
use crate::constants::PI;
use crate::rect::angle::log1p_over_x;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::RectGlossy;
use lobe_codegen::prelude::*;

/// `-ln 0.05`, as printed: a lobe falls to 0.05 at the disk's rim.
#[kernel]
pub const RIM: f32 = 2.996;

/// An anisotropic lobe that stands for a disk, and the disk's half extents.
#[kernel]
pub struct DiskLobe {
    /// Unit vector to the peak.
    #[domain(unit)]
    pub z: Vec3,
    /// Unit tangent, perpendicular to `z`.
    #[domain(normal_to(z))]
    pub x: Vec3,
    /// Unit bitangent, `cross(z, x)`.
    #[domain(cross(z, x))]
    pub y: Vec3,
    /// Half extent of the disk along `x` over its distance.
    #[domain(1e-3..=4.0)]
    pub half_x: f32,
    /// Half extent along `y`.
    #[domain(1e-6..=4.0)]
    pub half_y: f32,
    /// Bandwidth along `x`.
    #[domain(0.0..=1e6)]
    pub lambda: f32,
    /// Bandwidth along `y`.
    #[domain(0.0..=1e6)]
    pub mu: f32,
    /// Value at the peak.
    #[domain(0.0..=1e4)]
    pub amplitude: f32,
}

/// A disk's lobe as a lobe.
///
/// Source: [RectGlossy] eq. 2.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `disk` | the disk's lobe | bandwidths 0 ..= 1e6, amplitude 0 ..= 1e4 | 1 |
///
/// Returns the lobe.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 2",
    budget(z = 1e-37, x = 1e-37, y = 1e-37, lambda = 1e-37, mu = 1e-37, amplitude = 1e-37),
    measured
)]
pub fn rect_disk_asg(disk: DiskLobe) -> Asg {
    Asg { z: disk.z, x: disk.x, y: disk.y, lambda: disk.lambda, mu: disk.mu, amplitude: disk.amplitude }
}

/// Bandwidth of a lobe that falls to 0.05 at a given half extent.
///
/// `λ = (1 + 1/l²)(2.996 - ln(1 + l²)/2)`
/// Source: [RectGlossy] eq. 32, for `l` limited to 4.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `ratio` | half extent over the distance, `l`; above 4 it is taken for that | 1e-6 ..= 1e6 | 1 |
///
/// Returns the bandwidth, in 1.68 ..= 3e12. The printed form ([`rect_bandwidth_paper`]) falls below 0 at 19.98, and
/// from 4 on the integral of the lobe is no longer `π/√(λ μ)` (23 % off there).
#[kernel(family = "rect", cite = "[RectGlossy] eq. 32", domain(ratio = 1e-6..=1e6), budget(3e-6 * result), measured)]
pub fn rect_bandwidth(ratio: f32) -> f32 {
    rect_bandwidth_paper(min(ratio, 4.0))
}

/// Bandwidth of a lobe that falls to 0.05 at a given half extent, as printed.
///
/// Source: [RectGlossy] eq. 32. Arguments and domain as of [`rect_bandwidth`].
///
/// Returns the bandwidth, which is negative for ratios above 19.98.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 32",
    domain(ratio = 1e-6..=1e6),
    budget(3e-6 * abs(result) + 1e-5),
    variant_of = rect_bandwidth,
    measured
)]
pub fn rect_bandwidth_paper(ratio: f32) -> f32 {
    let square = max(ratio * ratio, 1e-20);
    (1.0 + 1.0 / square) * (RIM - 0.5 * (square * log1p_over_x(square)))
}

/// How much the bandwidths of a disk's lobe differ, over the square of the sine of the disk's slant.
///
/// `(μ - λ)/sin² σ`, `λ` the bandwidth at the half extent `l`, `μ` that at `l cos σ`.
/// Source: [RectGlossy] eq. 32; the quotient by algebra:
/// `(2.996 - ln(1 + M)/2)/M + (1 + L)/(2 (1 + M)) ln(1 + z)/z`, `L = l²`, `M = L cos² σ`, `z = (L - M)/(1 + M)`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `ratio` | half extent over the distance, `l` | 1e-3 ..= 1e3 | 1 |
/// | `cos_sigma` | cosine of the slant | 1e-5 ..= 1 | 1 |
///
/// Returns the quotient. It is finite for a disk that is seen from above, where the axes of its lobe have no
/// meaning: so the lobe can be evaluated without them.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 32",
    domain(ratio = 1e-3..=1e3, cos_sigma = 1e-5..=1.0),
    budget(4e-6 * abs(result) + 1e-5),
    measured
)]
pub fn rect_bandwidth_slope(ratio: f32, cos_sigma: f32) -> f32 {
    let wide = ratio * ratio;
    let narrow = max(wide * (cos_sigma * cos_sigma), 1e-20);
    let above = 1.0 + narrow;
    let rest = max(wide * ((1.0 - cos_sigma) * (1.0 + cos_sigma)), 0.0) / above;
    let first = (RIM - 0.5 * (narrow * log1p_over_x(narrow))) / narrow;
    first + 0.5 * ((1.0 + wide) / above) * log1p_over_x(rest)
}

/// The frame of a disk's lobe.
///
/// `x = n × z/|n × z|`, `y = z × x`
/// Source: [RectGlossy] eq. 18, 28. Its axes are those of the ellipse as which the disk is seen.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `axis` | unit direction from the shaded position to the disk, `z` | sphere | 1 |
/// | `normal` | unit normal of the disk, `n` | sphere | 1 |
/// | `tangent` | unit vector, taken for `x` where the disk is seen from above | sphere | 1 |
///
/// Returns the vectors `z`, `x`, `y` as columns.
///
/// Numerics: seen from within 1e-4 of straight above, the ellipse is a circle, and any tangent will do. Near that, rounding
/// errors turn the frame about `z`.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 18, 28",
    domain(axis = unit, normal = unit, tangent = unit),
    budget(
        x_axis = 1e-37,
        y_axis = min(2e-6 / max(length(cross(normal, axis)), 1e-5), 2.5)
            + select(0.0, 2.5, length(cross(normal, axis)) < 1.001e-4),
        z_axis = min(4e-6 / max(length(cross(normal, axis)), 1e-5), 4.5)
            + select(0.0, 4.5, length(cross(normal, axis)) < 1.001e-4)
    ),
    measured
)]
pub fn rect_disk_frame(axis: Vec3, normal: Vec3, tangent: Vec3) -> Mat3 {
    let across = cross(normal, axis);
    let level = tangent - dot(tangent, axis) * axis;
    let long = select(level, across, dot(across, across) > 1e-8);
    let unit = long * inverse_sqrt(max(dot(long, long), 1e-20));
    // For two vectors along the axis, of which there is nothing to make a frame.
    let x = clamp(unit, Vec3::new(-1.0, -1.0, -1.0), Vec3::new(1.0, 1.0, 1.0));
    Mat3::from_cols(axis, x, cross(axis, x))
}

/// The lobe that stands for the light from the sampling disk.
///
/// `z` from the position to the peak, `l_m = r/d`, `l_n = l_m (n·-z)`, the bandwidths of [`rect_bandwidth`], the
/// frame of [`rect_disk_frame`], the amplitude `√(λ μ) C/π`.
/// Source: [RectGlossy] eq. 28, 29, 32, 35. Half extents are taken over the distance, where the paper has it for 1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `peak` | middle of the disk | -1e4 ..= 1e4 | m |
/// | `position` | the shaded position | -1e4 ..= 1e4 | m |
/// | `normal` | unit normal of the disk | sphere | 1 |
/// | `tangent` | unit vector, the axis `x` for a disk that is seen from above | sphere | 1 |
/// | `energy` | what the disk sends, `C` | 0 ..= 1e6 | W m⁻² |
/// | `radius` | of the disk | 1e-3 ..= 100 | m |
///
/// Returns the lobe in W m⁻² sr⁻¹. Half extents are limited to 1e-3 ..= 4, cosines to at least 1e-3:
/// [`rect_asg_from_disk_paper`] has no limits. For bandwidths below 3 the integral of the lobe is smaller than `C`.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 28, 29, 32, 35",
    domain(
        peak = -1e4..=1e4, position = -1e4..=1e4, normal = unit, tangent = unit, energy = 0.0..=1e6,
        radius = 1e-3..=100.0
    ),
    budget(
        z = 2e-6,
        lambda = 1e-5 * result.lambda,
        mu = (1e-5 + 4e-6 * result.half_x / result.half_y) * result.mu,
        amplitude = (1e-5 + 4e-6 * result.half_x / result.half_y) * result.amplitude + 1e-28,
        half_x = 2e-6 * result.half_x,
        half_y = 4e-6 * result.half_x
    ),
    measured
)]
pub fn rect_asg_from_disk(
    peak: Vec3,
    position: Vec3,
    normal: Vec3,
    tangent: Vec3,
    energy: f32,
    radius: f32,
) -> DiskLobe {
    let way = peak - position;
    let dist = max(length(way), 1e-12);
    let axis = way / dist;
    let half_x = clamp(radius / dist, 1e-3, 4.0);
    let half_y = half_x * max(-dot(normal, axis), 1e-3);
    rect_lobe(rect_disk_frame(axis, normal, tangent), half_x, half_y, energy)
}

/// The lobe that stands for the light from the sampling disk, as printed.
///
/// Source: [RectGlossy] eq. 28, 29, 32, 35. Arguments and domain as of [`rect_asg_from_disk`].
///
/// Returns the lobe; for half extents above 19.98 of the distance its bandwidths are negative, and its amplitude is 0.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 28, 29, 32, 35",
    domain(
        peak = -1e4..=1e4, position = -1e4..=1e4, normal = unit, tangent = unit, energy = 0.0..=1e6,
        radius = 1e-3..=100.0
    ),
    budget(
        z = 2e-6,
        lambda = 1e-5 * abs(result.lambda) + 3e-5,
        mu = (1e-5 + 4e-6 * result.half_x / result.half_y) * (abs(result.mu) + 10.0),
        half_x = 2e-6 * result.half_x,
        half_y = 4e-6 * result.half_x
    ),
    variant_of = rect_asg_from_disk,
    measured
)]
pub fn rect_asg_from_disk_paper(
    peak: Vec3,
    position: Vec3,
    normal: Vec3,
    tangent: Vec3,
    energy: f32,
    radius: f32,
) -> DiskLobe {
    let way = peak - position;
    let dist = max(length(way), 1e-12);
    let axis = way / dist;
    let half_x = radius / dist;
    let half_y = half_x * max(-dot(normal, axis), 1e-5);
    rect_lobe(rect_disk_frame(axis, normal, tangent), half_x, half_y, energy)
}

/// The lobe of a frame, half extents and energy; part of [`rect_asg_from_disk`].
///
/// Source: [RectGlossy] eq. 32, 35.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `frame` | the vectors `z`, `x`, `y` | unit vectors | 1 |
/// | `half_x`, `half_y` | half extents over the distance | 1e-6 ..= 4 | 1 |
/// | `energy` | integral of the lobe | 0 ..= 1e6 | W m⁻² |
///
/// Returns the lobe in W m⁻² sr⁻¹.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 32, 35",
    domain(frame = -1.0..=1.0, half_x = 1e-6..=4.0, half_y = 1e-6..=4.0, energy = 0.0..=1e6),
    budget(
        z = 1e-37,
        x = 1e-37,
        y = 1e-37,
        half_x = 0.0,
        half_y = 0.0,
        lambda = 3e-6 * abs(result.lambda) + 1e-5,
        mu = 3e-6 * abs(result.mu) + 1e-5,
        amplitude = 1e-5 * result.amplitude + 1e-24
    ),
    measured
)]
pub fn rect_lobe(frame: Mat3, half_x: f32, half_y: f32, energy: f32) -> DiskLobe {
    let lambda = rect_bandwidth_paper(half_x);
    let mu = rect_bandwidth_paper(half_y);
    let amplitude = sqrt(max(lambda, 0.0)) * sqrt(max(mu, 0.0)) * (energy / PI);
    DiskLobe { z: frame.x_axis, x: frame.y_axis, y: frame.z_axis, half_x, half_y, lambda, mu, amplitude }
}
