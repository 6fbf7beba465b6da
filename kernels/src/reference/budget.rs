//! Scales that the budgets are stated in. No kernel computes with them.

use crate::brdf::Material;
use crate::brdf::budget::{largest, surface_error};
use crate::brdf::model::{surface_brdf_cosine, surface_transfer};
use crate::brdf::ndf::ggx_ndf_between;
use crate::brdf::sampling::{ggx_half_vector_pdf, ggx_visible_normal_pdf};
#[allow(unused_imports, reason = "the documentation links to it")]
use crate::reference::one_bounce::one_bounce_transfer;
use crate::reference::one_bounce::{OneBounce, one_bounce_density};
use lobe_codegen::prelude::*;

/// The permitted error of [`one_bounce_transfer`]: the product's, out of those of its factors.
#[kernel]
pub fn transfer_error(bounce: OneBounce, dir: Vec3) -> f32 {
    let receiver_error = surface_error(bounce.material, bounce.normal, dir, bounce.view);
    let reflector_error =
        surface_error(bounce.rectangle_material, bounce.rectangle.normal, bounce.light, -dir);
    0.6 * product_error(bounce, dir, receiver_error, reflector_error)
}

/// The same for a direction that was itself computed.
#[kernel]
pub fn turned_transfer_error(bounce: OneBounce, dir: Vec3) -> f32 {
    let normal = bounce.rectangle.normal;
    let receiver_error = surface_error(bounce.material, bounce.normal, dir, bounce.view)
        + turn_error(bounce.material, bounce.normal, dir, bounce.view);
    let reflector_error = surface_error(bounce.rectangle_material, normal, bounce.light, -dir)
        + turn_error(bounce.rectangle_material, normal, bounce.light, -dir);
    1.5 * product_error(bounce, dir, receiver_error, reflector_error)
}

/// What turning a direction by 3e-7 does to [`surface_transfer`]: the half vector of nearly opposite directions
/// turns by more.
#[kernel]
pub fn turn_error(material: Material, normal: Vec3, light: Vec3, view: Vec3) -> f32 {
    let squared = dot(light + view, light + view);
    let alpha = material.alpha;
    let turned =
        1e-6 / alpha * inverse_sqrt(max(squared, 1e-12)) * ggx_ndf_between(normal, light, view, alpha);
    let grazing = select(0.0, 1.5e-6 / (alpha * alpha * alpha), squared < 1e-6);
    max(largest(material.f0), material.f90) * (turned + grazing)
}

/// The error of the product of the receiver's and the reflector's part.
#[kernel]
pub fn product_error(bounce: OneBounce, dir: Vec3, receiver_error: f32, reflector_error: f32) -> f32 {
    let receiver = largest(surface_brdf_cosine(bounce.material, bounce.normal, dir, bounce.view));
    let error = receiver_error / max(dot(bounce.normal, bounce.view), 1e-4);
    let reflector =
        largest(surface_transfer(bounce.rectangle_material, bounce.rectangle.normal, bounce.light, -dir));
    (receiver + error) * reflector_error + error * reflector + 1e-6 * receiver * reflector
}

/// The permitted error of [`one_bounce_density`].
#[kernel]
pub fn density_error(bounce: OneBounce, dir: Vec3, dist: f32) -> f32 {
    let alpha = bounce.material.alpha;
    let normal = bounce.rectangle.normal;
    let material = bounce.rectangle_material;
    let sum = bounce.light - dir;
    let by_light = ggx_half_vector_pdf(material.alpha, normal, -dir, bounce.light)
        + 2.0
            * ggx_ndf_between(normal, bounce.light, -dir, material.alpha)
            * inverse_sqrt(max(dot(sum, sum), 1e-6));
    let by_normal = ggx_visible_normal_pdf(alpha, bounce.normal, dir, bounce.view);
    (4e-6 + 1.2e-6 / alpha + 1.2e-6 / material.alpha) * one_bounce_density(bounce, dir, dist)
        + 6e-8 * (1.0 + by_normal + by_light)
}

/// The least that a driver may find for [`one_bounce_density`]: its share by area has no cosine that could vanish.
#[kernel]
pub fn least_density(bounce: OneBounce, dir: Vec3, dist: f32) -> f32 {
    let by_area = (dist / bounce.rectangle.half_x) * (dist / bounce.rectangle.half_y);
    let lowered = one_bounce_density(bounce, dir, dist) - density_error(bounce, dir, dist);
    max(max(lowered, 0.06 * by_area), 1e-20)
}
