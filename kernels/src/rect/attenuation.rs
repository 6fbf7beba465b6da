//! How the reflected light falls off around the specular peak.

use crate::rect::angle::arctangent;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::RectGlossy;
use lobe_codegen::prelude::*;

/// Angle between the rectangle's normal and the half vector, at a place seen under the angle `theta` from the peak.
///
/// `ψ(θ) = θ/2`
/// Source: the geometry; exact within the plane of incidence. [RectGlossy] eq. 24 is [`rect_psi_paper`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `theta` | angle at the shaded position between peak and place | 0 ..= π/2 | rad |
///
/// Returns the angle in rad. Across the plane of incidence it is `θ/(2 cos σ)` to first order.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 24",
    domain(theta = 0.0..=1.5707963267948966),
    budget(1e-7 * result + 1e-37),
    measured
)]
pub fn rect_psi(theta: f32) -> f32 {
    0.5 * theta
}

/// Angle between the rectangle's normal and the half vector, as printed.
///
/// `ψ(θ) = -σ/2 + atan(sec² σ tan θ + tan σ)/2 = atan2(tan θ, 1 + tan σ tan θ)/2`
/// Source: [RectGlossy] eq. 24; the second form is the same without the difference.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `tan_theta` | tangent of the angle at the shaded position | 0 ..= 1e7 | 1 |
/// | `tan_sigma` | tangent of the light's angle of incidence | 0 ..= 1e4 | 1 |
///
/// Returns the angle in rad. It is `θ/2` only for light along the normal: the distance that the derivation takes
/// for `tan θ/cos σ` is `1 + tan σ tan θ` times as long.
///
/// Numerics: it takes tangents, since a driver's sine of an angle may err by 2^-11, and has an arc tangent of its
/// own. The printed difference loses 6e-3 of small angles.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 24",
    domain(tan_theta = 0.0..=1e7, tan_sigma = 0.0..=1e4),
    budget(1.5e-6 * result + 1e-30),
    variant_of = rect_psi,
    measured
)]
pub fn rect_psi_paper(tan_theta: f32, tan_sigma: f32) -> f32 {
    0.5 * arctangent(tan_theta, 1.0 + tan_sigma * tan_theta)
}

/// Falloff of the reflected radiance around the specular peak, `D(ψ)/D(0)` of the GGX distribution, `ψ = θ/2`.
///
/// `f(θ) = m⁴/(1 - (1 - m²) cos² ψ)²`
/// Source: [RectGlossy] eq. 23 with the exact angle of [`rect_psi`], as `(m²/(sin² ψ + m² cos² ψ))²`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `tan_theta` | tangent of the angle at the shaded position between peak and place, `tan 2ψ` | 0 ..= 1e7 | 1 |
/// | `alpha` | GGX alpha `m` of the rectangle | 0.001 ..= 1 | 1 |
///
/// Returns the falloff, in 0 ..= 1; 1 at the peak.
///
/// Numerics: the printed denominator cancels for a smooth rectangle. `sin² ψ` comes from the tangent of the double
/// angle by a root, `tan² θ/(2 (1 + tan² θ + √(1 + tan² θ)))`.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 23",
    domain(tan_theta = 0.0..=1e7, alpha = 0.001..=1.0),
    budget(6e-6 * result),
    measured
)]
pub fn rect_falloff(tan_theta: f32, alpha: f32) -> f32 {
    let secant_squared = 1.0 + tan_theta * tan_theta;
    let sine_squared = 0.5 * (tan_theta * tan_theta / (secant_squared + sqrt(secant_squared)));
    let alpha_squared = alpha * alpha;
    let cosine_squared = max(1.0 - sine_squared, 0.5);
    let ratio = alpha_squared / max(sine_squared + alpha_squared * cosine_squared, 1e-12);
    ratio * ratio
}

/// Falloff of the reflected radiance around the specular peak, as printed.
///
/// Source: [RectGlossy] eq. 23 with the angle of eq. 24 ([`rect_psi_paper`]), of which
/// `tan 2ψ = tan θ/(1 + tan σ tan θ)`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `tan_theta` | tangent of the angle at the shaded position between peak and place | 0 ..= 1e7 | 1 |
/// | `tan_sigma` | tangent of the light's angle of incidence | 0 ..= 1e4 | 1 |
/// | `alpha` | GGX alpha of the rectangle | 0.001 ..= 1 | 1 |
///
/// Returns the falloff, in 0 ..= 1. Too wide for slanting light: at σ = 72° it falls to a floor, since its `ψ` does
/// not exceed `(90° - σ)/2`.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 23, 24",
    domain(tan_theta = 0.0..=1e7, tan_sigma = 0.0..=1e4, alpha = 0.001..=1.0),
    budget(8e-6 * result),
    variant_of = rect_falloff,
    measured
)]
pub fn rect_falloff_paper(tan_theta: f32, tan_sigma: f32, alpha: f32) -> f32 {
    rect_falloff(tan_theta / max(1.0 + tan_sigma * tan_theta, 1.0), alpha)
}

/// Exponent of the falloff's fit.
///
/// `k = 0.288 cos σ/m² - 0.673`
/// Source: [RectGlossy] eq. 25.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `cos_sigma` | cosine of the light's angle of incidence | 1e-3 ..= 1 | 1 |
/// | `alpha` | GGX alpha `m` of the rectangle | 0.001 ..= 1 | 1 |
///
/// Returns the exponent, at least -0.673: it passes zero at `m = 0.654 √cos σ`, so that nothing may divide by it.
/// For light along the normal the least squares would have 0.36 in place of 0.288.
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 25",
    domain(cos_sigma = 1e-3..=1.0, alpha = 0.001..=1.0),
    budget(1e-6 * abs(result) + 1e-6),
    measured
)]
pub fn rect_attenuation(cos_sigma: f32, alpha: f32) -> f32 {
    0.288 * cos_sigma / max(alpha * alpha, 1e-12) - 0.673
}

/// Fit of the falloff that can be integrated.
///
/// `f(θ) ≈ exp(-k sin² θ) cos θ`
/// Source: [RectGlossy] eq. 25, with `k` of [`rect_attenuation`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `tan_theta` | tangent of the angle at the shaded position between peak and place | 0 ..= 1e7 | 1 |
/// | `cos_sigma` | cosine of the light's angle of incidence | 1e-3 ..= 1 | 1 |
/// | `alpha` | GGX alpha of the rectangle | 0.001 ..= 1 | 1 |
///
/// Returns the falloff, in 0 ..= 1.025.
///
/// Largest distance over 0 ..= π/2 to [`rect_falloff_paper`], for which it was made, and to [`rect_falloff`]:
///
/// | σ, m | `rect_falloff_paper` | `rect_falloff` |
/// |---|---|---|
/// | π/6, 0.1 | 0.120 | 0.163 |
/// | 2π/5, 0.1 | 0.196 | 0.455 |
/// | π/6, 0.7 | 0.630 | 0.433 |
/// | 2π/5, 0.7 | 0.951 | 0.433 |
#[kernel(
    family = "rect",
    cite = "[RectGlossy] eq. 25",
    domain(tan_theta = 0.0..=1e7, cos_sigma = 1e-3..=1.0, alpha = 0.001..=1.0),
    budget(3e-6),
    measured
)]
pub fn rect_falloff_fit(tan_theta: f32, cos_sigma: f32, alpha: f32) -> f32 {
    let secant_squared = 1.0 + tan_theta * tan_theta;
    let sine_squared = tan_theta * tan_theta / secant_squared;
    exp(-rect_attenuation(cos_sigma, alpha) * sine_squared) * inverse_sqrt(secant_squared)
}
