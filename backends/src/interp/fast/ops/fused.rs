//! Pairs of additions, subtractions and products, each rounded.

use super::super::super::program::op::Simple;
use super::super::shape::{Ask, Fn2, Fn3, Found, three, three_any};
use super::float::{Add, Mul, Sub};
use std::marker::PhantomData;

/// A function of two f32.
trait Pair: Fn2<A = f32, B = f32, R = f32> {}
impl Pair for Add {}
impl Pair for Sub {}
impl Pair for Mul {}

/// `(a F b) G c`
pub(super) struct Then<F, G>(PhantomData<(F, G)>);
/// `c G (a F b)`
struct After<F, G>(PhantomData<(F, G)>);

impl<F: Pair, G: Pair> Fn3 for Then<F, G> {
    type A = f32;
    type B = f32;
    type C = f32;
    type R = f32;
    #[inline(always)]
    fn eval(a: f32, b: f32, c: f32) -> f32 {
        G::eval(F::eval(a, b), c)
    }
}

impl<F: Pair, G: Pair> Fn3 for After<F, G> {
    type A = f32;
    type B = f32;
    type C = f32;
    type R = f32;
    #[inline(always)]
    fn eval(a: f32, b: f32, c: f32) -> f32 {
        G::eval(c, F::eval(a, b))
    }
}

/// The form of a pair; `flipped` matters for subtractions only.
pub(super) fn find<const N: usize>(first: Simple, second: Simple, flipped: bool, ask: Ask) -> Found<N> {
    match (first, second, flipped) {
        (Simple::Add, Simple::Add, _) => three::<Then<Add, Add>, N>(ask),
        (Simple::Add, Simple::Sub, false) => three::<Then<Add, Sub>, N>(ask),
        (Simple::Add, Simple::Sub, true) => three::<After<Add, Sub>, N>(ask),
        (Simple::Add, Simple::Mul, _) => three::<Then<Add, Mul>, N>(ask),
        (Simple::Sub, Simple::Add, _) => three_any::<Then<Sub, Add>, N>(ask),
        (Simple::Sub, Simple::Sub, false) => three_any::<Then<Sub, Sub>, N>(ask),
        (Simple::Sub, Simple::Sub, true) => three_any::<After<Sub, Sub>, N>(ask),
        (Simple::Sub, Simple::Mul, _) => three_any::<Then<Sub, Mul>, N>(ask),
        (Simple::Mul, Simple::Add, _) => three::<Then<Mul, Add>, N>(ask),
        (Simple::Mul, Simple::Sub, false) => three::<Then<Mul, Sub>, N>(ask),
        (Simple::Mul, Simple::Sub, true) => three::<After<Mul, Sub>, N>(ask),
        (Simple::Mul, Simple::Mul, _) => three::<Then<Mul, Mul>, N>(ask),
    }
}
