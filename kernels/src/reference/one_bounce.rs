//! Light that reaches a point over one glossy rectangle: the integrand, four ways to sample it, the estimate.
//!
//! Everything is per rectangle and per light, without occlusion. Directions of incidence at the receiver are
//! what is integrated; densities are per solid angle there, or, times the cosine at the rectangle and over the
//! squared distance, per area of the rectangle.

use crate::brdf::Material;
use crate::brdf::budget::largest;
use crate::brdf::model::{surface_brdf_cosine, surface_transfer};
use crate::brdf::ndf::ggx_ndf_between;
use crate::brdf::sampling::{
    cosine_hemisphere_pdf, cosine_sample_hemisphere, frame_to_local, frame_to_world, ggx_half_vector_pdf,
    ggx_sample_half_vector, ggx_sample_visible_normal, ggx_visible_normal_pdf, mirror, orthonormal_frame,
};
use crate::rect::Rectangle;
use crate::reference::budget::{density_error, least_density, transfer_error, turned_transfer_error};
use crate::reference::rectangle::rectangle_point;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{RectGlossy, Veach97};
use lobe_codegen::prelude::*;

/// A viewed point, a rectangle, and a light.
#[kernel]
pub struct OneBounce {
    /// The viewed point.
    #[domain(-100.0..=100.0)]
    pub position: Vec3,
    /// Its unit normal.
    #[domain(unit)]
    pub normal: Vec3,
    /// Unit direction from it to the viewer.
    #[domain(unit)]
    pub view: Vec3,
    /// Its surface.
    pub material: Material,
    /// What reflects the light onto it.
    pub rectangle: Rectangle,
    /// The rectangle's surface.
    pub rectangle_material: Material,
    /// Unit direction from the rectangle to the light.
    #[domain(unit)]
    pub light: Vec3,
}

/// The integrand without the distance: both surfaces and all cosines.
///
/// `f_B(w, o) (n_B·w)⁺ f_A(l, -w) (n_A·l)⁺ (-n_A·w)⁺`
/// Source: [RectGlossy] eq. 3, with both lobes of both surfaces.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `bounce` | the point B, the rectangle A, the light | alpha 0.02 ..= 1 | 1 |
/// | `dir` | unit direction `w` from the point | sphere | 1 |
///
/// Returns the transfer in 1/sr², at least 0: times the light's irradiance across its direction, over the squared
/// distance, what an area of the rectangle adds to the radiance. 0 where a direction is not above a surface. Whether
/// the direction meets the rectangle is not asked.
#[kernel(
    family = "reference",
    cite = "[RectGlossy] eq. 3",
    domain(dir = unit),
    budget(
        transfer_error(bounce, dir)
    ),
    measured
)]
pub fn one_bounce_transfer(bounce: OneBounce, dir: Vec3) -> Vec3 {
    surface_brdf_cosine(bounce.material, bounce.normal, dir, bounce.view)
        * surface_transfer(bounce.rectangle_material, bounce.rectangle.normal, bounce.light, -dir)
}

/// What an area of the rectangle adds to the radiance, for an irradiance of 1 across the light's direction.
///
/// `f_B(w, o) (n_B·w)⁺ f_A(l, -w) (n_A·l)⁺ (-n_A·w)⁺ / |y - x|²`
/// Source: [RectGlossy] eq. 3, with both lobes of both surfaces.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `bounce` | the point B, the rectangle A, the light | alpha 0.02 ..= 1 | 1 |
/// | `place` | point `y` of the rectangle | -100 ..= 100 | m |
///
/// Returns the radiance by area in 1/(sr² m²), at least 0.
///
/// Numerics: the difference of the points is rounded once; distances below 1e-4 m count as that.
#[kernel(
    family = "reference",
    cite = "[RectGlossy] eq. 3",
    domain(place = -100.0..=100.0),
    budget(
        turned_transfer_error(bounce, direction_to(bounce, place))
            / max(dot(place - bounce.position, place - bounce.position), 1e-8)
    ),
    measured
)]
pub fn one_bounce_area_integrand(bounce: OneBounce, place: Vec3) -> Vec3 {
    let offset = place - bounce.position;
    one_bounce_transfer(bounce, direction_to(bounce, place)) / max(dot(offset, offset), 1e-8)
}

