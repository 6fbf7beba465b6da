//! Pairs of additions, subtractions and products, each rounded.

use super::super::super::program::op::Simple;
use super::super::shape::{Ask, Fn2, Fn3, Found, three};
use super::float::{Add, Mul, Sub};
use std::marker::PhantomData;

/// A function of two f32.
trait Pair: Fn2<A = f32, B = f32, R = f32> {}
impl Pair for Add {}
impl Pair for Sub {}
impl Pair for Mul {}

/// `(a F b) G c`
struct Then<F, G>(PhantomData<(F, G)>);
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

pub(super) fn find<const N: usize>(first: Simple, second: Simple, flipped: bool, ask: Ask) -> Found<N> {
    match first {
        Simple::Add => follow::<Add, N>(second, flipped, ask),
        Simple::Sub => follow::<Sub, N>(second, flipped, ask),
        Simple::Mul => follow::<Mul, N>(second, flipped, ask),
    }
}

fn follow<F: Pair, const N: usize>(second: Simple, flipped: bool, ask: Ask) -> Found<N> {
    match (second, flipped) {
        (Simple::Add, false) => three::<Then<F, Add>, N>(ask),
        (Simple::Add, true) => three::<After<F, Add>, N>(ask),
        (Simple::Sub, false) => three::<Then<F, Sub>, N>(ask),
        (Simple::Sub, true) => three::<After<F, Sub>, N>(ask),
        (Simple::Mul, false) => three::<Then<F, Mul>, N>(ask),
        (Simple::Mul, true) => three::<After<F, Mul>, N>(ask),
    }
}
