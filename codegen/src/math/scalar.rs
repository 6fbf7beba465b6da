//! One f32 lane: what each operation returns, including at NaN, infinities and signed zeros.

pub use super::elementary::{
    acos, acosh, asin, asinh, atan, atan2, atanh, cos, cosh, exp, exp2, log, log2, pow, sin, sinh, tan, tanh,
};

/// Square root, correctly rounded.
#[inline(always)]
pub fn sqrt(x: f32) -> f32 {
    x.sqrt()
}

/// `1 / sqrt(x)`, rounded once.
#[inline(always)]
pub fn inverse_sqrt(x: f32) -> f32 {
    (1.0 / f64::from(x).sqrt()) as f32
}

/// Magnitude.
#[inline(always)]
pub fn abs(x: f32) -> f32 {
    x.abs()
}

/// The smaller; the other one when one is NaN; the first of equals.
#[inline(always)]
pub fn min(a: f32, b: f32) -> f32 {
    if (b < a) | a.is_nan() { b } else { a }
}

/// The larger; the other one when one is NaN; the first of equals.
#[inline(always)]
pub fn max(a: f32, b: f32) -> f32 {
    if (b > a) | a.is_nan() { b } else { a }
}

/// `min(max(x, low), high)`
#[inline(always)]
pub fn clamp(x: f32, low: f32, high: f32) -> f32 {
    min(max(x, low), high)
}

/// `clamp(x, 0, 1)`; 0 for NaN.
#[inline(always)]
pub fn saturate(x: f32) -> f32 {
    clamp(x, 0.0, 1.0)
}

/// -1, 0 or 1; zeros and NaN are returned as they are.
#[inline(always)]
pub fn sign(x: f32) -> f32 {
    let below = if x < 0.0 { -1.0 } else { x };
    if x > 0.0 { 1.0 } else { below }
}

/// Towards +infinity.
#[inline(always)]
pub fn ceil(x: f32) -> f32 {
    x.ceil()
}

/// Towards -infinity.
#[inline(always)]
pub fn floor(x: f32) -> f32 {
    x.floor()
}

/// To the nearest integer, ties to even.
#[inline(always)]
pub fn round(x: f32) -> f32 {
    x.round_ties_even()
}

/// Towards zero.
#[inline(always)]
pub fn trunc(x: f32) -> f32 {
    x.trunc()
}

/// `x - floor(x)`
#[inline(always)]
pub fn fract(x: f32) -> f32 {
    x - x.floor()
}

/// 1 if `edge <= x`, otherwise 0.
#[inline(always)]
pub fn step(edge: f32, x: f32) -> f32 {
    if edge <= x { 1.0 } else { 0.0 }
}

/// Radians to degrees.
#[inline(always)]
pub fn degrees(x: f32) -> f32 {
    x * 57.295779513082322865
}

/// Degrees to radians.
#[inline(always)]
pub fn radians(x: f32) -> f32 {
    x * 0.017453292519943295474
}

/// `x * y + z`, rounded once.
#[inline(always)]
pub fn fma(x: f32, y: f32, z: f32) -> f32 {
    x.mul_add(y, z)
}

/// `x * (1 - t) + y * t`
#[inline(always)]
pub fn mix(x: f32, y: f32, t: f32) -> f32 {
    x * (1.0 - t) + y * t
}

/// Hermite interpolation between 0 at `low` and 1 at `high`.
#[inline(always)]
pub fn smoothstep(low: f32, high: f32, x: f32) -> f32 {
    let t = clamp((x - low) / (high - low), 0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// To a signed integer as WGSL converts: truncated, clamped to the range, 0 for NaN.
#[inline(always)]
pub fn to_i32(x: f32) -> i32 {
    x as i32
}

/// To an unsigned integer as WGSL converts: truncated, clamped to the range, 0 for NaN.
#[inline(always)]
pub fn to_u32(x: f32) -> u32 {
    x as u32
}
