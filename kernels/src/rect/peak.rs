//! Where on the rectangle's plane the light is mirrored to a position.

use crate::rect::Rectangle;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::RectGlossy;
use lobe_codegen::prelude::*;

/// Below it a cosine of incidence is taken for it.
#[kernel]
pub const LEAST_COSINE: f32 = 1e-5;

/// The place where a rectangle's plane mirrors a distant light to a position.
#[kernel]
pub struct SpecularPeak {
    /// The place, which may lie outside the rectangle.
    #[domain(-1e4..=1e4)]
    pub position: Vec3,
    /// Unit direction in which the light leaves it.
    #[domain(unit)]
    pub reflected: Vec3,
    /// Its distance from the position; 0 or negative for one that is not on the reflecting side.
    #[domain(-1e4..=1e4)]
    pub dist: f32,
}

/// The specular peak of a distant light.
///
/// `r = 2 (i·n) n - i`, `d = (x - c)·n/(i·n)`, `y = x - d r`
/// Source: [RectGlossy] eq. 12.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the rectangle, of which its plane counts: `c`, `n` | positions -100 ..= 100 | m |
/// | `light_dir` | unit direction to the light, `i` | sphere | 1 |
/// | `position` | the shaded position, `x` | -1e4 ..= 1e4 | m |
///
/// Returns the peak. There is none where the light is below the rectangle's plane (`i·n <= 0`) or the position is
/// (`dist <= 0`): that is for the caller to ask.
///
/// Numerics: the way within the plane is taken from the rectangle's middle, so that the peak is on the plane. A cosine
/// `i·n` below 1e-5 is taken for that. The distance is as wrong as the height over the plane,
/// which is small against the way to the rectangle's middle for positions near the plane.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 12",
    domain(light_dir = unit, position = -1e4..=1e4),
    budget(
        position = (2e-6 * (abs(result.dist) + length(position - rectangle.position))
            / max(dot(light_dir, rectangle.normal), LEAST_COSINE)) + 1e-6 * length(position) + 1e-30,
        reflected = 2e-6,
        dist = 2e-6 * (abs(result.dist) + length(position - rectangle.position))
            / max(dot(light_dir, rectangle.normal), LEAST_COSINE) + 1e-30
    ),
    measured
)]
pub fn rect_specular_peak(rectangle: Rectangle, light_dir: Vec3, position: Vec3) -> SpecularPeak {
    let cosine = dot(light_dir, rectangle.normal);
    let offset = position - rectangle.position;
    let height = dot(offset, rectangle.normal);
    let dist = height / max(cosine, LEAST_COSINE);
    let level = (offset - height * rectangle.normal) + dist * (light_dir - cosine * rectangle.normal);
    SpecularPeak {
        position: rectangle.position + level,
        reflected: 2.0 * cosine * rectangle.normal - light_dir,
        dist,
    }
}
