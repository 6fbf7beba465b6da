//! Diffuse light: of a glossy rectangle on a matt surface, and of a matt rectangle.

use crate::constants::PI;
use crate::hsg::hsg_cosine_product_integral;
use crate::rect::Rectangle;
use crate::rect::angle::angle_over_sine;
use crate::rect::budget::rect_form_factor_error;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Lambert1760, RectGlossy, Tokuyoshi22};
use crate::sg::{Sg, sg_integral};
use lobe_codegen::prelude::*;

/// A side that rises or falls by less than this share of its length is level.
#[kernel]
pub const LEVEL: f32 = 1e-6;

/// Radiance that a matt surface reflects of a glossy rectangle.
///
/// `L = ρ/π ∫ G(w) max(n·w, 0) dw`, `G` the isotropic lobe about `z` of sharpness `2 √(λ μ)` and of energy `C`.
/// Source: our own; [RectGlossy] shows pictures of it (fig. 5) and no formula. The integral is that of
/// [Tokuyoshi22].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `axis` | unit direction to the specular peak, `z` | sphere | 1 |
/// | `lambda`, `mu` | bandwidths of the disk's lobe | 0 ..= 1e6 | 1 |
/// | `energy` | what the disk sends, `C` | 0 ..= 1e6 | W m⁻² |
/// | `normal` | unit normal of the matt surface, `n` | sphere | 1 |
/// | `albedo` | its albedo, `ρ` | 0 ..= 1 | 1 |
///
/// Returns the radiance in W m⁻² sr⁻¹, in 0 ..= `ρ C/π`. The integral errs by 0.4 % of that at most; the lobe stands
/// for one that is not round, which matters little under a cosine.
///
/// Numerics: sharpness above 1e5 is taken for that.
#[kernel(
    family = "rect",
    cite = "our own, [Tokuyoshi22]",
    domain(
        axis = unit, lambda = 0.0..=1e6, mu = 0.0..=1e6, energy = 0.0..=1e6, normal = unit, albedo = 0.0..=1.0
    ),
    budget(1.5e-5 * energy * albedo / PI + 1e-30),
    measured
)]
pub fn rect_diffuse_glossy(axis: Vec3, lambda: f32, mu: f32, energy: f32, normal: Vec3, albedo: f32) -> f32 {
    let sharpness = min(2.0 * (sqrt(lambda) * sqrt(mu)), 1e5);
    let lobe = Sg { axis, sharpness, log_amplitude: 0.0 };
    let cosine = hsg_cosine_product_integral(lobe, normal) / sg_integral(sharpness);
    albedo / PI * energy * cosine
}

/// What one edge of a polygon adds to its form factor.
///
/// `θ n·(p × q)/|p × q|`, `θ` the angle between the vertices `p` and `q = p + edge`.
/// Source: [Lambert1760].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `start` | vertex, seen from the shaded position, `p` | -100 ..= 100 | m |
/// | `edge` | from it to the next vertex | -100 ..= 100 | m |
/// | `normal` | unit normal of the shaded surface, `n` | sphere | 1 |
///
/// Returns the angle in rad, in -π ..= π; 0 for an edge without length.
///
/// Numerics: `n·(p × edge)` times `θ/sin θ` of [`angle_over_sine`], since the driver's arc cosine may err by 4096 ULP.
/// For obtuse angles `θ/sin θ = π/sin θ - θ'/sin θ'` of the complement. An angle of π has no value: the position then
/// lies on the edge.
#[kernel(
    family = "rect",
    cite = "[Lambert1760]",
    domain(start = -100.0..=100.0, edge = -100.0..=100.0, normal = unit),
    budget(
        1e-5 * min(length(edge) / max(length(start), 1e-12), 1.0)
            + min(4e-6 * (length(start) * length(edge)) / max(length(cross(start, edge)), 1e-18)
                * (length(start) + length(edge)) / max(length(start + edge), 1e-12), 8.0)
            + select(0.0, 8.0, min(length(start), length(start + edge)) < 1e-6) + 1e-9
    ),
    measured
)]
pub fn polygon_edge(start: Vec3, edge: Vec3, normal: Vec3) -> f32 {
    let to = start + edge;
    let product = max(dot(start, start), 1e-24);
    let other = max(dot(to, to), 1e-24);
    let scale = inverse_sqrt(product) * inverse_sqrt(other);
    let across = cross(start, edge) * scale;
    let cosine = clamp(dot(start, to) * scale, -1.0, 1.0);
    let sharp = angle_over_sine(1.0 - abs(cosine));
    let sine = sqrt(dot(across, across));
    let blunt = PI / max(sine, 1e-6) - sharp;
    clamp(dot(normal, across) * select(sharp, blunt, cosine < 0.0), -PI, PI)
}

