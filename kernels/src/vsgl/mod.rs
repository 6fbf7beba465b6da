//! Virtual point lights, spherical lights and spherical-Gaussian lights.
//!
//! Indirect light out of a reflective shadow map, by two papers.
//!
//! [Tokuyoshi15] makes a light of each sampled texel, and weighs it by the cone that it fills:
//!
//! 1. sample: [`brsm_pdf`] chooses texels, [`vsl_mip_level`] the level at which they are read,
//!    [`brsm_weight`] weighs them, [`vsl_radius`] makes a radius of the filtered positions (`sample`);
//! 2. shade: [`vsgl_pair_radiance`] for each pair of the light's and the surface's lobes,
//!    [`vsgl_pair_radiance_diffuse`] for a surface whose lobe is constant (`triple`, by the cone of `cone`);
//! 3. reduce the bias: where [`vsgl_smoothness`] is small, [`vsl_radiance`] of the reflectances themselves
//!    takes the place of the lobes ([`vsgl_reduce_bias`]; `vsl`).
//!
//! [Tokuyoshi15b] makes two lights of the whole map, one of its diffuse and one of its glossy reflection.
//! That is faster, and knows no more of the map than means and variances:
//!
//! 1. filter the map: [`moments_of_position`], [`moments_of_lobe`], [`moments_merge4`] of
//!    [`filter`](crate::filter);
//! 2. make the light: [`vsgl_from_moments`] (`light`);
//! 3. shade: [`vsgl_diffuse`] (`shade`), [`vsgl_specular`] with the slow factors at [`vsgl_specular_axis`]
//!    (`specular`). [`vsgl_light`] is the radiance that they take, [`vsgl_incoming`] the same as one lobe (`radiance`).
//!
//! Conventions: weights are scalars (luminances of power times reflectance); for colour, scale the result by
//! the ratio of the coloured sum to the scalar one. Directions point from the shaded position to the light; a
//! light's own axis points the way that it sends. Variances are those along one axis, which is half the trace
//! for positions on a plane; [`vsl_radius`] is the one that takes the trace. Nothing is shadowed.
//!
//! [`moments_of_position`]: crate::filter::moments_of_position
//! [`moments_of_lobe`]: crate::filter::moments_of_lobe
//! [`moments_merge4`]: crate::filter::moments_merge4

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Tokuyoshi15, Tokuyoshi15b};

mod budget;
mod cone;
mod light;
mod radiance;
mod sample;
mod shade;
mod specular;
mod triple;
mod vsl;

pub use budget::{asg_sg_sg_budget, vsgl_budget, vsgl_larger, vsgl_shift_budget};
pub use cone::{Cone, LN_2, vsl_cone, vsl_cone_paper, vsl_window};
pub use light::{Vsgl, vsgl_from_moments, vsgl_from_moments_paper, vsgl_intensity};
pub use radiance::{
    VsglLight, vsgl_distance2, vsgl_extent_sharpness, vsgl_incoming, vsgl_incoming_paper, vsgl_light,
    vsgl_region, vsgl_variance,
};
pub use sample::{brsm_pdf, brsm_texel_pdf, brsm_weight, vsl_mip_level, vsl_radius};
pub use shade::{vsgl_diffuse, vsgl_diffuse_paper};
pub use specular::{vsgl_specular, vsgl_specular_axis};
pub use triple::{
    asg_sg_sg_product_integral, product_components, vsgl_pair_radiance, vsgl_pair_radiance_diffuse,
};
pub use vsl::{
    vpl_radiance, vpl_transfer, vsgl_reduce_bias, vsgl_smoothness, vsgl_transfer_sharpness, vsl_radiance,
};
