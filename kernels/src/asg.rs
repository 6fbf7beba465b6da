//! Anisotropic spherical Gaussians: evaluation, integral, product with an isotropic one.

use crate::constants::PI;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{RectGlossy, Tokuyoshi15b, Xu13};
use crate::sg::Sg;
use crate::special::erf;
use lobe_codegen::prelude::*;

/// √π/2, the inverse slope of `erf` at 0, and the root of `π/4`.
#[kernel]
pub const ERF_INVERSE_SLOPE: f32 = 0.88622692545275801365;

/// An anisotropic spherical Gaussian
/// `G(w) = amplitude max(w·z, 0) exp(-lambda (w·x)² - mu (w·y)²)`.
#[kernel]
pub struct Asg {
    /// Unit vector to the peak.
    #[domain(unit)]
    pub z: Vec3,
    /// Unit tangent, perpendicular to `z`.
    #[domain(normal_to(z))]
    pub x: Vec3,
    /// Unit bitangent, `cross(z, x)`.
    #[domain(cross(z, x))]
    pub y: Vec3,
    /// Bandwidth along `x`, at least 0.
    #[domain(0.0..=1e6)]
    pub lambda: f32,
    /// Bandwidth along `y`, at least 0.
    #[domain(0.0..=1e6)]
    pub mu: f32,
    /// Value at the peak.
    #[domain(0.0..=1e4)]
    pub amplitude: f32,
}

/// Value of an anisotropic spherical Gaussian in a direction.
///
/// `G(w) = amplitude max(w·z, 0) exp(-lambda (w·x)² - mu (w·y)²)`
/// Source: [Xu13] eq. 1, with `w·x = (w - z)·x`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `dir` | unit direction `w` | sphere | 1 |
/// | `asg` | the lobe | bandwidths 0 ..= 1e6, amplitude 0 ..= 1e4 | 1 |
///
/// Returns the value, in 0 ..= `amplitude`; 0 below the horizon of `z`.
///
/// Numerics: near the peak the difference `w - z` is exact, so that only the error of the frame's
/// perpendicularity times that small difference is multiplied by the bandwidth. Far along the ridge of a
/// lobe with one wide bandwidth, the error of `w·x` itself is: hence the budget's roots.
#[kernel(
    family = "asg",
    cite = "[Xu13] eq. 1",
    domain(dir = unit),
    budget((2e-6 + 2e-7 * (sqrt(asg.lambda) + sqrt(asg.mu))) * asg.amplitude + 1e-36),
    measured
)]
pub fn asg_eval(dir: Vec3, asg: Asg) -> f32 {
    let chord = dir - asg.z;
    let along_x = dot(chord, asg.x);
    let along_y = dot(chord, asg.y);
    let exponent = -asg.lambda * (along_x * along_x) - asg.mu * (along_y * along_y);
    asg.amplitude * max(dot(dir, asg.z), 0.0) * exp(exponent)
}

/// Value of an anisotropic spherical Gaussian out of the cosines to its axes.
///
/// `G = amplitude max(cos θ, 0) exp(-lambda cos² φ - mu cos² η)`
/// Source: [RectGlossy] eq. 30, with the clamp of its eq. 2, which eq. 30 leaves out.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `cos_z`, `cos_x`, `cos_y` | `w·z`, `w·x`, `w·y`: cosines of θ, φ, η | -1 ..= 1 | 1 |
/// | `lambda`, `mu` | bandwidths along `x` and `y` | 0 ..= 1e6 | 1 |
/// | `amplitude` | value at the peak | 0 ..= 1e4 | 1 |
///
/// Returns the value, in 0 ..= `amplitude`.
///
/// Numerics: it takes cosines, since the cosine of an angle may err by 2^-11 in WGSL and the bandwidths would
/// multiply that.
#[kernel(
    family = "asg",
    cite = "[RectGlossy] eq. 30",
    domain(
        cos_z = -1.0..=1.0, cos_x = -1.0..=1.0, cos_y = -1.0..=1.0,
        lambda = 0.0..=1e6, mu = 0.0..=1e6, amplitude = 0.0..=1e4
    ),
    budget(1.5e-6 * amplitude + 1e-36),
    measured
)]
pub fn asg_eval_polar(cos_z: f32, cos_x: f32, cos_y: f32, lambda: f32, mu: f32, amplitude: f32) -> f32 {
    amplitude * max(cos_z, 0.0) * exp(-lambda * (cos_x * cos_x) - mu * (cos_y * cos_y))
}

