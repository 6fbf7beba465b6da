//! Scales that the budgets are stated in. No kernel computes with them.

use super::Vsgl;
#[allow(unused_imports, reason = "the documentation links to it")]
use super::radiance::VsglLight;
use super::radiance::{vsgl_extent_sharpness, vsgl_light};
#[allow(unused_imports, reason = "the documentation links to it")]
use super::triple::asg_sg_sg_product_integral;
use crate::asg::Asg;
#[allow(unused_imports, reason = "the documentation links to it")]
use crate::asg::asg_sg_peak;
use crate::sg::{Sg, sg_product};
use lobe_codegen::prelude::*;

/// The larger sharpness of a light: of the region that it fills or of its emission.
///
/// What the cancellation of the two is measured by. Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `light`, `position` | as of [`vsgl_light`] | as there | as there |
///
/// Returns the sharpness, at least 1e-30.
#[kernel]
pub fn vsgl_larger(light: Vsgl, position: Vec3) -> f32 {
    max(max(vsgl_extent_sharpness(light.mean, light.variance, position), light.sharpness), 1e-30)
}

/// Error permitted to the exponent that the product of a light's region with its emission leaves.
///
/// Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `light`, `position` | as of [`vsgl_light`] | as there | as there |
/// | `shift` | the exponent | -4e6 ..= 0 | 1 |
///
/// Returns the error: relative, and that of the axis towards the light, times the smaller sharpness.
#[kernel]
pub fn vsgl_shift_budget(light: Vsgl, position: Vec3, shift: f32) -> f32 {
    let smaller = min(vsgl_extent_sharpness(light.mean, light.variance, position), light.sharpness);
    1e-7 + 1.1e-5 * abs(shift) + 1.5e-6 * sqrt(abs(shift) * smaller) + 1e-12 * smaller
}

/// Error permitted to what is computed from a light, relative to the integral of its radiance but for 2π.
///
/// Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `light`, `position` | as of [`vsgl_light`] | as there | as there |
/// | `by_axis` | how much the result changes with the axis | 0 ..= 1e5 | 1 |
///
/// Returns the error: [`VsglLight::density`] with its shift, times what the rules permit to the exponent and to
/// the cancellation of extent and emission.
#[kernel]
pub fn vsgl_budget(light: Vsgl, position: Vec3, by_axis: f32) -> f32 {
    let incoming = vsgl_light(light, position);
    let larger = vsgl_larger(light, position);
    let exponent = vsgl_shift_budget(light, position, incoming.log_shift);
    let cancelled = 1.5e-5 * larger / (1.0 + incoming.sharpness);
    let turned = 5e-6 * by_axis * larger / max(incoming.sharpness, 1e-6 * larger);
    (2e-5 + cancelled + turned + exponent) * (incoming.density * exp(incoming.log_shift))
}

/// Relative error permitted to the products of an anisotropic and two isotropic lobes, times their amplitudes.
///
/// Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `asg`, `v`, `l` | the lobes | of [`asg_sg_sg_product_integral`] | 1 |
///
/// Returns the error against [`asg_sg_peak`].
#[kernel]
pub fn asg_sg_sg_budget(asg: Asg, v: Sg, l: Sg) -> f32 {
    let product = sg_product(v, l);
    let largest = max(max(v.sharpness, l.sharpness), 1e-30);
    let roots = 2e-7 * (sqrt(asg.lambda) + sqrt(asg.mu));
    let logs = 4e-6 * abs(product.log_amplitude) + 2e-6 * (abs(v.log_amplitude) + abs(l.log_amplitude));
    let cancelled = 8e-6 * largest / max(product.sharpness, 1e-6 * largest);
    let amplitude = asg.amplitude * exp(product.log_amplitude);
    (1e-5 + roots + logs + cancelled) * amplitude
}
