//! Integers of 16 and 64 bits.

use super::super::super::program::op::IntOp;
use super::super::super::scalar::integer::Integer;
use super::super::machine::Lane;
use super::super::shape::{
    Ask, Fn1, Fn2, Fn3, Fn4, Found, four_alike, one, three_alike, three_plain, two_alike, two_plain,
};
use std::marker::PhantomData;

/// An operation, as a type.
trait Which: 'static {
    const OP: IntOp;
}

macro_rules! which {
    ($($name:ident)*) => {
        $(struct $name;
        impl Which for $name {
            const OP: IntOp = IntOp::$name;
        })*
    };
}
which! {
    Neg Not Abs Sign CountOneBits CountLeadingZeros CountTrailingZeros ReverseBits FirstLeadingBit FirstTrailingBit
    Add Sub Mul Div Rem And Or Xor Min Max Shl Shr
}

struct Single<T, O>(PhantomData<(T, O)>);
struct Pair<T, O>(PhantomData<(T, O)>);
struct Shift<T, O>(PhantomData<(T, O)>);
struct Clamp<T>(PhantomData<T>);
struct Extract<T>(PhantomData<T>);
struct Insert<T>(PhantomData<T>);

impl<T: Integer<Held: Lane>, O: Which> Fn1 for Single<T, O> {
    type A = T::Held;
    type R = T::Held;
    #[inline(always)]
    fn eval(a: T::Held) -> T::Held {
        T::one(O::OP, a)
    }
}

impl<T: Integer<Held: Lane>, O: Which> Fn2 for Pair<T, O> {
    type A = T::Held;
    type B = T::Held;
    type R = T::Held;
    #[inline(always)]
    fn eval(a: T::Held, b: T::Held) -> T::Held {
        T::two(O::OP, a, b)
    }
}

impl<T: Integer<Held: Lane>, O: Which> Fn2 for Shift<T, O> {
    type A = T::Held;
    type B = u32;
    type R = T::Held;
    #[inline(always)]
    fn eval(a: T::Held, by: u32) -> T::Held {
        T::shift(O::OP, a, by)
    }
}

impl<T: Integer<Held: Lane>> Fn3 for Clamp<T> {
    type A = T::Held;
    type B = T::Held;
    type C = T::Held;
    type R = T::Held;
    #[inline(always)]
    fn eval(a: T::Held, low: T::Held, high: T::Held) -> T::Held {
        T::clamp(a, low, high)
    }
}

impl<T: Integer<Held: Lane>> Fn3 for Extract<T> {
    type A = T::Held;
    type B = u32;
    type C = u32;
    type R = T::Held;
    #[inline(always)]
    fn eval(a: T::Held, at: u32, count: u32) -> T::Held {
        T::extract(a, at, count)
    }
}

impl<T: Integer<Held: Lane>> Fn4 for Insert<T> {
    type A = T::Held;
    type C = u32;
    #[inline(always)]
    fn eval(a: T::Held, bits: T::Held, at: u32, count: u32) -> T::Held {
        T::insert(a, bits, at, count)
    }
}

/// The form of an operation on `T`.
pub(super) fn find<T: Integer<Held: Lane>, const N: usize>(op: IntOp, ask: Ask) -> Found<N> {
    match op {
        IntOp::Neg => one::<Single<T, Neg>, N>(ask),
        IntOp::Not => one::<Single<T, Not>, N>(ask),
        IntOp::Abs => one::<Single<T, Abs>, N>(ask),
        IntOp::Sign => one::<Single<T, Sign>, N>(ask),
        IntOp::CountOneBits => one::<Single<T, CountOneBits>, N>(ask),
        IntOp::CountLeadingZeros => one::<Single<T, CountLeadingZeros>, N>(ask),
        IntOp::CountTrailingZeros => one::<Single<T, CountTrailingZeros>, N>(ask),
        IntOp::ReverseBits => one::<Single<T, ReverseBits>, N>(ask),
        IntOp::FirstLeadingBit => one::<Single<T, FirstLeadingBit>, N>(ask),
        IntOp::FirstTrailingBit => one::<Single<T, FirstTrailingBit>, N>(ask),
        IntOp::Add => two_alike::<Pair<T, Add>, N>(ask),
        IntOp::Sub => two_alike::<Pair<T, Sub>, N>(ask),
        IntOp::Mul => two_alike::<Pair<T, Mul>, N>(ask),
        IntOp::Div => two_plain::<Pair<T, Div>, N>(ask),
        IntOp::Rem => two_plain::<Pair<T, Rem>, N>(ask),
        IntOp::And => two_alike::<Pair<T, And>, N>(ask),
        IntOp::Or => two_alike::<Pair<T, Or>, N>(ask),
        IntOp::Xor => two_alike::<Pair<T, Xor>, N>(ask),
        IntOp::Min => two_alike::<Pair<T, Min>, N>(ask),
        IntOp::Max => two_alike::<Pair<T, Max>, N>(ask),
        IntOp::Shl => two_alike::<Shift<T, Shl>, N>(ask),
        IntOp::Shr => two_alike::<Shift<T, Shr>, N>(ask),
        IntOp::Clamp => three_alike::<Clamp<T>, N>(ask),
        IntOp::ExtractBits => three_plain::<Extract<T>, N>(ask),
        IntOp::InsertBits => four_alike::<Insert<T>, N>(ask),
    }
}
