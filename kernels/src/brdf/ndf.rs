//! Distributions of normals.

use crate::constants::INVERSE_PI;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{RectGlossy, Walter07};
use lobe_codegen::prelude::*;

/// GGX (Trowbridge-Reitz) distribution of normals.
///
/// `D = alpha² / (π ((n·h)² (alpha² - 1) + 1)²)`
/// Source: [Walter07] eq. 33, with `1 - (n·h)² = |n x h|²`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal` | unit normal `n` | sphere | 1 |
/// | `half_vector` | unit half vector `h` | sphere | 1 |
/// | `alpha` | width | 1e-3 ..= 1 | 1 |
///
/// Returns the density in 1/sr, in 0 ..= 1/(π alpha²). It does not tell `h` from `-h`.
///
/// Numerics: near the peak `1 - (n·h)²` cancels, and the printed form loses all digits at a width of 1e-3
/// ([`ggx_ndf_paper`]). The cross product is that with the chord `h - n`, which is exact near the peak.
#[kernel(
    family = "brdf",
    cite = "[Walter07] eq. 33",
    domain(normal = unit, half_vector = unit, alpha = 1e-3..=1.0),
    budget((4e-6 + 1e-6 * max(-dot(normal, half_vector), 0.0) / alpha) * result + 1e-12 / (alpha * alpha) * max(-dot(normal, half_vector), 0.0)),
    measured
)]
pub fn ggx_ndf(normal: Vec3, half_vector: Vec3, alpha: f32) -> f32 {
    let sine = cross(normal, half_vector - normal);
    let cosine = dot(normal, half_vector);
    let width = alpha / max(dot(sine, sine) + (alpha * alpha) * (cosine * cosine), 1e-12);
    INVERSE_PI * (width * width)
}

/// GGX distribution of normals, out of the cosine.
///
/// `D = alpha² / (π (1 - (1 - alpha²) c²)²)`
/// Source: [RectGlossy] eq. 16, as `alpha² / (π ((1 - c)(1 + c) + alpha² c²)²)`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `cosine` | `c = n·h` | 0 ..= 1 | 1 |
/// | `alpha` | width | 1e-3 ..= 1 | 1 |
///
/// Returns the density in 1/sr, in 0 ..= 1/(π alpha²).
///
/// Numerics: exact for the cosine that is given. A cosine of two vectors is itself off by 1e-7, which costs
/// `1e-7/alpha²` of the peak: prefer [`ggx_ndf`].
#[kernel(
    family = "brdf",
    cite = "[RectGlossy] eq. 16",
    domain(cosine = 0.0..=1.0, alpha = 1e-3..=1.0),
    budget(3e-6 * result),
    measured
)]
pub fn ggx_ndf_cosine(cosine: f32, alpha: f32) -> f32 {
    let width = alpha / max((1.0 - cosine) * (1.0 + cosine) + (alpha * alpha) * (cosine * cosine), 1e-12);
    INVERSE_PI * (width * width)
}

/// GGX distribution of normals out of the cosine, as printed.
///
/// Source: [RectGlossy] eq. 16. Arguments, domain and result as of [`ggx_ndf_cosine`].
///
/// Numerics: `1 - (1 - alpha²) c²` cancels near the peak: in f32 it is off by 88 % at a width of 1e-3, by 5e-3
/// at 0.01, by 6e-5 at 0.1.
#[kernel(
    family = "brdf",
    cite = "[RectGlossy] eq. 16",
    domain(cosine = 0.0..=1.0, alpha = 1e-3..=1.0),
    budget(3e-6 * result),
    variant_of = ggx_ndf_cosine,
    not_robust = "1 - (1 - alpha²) c² cancels near the peak",
    measured
)]
pub fn ggx_ndf_paper(cosine: f32, alpha: f32) -> f32 {
    let squared = alpha * alpha;
    let falloff = 1.0 - (1.0 - squared) * (cosine * cosine);
    INVERSE_PI * squared / (falloff * falloff)
}

