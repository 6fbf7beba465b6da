//! Floats of 32 bits, as the native functions have them.

use super::super::super::program::op::FloatOp;
use super::super::super::scalar::float as numbers;
use super::super::shape::{
    Ask, Fn1, Found, abreast, one, one_plain, three_alike, two, two_alike, two_commuting,
};
use super::functions;
use lobe_codegen::math::elementary::{finite, near, several};
use lobe_codegen::math::scalar;

functions! {
    Add(a: f32, b: f32) -> f32 = a + b;
    Sub(a: f32, b: f32) -> f32 = a - b;
    Mul(a: f32, b: f32) -> f32 = a * b;
    Div(a: f32, b: f32) -> f32 = a / b;
    Rem(a: f32, b: f32) -> f32 = a % b;
    Neg(a: f32) -> f32 = -a;
    Square(a: f32) -> f32 = a * a;
    Nonnegative(a: f32) -> f32 = a;
    Abs(a: f32) -> f32 = scalar::abs(a);
    Min(a: f32, b: f32) -> f32 = scalar::min(a, b);
    Max(a: f32, b: f32) -> f32 = scalar::max(a, b);
    Sign(a: f32) -> f32 = scalar::sign(a);
    Ceil(a: f32) -> f32 = scalar::ceil(a);
    Floor(a: f32) -> f32 = scalar::floor(a);
    Round(a: f32) -> f32 = scalar::round(a);
    Trunc(a: f32) -> f32 = scalar::trunc(a);
    Fract(a: f32) -> f32 = scalar::fract(a);
    Step(edge: f32, x: f32) -> f32 = scalar::step(edge, x);
    Clamp(x: f32, low: f32, high: f32) -> f32 = scalar::clamp(x, low, high);
    Saturate(x: f32) -> f32 = scalar::saturate(x);
    Sqrt(a: f32) -> f32 = scalar::sqrt(a);
    InverseSqrt(a: f32) -> f32 = scalar::inverse_sqrt(a);
    Log(a: f32) -> f32 = scalar::log(a);
    Log2(a: f32) -> f32 = scalar::log2(a);
    Pow(x: f32, y: f32) -> f32 = scalar::pow(x, y);
    Asin(a: f32) -> f32 = scalar::asin(a);
    Acos(a: f32) -> f32 = scalar::acos(a);
    Atan(a: f32) -> f32 = scalar::atan(a);
    Atan2(y: f32, x: f32) -> f32 = scalar::atan2(y, x);
    Sinh(a: f32) -> f32 = scalar::sinh(a);
    Cosh(a: f32) -> f32 = scalar::cosh(a);
    Tanh(a: f32) -> f32 = scalar::tanh(a);
    Asinh(a: f32) -> f32 = scalar::asinh(a);
    Acosh(a: f32) -> f32 = scalar::acosh(a);
    Atanh(a: f32) -> f32 = scalar::atanh(a);
    Degrees(a: f32) -> f32 = scalar::degrees(a);
    Radians(a: f32) -> f32 = scalar::radians(a);
    Fma(x: f32, y: f32, z: f32) -> f32 = scalar::fma(x, y, z);
    Mix(x: f32, y: f32, t: f32) -> f32 = scalar::mix(x, y, t);
    SmoothStep(low: f32, high: f32, x: f32) -> f32 = scalar::smoothstep(low, high, x);
    Significand(x: f32) -> f32 = numbers::f32(FloatOp::Significand, [x; 3]);
}

/// Functions with a shorter way for most numbers: it is gone where it is right for all lanes.
macro_rules! shortened {
    ($($name:ident $function:ident, $short:path where $right:path;)*) => {
        $(
            pub(super) struct $name;
            impl Fn1 for $name {
                type A = f32;
                type R = f32;
                #[inline(always)]
                fn eval(a: f32) -> f32 {
                    scalar::$function(a)
                }
                #[inline(always)]
                fn lanes<const N: usize>(d: &mut [f32; N], a: &[f32; N]) {
                    if a.iter().fold(true, |all, a| all & $right(*a)) {
                        for lane in 0..N {
                            d[lane] = $short(a[lane]);
                        }
                    } else {
                        for lane in 0..N {
                            d[lane] = Self::eval(a[lane]);
                        }
                    }
                }
            }
        )*
    };
}
shortened! {
    Sin sin, near::sin where near::holds;
    Cos cos, near::cos where near::holds;
    Tan tan, near::tan where near::holds;
}

