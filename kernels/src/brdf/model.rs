//! The model: a Lambertian lobe and a glossy one of GGX facets, split into the distribution and the rest.

use super::Material;
use super::budget::{largest, surface_error};
use super::fresnel::fresnel_schlick_between;
use super::ndf::ggx_ndf_between;
use super::visibility::{smith_g2, smith_root, smith_visibility};
use crate::constants::INVERSE_PI;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{CookTorrance82, Pharr23, RectGlossy, Tokuyoshi15b};
use lobe_codegen::prelude::*;

/// Reflectance of a Lambertian surface.
///
/// `f = albedo/π`
/// Source: [Pharr23] section 9.2.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `albedo` | share of the light that is reflected, linear RGB | 0 ..= 1 | 1 |
///
/// Returns the reflectance in 1/sr. It is not lowered by what the glossy lobe reflects.
#[kernel(family = "brdf", cite = "[Pharr23] section 9.2", domain(albedo = 0.0..=1.0), budget(1e-7 * largest(albedo) + 1e-37), measured)]
pub fn lambert_brdf(albedo: Vec3) -> Vec3 {
    INVERSE_PI * albedo
}

/// All of the glossy reflectance but the distribution of normals, `M = F V`.
///
/// `f_s = M D`, `M = F(v·h) G2/(4 (n·l) (n·v))`
/// Source: [RectGlossy] eq. 5, [CookTorrance82].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `f0` | reflectance of a facet at normal incidence, linear RGB | 0 ..= 1 | 1 |
/// | `f90` | that at grazing incidence | 0 ..= 1 | 1 |
/// | `alpha` | width of the distribution | 0.02 ..= 1 | 1 |
/// | `normal`, `light`, `view` | unit vectors `n`, `l`, `v` | sphere | 1 |
///
/// Returns the factor, at least 0; see [`smith_visibility`] for directions at the horizon or below.
///
/// Numerics: the cosines' own errors, 2e-7, enter as the visibility's square.
#[kernel(
    family = "brdf",
    cite = "[RectGlossy] eq. 5",
    domain(f0 = 0.0..=1.0, f90 = 0.0..=1.0, alpha = 0.02..=1.0, normal = unit, light = unit, view = unit),
    budget(
        (4e-6 + 1.5e-6 * smith_visibility(dot(normal, light), dot(normal, view), alpha))
            * smith_visibility(dot(normal, light), dot(normal, view), alpha) * max(largest(f0), f90) + 1e-30
    ),
    measured
)]
pub fn microfacet_m(f0: Vec3, f90: f32, alpha: f32, normal: Vec3, light: Vec3, view: Vec3) -> Vec3 {
    fresnel_schlick_between(f0, f90, light, view)
        * smith_visibility(dot(normal, light), dot(normal, view), alpha)
}

/// The glossy reflectance with the light's cosine, for a distribution of normals that is 1 at its peak.
///
/// `M = F(v·h) V (n·l)/(π alpha²)`
/// Source: [Tokuyoshi15b] section 1.1, where the lobes of the distribution have amplitude 1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `f0` | reflectance of a facet at normal incidence, linear RGB | 0 ..= 1 | 1 |
/// | `f90` | that at grazing incidence | 0 ..= 1 | 1 |
/// | `alpha` | width of the distribution | 0.02 ..= 1 | 1 |
/// | `normal`, `light`, `view` | unit vectors `n`, `l`, `v` | sphere | 1 |
///
/// Returns the factor in 1/sr, in 0 ..= 1/(2 π alpha³); 0 for a light below the horizon. The view's cosine is
/// held at 1e-4.
///
/// Numerics: `V (n·l) = 0.5/(√(alpha² + (1 - alpha²) (n·v)²) + (n·v) √(1 - alpha² + alpha²/(n·l)²))`, in which the
/// light's cosine stands once and which is continuous at its horizon.
#[kernel(
    family = "brdf",
    cite = "[Tokuyoshi15b] section 1.1",
    domain(f0 = 0.0..=1.0, f90 = 0.0..=1.0, alpha = 0.02..=1.0, normal = unit, light = unit, view = unit),
    budget((6e-6 + 1e-6 / max(dot(normal, view), 1e-4)) * max(largest(f0), f90) / (alpha * alpha * alpha) + 1e-33),
    measured
)]
pub fn microfacet_reflectance(f0: Vec3, f90: f32, alpha: f32, normal: Vec3, light: Vec3, view: Vec3) -> Vec3 {
    let n_dot_v = max(dot(normal, view), 1e-4);
    let root = sqrt(alpha * alpha + (1.0 - alpha) * (1.0 + alpha) * (n_dot_v * n_dot_v));
    let masked = root + n_dot_v * smith_root(dot(normal, light), alpha);
    let scale = 0.5 * INVERSE_PI / (alpha * alpha * masked);
    fresnel_schlick_between(f0, f90, light, view) * scale
}

