//! Float operations of 32, 16 and 64 bits. An operation takes as many of the operands as it has.

use super::super::program::op::FloatOp;
use super::half;
use lobe_codegen::math::scalar as single;

/// On f32, as the native functions.
#[inline(always)]
pub(crate) fn f32(op: FloatOp, [a, b, c]: [f32; 3]) -> f32 {
    use FloatOp as F;
    match op {
        F::Add => a + b,
        F::Sub => a - b,
        F::Mul => a * b,
        F::Div => a / b,
        F::Rem => a % b,
        F::Neg => -a,
        F::Square => a * a,
        F::Nonnegative => a,
        F::Abs | F::Length => single::abs(a),
        F::Min => single::min(a, b),
        F::Max => single::max(a, b),
        F::Sign => single::sign(a),
        F::Ceil => single::ceil(a),
        F::Floor => single::floor(a),
        F::Round => single::round(a),
        F::Trunc => single::trunc(a),
        F::Fract => single::fract(a),
        F::Step => single::step(a, b),
        F::Clamp => single::clamp(a, b, c),
        F::Saturate => single::saturate(a),
        F::Sqrt => single::sqrt(a),
        F::InverseSqrt => single::inverse_sqrt(a),
        F::Exp => single::exp(a),
        F::Exp2 => single::exp2(a),
        F::Log => single::log(a),
        F::Log2 => single::log2(a),
        F::Pow => single::pow(a, b),
        F::Sin => single::sin(a),
        F::Cos => single::cos(a),
        F::Tan => single::tan(a),
        F::Asin => single::asin(a),
        F::Acos => single::acos(a),
        F::Atan => single::atan(a),
        F::Atan2 => single::atan2(a, b),
        F::Sinh => single::sinh(a),
        F::Cosh => single::cosh(a),
        F::Tanh => single::tanh(a),
        F::Asinh => single::asinh(a),
        F::Acosh => single::acosh(a),
        F::Atanh => single::atanh(a),
        F::Degrees => single::degrees(a),
        F::Radians => single::radians(a),
        F::Fma => single::fma(a, b, c),
        F::Mix => single::mix(a, b, c),
        F::SmoothStep => single::smoothstep(a, b, c),
        F::Significand => significand(a.into()) as f32,
    }
}

/// On numbers of 16 bits, held as f32: the f32 operation, rounded again.
///
/// Of sums, products, quotients and roots that is the number of 16 bits nearest to the exact result.
#[inline(always)]
pub(crate) fn f16(op: FloatOp, [a, b, c]: [f32; 3]) -> f32 {
    match op {
        FloatOp::Fma => half::fma(a, b, c),
        op => half::round(f32(op, [a, b, c])),
    }
}

/// On f64.
#[inline(always)]
pub(crate) fn f64(op: FloatOp, [a, b, c]: [f64; 3]) -> f64 {
    use FloatOp as F;
    match op {
        F::Add => a + b,
        F::Sub => a - b,
        F::Mul => a * b,
        F::Div => a / b,
        F::Rem => a % b,
        F::Neg => -a,
        F::Square => a * a,
        F::Nonnegative => a,
        F::Abs | F::Length => a.abs(),
        F::Min => min(a, b),
        F::Max => max(a, b),
        F::Sign if a > 0.0 => 1.0,
        F::Sign if a < 0.0 => -1.0,
        F::Sign => a,
        F::Ceil => a.ceil(),
        F::Floor => a.floor(),
        F::Round => a.round_ties_even(),
        F::Trunc => a.trunc(),
        F::Fract => a - a.floor(),
        F::Step if a <= b => 1.0,
        F::Step => 0.0,
        F::Clamp => min(max(a, b), c),
        F::Saturate => min(max(a, 0.0), 1.0),
        F::Sqrt => a.sqrt(),
        F::InverseSqrt => 1.0 / a.sqrt(),
        F::Exp => libm::exp(a),
        F::Exp2 => libm::exp2(a),
        F::Log => libm::log(a),
        F::Log2 => libm::log2(a),
        F::Pow if a < 0.0 => f64::NAN,
        F::Pow => libm::pow(a, b),
        F::Sin => libm::sin(a),
        F::Cos => libm::cos(a),
        F::Tan => libm::tan(a),
        F::Asin => libm::asin(a),
        F::Acos => libm::acos(a),
        F::Atan => libm::atan(a),
        F::Atan2 => libm::atan2(a, b),
        F::Sinh => libm::sinh(a),
        F::Cosh => libm::cosh(a),
        F::Tanh => libm::tanh(a),
        F::Asinh => libm::asinh(a),
        F::Acosh => libm::acosh(a),
        F::Atanh => libm::atanh(a),
        F::Degrees => a * 57.295_779_513_082_32,
        F::Radians => a * 0.017_453_292_519_943_295,
        F::Fma => a.mul_add(b, c),
        F::Mix => a * (1.0 - c) + b * c,
        F::SmoothStep => {
            let t = min(max((c - a) / (b - a), 0.0), 1.0);
            t * t * (3.0 - 2.0 * t)
        }
        F::Significand => significand(a),
    }
}

/// The smaller; the other one when one is NaN; the first of equals.
#[inline(always)]
fn min(a: f64, b: f64) -> f64 {
    if b < a || a.is_nan() { b } else { a }
}

/// The larger; the other one when one is NaN; the first of equals.
#[inline(always)]
fn max(a: f64, b: f64) -> f64 {
    if b > a || a.is_nan() { b } else { a }
}

/// The first part of `frexp`: in `[0.5, 1)`, with the sign; zeros, infinities and NaN as they are.
fn significand(x: f64) -> f64 {
    if x.is_finite() { libm::frexp(x).0 } else { x }
}

/// The second part of `frexp`: `x` is the significand times two to this power; 0 for zeros, infinities and NaN.
pub(crate) fn exponent(x: f64) -> i32 {
    if x.is_finite() { libm::frexp(x).1 } else { 0 }
}

/// `x * 2^by` of an f32, rounded once.
#[inline(always)]
pub(crate) fn ldexp_f32(x: f32, by: i32) -> f32 {
    ldexp_f64(x.into(), by.clamp(-400, 400)) as f32
}

/// `x * 2^by` of a number of 16 bits, rounded once.
#[inline(always)]
pub(crate) fn ldexp_f16(x: f32, by: i32) -> f32 {
    half::round_f64(ldexp_f64(x.into(), by.clamp(-400, 400)))
}

/// `x * 2^by`, rounded once.
pub(crate) fn ldexp_f64(x: f64, by: i32) -> f64 {
    libm::ldexp(x, by)
}
