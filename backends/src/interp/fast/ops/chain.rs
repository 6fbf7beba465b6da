//! A function of the result of a simple operation, in one step: what is between stays in a register of the machine.

use super::super::super::program::op::{FloatOp, Simple};
use super::super::super::program::{Eval, Op, Scalar, Value};
use super::super::shape::{Ask, Fn1, Fn2, Fn3, Found, one, three, three_any, two_alike, two_commuting};
use super::super::{Isa, LANES};
use super::float::{Add, Div, Exp, Exp2, Mul, Neg, Sqrt, Sub};
use super::fused::Then;
use std::marker::PhantomData;

/// `G` of the result of `F`.
struct Of<G, F>(PhantomData<(G, F)>);

impl<G: Fn1<A = f32>, F: Fn1<R = f32>> Fn1 for Of<G, F> {
    type A = F::A;
    type R = G::R;
    const LONG: bool = G::LONG;
    #[inline(always)]
    fn eval(a: F::A) -> G::R {
        G::eval(F::eval(a))
    }
    #[inline(always)]
    fn several<const K: usize>(a: [F::A; K]) -> [G::R; K] {
        G::several(F::several(a))
    }
}

impl<G: Fn1<A = f32>, F: Fn2<R = f32>> Fn2 for Of<G, F> {
    type A = F::A;
    type B = F::B;
    type R = G::R;
    const LONG: bool = G::LONG;
    #[inline(always)]
    fn eval(a: F::A, b: F::B) -> G::R {
        G::eval(F::eval(a, b))
    }
    #[inline(always)]
    fn several<const K: usize>(a: [F::A; K], b: [F::B; K]) -> [G::R; K] {
        G::several(F::several(a, b))
    }
}

impl<G: Fn1<A = f32>, F: Fn3<R = f32>> Fn3 for Of<G, F> {
    type A = F::A;
    type B = F::B;
    type C = F::C;
    type R = G::R;
    const LONG: bool = G::LONG;
    #[inline(always)]
    fn eval(a: F::A, b: F::B, c: F::C) -> G::R {
        G::eval(F::eval(a, b, c))
    }
    #[inline(always)]
    fn several<const K: usize>(a: [F::A; K], b: [F::B; K], c: [F::C; K]) -> [G::R; K] {
        G::several(F::several(a, b, c))
    }
}

/// Whether there is a form for the two, the second of nothing but the result of the first.
pub(in super::super) fn chained(first: &Eval, second: &Eval) -> bool {
    let ask = Ask { isa: Isa::Portable, varying: [true; 4] };
    second.args[..] == [Value::Reg(first.to)] && find::<LANES>(first.op, second.op, ask).is_some()
}

/// The form of `second` of the result of `first`, if there is one: those that kernels are full of.
pub(in super::super) fn find<const N: usize>(first: Op, second: Op, ask: Ask) -> Found<N> {
    use FloatOp as F;
    let Op::Float(Scalar::F32, second) = second else {
        return None;
    };
    match (first, second) {
        (Op::Float(Scalar::F32, F::Mul), F::Exp) => two_commuting::<Of<Exp, Mul>, N>(ask),
        (Op::Float(Scalar::F32, F::Neg), F::Exp) => one::<Of<Exp, Neg>, N>(ask),
        (Op::Float(Scalar::F32, F::Mul), F::Exp2) => two_commuting::<Of<Exp2, Mul>, N>(ask),
        (Op::Float(Scalar::F32, F::Neg), F::Exp2) => one::<Of<Exp2, Neg>, N>(ask),
        (Op::Fused { first: Simple::Sub, second: Simple::Sub, flipped: false }, F::Exp) => {
            three_any::<Of<Exp, Then<Sub, Sub>>, N>(ask)
        }
        (Op::Fused { first: Simple::Sub, second: Simple::Mul, .. }, F::Exp) => {
            three_any::<Of<Exp, Then<Sub, Mul>>, N>(ask)
        }
        (Op::Float(Scalar::F32, F::Div), F::Sqrt) => two_alike::<Of<Sqrt, Div>, N>(ask),
        (Op::Fused { first: Simple::Mul, second: Simple::Add, .. }, F::Sqrt) => {
            three::<Of<Sqrt, Then<Mul, Add>>, N>(ask)
        }
        _ => None,
    }
}
