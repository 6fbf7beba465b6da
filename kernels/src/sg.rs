//! Spherical Gaussians: evaluation, integral, product.

use crate::constants::FOUR_PI;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Iwasaki12, Tokuyoshi22, Wang09};
use crate::special::expm1_over_x;
use lobe_codegen::prelude::*;

/// A spherical Gaussian `G(w) = exp(log_amplitude + sharpness (w·axis - 1))`.
#[kernel]
pub struct Sg {
    /// Unit vector to the peak; the zero vector where products of opposite lobes have no axis.
    #[domain(unit)]
    pub axis: Vec3,
    /// Sharpness, at least 0; 0 is the constant lobe.
    #[domain(0.0..=1e6)]
    pub sharpness: f32,
    /// Natural logarithm of the value at the peak.
    #[domain(-10.0..=10.0)]
    pub log_amplitude: f32,
}

/// Value of a spherical Gaussian in a direction.
///
/// `G(w) = exp(log_amplitude + sharpness (w·axis - 1))`
/// Source: [Wang09] eq. 1, by the chord: `w·v - 1 = -|w - v|²/2`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `dir` | unit direction `w` | sphere | 1 |
/// | `sg` | the lobe | sharpness 0 ..= 1e6, log amplitude -10 ..= 10 | 1 |
///
/// Returns the value, in 0 ..= `exp(log_amplitude)`.
///
/// Numerics: the chord keeps the exponent's relative accuracy near the axis, where `w·v - 1` cancels and
/// [`sg_eval_paper`] loses all digits at a sharpness of 1e6. The budget is stated against the peak.
#[kernel(family = "sg", cite = "[Wang09] eq. 1", domain(dir = unit), budget((1.5e-6 + 5e-7 * abs(sg.log_amplitude)) * exp(sg.log_amplitude)), measured)]
pub fn sg_eval(dir: Vec3, sg: Sg) -> f32 {
    let chord = dir - sg.axis;
    exp(sg.log_amplitude) * exp(-0.5 * sg.sharpness * dot(chord, chord))
}

/// Value of a spherical Gaussian, by the inner product as printed.
///
/// Source: [Wang09] eq. 1. Arguments, domain and result as of [`sg_eval`].
///
/// Numerics: the inner product of unit vectors carries an error of about 2e-7, which the sharpness
/// multiplies.
#[kernel(
    family = "sg",
    cite = "[Wang09] eq. 1",
    domain(dir = unit),
    budget((1.5e-6 + 5e-7 * abs(sg.log_amplitude)) * exp(sg.log_amplitude)),
    variant_of = sg_eval,
    not_robust = "dot(dir, axis) - 1 cancels near the axis, and the sharpness multiplies its error",
    measured
)]
pub fn sg_eval_paper(dir: Vec3, sg: Sg) -> f32 {
    exp(sg.log_amplitude) * exp(sg.sharpness * (dot(dir, sg.axis) - 1.0))
}

/// Integral of a spherical Gaussian of amplitude 1 over the sphere.
///
/// `∫ exp(k (w·v - 1)) dw = 2π (1 - e^(-2k)) / k = 4π expm1_over_x(-2k)`
/// Source: [Wang09] section 3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `sharpness` | `k` | 0 ..= 1e6 | 1 |
///
/// Returns the integral in sr, in 0 ..= 4π; 4π at sharpness 0.
#[kernel(family = "sg", cite = "[Wang09] section 3", domain(sharpness = 0.0..=1e6), budget(2e-6 * result), measured)]
pub fn sg_integral(sharpness: f32) -> f32 {
    FOUR_PI * expm1_over_x(-2.0 * sharpness)
}

/// Product of two spherical Gaussians, which is one.
///
/// With `k3 v3 = k1 v1 + k2 v2`, `|v3| = 1`:
/// `G(w; v1, k1) G(w; v2, k2) = e^(k3 - k1 - k2) G(w; v3, k3)`
/// Source: [Tokuyoshi22] supplement eq. 1, in a form of our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `a`, `b` | the lobes | sharpness 0 ..= 1e6, log amplitude -10 ..= 10 | 1 |
///
/// Returns the product lobe. Where the lobes cancel (opposite axes, sharpness equal to within 1e-6) the
/// axis has no meaning and is shorter than 1, down to the zero vector; so it is for two lobes of sharpness
/// below 1e-30, which count as constant.
///
/// Numerics: sharpnesses are taken relative to the larger one, `ra` and `rb`. With the chords
/// `q = |v1 - v2|²` and `p = |v1 + v2|²`, `k3` is the larger one times `n = sqrt((ra - rb)² + ra rb p)`, and
/// `k3 - k1 - k2` the larger one times `-ra rb q / (n + ra + rb)`: no difference of large numbers, and
/// nothing under the root that could be negative.
#[kernel(
    family = "sg",
    cite = "[Tokuyoshi22] supplement eq. 1, 2",
    budget(
        axis = 2e-6 + 2e-6 * max(a.sharpness, b.sharpness) / max(result.sharpness, 1e-6 * max(a.sharpness, b.sharpness) + 1e-36) + 1e-30 / max(max(a.sharpness, b.sharpness), 1e-30),
        sharpness = 3.5e-6 * max(a.sharpness, b.sharpness) + 1e-30,
        log_amplitude = 3.5e-6 * abs(result.log_amplitude - a.log_amplitude - b.log_amplitude) + 5e-7 * (abs(a.log_amplitude) + abs(b.log_amplitude)) + 1e-30
    ),
    measured
)]
pub fn sg_product(a: Sg, b: Sg) -> Sg {
    // The floors here and below keep two constant lobes from dividing by zero; otherwise `ra + rb >= 1`.
    let largest = max(max(a.sharpness, b.sharpness), 1e-30);
    let ra = a.sharpness / largest;
    let rb = b.sharpness / largest;
    let difference = a.axis - b.axis;
    let sum = a.axis + b.axis;
    let gap = ra - rb;
    let norm = sqrt(gap * gap + ra * rb * dot(sum, sum));
    let shift = -largest * (ra * rb * dot(difference, difference) / max(norm + ra + rb, 1.0));
    Sg {
        axis: (ra * a.axis + rb * b.axis) / max(norm, 1e-6),
        sharpness: largest * norm,
        log_amplitude: a.log_amplitude + b.log_amplitude + shift,
    }
}