/// GGX distribution of normals at the half vector of two directions.
///
/// `D(h)`, `h = (l + v)/|l + v|`; with `s = l + v`: `D = (alpha |s|² / (|n x s|² + alpha² (n·s)²))² / π`
/// Source: [Walter07] eq. 33.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal` | unit normal `n` | sphere | 1 |
/// | `light`, `view` | unit directions `l`, `v` | sphere | 1 |
/// | `alpha` | width | 0.02 ..= 1 | 1 |
///
/// Returns the density in 1/sr, in 0 ..= 1/(π alpha²); 0 for opposite directions, which have no half vector.
///
/// Numerics: no root and no quotient before the last one. The sum is rounded, which turns the half vector by
/// up to 1e-7; a lobe of width `alpha` feels `1e-7/alpha` of that, which no form avoids. Where rounding is all that
/// is left of the sum, the width is held at the peak's.
#[kernel(
    family = "brdf",
    cite = "[Walter07] eq. 33",
    domain(normal = unit, light = unit, view = unit, alpha = 0.02..=1.0),
    budget((4e-6 + 2e-6 / alpha) * result + 1e-11),
    measured
)]
pub fn ggx_ndf_between(normal: Vec3, light: Vec3, view: Vec3, alpha: f32) -> f32 {
    let sum = light + view;
    let sine = cross(normal, sum);
    let cosine = dot(normal, sum);
    let falloff = dot(sine, sine) + (alpha * alpha) * (cosine * cosine);
    let width = min(alpha * (dot(sum, sum) / max(falloff, 1e-24)), 1.0 / alpha);
    INVERSE_PI * (width * width)
}

/// Beckmann distribution of normals.
///
/// `D = exp(-tan²θ/alpha²) / (π alpha² cos⁴θ)`
/// Source: [Walter07] eq. 25, with `tan²θ = |n x h|²/(n·h)²`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal` | unit normal `n` | sphere | 1 |
/// | `half_vector` | unit half vector `h` | sphere | 1 |
/// | `alpha` | width | 1e-3 ..= 1 | 1 |
///
/// Returns the density in 1/sr, at least 0. It does not tell `h` from `-h`.
///
/// Numerics: the tangent is built of the chord `h - n`, as in [`ggx_ndf`]. Where the exponential is below
/// 1e-43 it is taken there, so that the quotient cannot be 0/0 at the horizon.
#[kernel(
    family = "brdf",
    cite = "[Walter07] eq. 25",
    domain(normal = unit, half_vector = unit, alpha = 1e-3..=1.0),
    budget(
        (6e-6 + 7e-6 * beckmann_exponent(normal, half_vector, alpha)
            + (2e-6 * sqrt(beckmann_exponent(normal, half_vector, alpha)) / alpha + 1e-12 / (alpha * alpha))
            * max(-dot(normal, half_vector), 0.0)) * result + 1e-24 / (alpha * alpha)
    ),
    measured
)]
pub fn beckmann_ndf(normal: Vec3, half_vector: Vec3, alpha: f32) -> f32 {
    let cosine = dot(normal, half_vector);
    let squared = max(cosine * cosine, 1e-4);
    let falloff = exp(-beckmann_exponent(normal, half_vector, alpha));
    INVERSE_PI / (alpha * alpha) * (falloff / (squared * squared))
}

/// The exponent of [`beckmann_ndf`], `tan²θ/alpha²`, up to 100.
///
/// Source: [Walter07] eq. 25. Arguments and domain as of [`beckmann_ndf`].
///
/// Returns the exponent, in 0 ..= 100.
#[kernel(
    family = "brdf",
    cite = "[Walter07] eq. 25",
    domain(normal = unit, half_vector = unit, alpha = 1e-3..=1.0),
    budget(6e-6 * result + (2e-6 * sqrt(result) / alpha + 1e-12 / (alpha * alpha)) * max(-dot(normal, half_vector), 0.0) + 1e-30),
    measured
)]
pub fn beckmann_exponent(normal: Vec3, half_vector: Vec3, alpha: f32) -> f32 {
    let sine = cross(normal, half_vector - normal);
    let cosine = dot(normal, half_vector);
    // At a squared cosine of 1e-4 and a width of 1 the exponent is 1e4, far beyond where it ends.
    let tangent = dot(sine, sine) / max(cosine * cosine, 1e-4);
    min(tangent / (alpha * alpha), 100.0)
}
