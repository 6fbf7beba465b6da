//! Reflectance: normal distributions, masking, Fresnel, the model made of them, its lobes, its sampling.
//!
//! | file | what | begin with |
//! |---|---|---|
//! | [`model`] | a [`Material`] whole, or split into the distribution and the rest | [`surface_brdf_cosine`](model::surface_brdf_cosine) |
//! | [`ndf`] | GGX and Beckmann distributions | [`ggx_ndf_between`](ndf::ggx_ndf_between) |
//! | [`visibility`] | masking and shadowing of GGX facets | [`smith_visibility`](visibility::smith_visibility) |
//! | [`fresnel`] | reflectance of a facet | [`fresnel_schlick_between`](fresnel::fresnel_schlick_between) |
//! | [`lobe`] | lobes in place of a distribution | [`asg_ndf_warp`](lobe::asg_ndf_warp), [`sg_ndf_warp`](lobe::sg_ndf_warp) |
//! | [`sampling`] | random directions and their densities | [`orthonormal_frame`](sampling::orthonormal_frame) |
//!
//! To shade with lobes: take the reflection lobe about the mirrored view (`lobe`), multiply the light's lobe
//! with it ([`sg`](crate::sg), [`asg`](crate::asg)), and the result by what the lobe leaves out, evaluated in
//! one direction: [`microfacet_m`](model::microfacet_m) times the light's cosine with lobes of [`lobe`],
//! whose amplitude is the distribution's peak; [`microfacet_reflectance`](model::microfacet_reflectance),
//! which has the peak and the light's cosine, with lobes of amplitude 1, as
//! [`vsgl_specular`](crate::vsgl::vsgl_specular) has them.
//!
//! Conventions: `normal`, `light` and `view` are unit vectors that point away from the surface; `alpha` is
//! the width of the distribution as the equations have it, the square of what artists call roughness; a
//! surface reflects on the side of its normal only. Reflectances are linear RGB. Local directions have the
//! normal along `z`; densities are per solid angle.

pub mod budget;
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
