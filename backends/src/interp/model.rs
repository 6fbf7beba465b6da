//! What a lane holds: the interpreter is written once over [`Model`], and a model says what a float, a
//! word and a boolean are.
//!
//! [`Strict`] is IEEE f32.
//! [`super::shadow::Shadow`] carries the f64 value and a bound beside it.

use lobe_codegen::math::scalar;

/// Float operations of one argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum F1 {
    Negate,
    Abs,
    Saturate,
    Sign,
    Ceil,
    Floor,
    Round,
    Trunc,
    Fract,
    Sqrt,
    InverseSqrt,
    Exp,
    Exp2,
    Log,
    Log2,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Degrees,
    Radians,
}

/// Float operations of two arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum F2 {
    Add,
    Subtract,
    Multiply,
    Divide,
    Remainder,
    Min,
    Max,
    Step,
    Pow,
    Atan2,
}

/// Float operations of three arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum F3 {
    Clamp,
    Fma,
    Mix,
    SmoothStep,
}

/// Comparisons.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Comparison {
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
}

impl Comparison {
    /// Whether it holds between two ordered values.
    pub(super) fn holds<T: PartialOrd>(self, a: T, b: T) -> bool {
        match self {
            Self::Equal => a == b,
            Self::NotEqual => a != b,
            Self::Less => a < b,
            Self::LessEqual => a <= b,
            Self::Greater => a > b,
            Self::GreaterEqual => a >= b,
        }
    }
}

/// What lanes hold, and the operations on them.
///
/// Operations are looked up once for all lanes: a lookup returns a function.
pub(super) trait Model: Copy + Send + Sync + std::fmt::Debug + 'static {
    /// A float.
    type F: Copy + Send + Sync + std::fmt::Debug;
    /// An integer of 32 bits, signed or not.
    type W: Copy + Send + Sync + std::fmt::Debug;
    /// A boolean.
    type B: Copy + Send + Sync + std::fmt::Debug;

    /// A float that is `value` in f32 and `exact` in truth.
    fn float(value: f32, exact: f64) -> Self::F;
    /// A known word.
    fn word(value: u32) -> Self::W;
    /// A known boolean.
    fn bool(value: bool) -> Self::B;

    /// The f32 value.
    fn float_value(x: Self::F) -> f32;
    /// The word on the f32 path.
    fn word_value(x: Self::W) -> u32;
    /// The decision on the f32 path.
    fn bool_value(x: Self::B) -> bool;
    /// Whether a word is what it would be on every legal driver.
    fn is_known(x: Self::W) -> bool;
    /// Whether a boolean could come out either way on a legal driver.
    fn is_ambiguous(x: Self::B) -> bool;

    /// A float operation.
    fn f1(op: F1) -> fn(Self::F) -> Self::F;
    /// A float operation.
    fn f2(op: F2) -> fn(Self::F, Self::F) -> Self::F;
    /// A float operation.
    fn f3(op: F3) -> fn(Self::F, Self::F, Self::F) -> Self::F;
    /// A comparison of floats.
    fn compare(op: Comparison, a: Self::F, b: Self::F) -> Self::B;

    /// An integer operation: `f` on the words.
    fn w1(x: Self::W, f: impl Fn(u32) -> u32) -> Self::W;
    /// An integer operation: `f` on the words.
    fn w2(x: Self::W, y: Self::W, f: impl Fn(u32, u32) -> u32) -> Self::W;
    /// A test of integers.
    fn test(x: Self::W, y: Self::W, f: impl Fn(u32, u32) -> bool) -> Self::B;

    /// Logical not.
    fn not(x: Self::B) -> Self::B;
    /// Logical and.
    fn and(x: Self::B, y: Self::B) -> Self::B;

    /// A float's bits.
    fn to_bits(x: Self::F) -> Self::W;
    /// A float of these bits.
    fn from_bits(x: Self::W) -> Self::F;
    /// A float to an integer, clamped; `f` is the conversion.
    fn to_word(x: Self::F, f: fn(f64) -> u32) -> Self::W;
    /// An integer to a float; `f` is the conversion.
    fn to_float(x: Self::W, f: fn(u32) -> f64) -> Self::F;
    /// 1 or 0.
    fn bool_to_word(x: Self::B) -> Self::W;

    /// `accept` where the condition holds, otherwise `reject`; both where it may come out either way.
    fn select_float(condition: Self::B, accept: Self::F, reject: Self::F) -> Self::F;
    /// As [`Model::select_float`].
    fn select_word(condition: Self::B, accept: Self::W, reject: Self::W) -> Self::W;
    /// As [`Model::select_float`].
    fn select_bool(condition: Self::B, accept: Self::B, reject: Self::B) -> Self::B;

    /// Replaces a body's result by the exact function it approximates.
    fn with_truth(result: Self::F, truth: lobe_codegen::def::Truth, arguments: &[Self::F]) -> Self::F;
}

