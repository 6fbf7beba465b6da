//! Hyperbolic functions and their inverses.

use super::double::{exp_minus_1, log_1_plus};

/// The magnitude, at most `most`; NaN of NaN.
#[inline(always)]
fn bounded(x: f32, most: f64) -> f64 {
    let a = f64::from(x.abs());
    if a > most { most } else { a }
}

#[inline(always)]
fn with_sign(result: f64, x: f32) -> f32 {
    result.copysign(x.into()) as f32
}

/// Hyperbolic sine. At most 0.51 ULP.
#[inline(always)]
pub fn sinh(x: f32) -> f32 {
    let e = exp_minus_1(bounded(x, 100.0));
    with_sign(0.5 * (e + e / (e + 1.0)), x)
}

/// Hyperbolic cosine. At most 0.51 ULP.
#[inline(always)]
pub fn cosh(x: f32) -> f32 {
    let e = exp_minus_1(bounded(x, 100.0)) + 1.0;
    (0.5 * (e + 1.0 / e)) as f32
}

/// Hyperbolic tangent. At most 0.51 ULP.
#[inline(always)]
pub fn tanh(x: f32) -> f32 {
    let e = exp_minus_1(2.0 * bounded(x, 20.0));
    with_sign(e / (e + 2.0), x)
}

/// Inverse hyperbolic sine. At most 0.51 ULP.
#[inline(always)]
pub fn asinh(x: f32) -> f32 {
    let a = f64::from(x.abs());
    let square = a * a;
    let result = log_1_plus(a + square / (1.0 + (1.0 + square).sqrt()));
    with_sign(if a == f64::INFINITY { a } else { result }, x)
}

/// Inverse hyperbolic cosine. At most 0.51 ULP; NaN below 1.
#[inline(always)]
pub fn acosh(x: f32) -> f32 {
    let t = f64::from(x) - 1.0;
    let result = log_1_plus(t + (t * (t + 2.0)).sqrt());
    let result = if x == f32::INFINITY { x } else { result as f32 };
    if x < 1.0 { f32::NAN } else { result }
}

/// Inverse hyperbolic tangent. At most 0.51 ULP; infinite at 1, NaN beyond.
#[inline(always)]
pub fn atanh(x: f32) -> f32 {
    let a = f64::from(x.abs());
    let result = 0.5 * log_1_plus(2.0 * a / (1.0 - a));
    let result = if a == 1.0 { f64::INFINITY } else { result };
    with_sign(if a > 1.0 { f64::NAN } else { result }, x)
}