/// The integrand without the distance for reflectances that are their distributions of normals alone.
///
/// `D_B(w, o) (n_B·w)⁺ D_A(l, -w) (n_A·l)⁺ (-n_A·w)⁺`
/// Source: [RectGlossy] eq. 3, with `M = 1`: what its method approximates.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `bounce` | the point B, the rectangle A, the light; of the surfaces only alpha | alpha 0.02 ..= 1 | 1 |
/// | `dir` | unit direction `w` from the point | sphere | 1 |
///
/// Returns the transfer in 1/sr², at least 0.
#[kernel(
    family = "reference",
    cite = "[RectGlossy] eq. 3",
    domain(dir = unit),
    budget(
        ((7e-6 + 2e-6 / bounce.material.alpha + 2e-6 / bounce.rectangle_material.alpha) * one_bounce_cosines(bounce, dir) + 8e-7)
            * ggx_ndf_between(bounce.normal, dir, bounce.view, bounce.material.alpha)
            * ggx_ndf_between(bounce.rectangle.normal, bounce.light, -dir, bounce.rectangle_material.alpha) + 1e-8
    ),
    measured
)]
pub fn one_bounce_ndf_transfer(bounce: OneBounce, dir: Vec3) -> f32 {
    let receiver = ggx_ndf_between(bounce.normal, dir, bounce.view, bounce.material.alpha);
    let reflector =
        ggx_ndf_between(bounce.rectangle.normal, bounce.light, -dir, bounce.rectangle_material.alpha);
    one_bounce_cosines(bounce, dir) * receiver * reflector
}

/// The cosines of the integrand.
///
/// `(n_B·w)⁺ (n_A·l)⁺ (-n_A·w)⁺`
/// Source: [RectGlossy] eq. 3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `bounce` | the point B, the rectangle A, the light | | 1 |
/// | `dir` | unit direction `w` from the point | sphere | 1 |
///
/// Returns the product, in 0 ..= 1.
#[kernel(family = "reference", cite = "[RectGlossy] eq. 3", domain(dir = unit), budget(1.2e-6), measured)]
pub fn one_bounce_cosines(bounce: OneBounce, dir: Vec3) -> f32 {
    let towards_light = max(dot(bounce.rectangle.normal, bounce.light), 0.0);
    let towards_point = max(-dot(bounce.rectangle.normal, dir), 0.0);
    max(dot(bounce.normal, dir), 0.0) * (towards_light * towards_point)
}

/// A random direction from the point, by one of four techniques.
///
/// 0: to a uniform point of the rectangle; 1: the view mirrored about a visible normal of the point's surface;
/// 2: by the cosine at the point; 3: from where the light is mirrored about a half vector of the rectangle's surface.
/// Source: [Veach97] section 9.2.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `bounce` | the point, the rectangle, the light | alpha 0.02 ..= 1 | 1 |
/// | `strategy` | which; above 3 counts as 2 | 0 ..= 3 | 1 |
/// | `u` | two uniform numbers | 0 ..= 1 - 2^-24 | 1 |
///
/// Returns a unit direction; with a technique drawn uniformly, its density is [`one_bounce_density`].
///
/// Numerics: the estimate is of the direction as it was rounded, so an error here moves the samples by that much,
/// and not the estimate's mean.
#[kernel(
    family = "reference",
    cite = "[Veach97] section 9.2",
    domain(strategy = 0.0..=3.0, u = 0.0..=0.99999994),
    budget(
        2e-5 + 1e-5 * bounce.material.alpha / (1.0 - u.y) * (2.0 + 1e-5 * bounce.material.alpha / (1.0 - u.y))
            + 3e-6 * (length(bounce.rectangle.position) + bounce.rectangle.half_x + bounce.rectangle.half_y + length(bounce.position))
            / max(length(rectangle_point(bounce.rectangle, u) - bounce.position), 1e-6)
    ),
    measured
)]
pub fn one_bounce_sample(bounce: OneBounce, strategy: u32, u: Vec2) -> Vec3 {
    if strategy == 0 {
        let offset = rectangle_point(bounce.rectangle, u) - bounce.position;
        offset * inverse_sqrt(max(dot(offset, offset), 1e-12))
    } else if strategy == 3 {
        let frame = orthonormal_frame(bounce.rectangle.normal);
        let half_vector = frame_to_world(frame, ggx_sample_half_vector(bounce.rectangle_material.alpha, u));
        -mirror(bounce.light, half_vector)
    } else {
        let frame = orthonormal_frame(bounce.normal);
        if strategy == 1 {
            let view = frame_to_local(frame, bounce.view);
            let seen = ggx_sample_visible_normal(view, bounce.material.alpha, u);
            mirror(bounce.view, frame_to_world(frame, seen))
        } else {
            frame_to_world(frame, cosine_sample_hemisphere(u))
        }
    }
}

