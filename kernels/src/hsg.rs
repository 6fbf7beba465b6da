//! Spherical Gaussians over a hemisphere, and against the clamped cosine.

use crate::constants::TWO_PI;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Tokuyoshi22;
use crate::sg::{Sg, sg_product_paper};
use crate::special::{erf, expm1_over_x, expm1_over_x_higham, expm1_over_x_slope};
use lobe_codegen::prelude::*;

/// 2/√π, the slope of `erf` at 0.
#[kernel]
pub const ERF_SLOPE: f32 = 1.1283791670955125739;

/// The fitted ratio of [`hsg_steepness`] to the sharpness: constant of the numerator.
#[kernel]
pub const STEEPNESS_A: f32 = 0.65173288269070562;

/// The fitted ratio of [`hsg_steepness`] to the sharpness: linear coefficient of the denominator.
#[kernel]
pub const STEEPNESS_B: f32 = 1.3418280033141288;

/// The fitted ratio of [`hsg_steepness`] to the sharpness: constant of the denominator.
#[kernel]
pub const STEEPNESS_C: f32 = 7.2216687798956709;

/// Sharpness of the lobe that stands for the clamped cosine.
#[kernel]
pub const COSINE_SHARPNESS: f32 = 0.00084560872241480124;

/// Amplitude of the lobe that stands for the clamped cosine.
#[kernel]
pub const COSINE_AMPLITUDE: f32 = 1182.2467339678153;

/// Steepness of the normalised hemispherical integral, over the sharpness.
///
/// `t(k)/k = sqrt((k/2 + a) / ((k + b) k + c))`
/// Source: [Tokuyoshi22] eq. 6.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `sharpness` | `k` | 0 ..= 1e6 | 1 |
///
/// Returns the ratio, in 0 ..= 0.301; `t` approaches `sqrt(k/2)` for sharp lobes.
///
/// Numerics: the sharpness is clamped to 1e9, beyond which its square would overflow at last.
#[kernel(family = "hsg", cite = "[Tokuyoshi22] eq. 6", domain(sharpness = 0.0..=1e6), budget(1e-6 * result), measured)]
pub fn hsg_steepness(sharpness: f32) -> f32 {
    let k = min(sharpness, 1e9);
    sqrt((0.5 * k + STEEPNESS_A) / ((k + STEEPNESS_B) * k + STEEPNESS_C))
}

/// Integral of a spherical Gaussian of amplitude 1 over the hemisphere around its axis.
///
/// `2π (1 - e^(-k)) / k = 2π expm1_over_x(-k)`
/// Source: [Tokuyoshi22] supplement section 2.2; exact.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `sharpness` | `k` | 0 ..= 1e6 | 1 |
///
/// Returns the integral in sr, in 0 ..= 2π; 2π at sharpness 0.
#[kernel(family = "hsg", cite = "[Tokuyoshi22] supplement section 2.2", domain(sharpness = 0.0..=1e6), budget(2e-6 * result), measured)]
pub fn hsg_upper_integral(sharpness: f32) -> f32 {
    TWO_PI * expm1_over_x(-sharpness)
}

/// Twice the share of a spherical Gaussian above a plane, less one: `erf(t c) / erf(t)`.
///
/// Source: [Tokuyoshi22] eq. 5, with `t` = `sharpness` times [`hsg_steepness`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `cosine` | of the angle between the lobe's axis and the plane's normal, `c` | -1 ..= 1 | 1 |
/// | `sharpness` | `k` | 0 ..= 1e6 | 1 |
///
/// Returns the ratio, in -1 ..= 1, with the sign of `c`.
///
/// Numerics: `t` is at least 1e-4, where the ratio is `c` to within 3e-9, as it is for all smaller ones.
#[kernel(family = "hsg", cite = "[Tokuyoshi22] eq. 5", domain(cosine = -1.0..=1.0, sharpness = 0.0..=1e6), budget(6e-6), measured)]
pub fn hsg_ratio(cosine: f32, sharpness: f32) -> f32 {
    let c = clamp(cosine, -1.0, 1.0);
    let t = max(sharpness * hsg_steepness(sharpness), 1e-4);
    clamp(erf(t * c) / erf(t), -1.0, 1.0)
}