/// IEEE f32, as the native form computes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strict;

impl Model for Strict {
    type F = f32;
    type W = u32;
    type B = bool;

    fn float(value: f32, _exact: f64) -> f32 {
        value
    }
    fn word(value: u32) -> u32 {
        value
    }
    fn bool(value: bool) -> bool {
        value
    }
    fn float_value(x: f32) -> f32 {
        x
    }
    fn word_value(x: u32) -> u32 {
        x
    }
    fn bool_value(x: bool) -> bool {
        x
    }
    fn is_known(_: u32) -> bool {
        true
    }
    fn is_ambiguous(_: bool) -> bool {
        false
    }

    fn f1(op: F1) -> fn(f32) -> f32 {
        match op {
            F1::Negate => |x| -x,
            F1::Abs => scalar::abs,
            F1::Saturate => scalar::saturate,
            F1::Sign => scalar::sign,
            F1::Ceil => scalar::ceil,
            F1::Floor => scalar::floor,
            F1::Round => scalar::round,
            F1::Trunc => scalar::trunc,
            F1::Fract => scalar::fract,
            F1::Sqrt => scalar::sqrt,
            F1::InverseSqrt => scalar::inverse_sqrt,
            F1::Exp => scalar::exp,
            F1::Exp2 => scalar::exp2,
            F1::Log => scalar::log,
            F1::Log2 => scalar::log2,
            F1::Sin => scalar::sin,
            F1::Cos => scalar::cos,
            F1::Tan => scalar::tan,
            F1::Asin => scalar::asin,
            F1::Acos => scalar::acos,
            F1::Atan => scalar::atan,
            F1::Sinh => scalar::sinh,
            F1::Cosh => scalar::cosh,
            F1::Tanh => scalar::tanh,
            F1::Asinh => scalar::asinh,
            F1::Acosh => scalar::acosh,
            F1::Atanh => scalar::atanh,
            F1::Degrees => scalar::degrees,
            F1::Radians => scalar::radians,
        }
    }

    fn f2(op: F2) -> fn(f32, f32) -> f32 {
        match op {
            F2::Add => |x, y| x + y,
            F2::Subtract => |x, y| x - y,
            F2::Multiply => |x, y| x * y,
            F2::Divide => |x, y| x / y,
            F2::Remainder => |x, y| x % y,
            F2::Min => scalar::min,
            F2::Max => scalar::max,
            F2::Step => scalar::step,
            F2::Pow => scalar::pow,
            F2::Atan2 => scalar::atan2,
        }
    }

    fn f3(op: F3) -> fn(f32, f32, f32) -> f32 {
        match op {
            F3::Clamp => scalar::clamp,
            F3::Fma => scalar::fma,
            F3::Mix => scalar::mix,
            F3::SmoothStep => scalar::smoothstep,
        }
    }

    fn compare(op: Comparison, a: f32, b: f32) -> bool {
        op.holds(a, b)
    }
    fn w1(x: u32, f: impl Fn(u32) -> u32) -> u32 {
        f(x)
    }
    fn w2(x: u32, y: u32, f: impl Fn(u32, u32) -> u32) -> u32 {
        f(x, y)
    }
    fn test(x: u32, y: u32, f: impl Fn(u32, u32) -> bool) -> bool {
        f(x, y)
    }
    fn not(x: bool) -> bool {
        !x
    }
    fn and(x: bool, y: bool) -> bool {
        x && y
    }
    fn to_bits(x: f32) -> u32 {
        x.to_bits()
    }
    fn from_bits(x: u32) -> f32 {
        f32::from_bits(x)
    }
    fn to_word(x: f32, f: fn(f64) -> u32) -> u32 {
        f(x.into())
    }
    fn to_float(x: u32, f: fn(u32) -> f64) -> f32 {
        f(x) as f32
    }
    fn bool_to_word(x: bool) -> u32 {
        x.into()
    }
    fn select_float(condition: bool, accept: f32, reject: f32) -> f32 {
        if condition { accept } else { reject }
    }
    fn select_word(condition: bool, accept: u32, reject: u32) -> u32 {
        if condition { accept } else { reject }
    }
    fn select_bool(condition: bool, accept: bool, reject: bool) -> bool {
        if condition { accept } else { reject }
    }
    fn with_truth(result: f32, _: lobe_codegen::def::Truth, _: &[f32]) -> f32 {
        result
    }
}