/// Glossy reflectance of GGX facets.
///
/// `f_s = D V F`
/// Source: [CookTorrance82], with [`ggx_ndf_between`], [`smith_visibility`] and
/// [`fresnel_schlick`](super::fresnel::fresnel_schlick).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `f0` | reflectance of a facet at normal incidence, linear RGB | 0 ..= 1 | 1 |
/// | `f90` | that at grazing incidence | 0 ..= 1 | 1 |
/// | `alpha` | width of the distribution | 0.02 ..= 1 | 1 |
/// | `normal`, `light`, `view` | unit vectors `n`, `l`, `v` | sphere | 1 |
///
/// Returns the reflectance in 1/sr, at least 0; 0 where a direction is not above the horizon. There it jumps:
/// [`surface_transfer`] does not.
///
/// A single bounce: what facets reflect onto each other is lost.
#[kernel(
    family = "brdf",
    cite = "[CookTorrance82]",
    domain(f0 = 0.0..=1.0, f90 = 0.0..=1.0, alpha = 0.02..=1.0, normal = unit, light = unit, view = unit),
    budget(
        (6e-6 + 2e-6 / alpha + 1.5e-6 * smith_visibility(dot(normal, light), dot(normal, view), alpha)
            + select(0.0, 10.0, min(dot(normal, light), dot(normal, view)) < 1e-6))
            * smith_visibility(dot(normal, light), dot(normal, view), alpha)
            * ggx_ndf_between(normal, light, view, alpha) * max(largest(f0), f90) + 1e-30
    ),
    measured
)]
pub fn microfacet_brdf(f0: Vec3, f90: f32, alpha: f32, normal: Vec3, light: Vec3, view: Vec3) -> Vec3 {
    let n_dot_l = dot(normal, light);
    let n_dot_v = dot(normal, view);
    let value = smith_visibility(n_dot_l, n_dot_v, alpha) * ggx_ndf_between(normal, light, view, alpha);
    let seen = select(0.0, value, n_dot_l > 0.0 && n_dot_v > 0.0);
    fresnel_schlick_between(f0, f90, light, view) * seen
}

/// Reflectance of a surface times both cosines.
///
/// `f (n·l)⁺ (n·v)⁺`, `f = albedo/π + D V F`
/// Source: [CookTorrance82]; with the cosines, `V` becomes `G2/4`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `material` | the surface | alpha 0.02 ..= 1 | 1 |
/// | `normal`, `light`, `view` | unit vectors `n`, `l`, `v` | sphere | 1 |
///
/// Returns the product in 1/sr, at least 0. It is symmetric in the directions, and continuous: 0 where one is not
/// above the horizon.
#[kernel(
    family = "brdf",
    cite = "[CookTorrance82]",
    domain(normal = unit, light = unit, view = unit),
    budget(
        surface_error(material, normal, light, view)
    ),
    measured
)]
pub fn surface_transfer(material: Material, normal: Vec3, light: Vec3, view: Vec3) -> Vec3 {
    let n_dot_l = dot(normal, light);
    let n_dot_v = dot(normal, view);
    let glossy = 0.25
        * smith_g2(n_dot_l, n_dot_v, material.alpha)
        * ggx_ndf_between(normal, light, view, material.alpha);
    let fresnel = fresnel_schlick_between(material.f0, material.f90, light, view);
    lambert_brdf(material.diffuse_albedo) * (max(n_dot_l, 0.0) * max(n_dot_v, 0.0)) + fresnel * glossy
}

/// Reflectance of a surface times the light's cosine, seen from above.
///
/// `f (n·l)⁺`
/// Source: [CookTorrance82], by [`surface_transfer`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `material` | the surface | alpha 0.02 ..= 1 | 1 |
/// | `normal`, `light`, `view` | unit vectors `n`, `l`, `v` | sphere | 1 |
///
/// Returns the product in 1/sr, at least 0; 0 where a direction is not above the horizon. The view's cosine is held
/// at 1e-4 below the line, so that seen from there on it fades.
#[kernel(
    family = "brdf",
    cite = "[CookTorrance82]",
    domain(normal = unit, light = unit, view = unit),
    budget(
        surface_error(material, normal, light, view) / max(dot(normal, view), 1e-4)
    ),
    measured
)]
pub fn surface_brdf_cosine(material: Material, normal: Vec3, light: Vec3, view: Vec3) -> Vec3 {
    surface_transfer(material, normal, light, view) / max(dot(normal, view), 1e-4)
}

/// Reflectance of a surface.
///
/// `f = albedo/π + D V F`
/// Source: [CookTorrance82], by [`lambert_brdf`] and [`microfacet_brdf`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `material` | the surface | alpha 0.02 ..= 1 | 1 |
/// | `normal`, `light`, `view` | unit vectors `n`, `l`, `v` | sphere | 1 |
///
/// Returns the reflectance in 1/sr, at least 0; 0 where a direction is not above the horizon. There it jumps:
/// [`surface_transfer`] does not.
#[kernel(
    family = "brdf",
    cite = "[CookTorrance82]",
    domain(normal = unit, light = unit, view = unit),
    budget(
        (6e-6 + 2e-6 / material.alpha + 1.5e-6 * smith_visibility(dot(normal, light), dot(normal, view), material.alpha)
            + select(0.0, 10.0, min(dot(normal, light), dot(normal, view)) < 1e-6))
            * smith_visibility(dot(normal, light), dot(normal, view), material.alpha)
            * ggx_ndf_between(normal, light, view, material.alpha)
            * max(largest(material.f0), material.f90)
            + 2e-7 + select(0.0, 0.4, min(dot(normal, light), dot(normal, view)) < 1e-6)
    ),
    measured
)]
pub fn surface_brdf(material: Material, normal: Vec3, light: Vec3, view: Vec3) -> Vec3 {
    let is_seen = dot(normal, light) > 0.0 && dot(normal, view) > 0.0;
    let diffuse = select(Vec3::ZERO, lambert_brdf(material.diffuse_albedo), is_seen);
    diffuse + microfacet_brdf(material.f0, material.f90, material.alpha, normal, light, view)
}

/// The glossy lobe of a material alone.
#[kernel]
pub fn glossy_part(material: Material) -> Material {
    Material { diffuse_albedo: Vec3::ZERO, f0: material.f0, f90: material.f90, alpha: material.alpha }
}
