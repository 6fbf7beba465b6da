//! Scales that the budgets are stated in. No kernel computes with them.

use crate::brdf::Material;
#[allow(unused_imports, reason = "the documentation links to it")]
use crate::brdf::model::surface_transfer;
use crate::brdf::ndf::ggx_ndf_between;
use lobe_codegen::prelude::*;

/// The permitted error of [`surface_transfer`]: that of the cosines, and that of the distribution.
#[kernel]
pub fn surface_error(material: Material, normal: Vec3, light: Vec3, view: Vec3) -> f32 {
    let lobe = ggx_ndf_between(normal, light, view, material.alpha) * max(largest(material.f0), material.f90);
    5e-7 + (1e-6 + 2e-6 / material.alpha) * lobe
}

/// The largest channel of a colour.
#[kernel]
pub fn largest(colour: Vec3) -> f32 {
    max(max(colour.x, colour.y), colour.z)
}