/// Integral of a spherical Gaussian of amplitude 1 over a hemisphere.
///
/// `H(c, k) ≈ 2π lerp(e^(-k), 1, s) (1 - e^(-k))/k`, `s = 1/2 + erf(t c) / (2 erf(t))`, `t` of
/// [`hsg_steepness`].
/// Source: [Tokuyoshi22] eq. 5, supplement listing 3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `cosine` | of the angle between the lobe's axis and the hemisphere's, `c` | -1 ..= 1 | 1 |
/// | `sharpness` | `k` | 0 ..= 1e6 | 1 |
///
/// Returns the integral in sr, in 0 ..= 2π. Exact for `c` in -1, 0, 1 and for `k = 0`, where it is 2π; elsewhere
/// within 4.94e-3 of the lobe's integral over the sphere (worst at `k = 7.6`, `c = ±0.66`).
///
/// Numerics: `1 - e^(-k)` is written `k expm1_over_x(-k)`. The budget is stated against the integral over the
/// upper hemisphere, since the value is exponentially small for `c < 0`.
#[kernel(
    family = "hsg",
    cite = "[Tokuyoshi22] eq. 5, supplement listing 3",
    domain(cosine = -1.0..=1.0, sharpness = 0.0..=1e6),
    budget(4e-6 * hsg_upper_integral(sharpness)),
    measured
)]
pub fn hsg_integral(cosine: f32, sharpness: f32) -> f32 {
    let ratio = hsg_ratio(cosine, sharpness);
    let e = expm1_over_x(-sharpness);
    // lerp(e^-k, 1, s) = e^-k + s (1 - e^-k)
    TWO_PI * e * (exp(-sharpness) + (0.5 + 0.5 * ratio) * (sharpness * e))
}

/// Integral of a spherical Gaussian of amplitude 1 over a hemisphere, as printed.
///
/// Source: [Tokuyoshi22] supplement listing 3, with listing 4 for `(1 - e^-k)/k`.
/// Arguments, domain and result as of [`hsg_integral`].
///
/// Numerics: listing 4 needs an accurate logarithm, see [`expm1_over_x_higham`]; at sharpness 0 the
/// quotient of error functions is 0/0.
#[kernel(
    family = "hsg",
    cite = "[Tokuyoshi22] supplement listing 3",
    domain(cosine = -1.0..=1.0, sharpness = 0.0..=1e6),
    budget(4e-6 * hsg_upper_integral(sharpness)),
    variant_of = hsg_integral,
    not_robust = "listing 4 needs a logarithm that is accurate near 1, and 0/0 at sharpness 0",
    measured
)]
pub fn hsg_integral_paper(cosine: f32, sharpness: f32) -> f32 {
    let steepness = sharpness
        * sqrt((0.5 * sharpness + STEEPNESS_A) / ((sharpness + STEEPNESS_B) * sharpness + STEEPNESS_C));
    let s = 0.5 + 0.5 * (erf(steepness * clamp(cosine, -1.0, 1.0)) / erf(steepness));
    TWO_PI * mix(exp(-sharpness), 1.0, s) * expm1_over_x_higham(-sharpness)
}

/// Clamped cosine, as the spherical Gaussian that stands for it.
///
/// `max(cosine, 0) ≈ a (e^(l cosine) - 1)` for `cosine >= 0`, `l` = [`COSINE_SHARPNESS`], `a` =
/// [`COSINE_AMPLITUDE`].
/// Source: [Tokuyoshi22] eq. 3, supplement section 1.1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `cosine` | of the angle to the normal | -1 ..= 1 | 1 |
///
/// Returns the approximation, 0 below the horizon; within -4.7e-5 ..= 1.41e-4 of the clamped cosine.
///
/// Numerics: written `a l cosine expm1_over_x(l cosine)`, since `e^(l cosine) - 1` cancels and the
/// amplitude multiplies what is lost by 1182 ([`clamped_cosine_paper`]).
#[kernel(family = "hsg", cite = "[Tokuyoshi22] eq. 3", domain(cosine = -1.0..=1.0), budget(2e-6 * result + 1e-37), measured)]
pub fn clamped_cosine(cosine: f32) -> f32 {
    let c = max(cosine, 0.0);
    COSINE_AMPLITUDE * COSINE_SHARPNESS * c * expm1_over_x(COSINE_SHARPNESS * c)
}

/// Clamped cosine, as the spherical Gaussian that stands for it, in the printed form.
///
/// Source: [Tokuyoshi22] eq. 3. Arguments, domain and result as of [`clamped_cosine`].
#[kernel(
    family = "hsg",
    cite = "[Tokuyoshi22] eq. 3",
    domain(cosine = -1.0..=1.0),
    budget(2e-6 * result + 1e-37),
    variant_of = clamped_cosine,
    not_robust = "exp(l cosine) - 1 cancels, and the amplitude multiplies the error by 1182",
    measured
)]
pub fn clamped_cosine_paper(cosine: f32) -> f32 {
    COSINE_AMPLITUDE * (exp(COSINE_SHARPNESS * max(cosine, 0.0)) - 1.0)
}