/// Value of an anisotropic spherical Gaussian out of the cosines to its axes, as printed.
///
/// Source: [RectGlossy] eq. 30. Arguments and domain as of [`asg_eval_polar`].
///
/// Returns the value, in `-amplitude` ..= `amplitude`: without the clamp, directions below the horizon take
/// light away.
#[kernel(
    family = "asg",
    cite = "[RectGlossy] eq. 30",
    domain(
        cos_z = -1.0..=1.0, cos_x = -1.0..=1.0, cos_y = -1.0..=1.0,
        lambda = 0.0..=1e6, mu = 0.0..=1e6, amplitude = 0.0..=1e4
    ),
    budget(1.5e-6 * amplitude + 1e-36),
    variant_of = asg_eval_polar,
    measured
)]
pub fn asg_eval_polar_paper(cos_z: f32, cos_x: f32, cos_y: f32, lambda: f32, mu: f32, amplitude: f32) -> f32 {
    amplitude * cos_z * exp(-lambda * (cos_x * cos_x) - mu * (cos_y * cos_y))
}

/// One bandwidth's factor of [`asg_integral`], `erf(√(π b)/2)/√b`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `bandwidth` | `b` | 0 ..= 1e6 | 1 |
///
/// Returns the factor, in 0 ..= 1: 1 for a constant lobe, `1/√b` for a sharp one.
///
/// Numerics: the quotient `erf(t)/t` with `t` at least 1e-15, where it is at its limit.
#[kernel(family = "asg", cite = "[Xu13] section 3", domain(bandwidth = 0.0..=1e6), budget(4e-6 * result), measured)]
pub fn asg_width(bandwidth: f32) -> f32 {
    let t = max(ERF_INVERSE_SLOPE * sqrt(bandwidth), 1e-15);
    ERF_INVERSE_SLOPE * (erf(t) / t)
}

/// Integral of an anisotropic spherical Gaussian of amplitude 1 over the sphere, for any bandwidths.
///
/// `∫ G dw ≈ π/√(lambda mu) erf(√(π lambda)/2) erf(√(π mu)/2)`
/// Source: our own; [Xu13] gives `π/√(lambda mu)`, which has no limit for wide lobes
/// ([`asg_integral_paper`]).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `lambda`, `mu` | bandwidths | 0 ..= 1e6 | 1 |
///
/// Returns the integral in sr, in 0 ..= π; π for a constant lobe, which is exact.
///
/// Against the exact integral it is off by -0.3 % at (5, 5), -1.3 % at (1, 1), -6.1 % at (100, 1) and -10.5 % at
/// (100, 0.1).
#[kernel(
    family = "asg",
    cite = "[Xu13] section 3",
    domain(lambda = 0.0..=1e6, mu = 0.0..=1e6),
    budget(6e-6 * result),
    measured
)]
pub fn asg_integral(lambda: f32, mu: f32) -> f32 {
    PI * (asg_width(lambda) * asg_width(mu))
}

/// Integral of an anisotropic spherical Gaussian of amplitude 1 over the sphere, for narrow lobes.
///
/// `∫ G dw ≈ π/√(lambda mu)`
/// Source: [RectGlossy] eq. 34, [Xu13] section 3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `lambda`, `mu` | bandwidths | 1e-3 ..= 1e6 | 1 |
///
/// Returns the integral in sr. Always too large, by what the smaller bandwidth says (for equal ones, and for
/// the other very large): 10: 5e-5; 5: 0.7 %; 3: 5 %; 2: 16 % (5 %); 1: 58 % (19 %); without limit towards 0.
#[kernel(
    family = "asg",
    cite = "[RectGlossy] eq. 34",
    domain(lambda = 1e-3..=1e6, mu = 1e-3..=1e6),
    budget(4e-6 * result),
    variant_of = asg_integral,
    measured
)]
pub fn asg_integral_paper(lambda: f32, mu: f32) -> f32 {
    // The roots are taken apart, since the product of the bandwidths may overflow.
    PI / max(sqrt(lambda) * sqrt(mu), 1e-30)
}