/// Density of [`one_bounce_sample`] with a uniform technique, per area of the rectangle, times the squared distance.
///
/// `¼ (t²/(4 half_x half_y) + (-n_A·w)⁺ (p_1 + p_2 + p_3))`, the densities per solid angle `p_i`.
/// Source: [Veach97] section 9.2: dividing by the mean of all densities is the balance heuristic.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `bounce` | the point, the rectangle, the light | alpha 0.02 ..= 1 | 1 |
/// | `dir` | unit direction `w` | sphere | 1 |
/// | `dist` | `t`, from the point to the rectangle along it | 1e-3 ..= 1e4 | m |
///
/// Returns the density in 1/sr, times the cosine at the rectangle; above 0.
#[kernel(
    family = "reference",
    cite = "[Veach97] section 9.2",
    domain(dir = unit, dist = 1e-3..=1e4),
    budget(
        density_error(bounce, dir, dist)
    ),
    measured
)]
pub fn one_bounce_density(bounce: OneBounce, dir: Vec3, dist: f32) -> f32 {
    let by_area = 0.25 * (dist / bounce.rectangle.half_x) * (dist / bounce.rectangle.half_y);
    let by_normal = ggx_visible_normal_pdf(bounce.material.alpha, bounce.normal, dir, bounce.view);
    let by_cosine = cosine_hemisphere_pdf(dot(bounce.normal, dir));
    let by_light =
        ggx_half_vector_pdf(bounce.rectangle_material.alpha, bounce.rectangle.normal, -dir, bounce.light);
    let cosine = max(-dot(bounce.rectangle.normal, dir), 0.0);
    0.25 * (by_area + cosine * (by_normal + by_cosine + by_light))
}

/// What one direction of [`one_bounce_sample`] that meets the rectangle contributes to the estimate of the radiance.
///
/// [`one_bounce_transfer`] over [`one_bounce_density`], for an irradiance of 1 across the light's direction.
/// Source: [Veach97] eq. 9.15, of one sample.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `bounce` | the point, the rectangle, the light | alpha 0.02 ..= 1 | 1 |
/// | `dir` | unit direction | sphere | 1 |
/// | `dist` | from the point to the rectangle along it | 1e-3 ..= 1e4 | m |
///
/// Returns the contribution in 1/sr, at least 0. The mean over directions, with 0 for those that do not meet the
/// rectangle, is the radiance that the point sends to the viewer.
#[kernel(
    family = "reference",
    cite = "[Veach97] eq. 9.15",
    domain(dir = unit, dist = 1e-3..=1e4),
    budget(
        (transfer_error(bounce, dir) + density_error(bounce, dir, dist) * largest(result))
            * 0.6 / least_density(bounce, dir, dist)
    ),
    measured
)]
pub fn one_bounce_estimate(bounce: OneBounce, dir: Vec3, dist: f32) -> Vec3 {
    one_bounce_transfer(bounce, dir) / max(one_bounce_density(bounce, dir, dist), 1e-20)
}

/// The direction of [`one_bounce_area_integrand`].
#[kernel]
fn direction_to(bounce: OneBounce, place: Vec3) -> Vec3 {
    let offset = place - bounce.position;
    offset * inverse_sqrt(max(dot(offset, offset), 1e-8))
}
