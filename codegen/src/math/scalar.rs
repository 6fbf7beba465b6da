//! One f32 lane: what each operation returns, including at NaN, infinities and signed zeros.

pub use super::elementary::{exp, log};

macro_rules! by_libm {
    ($($(#[$doc:meta])* $name:ident => $f:path;)*) => {
        $(
            $(#[$doc])*
            pub fn $name(x: f32) -> f32 {
                $f(f64::from(x)) as f32
            }
        )*
    };
}

by_libm! {
    /// `2^x`
    exp2 => libm::exp2;
    /// Logarithm of base 2.
    log2 => libm::log2;
    /// Sine of radians.
    sin => libm::sin;
    /// Cosine of radians.
    cos => libm::cos;
    /// Tangent of radians.
    tan => libm::tan;
    /// Arc sine.
    asin => libm::asin;
    /// Arc cosine.
    acos => libm::acos;
    /// Arc tangent.
    atan => libm::atan;
    /// Hyperbolic sine.
    sinh => libm::sinh;
    /// Hyperbolic cosine.
    cosh => libm::cosh;
    /// Hyperbolic tangent.
    tanh => libm::tanh;
    /// Inverse hyperbolic sine.
    asinh => libm::asinh;
    /// Inverse hyperbolic cosine.
    acosh => libm::acosh;
    /// Inverse hyperbolic tangent.
    atanh => libm::atanh;
}

/// Square root, correctly rounded.
pub fn sqrt(x: f32) -> f32 {
    x.sqrt()
}

/// `1 / sqrt(x)`, rounded once.
pub fn inverse_sqrt(x: f32) -> f32 {
    (1.0 / f64::from(x).sqrt()) as f32
}

/// `x^y`, for `x >= 0` as `exp2(y * log2(x))` is; a negative base gives NaN, as in the shading languages.
pub fn pow(x: f32, y: f32) -> f32 {
    if x < 0.0 { f32::NAN } else { libm::pow(f64::from(x), f64::from(y)) as f32 }
}

/// Angle of the point `(x, y)`.
pub fn atan2(y: f32, x: f32) -> f32 {
    libm::atan2(f64::from(y), f64::from(x)) as f32
}

/// Magnitude.
pub fn abs(x: f32) -> f32 {
    x.abs()
}

/// The smaller; the other one when one is NaN; the first of equals.
pub fn min(a: f32, b: f32) -> f32 {
    if b < a || a.is_nan() { b } else { a }
}

/// The larger; the other one when one is NaN; the first of equals.
pub fn max(a: f32, b: f32) -> f32 {
    if b > a || a.is_nan() { b } else { a }
}

/// `min(max(x, low), high)`
pub fn clamp(x: f32, low: f32, high: f32) -> f32 {
    min(max(x, low), high)
}

/// `clamp(x, 0, 1)`; 0 for NaN.
pub fn saturate(x: f32) -> f32 {
    clamp(x, 0.0, 1.0)
}

/// -1, 0 or 1; zeros and NaN are returned as they are.
pub fn sign(x: f32) -> f32 {
    if x > 0.0 {
        1.0
    } else if x < 0.0 {
        -1.0
    } else {
        x
    }
}

/// Towards +infinity.
pub fn ceil(x: f32) -> f32 {
    x.ceil()
}

/// Towards -infinity.
pub fn floor(x: f32) -> f32 {
    x.floor()
}

/// To the nearest integer, ties to even.
pub fn round(x: f32) -> f32 {
    x.round_ties_even()
}

/// Towards zero.
pub fn trunc(x: f32) -> f32 {
    x.trunc()
}

/// `x - floor(x)`
pub fn fract(x: f32) -> f32 {
    x - x.floor()
}

/// 1 if `edge <= x`, otherwise 0.
pub fn step(edge: f32, x: f32) -> f32 {
    if edge <= x { 1.0 } else { 0.0 }
}

/// Radians to degrees.
pub fn degrees(x: f32) -> f32 {
    x * 57.295779513082322865
}

/// Degrees to radians.
pub fn radians(x: f32) -> f32 {
    x * 0.017453292519943295474
}

/// `x * y + z`, rounded once.
pub fn fma(x: f32, y: f32, z: f32) -> f32 {
    x.mul_add(y, z)
}

/// `x * (1 - t) + y * t`
pub fn mix(x: f32, y: f32, t: f32) -> f32 {
    x * (1.0 - t) + y * t
}

/// Hermite interpolation between 0 at `low` and 1 at `high`.
pub fn smoothstep(low: f32, high: f32, x: f32) -> f32 {
    let t = clamp((x - low) / (high - low), 0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// To a signed integer as WGSL converts: truncated, clamped to the range, 0 for NaN.
pub fn to_i32(x: f32) -> i32 {
    x as i32
}

/// To an unsigned integer as WGSL converts: truncated, clamped to the range, 0 for NaN.
pub fn to_u32(x: f32) -> u32 {
    x as u32
}