/// Integral over the sphere of the product of an anisotropic and an isotropic spherical Gaussian.
///
/// With `n = k/2`, half the sharpness:
/// `∫ G_asg G_sg dw ≈ π/√((lambda + n)(mu + n)) max(p·z, 0) exp(-lambda n/(lambda + n) (p·x)² - mu n/(mu + n) (p·y)²)`
/// times both amplitudes.
/// Source: [Xu13] section 3, where an isotropic lobe is `exp(2 n (w·p - 1))`; [Tokuyoshi15b] section 3.2.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `asg` | the anisotropic lobe | bandwidths 0 ..= 1e6, amplitude 0 ..= 1e4 | 1 |
/// | `sg` | the isotropic lobe `p`, `k` | sharpness 0 ..= 1e6, log amplitude -10 ..= 10 | 1 |
///
/// Returns the integral in sr, at least 0; 0 where the axes are more than a right angle apart.
///
/// On the axis it is within 1.3 % of the exact integral for bandwidths from 10 on, within 0.3 % from 50 on.
/// Off the axis it errs by up to 9 % of its value on the axis for bandwidths and `n` near 5, by 0.1 % at a
/// sharpness of 1000. Where both lobes are nearly constant it grows without limit: use [`asg_integral`].
#[kernel(
    family = "asg",
    cite = "[Xu13] section 3",
    budget(
        (5e-6 + 2e-7 * (sqrt(asg.lambda) + sqrt(asg.mu)) + 1e-6 * abs(sg.log_amplitude))
            * asg.amplitude * exp(sg.log_amplitude)
            * asg_sg_peak(asg.lambda, asg.mu, 0.5 * sg.sharpness) + 1e-23
    ),
    measured
)]
pub fn asg_sg_product_integral(asg: Asg, sg: Sg) -> f32 {
    asg_sg_convolved(asg, sg, 0.5 * sg.sharpness)
}

/// Integral over the sphere of the product of an anisotropic and an isotropic spherical Gaussian, as printed.
///
/// Source: [RectGlossy] eq. 11, which takes the whole sharpness where half is meant by its own eq. 1.
/// Arguments and domain as of [`asg_sg_product_integral`].
///
/// Returns the integral in sr: on the axis 0.98 of the exact one for wide isotropic lobes, down to 0.50 for
/// sharp ones.
#[kernel(
    family = "asg",
    cite = "[RectGlossy] eq. 11",
    budget(
        (5e-6 + 2e-7 * (sqrt(asg.lambda) + sqrt(asg.mu)) + 1e-6 * abs(sg.log_amplitude))
            * asg.amplitude * exp(sg.log_amplitude)
            * asg_sg_peak(asg.lambda, asg.mu, sg.sharpness) + 1e-23
    ),
    variant_of = asg_sg_product_integral,
    measured
)]
pub fn asg_sg_product_integral_paper(asg: Asg, sg: Sg) -> f32 {
    asg_sg_convolved(asg, sg, sg.sharpness)
}

/// Value on the axis of [`asg_sg_product_integral`] for lobes of amplitude 1, `π/√((lambda + n)(mu + n))`.
///
/// Source: [Xu13] section 3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `lambda`, `mu` | bandwidths | 0 ..= 1e6 | 1 |
/// | `nu` | of the isotropic lobe, `n` | 0 ..= 1e6 | 1 |
///
/// Returns the integral in sr, at most 1e10 π.
#[kernel(
    family = "asg",
    cite = "[Xu13] section 3",
    domain(lambda = 0.0..=1e6, mu = 0.0..=1e6, nu = 0.0..=1e6),
    budget(1.5e-6 * result),
    measured
)]
pub fn asg_sg_peak(lambda: f32, mu: f32, nu: f32) -> f32 {
    // The floor keeps two constant lobes, for which the form has no value, from giving infinity.
    PI * (inverse_sqrt(max(lambda + nu, 1e-10)) * inverse_sqrt(max(mu + nu, 1e-10)))
}

/// An anisotropic lobe of amplitude 1, convolved with an isotropic one, out of the latter's components.
///
/// `max(p·z, 0) exp(a - lambda n/(lambda + n) (p·x)² - mu n/(mu + n) (p·y)²)`
/// Source: [Xu13] section 3; the factor `π/√((lambda + n)(mu + n))` is [`asg_sg_peak`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `lambda`, `mu` | bandwidths | 0 ..= 1e6 | 1 |
/// | `nu` | half the isotropic lobe's sharpness, `n` | 0 ..= 1e6 | 1 |
/// | `components` | its axis in the frame of the anisotropic one, `(p·x, p·y, p·z)` | -1 ..= 1 | 1 |
/// | `log_amplitude` | of the isotropic lobe, `a` | -10 ..= 10 | 1 |
///
/// Returns the value, in 0 ..= `exp(a)`.
#[kernel(
    family = "asg",
    cite = "[Xu13] section 3",
    domain(lambda = 0.0..=1e6, mu = 0.0..=1e6, nu = 0.0..=1e6, components = -1.0..=1.0, log_amplitude = -10.0..=10.0),
    budget((3e-6 + 4e-7 * abs(log_amplitude)) * exp(log_amplitude)),
    measured
)]
pub fn asg_convolved_at(lambda: f32, mu: f32, nu: f32, components: Vec3, log_amplitude: f32) -> f32 {
    // lambda n/(lambda + n), without the product that may overflow.
    let across = lambda * (nu / max(lambda + nu, 1e-10));
    let along = mu * (nu / max(mu + nu, 1e-10));
    let x2 = components.x * components.x;
    let y2 = components.y * components.y;
    max(components.z, 0.0) * exp(log_amplitude - across * x2 - along * y2)
}