/// Form factor from a surface element to a rectangle: the irradiance that it receives over the rectangle's radiosity.
///
/// `F = 1/(2π) Σ θ_i n·Γ_i` over the edges of the part above the element's horizon.
/// Source: [Lambert1760].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the rectangle, a matt one | positions -100 ..= 100, half sides 1e-3 ..= 100 | m |
/// | `position` | of the element | -1e4 ..= 1e4 | m |
/// | `normal` | unit normal of the element | sphere | 1 |
///
/// Returns the form factor, in 0 ..= 1; 0 behind the rectangle.
///
/// Numerics: the rectangle is cut by the horizon without cases. Seen along its two axes, so turned that heights grow
/// along them, the part above has the corners `(1, 1)`, `(1, v1)`, `(u1, v1)`, `(u2, v2)`, `(u2, 1)`, where `v1` and `u2`
/// are where the sides from the highest corner meet the horizon, and `u1` and `v2` the others; clamped to the rectangle,
/// they are its corners where the horizon does not cut.
#[kernel(
    family = "rect",
    cite = "[Lambert1760]",
    domain(position = -1e4..=1e4, normal = unit),
    budget(min(rect_form_factor_error(rectangle, position, normal), 1.0)),
    measured
)]
pub fn rect_form_factor(rectangle: Rectangle, position: Vec3, normal: Vec3) -> f32 {
    let middle = rectangle.position - position;
    let bitangent = cross(rectangle.normal, rectangle.tangent);
    let rise_x = dot(rectangle.tangent, normal);
    let rise_y = dot(bitangent, normal);
    // A hair below zero, so that a rectangle parallel to the element is turned one way by every driver.
    let side_x = rectangle.half_x * select(-rectangle.tangent, rectangle.tangent, rise_x > -LEVEL);
    let side_y = rectangle.half_y * select(-bitangent, bitangent, rise_y > -LEVEL);
    let x = max(abs(rise_x) * rectangle.half_x, 1e-12);
    let y = max(abs(rise_y) * rectangle.half_y, 1e-12);
    let z = dot(middle, normal);
    let v1 = clamp((-z - x) / y, -1.0, 1.0);
    let u2 = clamp((-z - y) / x, -1.0, 1.0);
    let u1 = clamp((-z + y) / x, -1.0, 1.0);
    let v2 = clamp((-z + x) / y, -1.0, 1.0);
    let high = middle + side_x + side_y;
    let right = middle + side_x + v1 * side_y;
    let low = middle + u1 * side_x + v1 * side_y;
    let left = middle + u2 * side_x + v2 * side_y;
    let upper = middle + u2 * side_x + side_y;
    let sum = polygon_edge(high, (v1 - 1.0) * side_y, normal)
        + polygon_edge(right, (u1 - 1.0) * side_x, normal)
        + polygon_edge(low, (u2 - u1) * side_x + (v2 - v1) * side_y, normal)
        + polygon_edge(left, (1.0 - v2) * side_y, normal)
        + polygon_edge(upper, (1.0 - u2) * side_x, normal);
    let factor = min(abs(sum) / (2.0 * PI), 1.0);
    select(0.0, factor, dot(middle, rectangle.normal) < 0.0)
}

/// Radiance that a matt surface reflects of a matt rectangle in the light of a distant source.
///
/// `L = ρ_x/π F B`, `B = ρ_r E cos σ` the rectangle's radiosity.
/// Source: [Lambert1760], by [`rect_form_factor`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `form_factor` | `F` | 0 ..= 1 | 1 |
/// | `albedo`, `rectangle_albedo` | `ρ_x`, `ρ_r` | 0 ..= 1 | 1 |
/// | `cos_sigma` | cosine of the light's angle of incidence on the rectangle; none below 0 | -1 ..= 1 | 1 |
/// | `irradiance` | of the light, on a plane that faces it | 0 ..= 1e4 | W m⁻² |
///
/// Returns the radiance in W m⁻² sr⁻¹.
#[kernel(
    family = "rect",
    cite = "[Lambert1760]",
    domain(
        form_factor = 0.0..=1.0, albedo = 0.0..=1.0, rectangle_albedo = 0.0..=1.0, cos_sigma = -1.0..=1.0,
        irradiance = 0.0..=1e4
    ),
    budget(1e-6 * result + 1e-30),
    measured
)]
pub fn rect_diffuse_matt(
    form_factor: f32,
    albedo: f32,
    rectangle_albedo: f32,
    cos_sigma: f32,
    irradiance: f32,
) -> f32 {
    form_factor * (albedo / PI) * (rectangle_albedo * max(cos_sigma, 0.0) * irradiance)
}
