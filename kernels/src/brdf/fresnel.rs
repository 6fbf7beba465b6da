//! Reflectance of a facet.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Schlick94;
use lobe_codegen::prelude::*;

/// Fresnel reflectance of a facet, approximated.
///
/// `F = F0 + (F90 - F0) (1 - v·h)⁵`
/// Source: [Schlick94] eq. 15, with a reflectance at grazing incidence.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `f0` | reflectance at normal incidence, linear RGB | 0 ..= 1 | 1 |
/// | `f90` | that at grazing incidence | 0 ..= 1 | 1 |
/// | `cosine` | `v·h`; a negative one counts as 0 | -1 ..= 1 | 1 |
///
/// Returns the reflectance, between `f0` and `f90`.
///
/// Numerics: as a mean of the two reflectances, so that nothing cancels.
#[kernel(
    family = "brdf",
    cite = "[Schlick94] eq. 15",
    domain(f0 = 0.0..=1.0, f90 = 0.0..=1.0, cosine = -1.0..=1.0),
    budget(8e-7 * max(max(f0.x, f0.y), f0.z) + 1e-6 * f90 + 1e-37),
    measured
)]
pub fn fresnel_schlick(f0: Vec3, f90: f32, cosine: f32) -> Vec3 {
    let down = 1.0 - clamp(cosine, 0.0, 1.0);
    let squared = down * down;
    let grazing = squared * squared * down;
    f0 * (1.0 - grazing) + Vec3::splat(f90 * grazing)
}

/// Fresnel reflectance, approximated, of a facet that reflects one direction into another.
///
/// [`fresnel_schlick`] with `v·h = |l + v|/2`, `h` being the half vector.
/// Source: [Schlick94] eq. 15.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `f0` | reflectance at normal incidence, linear RGB | 0 ..= 1 | 1 |
/// | `f90` | that at grazing incidence | 0 ..= 1 | 1 |
/// | `light`, `view` | unit directions `l`, `v` | sphere | 1 |
///
/// Returns the reflectance, between `f0` and `f90`.
#[kernel(
    family = "brdf",
    cite = "[Schlick94] eq. 15",
    domain(f0 = 0.0..=1.0, f90 = 0.0..=1.0, light = unit, view = unit),
    budget(1e-6 * max(max(f0.x, f0.y), f0.z) + 4e-6 * f90 + 1e-37),
    measured
)]
pub fn fresnel_schlick_between(f0: Vec3, f90: f32, light: Vec3, view: Vec3) -> Vec3 {
    let sum = light + view;
    fresnel_schlick(f0, f90, 0.5 * sqrt(dot(sum, sum)))
}