/// The same for functions that have a form for several numbers abreast.
macro_rules! shortened_abreast {
    ($($name:ident $function:ident where $right:path;)*) => {
        $(
            pub(super) struct $name;
            impl Fn1 for $name {
                type A = f32;
                type R = f32;
                const LONG: bool = true;
                #[inline(always)]
                fn eval(a: f32) -> f32 {
                    scalar::$function(a)
                }
                #[inline(always)]
                fn several<const K: usize>(a: [f32; K]) -> [f32; K] {
                    several::$function(a)
                }
                #[inline(always)]
                fn lanes<const N: usize>(d: &mut [f32; N], a: &[f32; N]) {
                    if a.iter().fold(true, |all, a| all & $right(*a)) {
                        abreast!(d, N, finite::$function, |lane| a[lane]);
                    } else {
                        abreast!(d, N, several::$function, |lane| a[lane]);
                    }
                }
            }
        )*
    };
}
shortened_abreast! {
    Exp exp where finite::has_exp;
    Exp2 exp2 where finite::has_exp2;
}

pub(super) fn find<const N: usize>(op: FloatOp, ask: Ask) -> Found<N> {
    match op {
        FloatOp::Add => two_commuting::<Add, N>(ask),
        FloatOp::Sub => two::<Sub, N>(ask),
        FloatOp::Mul => two_commuting::<Mul, N>(ask),
        FloatOp::Div => two::<Div, N>(ask),
        FloatOp::Rem => two_alike::<Rem, N>(ask),
        FloatOp::Neg => one::<Neg, N>(ask),
        FloatOp::Square => one::<Square, N>(ask),
        FloatOp::Nonnegative => one::<Nonnegative, N>(ask),
        FloatOp::Abs | FloatOp::Length => one::<Abs, N>(ask),
        FloatOp::Min => two::<Min, N>(ask),
        FloatOp::Max => two::<Max, N>(ask),
        FloatOp::Sign => one::<Sign, N>(ask),
        FloatOp::Ceil => one::<Ceil, N>(ask),
        FloatOp::Floor => one::<Floor, N>(ask),
        FloatOp::Round => one::<Round, N>(ask),
        FloatOp::Trunc => one::<Trunc, N>(ask),
        FloatOp::Fract => one::<Fract, N>(ask),
        FloatOp::Step => two_alike::<Step, N>(ask),
        FloatOp::Clamp => three_alike::<Clamp, N>(ask),
        FloatOp::Saturate => one::<Saturate, N>(ask),
        FloatOp::Sqrt => one::<Sqrt, N>(ask),
        FloatOp::InverseSqrt => one::<InverseSqrt, N>(ask),
        FloatOp::Exp => one::<Exp, N>(ask),
        FloatOp::Exp2 => one::<Exp2, N>(ask),
        FloatOp::Log => one::<Log, N>(ask),
        FloatOp::Log2 => one::<Log2, N>(ask),
        FloatOp::Pow => two_alike::<Pow, N>(ask),
        FloatOp::Sin => one::<Sin, N>(ask),
        FloatOp::Cos => one::<Cos, N>(ask),
        FloatOp::Tan => one::<Tan, N>(ask),
        FloatOp::Asin => one::<Asin, N>(ask),
        FloatOp::Acos => one::<Acos, N>(ask),
        FloatOp::Atan => one::<Atan, N>(ask),
        FloatOp::Atan2 => two_alike::<Atan2, N>(ask),
        FloatOp::Sinh => one::<Sinh, N>(ask),
        FloatOp::Cosh => one::<Cosh, N>(ask),
        FloatOp::Tanh => one::<Tanh, N>(ask),
        FloatOp::Asinh => one::<Asinh, N>(ask),
        FloatOp::Acosh => one::<Acosh, N>(ask),
        FloatOp::Atanh => one::<Atanh, N>(ask),
        FloatOp::Degrees => one::<Degrees, N>(ask),
        FloatOp::Radians => one::<Radians, N>(ask),
        FloatOp::Fma => three_alike::<Fma, N>(ask),
        FloatOp::Mix => three_alike::<Mix, N>(ask),
        FloatOp::SmoothStep => three_alike::<SmoothStep, N>(ask),
        FloatOp::Significand => one_plain::<Significand, N>(ask),
    }
}
