//! The radiance that comes from a spherical-Gaussian light.

use super::Vsgl;
use super::budget::{vsgl_larger, vsgl_shift_budget};
use crate::constants::TWO_PI;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Tokuyoshi15b, Xu14};
use crate::sg::{Sg, sg_product};
use lobe_codegen::prelude::*;

/// Incoming radiance `(1 + sharpness) density e^log_shift G(w; axis, sharpness)`.
#[kernel]
pub struct VsglLight {
    /// Unit axis, towards the light; shorter where the light faces away.
    #[domain(unit)]
    pub axis: Vec3,
    /// Sharpness; without limit for a point light.
    #[domain(0.0..=1e6)]
    pub sharpness: f32,
    /// Of extent against emission, at most 0.
    #[domain(-10.0..=0.0)]
    pub log_shift: f32,
    /// Radiance at the peak over `1 + sharpness`, before the shift.
    #[domain(0.0..=1e6)]
    pub density: f32,
}

/// Sharpness of the region that a light fills, seen from a point.
///
/// `D²/σ²`
/// Source: [Tokuyoshi15b] eq. 6.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `mean` | mean of the light's positions | within 1e4 | length |
/// | `variance` | their variance along one axis, `σ²` | 0 ..= 1e4 | length² |
/// | `position` | of the shading point | within 1e4 | length |
///
/// Returns the sharpness, in 0 ..= 1e30.
///
/// Numerics: the variance is no less than 1e-30 of the squared distance `D²`, and 1e-26: so a light without
/// extent has a sharpness.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15b] eq. 6",
    domain(mean = -1e4..=1e4, variance = 0.0..=1e4, position = -1e4..=1e4),
    budget(2e-6 * result + 1e-11),
    measured
)]
pub fn vsgl_extent_sharpness(mean: Vec3, variance: f32, position: Vec3) -> f32 {
    let d2 = vsgl_distance2(mean, position);
    d2 / vsgl_variance(variance, d2)
}

/// Squared distance of a light.
///
/// `D²`. Source: the definition.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `mean` | mean of the light's positions | within 1e4 | length |
/// | `position` | of the shading point | within 1e4 | length |
///
/// Returns the square, in length²; a distance below 1e-15 counts as 0, since its square is none that f32 holds.
#[kernel(
    family = "vsgl",
    cite = "definition",
    domain(mean = -1e4..=1e4, position = -1e4..=1e4),
    budget(1e-6 * result + 1e-36),
    measured
)]
pub fn vsgl_distance2(mean: Vec3, position: Vec3) -> f32 {
    let apart = mean - position;
    max(dot(apart, apart) - 1e-30, 0.0)
}

/// Variance of a light's positions, with the floor that keeps a point light's sharpness finite.
///
/// `max(σ², 1e-30 D², 1e-26)`. Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `variance` | `σ²` | 0 ..= 1e4 | length² |
/// | `d2` | squared distance of the light, `D²` | 0 ..= 1e9 | length² |
///
/// Returns the variance, at least 1e-26.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15b] eq. 6",
    domain(variance = 0.0..=1e4, d2 = 0.0..=1e9),
    budget(2e-7 * result),
    measured
)]
pub fn vsgl_variance(variance: f32, d2: f32) -> f32 {
    max(variance, max(1e-30 * d2, 1e-26))
}

/// Product of the region that a light fills with its emission, amplitude 1 each.
///
/// `G(w; ξ_μ, D²/σ²) G(w; -ξ_v, k)`
/// Source: [Tokuyoshi15b] eq. 6, 7, by [`sg_product`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `light` | the light | within 1e4, variance 0 ..= 1e4, sharpness 0 ..= 1e6 | length |
/// | `position` | of the shading point | within 1e4 | length |
///
/// Returns the lobe, its log amplitude at most 0. At the light's own mean the region has sharpness 0.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15b] eq. 6, 7",
    domain(position = -1e4..=1e4),
    budget(
        axis = 4e-6 + 1e-5 * vsgl_larger(light, position) / max(result.sharpness, 1e-6 * vsgl_larger(light, position)),
        sharpness = 8e-6 * vsgl_larger(light, position) + 1e-11,
        log_amplitude = vsgl_shift_budget(light, position, result.log_amplitude)
    ),
    measured
)]
pub fn vsgl_region(light: Vsgl, position: Vec3) -> Sg {
    let d2 = vsgl_distance2(light.mean, position);
    let region = Sg {
        axis: (light.mean - position) / max(sqrt(d2), 1e-15),
        sharpness: d2 / vsgl_variance(light.variance, d2),
        log_amplitude: 0.0,
    };
    sg_product(region, Sg { axis: -light.axis, sharpness: light.sharpness, log_amplitude: 0.0 })
}

