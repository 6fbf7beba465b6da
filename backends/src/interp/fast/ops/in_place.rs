//! Operations whose result takes the place of an operand: sums and the like over the rounds of a loop.
#![allow(unsafe_code, reason = "one step on slots at once")]
#![allow(
    clippy::needless_range_loop,
    reason = "lanes of several operands side by side, as the vectoriser likes them"
)]

use super::super::super::program::op::{FloatOp, Simple};
use super::super::super::program::{Op, Scalar};
use super::super::Inst;
use super::super::machine::Machine;
use super::super::shape::{Ask, Body, Each, Exec, Fn2, Same, Source, exec, target};
use super::float::{Add, Max, Min, Mul, Sub};
use std::marker::PhantomData;

/// What is done to the slot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum InPlace {
    Add,
    Sub,
    Mul,
    Min,
    Max,
    /// The product of two others is added, or taken away.
    AddProduct,
    SubProduct,
}

impl InPlace {
    /// Whether the first of the other operands must be a slot; of two, one always is.
    pub(in super::super) fn needs_slot(self) -> bool {
        matches!(self, Self::AddProduct | Self::SubProduct)
    }
}

/// `d` = `d` F `s[0]`.
struct Update<F, S>(PhantomData<(F, S)>);
/// `d` = `d` F (`s[0]` * `s[1]`), rounded twice.
struct UpdateByProduct<F, S>(PhantomData<(F, S)>);

/// `d` = `d` + (`s[0]` * `s[1]`) * `s[2]`, rounded each time.
struct AddProducts<S, T>(PhantomData<(S, T)>);

impl<F: Fn2<A = f32, B = f32, R = f32>, S: Source, const N: usize> Body<N> for Update<F, S> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let a = S::hold::<f32, N>(m, i.s[0]);
            let d: &mut [f32; N] = target(m, i.d);
            for lane in 0..N {
                d[lane] = F::eval(d[lane], S::get(a, lane));
            }
        }
        at + 1
    }
}

impl<F: Fn2<A = f32, B = f32, R = f32>, S: Source, const N: usize> Body<N> for UpdateByProduct<F, S> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let a: &[f32; N] = Each::hold(m, i.s[0]);
            let b = S::hold::<f32, N>(m, i.s[1]);
            let d: &mut [f32; N] = target(m, i.d);
            for lane in 0..N {
                d[lane] = F::eval(d[lane], a[lane] * S::get(b, lane));
            }
        }
        at + 1
    }
}

impl<S: Source, T: Source, const N: usize> Body<N> for AddProducts<S, T> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let a: &[f32; N] = Each::hold(m, i.s[0]);
            let (b, c) = (S::hold::<f32, N>(m, i.s[1]), T::hold::<f32, N>(m, i.s[2]));
            let d: &mut [f32; N] = target(m, i.d);
            for lane in 0..N {
                d[lane] += a[lane] * S::get(b, lane) * T::get(c, lane);
            }
        }
        at + 1
    }
}

/// The form in place of an operation, and the operands whose place its result can take.
pub(in super::super) fn in_place(op: Op) -> Option<(InPlace, &'static [usize])> {
    match op {
        Op::Float(Scalar::F32, FloatOp::Add) => Some((InPlace::Add, &[0, 1])),
        Op::Float(Scalar::F32, FloatOp::Sub) => Some((InPlace::Sub, &[0])),
        Op::Float(Scalar::F32, FloatOp::Mul) => Some((InPlace::Mul, &[0, 1])),
        Op::Float(Scalar::F32, FloatOp::Min) => Some((InPlace::Min, &[0])),
        Op::Float(Scalar::F32, FloatOp::Max) => Some((InPlace::Max, &[0])),
        Op::Fused { first: Simple::Mul, second: Simple::Add, .. } => Some((InPlace::AddProduct, &[2])),
        Op::Fused { first: Simple::Mul, second: Simple::Sub, flipped: true } => {
            Some((InPlace::SubProduct, &[2]))
        }
        _ => None,
    }
}

/// The step; `ask` is about the other operands. Of a product, the first is a slot.
pub(in super::super) fn update<const N: usize>(op: InPlace, ask: Ask) -> Exec<N> {
    match op {
        InPlace::Add => by::<Add, N>(ask),
        InPlace::Sub => by::<Sub, N>(ask),
        InPlace::Mul => by::<Mul, N>(ask),
        InPlace::Min => by::<Min, N>(ask),
        InPlace::Max => by::<Max, N>(ask),
        InPlace::AddProduct => by_product::<Add, N>(ask),
        InPlace::SubProduct => by_product::<Sub, N>(ask),
    }
}

fn by<F: Fn2<A = f32, B = f32, R = f32>, const N: usize>(Ask { isa, varying }: Ask) -> Exec<N> {
    if varying[0] { exec::<Update<F, Each>, N>(isa) } else { exec::<Update<F, Same>, N>(isa) }
}

fn by_product<F: Fn2<A = f32, B = f32, R = f32>, const N: usize>(Ask { isa, varying }: Ask) -> Exec<N> {
    if varying[1] {
        exec::<UpdateByProduct<F, Each>, N>(isa)
    } else {
        exec::<UpdateByProduct<F, Same>, N>(isa)
    }
}

/// Adds products of three to a slot, the first of which is a slot.
pub(in super::super) fn add_products<const N: usize>(Ask { isa, varying }: Ask) -> Exec<N> {
    match (varying[1], varying[2]) {
        (true, true) => exec::<AddProducts<Each, Each>, N>(isa),
        (true, false) => exec::<AddProducts<Each, Same>, N>(isa),
        (false, true) => exec::<AddProducts<Same, Each>, N>(isa),
        (false, false) => exec::<AddProducts<Same, Same>, N>(isa),
    }
}