/// Convolution of an anisotropic lobe with an isotropic one that falls as `exp(-2 n (1 - w·p))`.
///
/// The formula of [`asg_sg_product_integral`] for any reading of `n`. Source: [Xu13] section 3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `asg` | the anisotropic lobe | bandwidths 0 ..= 1e6, amplitude 0 ..= 1e4 | 1 |
/// | `sg` | the isotropic lobe; its sharpness is not read | log amplitude -10 ..= 10 | 1 |
/// | `nu` | `n` | 0 ..= 1e6 | 1 |
///
/// Returns the integral in sr, at least 0.
#[kernel(
    family = "asg",
    cite = "[Xu13] section 3",
    domain(nu = 0.0..=1e6),
    budget(
        (5e-6 + 2e-7 * (sqrt(asg.lambda) + sqrt(asg.mu)) + 1e-6 * abs(sg.log_amplitude))
            * asg.amplitude * exp(sg.log_amplitude) * asg_sg_peak(asg.lambda, asg.mu, nu) + 1e-23
    ),
    measured
)]
pub fn asg_sg_convolved(asg: Asg, sg: Sg, nu: f32) -> f32 {
    // Near the peak the difference is exact, as in asg_eval.
    let chord = sg.axis - asg.z;
    let components = Vec3::new(dot(chord, asg.x), dot(chord, asg.y), dot(sg.axis, asg.z));
    let value = asg_convolved_at(asg.lambda, asg.mu, nu, components, sg.log_amplitude);
    asg.amplitude * (asg_sg_peak(asg.lambda, asg.mu, nu) * value)
}

/// The isotropic spherical Gaussian that stands for an anisotropic one and has its energy.
///
/// Sharpness `2 √(lambda mu)`, about the same axis and with the same peak.
/// Source: [RectGlossy] eq. 37, corrected: its sharpness [`asg_to_sg_paper`] loses energy.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `asg` | the lobe | bandwidths 0 ..= 1e6, amplitude 1e-10 ..= 1e4 | 1 |
///
/// Returns the lobe. Its product with another lobe on the axis is within 4 % for `lambda/mu` up to 4, 27 % too
/// large at 20: use it for mild anisotropy.
#[kernel(
    family = "asg",
    cite = "[RectGlossy] eq. 37",
    domain(asg.amplitude = 1e-10..=1e4),
    budget(axis = 0.0, sharpness = 3e-6 * result.sharpness + 1e-15, log_amplitude = 1e-6 * abs(result.log_amplitude) + 5e-7),
    measured
)]
pub fn asg_to_sg(asg: Asg) -> Sg {
    Sg {
        axis: asg.z,
        sharpness: 2.0 * (sqrt(asg.lambda) * sqrt(asg.mu)),
        log_amplitude: log(max(asg.amplitude, f32::MIN_POSITIVE)),
    }
}

/// The isotropic spherical Gaussian that stands for an anisotropic one, as printed.
///
/// Sharpness `2 max(lambda, mu)`. Source: [RectGlossy] eq. 37. Arguments and domain as of [`asg_to_sg`].
///
/// Returns the lobe. It has `√(min/max)` of the energy: its product with another lobe on the axis is 0.57 of the
/// right one for bandwidths of ratio 4, 0.37 for 20.
#[kernel(
    family = "asg",
    cite = "[RectGlossy] eq. 37",
    domain(asg.amplitude = 1e-10..=1e4),
    budget(axis = 0.0, sharpness = 3e-6 * result.sharpness + 1e-30, log_amplitude = 1e-6 * abs(result.log_amplitude) + 5e-7),
    variant_of = asg_to_sg,
    measured
)]
pub fn asg_to_sg_paper(asg: Asg) -> Sg {
    Sg {
        axis: asg.z,
        sharpness: 2.0 * max(asg.lambda, asg.mu),
        log_amplitude: log(max(asg.amplitude, f32::MIN_POSITIVE)),
    }
}
