//! Virtual point lights, spherical lights and spherical-Gaussian lights.
//!
//! Two papers. [Tokuyoshi15] makes a light of each sampled texel of a reflective shadow map and weighs it by the
//! cone that it fills: `cone`, `triple`, `vsl`, `sample`. [Tokuyoshi15b] makes two lights of the whole map:
//! `radiance`, `shade`.
//!
//! Weights are scalars (luminances of power times reflectance); for colour, scale the result by the ratio of the
//! coloured sum to the scalar one.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Tokuyoshi15, Tokuyoshi15b};

mod cone;
mod radiance;
mod sample;
mod shade;
mod specular;
mod triple;
mod vsl;

pub use cone::{Cone, LN_2, vsl_cone, vsl_cone_paper, vsl_window};
pub use radiance::{
    Vsgl, VsglLight, vsgl_budget, vsgl_distance2, vsgl_extent_sharpness, vsgl_from_moments,
    vsgl_from_moments_paper, vsgl_incoming, vsgl_incoming_paper, vsgl_intensity, vsgl_larger, vsgl_light,
    vsgl_region, vsgl_shift_budget, vsgl_variance,
};
pub use sample::{brsm_pdf, brsm_texel_pdf, brsm_weight, vsl_mip_level, vsl_radius};
pub use shade::{vsgl_diffuse, vsgl_diffuse_paper};
pub use specular::{vsgl_specular, vsgl_specular_axis};
pub use triple::{
    asg_convolved_at, asg_sg_sg_budget, asg_sg_sg_product_integral, product_components, vsgl_pair_radiance,
    vsgl_pair_radiance_diffuse,
};
pub use vsl::{
    vpl_radiance, vpl_transfer, vsgl_reduce_bias, vsgl_smoothness, vsgl_transfer_sharpness, vsl_radiance,
};