/// Radiance that comes from a light.
///
/// `L(w) = c/(2πσ²) G(w; ξ_μ, D²/σ²) G(w; -ξ_v, k) = c_in G(w; ξ_in, k_in)`
/// Source: [Tokuyoshi15b] eq. 7.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `light` | the light | within 1e4, variance 0 ..= 1e4, sharpness 0 ..= 1e6, intensity 0 ..= 1e6 | length |
/// | `position` | of the shading point | within 1e4 | length |
///
/// Returns the lobe; `ln c_in` is its log amplitude, since `c_in` itself goes from 0 to beyond any number.
/// For a constant emission the integral is `c/D²`. At the mean itself the extent says nothing of the direction,
/// and the lobe is the emission's, reversed.
///
/// Numerics: `k_in - k - D²/σ²` cancels ([`vsgl_incoming_paper`]): it is 0.16 off at an extent sharpness of 1e6,
/// 14 at 1e8. For shading take [`vsgl_light`], in which a variance of 0 is a point light. An
/// intensity below 1e-30 counts as that.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15b] eq. 7",
    domain(position = -1e4..=1e4),
    budget(
        axis = 4e-6 + 1e-5 * vsgl_larger(light, position) / max(result.sharpness, 1e-6 * vsgl_larger(light, position)),
        sharpness = 8e-6 * vsgl_larger(light, position) + 1e-11,
        log_amplitude = 3e-6 + 5e-7 * abs(result.log_amplitude) + vsgl_shift_budget(light, position, vsgl_region(light, position).log_amplitude)
    ),
    measured
)]
pub fn vsgl_incoming(light: Vsgl, position: Vec3) -> Sg {
    let variance = vsgl_variance(light.variance, vsgl_distance2(light.mean, position));
    let product = vsgl_region(light, position);
    let peak = max(light.intensity, 1e-30) / (TWO_PI * variance);
    Sg { log_amplitude: log(peak) + product.log_amplitude, ..product }
}

/// Radiance that comes from a light, as printed.
///
/// `c_in = c/(2πσ²) e^(k_in - k - D²/σ²)`. Source: [Tokuyoshi15b] eq. 7. Arguments, domain and result as of
/// [`vsgl_incoming`].
///
/// Numerics: the exponent is a difference of large numbers; without extent, or at the light's mean, there is no
/// value.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15b] eq. 7",
    domain(position = -1e4..=1e4),
    budget(
        axis = 4e-6 + 1e-5 * vsgl_larger(light, position) / max(result.sharpness, 1e-6 * vsgl_larger(light, position)),
        sharpness = 8e-6 * vsgl_larger(light, position) + 1e-11,
        log_amplitude = 3e-6 + 5e-7 * abs(result.log_amplitude) + vsgl_shift_budget(light, position, vsgl_region(light, position).log_amplitude)
    ),
    variant_of = vsgl_incoming,
    not_robust = "the exponent is a difference of large numbers, and a light without extent divides by 0",
    measured
)]
pub fn vsgl_incoming_paper(light: Vsgl, position: Vec3) -> Sg {
    let apart = light.mean - position;
    let extent = dot(apart, apart) / light.variance;
    let weighted = extent * normalize(apart) - light.sharpness * light.axis;
    let sharpness = length(weighted);
    Sg {
        axis: weighted / sharpness,
        sharpness,
        log_amplitude: log(light.intensity / (TWO_PI * light.variance))
            + (sharpness - light.sharpness - extent),
    }
}

/// Radiance that comes from a light, in a form that has a limit for point lights.
///
/// `c_in/(1 + k_in) = c e^shift/(2π (σ² + |D² ξ_μ - σ² k ξ_v|))`
/// Source: [Tokuyoshi15b] eq. 7, multiplied through by `σ²`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `light` | the light | within 1e4, variance 0 ..= 1e4, sharpness 0 ..= 1e6, intensity 0 ..= 1e6 | length |
/// | `position` | of the shading point | within 1e4 | length |
///
/// Returns the lobe. For a vanishing variance the density is `c/(2π D²)`, and the lobe's integral the point
/// light's irradiance `c G(-ξ_μ)/D²`.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15b] eq. 7",
    domain(position = -1e4..=1e4),
    budget(
        axis = 4e-6 + 1e-5 * vsgl_larger(light, position) / max(result.sharpness, 1e-6 * vsgl_larger(light, position)),
        sharpness = 8e-6 * vsgl_larger(light, position) + 1e-11,
        log_shift = vsgl_shift_budget(light, position, result.log_shift),
        density = (3e-6 + 7e-6 * vsgl_larger(light, position) / (1.0 + result.sharpness)) * result.density
            + 1e-37 / vsgl_variance(light.variance, vsgl_distance2(light.mean, position)) + 1e-37
    ),
    measured
)]
pub fn vsgl_light(light: Vsgl, position: Vec3) -> VsglLight {
    let variance = vsgl_variance(light.variance, vsgl_distance2(light.mean, position));
    let product = vsgl_region(light, position);
    VsglLight {
        axis: product.axis,
        sharpness: product.sharpness,
        log_shift: product.log_amplitude,
        density: light.intensity / (TWO_PI * (variance * (1.0 + product.sharpness))),
    }
}