/// Integral of a spherical Gaussian times the clamped cosine.
///
/// `∫ G(w; sg) max(w·n, 0) dw`. The sphere's integral of a lobe times a linear function is a gradient of the
/// lobe's integral; here that of [`hsg_integral`]'s closed form, with `E = expm1_over_x(-k)`, `e = e^-k`,
/// `W = e + k E s` and `E' = (e - E)/k`:
/// `I = 2π (c (W (E + E') + E (k E ds/dk - e (1 - s))) + (1 - c²) E² ds/dc)`.
/// Source: [Tokuyoshi22] section 2, as the limit of its two-lobe difference for a vanishing sharpness of the
/// cosine's lobe; no difference of near values is left.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `sg` | the lobe | sharpness 0 ..= 1e5, log amplitude -4 ..= 4 | 1 |
/// | `normal` | unit normal `n` | sphere | 1 |
///
/// Returns the integral in sr, at least 0; `π exp(log_amplitude)` at sharpness 0. Within 3.7e-3 of the lobe's
/// upper hemispherical integral of the exact value (worst at a sharpness of 5.5).
///
/// Numerics: below a sharpness of 1e-4 the first two terms of the series around 0. The printed form
/// ([`hsg_cosine_product_integral_paper`]) differs by up to 2.2e-4 of the integral, and loses three more digits
/// in f32. The budget is 1e-5 of the lobe's integral over the upper hemisphere.
#[kernel(
    family = "hsg",
    cite = "[Tokuyoshi22] supplement listing 1, gradient form",
    domain(sg.sharpness = 0.0..=1e5, sg.log_amplitude = -4.0..=4.0, normal = unit),
    budget(1e-5 * exp(sg.log_amplitude) * hsg_upper_integral(sg.sharpness)),
    measured
)]
pub fn hsg_cosine_product_integral(sg: Sg, normal: Vec3) -> f32 {
    let amplitude = exp(sg.log_amplitude);
    let k = sg.sharpness;
    let c = clamp(dot(sg.axis, normal), -1.0, 1.0);
    if k < 1e-4 {
        return amplitude * max(0.5 * TWO_PI + k * (TWO_PI / 3.0 * c - 0.5 * TWO_PI), 0.0);
    }
    // The interpolation factor s and its derivatives by c and k.
    let width = hsg_steepness(k);
    let t = k * width;
    let scale = 1.0 / erf(t);
    let ratio = clamp(erf(t * c) * scale, -1.0, 1.0);
    let slope = ERF_SLOPE * scale * exp(-(t * c) * (t * c));
    let s = 0.5 + 0.5 * ratio;
    let s_c = 0.5 * t * slope;
    let s_t = 0.5 * (c * slope - ERF_SLOPE * scale * exp(-t * t) * ratio);
    let numerator = 0.5 * k + STEEPNESS_A;
    let denominator = (k + STEEPNESS_B) * k + STEEPNESS_C;
    let t_k = width * (1.0 + 0.5 * k * (0.5 / numerator - (2.0 * k + STEEPNESS_B) / denominator));

    // The lobe's integral over the upper hemisphere is 2π E.
    let e = exp(-k);
    let upper = expm1_over_x(-k);
    let upper_k = -expm1_over_x_slope(-k);
    let weight = e + k * upper * s;
    let along = weight * (upper + upper_k) + upper * (k * upper * s_t * t_k - e * (1.0 - s));
    let across = max(1.0 - c * c, 0.0) * (upper * upper) * s_c;
    amplitude * max(TWO_PI * (c * along + across), 0.0)
}

/// Integral of a spherical Gaussian times the clamped cosine, as printed.
///
/// Source: [Tokuyoshi22] supplement listing 1 over listings 2 to 5.
/// Arguments, domain and result as of [`hsg_cosine_product_integral`].
///
/// Numerics: the difference of two hemispherical integrals, multiplied by 1182: errors of 1e-7 of each come out
/// as 1e-4 of the result and more; listing 4 adds its own.
#[kernel(
    family = "hsg",
    cite = "[Tokuyoshi22] supplement listing 1",
    domain(sg.sharpness = 0.0..=1e5, sg.log_amplitude = -4.0..=4.0, normal = unit),
    budget(1e-5 * exp(sg.log_amplitude) * hsg_upper_integral(sg.sharpness)),
    variant_of = hsg_cosine_product_integral,
    not_robust = "a difference of near values, multiplied by 1182",
    measured
)]
pub fn hsg_cosine_product_integral_paper(sg: Sg, normal: Vec3) -> f32 {
    let cosine_lobe = Sg { axis: normal, sharpness: COSINE_SHARPNESS, log_amplitude: 0.0 };
    let product = sg_product_paper(Sg { log_amplitude: 0.0, ..sg }, cosine_lobe);
    let p = hsg_integral_paper(dot(product.axis, normal), product.sharpness)
        * exp(COSINE_SHARPNESS + product.log_amplitude);
    let q = hsg_integral_paper(dot(sg.axis, normal), sg.sharpness);
    exp(sg.log_amplitude) * max(COSINE_AMPLITUDE * p - COSINE_AMPLITUDE * q, 0.0)
}
