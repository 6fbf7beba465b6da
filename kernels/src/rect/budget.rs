//! Scales that the budgets are stated in. No kernel computes with them.

use crate::constants::PI;
use crate::rect::diffuse::LEVEL;
#[allow(unused_imports, reason = "the documentation links to it")]
use crate::rect::diffuse::rect_form_factor;
use crate::rect::energy::rect_energy;
use crate::rect::peak::LEAST_COSINE;
use crate::rect::reflection::Reflection;
use crate::rect::shade::RectShade;
use crate::rect::{GlossyReceiver, Rectangle};
use lobe_codegen::prelude::*;

/// How wrong rounding may make the radiance of a [`RectShade`]: the budget of these kernels.
///
/// A share of the radiance in the mirror direction of a disk that the rectangle covers: what errors of the height
/// over the plane, of the cosines, and of the peak's place against the disk make of it.
/// Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the rectangle | positions -100 ..= 100 | m |
/// | `reflection` | what it makes of the light | | |
/// | `receiver` | the shaded surface | positions -1e4 ..= 1e4 | m |
/// | `radius` | of the sampling disk | 1e-3 ..= 100 | m |
/// | `shade` | the shading | | |
///
/// Returns the error in W m⁻² sr⁻¹.
#[kernel]
pub fn rect_shade_error(
    rectangle: Rectangle,
    reflection: Reflection,
    receiver: GlossyReceiver,
    radius: f32,
    shade: RectShade,
) -> f32 {
    let cos_sigma = max(reflection.cos_sigma, LEAST_COSINE);
    let facing = max(dot(receiver.normal, receiver.view), 1e-3);
    let way = length(receiver.position - rectangle.position) + 1e-30;
    let nu = 0.5 * shade.sharpness;
    let geometry = way / max(shade.height, 1e-7 * way) + 1.0 / cos_sigma;
    let place = (way + shade.dist) / (cos_sigma * radius);
    let relative = 1e-5 + 2e-6 * geometry + 1e-6 * place + 5e-7 * sqrt(nu) + 5e-7 / facing;
    // A distance of which few digits are left says little of the disk: it may be as near as can be.
    let near = geometry > 300.0;
    let wide = select(max(shade.lambda, 1e-3) / (max(shade.lambda, 1e-3) + nu), 1.0, near);
    let narrow = select(max(shade.mu, 1e-3) / (max(shade.mu, 1e-3) + nu), 1.0, near);
    let aperture = select(shade.aperture, 1.0, near);
    let attenuation = select(reflection.attenuation, 0.0, near);
    let whole = rect_energy(1.0, reflection.radiance, attenuation, aperture);
    let peak =
        receiver.reflectance / (PI * receiver.alpha * receiver.alpha) * whole * sqrt(wide) * sqrt(narrow);
    min(relative, 1.5) * peak
}

/// How wrong rounding may make [`rect_form_factor`]: its budget.
///
/// It grows for positions near the rectangle's plane, from where its edges are long, and where the horizon cuts the
/// rectangle almost along one of its sides. It is 1 where drivers may turn a side that is level to 1e-6 either way:
/// both ways give the same part of the rectangle, of which a bound knows nothing.
/// Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the rectangle | positions -100 ..= 100, half sides 1e-3 ..= 100 | m |
/// | `position` | of the element | -1e4 ..= 1e4 | m |
/// | `normal` | unit normal of the element | sphere | 1 |
///
/// Returns the error of the form factor.
#[kernel]
pub fn rect_form_factor_error(rectangle: Rectangle, position: Vec3, normal: Vec3) -> f32 {
    let middle = rectangle.position - position;
    // A compiler may add the sides before it takes the difference of the positions.
    let reach = length(middle)
        + rectangle.half_x
        + rectangle.half_y
        + 0.1 * (length(rectangle.position) + length(position));
    let height = max(abs(dot(middle, rectangle.normal)), 1e-12);
    let rise_x = dot(rectangle.tangent, normal);
    let rise_y = dot(cross(rectangle.normal, rectangle.tangent), normal);
    let x = abs(rise_x) * rectangle.half_x;
    let y = abs(rise_y) * rectangle.half_y;
    let is_turned_anyhow = min(abs(rise_x + LEVEL), abs(rise_y + LEVEL)) < 5e-7;
    let is_cut = abs(dot(middle, normal)) < x + y + 1e-6 * reach;
    3e-6 + 3e-6 * reach / height
        + select(0.0, 3e-6 * reach / max(min(x, y), 1e-12) * (1.0 + 0.1 * reach / height), is_cut)
        + select(0.0, 1.0, is_turned_anyhow)
}