/// Product of two spherical Gaussians, as printed.
///
/// Source: [Tokuyoshi22] supplement listing 2. Arguments, domain and result as of [`sg_product`]; the
/// listing's lobes have amplitude 1, here their logarithms add.
///
/// Numerics: `cosine - 1` cancels for near-parallel axes and is multiplied by the sharpness; two constant
/// lobes divide 0 by 0.
#[kernel(
    family = "sg",
    cite = "[Tokuyoshi22] supplement listing 2",
    budget(
        axis = 2e-6 + 2e-6 * max(a.sharpness, b.sharpness) / max(result.sharpness, 1e-6 * max(a.sharpness, b.sharpness) + 1e-36) + 1e-30 / max(max(a.sharpness, b.sharpness), 1e-30),
        sharpness = 3.5e-6 * max(a.sharpness, b.sharpness) + 1e-30,
        log_amplitude = 3.5e-6 * abs(result.log_amplitude - a.log_amplitude - b.log_amplitude) + 5e-7 * (abs(a.log_amplitude) + abs(b.log_amplitude)) + 1e-30
    ),
    variant_of = sg_product,
    not_robust = "cosine - 1 cancels for near-parallel axes and the sharpness multiplies its error; 0/0 for two constant lobes",
    measured
)]
pub fn sg_product_paper(a: Sg, b: Sg) -> Sg {
    let weighted = a.axis * a.sharpness + b.axis * b.sharpness;
    let sharpness = length(weighted);
    let cosine = clamp(dot(a.axis, b.axis), -1.0, 1.0);
    let smaller = min(a.sharpness, b.sharpness);
    let ratio = smaller / max(a.sharpness, b.sharpness);
    let shift =
        2.0 * smaller * (cosine - 1.0) / (1.0 + ratio + sqrt(2.0 * ratio * cosine + ratio * ratio + 1.0));
    Sg {
        axis: weighted / max(sharpness, f32::MIN_POSITIVE),
        sharpness,
        log_amplitude: a.log_amplitude + b.log_amplitude + shift,
    }
}

/// Integral over the sphere of the product of two spherical Gaussians.
///
/// `∫ G(w; a) G(w; b) dw = exp(log_amplitude) 4π expm1_over_x(-2 k)`, with `k` and the log amplitude of the
/// product lobe.
/// Source: [Wang09] section 3, by [`sg_product`]; exact.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `a`, `b` | the lobes | sharpness 0 ..= 1e6, log amplitude -10 ..= 10 | 1 |
///
/// Returns the integral in sr, at least 0.
///
/// Numerics: the printed `4π e^(-k1-k2) sinh(k)/k` overflows from a sharpness of 89 on. The budget grows with
/// the logarithm of the result's peak, since the languages let `exp(x)` err by `3 + 2|x|` ULP.
#[kernel(
    family = "sg",
    cite = "[Wang09] section 3",
    budget((4e-6 + 4e-6 * abs(sg_product(a, b).log_amplitude - a.log_amplitude - b.log_amplitude) + 1e-6 * (abs(a.log_amplitude) + abs(b.log_amplitude))) * result + 1e-35),
    measured
)]
pub fn sg_sg_product_integral(a: Sg, b: Sg) -> f32 {
    let product = sg_product(a, b);
    exp(product.log_amplitude) * sg_integral(product.sharpness)
}

/// Integral over the sphere of the product of two spherical Gaussians, approximated.
///
/// `∫ G(w; a) G(w; b) dw ≈ 2π/(k1 + k2) exp(k1 k2/(k1 + k2) (v1·v2 - 1))`
/// Source: [Iwasaki12], with the inner product by the chord.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `a`, `b` | the lobes | sharpness 1e-3 ..= 1e6, log amplitude -10 ..= 10 | 1 |
///
/// Returns the approximate integral in sr. It is close when one lobe is sharp and the other wide (0.4 % at
/// 1000 against 2), 35 % off at 5 against 2 and opposite, and too large without limit for two sharp lobes
/// apart or two nearly constant ones: prefer [`sg_sg_product_integral`], which costs one more exponential.
#[kernel(
    family = "sg",
    cite = "[Iwasaki12]",
    domain(a.sharpness = 1e-3..=1e6, b.sharpness = 1e-3..=1e6),
    budget((4e-6 + 1.5e-6 * a.sharpness * b.sharpness / (a.sharpness + b.sharpness) * dot(a.axis - b.axis, a.axis - b.axis) + 1.5e-6 * abs(a.log_amplitude) + 1.5e-6 * abs(b.log_amplitude)) * result + 1e-35),
    variant_of = sg_sg_product_integral,
    measured
)]
pub fn sg_sg_product_integral_iwasaki(a: Sg, b: Sg) -> f32 {
    // The floor keeps two constant lobes, for which the form has no value, from giving NaN.
    let total = max(a.sharpness + b.sharpness, 1e-30);
    let chord = a.axis - b.axis;
    let exponent = -0.5 * (a.sharpness / total * b.sharpness) * dot(chord, chord);
    0.5 * FOUR_PI / total * exp(a.log_amplitude + b.log_amplitude + exponent)
}
