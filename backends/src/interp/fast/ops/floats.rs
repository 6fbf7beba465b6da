//! Floats of 16 and 64 bits.

use super::super::super::program::Scalar;
use super::super::super::program::op::FloatOp;
use super::super::super::scalar::float;
use super::super::machine::Lane;
use super::super::shape::{
    Ask, Fn1, Fn2, Fn3, Found, one, one_plain, three_alike, three_plain, two_alike, two_plain,
};
use super::functions;
use std::marker::PhantomData;

/// Floats of a width.
pub(super) trait Width: 'static {
    type Held: Lane;
    fn eval(op: FloatOp, args: [Self::Held; 3]) -> Self::Held;
}

/// 16 bits, held as f32.
pub(super) struct Half;
/// 64 bits.
pub(super) struct Double;

impl Width for Half {
    type Held = f32;
    #[inline(always)]
    fn eval(op: FloatOp, args: [f32; 3]) -> f32 {
        float::f16(op, args)
    }
}

impl Width for Double {
    type Held = f64;
    #[inline(always)]
    fn eval(op: FloatOp, args: [f64; 3]) -> f64 {
        float::f64(op, args)
    }
}

/// An operation, as a type.
trait Which: 'static {
    const OP: FloatOp;
}

struct Single<W, O>(PhantomData<(W, O)>);
struct Pair<W, O>(PhantomData<(W, O)>);
struct Triple<W, O>(PhantomData<(W, O)>);

impl<W: Width, O: Which> Fn1 for Single<W, O> {
    type A = W::Held;
    type R = W::Held;
    #[inline(always)]
    fn eval(a: W::Held) -> W::Held {
        W::eval(O::OP, [a; 3])
    }
}

impl<W: Width, O: Which> Fn2 for Pair<W, O> {
    type A = W::Held;
    type B = W::Held;
    type R = W::Held;
    #[inline(always)]
    fn eval(a: W::Held, b: W::Held) -> W::Held {
        W::eval(O::OP, [a, b, b])
    }
}

impl<W: Width, O: Which> Fn3 for Triple<W, O> {
    type A = W::Held;
    type B = W::Held;
    type C = W::Held;
    type R = W::Held;
    #[inline(always)]
    fn eval(a: W::Held, b: W::Held, c: W::Held) -> W::Held {
        W::eval(O::OP, [a, b, c])
    }
}

/// Operations by the form that they have.
macro_rules! forms {
    ($($form:ident $shape:ident: $($name:ident)*;)*) => {
        $($(struct $name;
        impl Which for $name {
            const OP: FloatOp = FloatOp::$name;
        })*)*

        /// The form of an operation.
        pub(super) fn find<W: Width, const N: usize>(op: FloatOp, ask: Ask) -> Found<N> {
            match op {
                $($(FloatOp::$name => $form::<$shape<W, $name>, N>(ask),)*)*
            }
        }
    };
}

forms! {
    one Single: Neg Square Nonnegative Abs Sign Ceil Floor Round Trunc Fract Saturate Sqrt Degrees Radians Length;
    one_plain Single: InverseSqrt Exp Exp2 Log Log2 Sin Cos Tan Asin Acos Atan Sinh Cosh Tanh Asinh Acosh Atanh
        Significand;
    two_alike Pair: Add Sub Mul Div Min Max Step;
    two_plain Pair: Rem Pow Atan2;
    three_alike Triple: Clamp Mix SmoothStep;
    three_plain Triple: Fma;
}

functions! {
    Exponent(a: f32) -> i32 = float::exponent(a.into());
    ExponentDouble(a: f64) -> i32 = float::exponent(a);
    Ldexp(a: f32, by: i32) -> f32 = float::ldexp_f32(a, by);
    LdexpHalf(a: f32, by: i32) -> f32 = float::ldexp_f16(a, by);
    LdexpDouble(a: f64, by: i32) -> f64 = float::ldexp_f64(a, by);
}

/// The power of two of a float.
pub(super) fn exponent<const N: usize>(scalar: Scalar, ask: Ask) -> Found<N> {
    if scalar.wide() { one_plain::<ExponentDouble, N>(ask) } else { one_plain::<Exponent, N>(ask) }
}

/// A float times a power of two.
pub(super) fn ldexp<const N: usize>(scalar: Scalar, ask: Ask) -> Found<N> {
    match scalar {
        Scalar::F16 => two_plain::<LdexpHalf, N>(ask),
        Scalar::F64 => two_plain::<LdexpDouble, N>(ask),
        _ => two_plain::<Ldexp, N>(ask),
    }
}
