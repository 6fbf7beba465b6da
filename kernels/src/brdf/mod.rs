//! Reflectance: normal distributions, masking, Fresnel, the model made of them, its lobes, its sampling.
//!
//! Conventions: `normal`, `light` and `view` are unit vectors that point away from the surface; `alpha` is the
//! width of the distribution as the equations have it, the square of what artists call roughness; a surface
//! reflects on the side of its normal only.

pub mod fresnel;
pub mod lobe;
pub mod model;
pub mod ndf;
pub mod sampling;
pub mod visibility;

use lobe_codegen::prelude::*;

/// A diffuse and a glossy lobe over each other, linear RGB.
#[kernel]
pub struct Material {
    /// Share of the light that the diffuse lobe reflects.
    #[domain(0.0..=1.0)]
    pub diffuse_albedo: Vec3,
    /// Reflectance of the glossy lobe's facets at normal incidence.
    #[domain(0.0..=1.0)]
    pub f0: Vec3,
    /// Theirs at grazing incidence; 0 where there is no glossy lobe.
    #[domain(0.0..=1.0)]
    pub f90: f32,
    /// Width of the GGX distribution, `alpha`.
    #[domain(0.02..=1.0)]
    pub alpha: f32,
}
