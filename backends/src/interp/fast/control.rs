//! Jumps and masks.
//!
//! A mask is a slot of all ones or zero a lane. A branch on a varying condition makes a mask for each arm and
//! skips an arm without lanes; a lane that leaves a construct is cleared in all masks up to it.
#![allow(unsafe_code, reason = "steps on slots and cells at once")]

use super::machine::{Lane, Machine};
use super::shape::{Body, Each, Fn2, Same, Source, target};
use super::{Inst, Stop};
use std::marker::PhantomData;

/// Steps that are no operations; `n[0]` is where to jump.
pub(super) struct Jump;
/// Jumps if cell `s[0]` is `WHEN`.
pub(super) struct JumpIf<const WHEN: bool>;
/// Jumps if `F` of cells `s[0]` and `s[1]` is `WHEN`; nothing else asks for what `F` says.
pub(super) struct JumpWhere<F, const WHEN: bool>(PhantomData<F>);
/// `d` = mask `s[0]` where condition `s[1]` is `ACCEPT`; jumps if no lane is left.
pub(super) struct Split<const ACCEPT: bool>;
/// Takes the lanes of mask `s[0]` out of mask `d`.
pub(super) struct Clear;
/// Jumps if mask `s[0]` has no lane.
pub(super) struct SkipEmpty;
/// Begins another round: jumps, as long as there is fuel. `n[1]` is the function.
pub(super) struct Round;
/// `d` takes `s[1]` in the lanes of mask `s[0]`.
pub(super) struct Blend<T, S>(PhantomData<(T, S)>);
/// Stops until all batches of the workgroup are here; mask `s[0]` must have all lanes. `n[0]` is the function.
pub(super) struct Barrier;

/// What a step returns to stop.
const HALT: usize = usize::MAX;

/// Whether no lane is on.
trait Lanes<const N: usize> {
    fn none(mask: &[u32; N]) -> bool;
    fn split<const ACCEPT: bool>(d: &mut [u32; N], mask: &[u32; N], condition: &[u32; N]) -> u32;
}

impl<K, const N: usize> Lanes<N> for K {
    #[inline(always)]
    fn none(mask: &[u32; N]) -> bool {
        mask.iter().fold(0, |any, m| any | m) == 0
    }
    #[inline(always)]
    fn split<const ACCEPT: bool>(d: &mut [u32; N], mask: &[u32; N], condition: &[u32; N]) -> u32 {
        let mut any = 0;
        for lane in 0..N {
            let c = if ACCEPT { condition[lane] } else { !condition[lane] };
            d[lane] = mask[lane] & c;
            any |= d[lane];
        }
        any
    }
}

impl<const N: usize> Body<N> for Jump {
    #[inline(always)]
    unsafe fn run(_: &mut Machine<N>, i: &Inst<N>, _: usize) -> usize {
        i.n[0] as usize
    }
}

impl<const WHEN: bool, const N: usize> Body<N> for JumpIf<WHEN> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        let holds: u32 = unsafe { Same::hold(m, i.s[0]) };
        if (holds != 0) == WHEN { i.n[0] as usize } else { at + 1 }
    }
}

impl<F: Fn2<R = u32>, const WHEN: bool, const N: usize> Body<N> for JumpWhere<F, WHEN> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        let holds = unsafe { F::eval(Same::hold(m, i.s[0]), Same::hold(m, i.s[1])) };
        if (holds != 0) == WHEN { i.n[0] as usize } else { at + 1 }
    }
}

impl<const ACCEPT: bool, const N: usize> Body<N> for Split<ACCEPT> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        let any = unsafe {
            let (mask, condition) = (Each::hold(m, i.s[0]), Each::hold(m, i.s[1]));
            <Self as Lanes<N>>::split::<ACCEPT>(target(m, i.d), mask, condition)
        };
        if any == 0 { i.n[0] as usize } else { at + 1 }
    }
}

impl<const N: usize> Body<N> for Clear {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises; a mask that clears itself is linked as a zero.
        unsafe {
            let mask: &[u32; N] = Each::hold(m, i.s[0]);
            let d: &mut [u32; N] = target(m, i.d);
            for lane in 0..N {
                d[lane] &= !mask[lane];
            }
        }
        at + 1
    }
}

impl<const N: usize> Body<N> for SkipEmpty {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        let none = <Self as Lanes<N>>::none(unsafe { Each::hold(m, i.s[0]) });
        if none { i.n[0] as usize } else { at + 1 }
    }
}

impl<const N: usize> Body<N> for Round {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, _: usize) -> usize {
        if m.fuel == 0 {
            m.stop = Stop::OutOfFuel { function: i.n[1] };
            return HALT;
        }
        m.fuel -= 1;
        i.n[0] as usize
    }
}

/// Types whose bits can be chosen by a mask.
pub(super) trait Chosen: Lane {
    fn choose(mask: u32, a: Self, b: Self) -> Self;
}

impl Chosen for u32 {
    #[inline(always)]
    fn choose(mask: u32, a: Self, b: Self) -> Self {
        (mask & a) | (!mask & b)
    }
}

impl Chosen for u64 {
    #[inline(always)]
    fn choose(mask: u32, a: Self, b: Self) -> Self {
        let mask = i64::from(mask as i32) as u64;
        (mask & a) | (!mask & b)
    }
}

impl<T: Chosen, S: Source, const N: usize> Body<N> for Blend<T, S> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let mask: &[u32; N] = Each::hold(m, i.s[0]);
            let value = S::hold::<T, N>(m, i.s[1]);
            let d: &mut [T; N] = target(m, i.d);
            for lane in 0..N {
                d[lane] = T::choose(mask[lane], S::get(value, lane), d[lane]);
            }
        }
        at + 1
    }
}

impl<const N: usize> Body<N> for Barrier {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        let (mask, live): (&[u32; N], &[u32; N]) = unsafe { (Each::hold(m, i.s[0]), Each::hold(m, 0)) };
        let function = i.n[0];
        let next = at + 1;
        m.stop = if mask == live { Stop::Barrier { next, function } } else { Stop::Apart { next, function } };
        HALT
    }
}
