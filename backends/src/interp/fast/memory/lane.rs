//! Loads and stores of memory that each lane has to itself: a stretch of slots.
//!
//! They go lane by lane: wider vectors would not help.
#![allow(unsafe_code, reason = "steps on slots and cells at once")]
#![allow(
    clippy::needless_range_loop,
    reason = "lanes of several operands side by side, as the vectoriser likes them"
)]

use super::super::super::program::Scalar;
use super::super::machine::{Lane, Machine};
use super::super::shape::{Body, Each, Exec, Same, Source, exec, target};
use super::super::{Inst, Isa};
use std::marker::PhantomData;

/// `d` = slot `n[0] + min(s[0] + n[1], n[2])`, lane by lane; the slots hold `F`.
struct LaneLoad<T, F, I>(PhantomData<(T, F, I)>);
/// The same, written in the lanes of mask `s[2]` with `s[1]`.
struct LaneStore<T, F, I, S>(PhantomData<(T, F, I, S)>);

impl<T: Lane, F: Lane, I: Source, const N: usize> Body<N> for LaneLoad<T, F, I> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: slots as `Body` promises, those of the array among them; indices are clamped to it.
        unsafe {
            let index = I::hold::<u32, N>(m, i.s[0]);
            let array = F::slots(m).add(i.n[0] as usize);
            let d: &mut [T; N] = target(m, i.d);
            for lane in 0..N {
                let slot = I::get(index, lane).saturating_add(i.n[1]).min(i.n[2]);
                d[lane] = T::from_cell((*array.add(slot as usize))[lane].to_cell());
            }
        }
        at + 1
    }
}

impl<T: Lane, F: Lane, I: Source, S: Source, const N: usize> Body<N> for LaneStore<T, F, I, S> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: slots as `Body` promises, those of the array among them; indices are clamped to it.
        unsafe {
            let index = I::hold::<u32, N>(m, i.s[0]);
            let value = S::hold::<T, N>(m, i.s[1]);
            let mask: &[u32; N] = Each::hold(m, i.s[2]);
            let array = F::slots(m).add(i.n[0] as usize);
            for lane in 0..N {
                if mask[lane] != 0 {
                    let slot = I::get(index, lane).saturating_add(i.n[1]).min(i.n[2]);
                    (*array.add(slot as usize))[lane] = F::from_cell(S::get(value, lane).to_cell());
                }
            }
        }
        at + 1
    }
}

pub(in super::super) fn lane_load<const N: usize>(scalar: Scalar, wide: bool, index: bool) -> Exec<N> {
    match (scalar.wide(), wide, index) {
        (true, _, true) => exec::<LaneLoad<u64, u64, Each>, N>(Isa::Portable),
        (true, _, false) => exec::<LaneLoad<u64, u64, Same>, N>(Isa::Portable),
        (false, true, true) => exec::<LaneLoad<u32, u64, Each>, N>(Isa::Portable),
        (false, true, false) => exec::<LaneLoad<u32, u64, Same>, N>(Isa::Portable),
        (false, false, true) => exec::<LaneLoad<u32, u32, Each>, N>(Isa::Portable),
        (false, false, false) => exec::<LaneLoad<u32, u32, Same>, N>(Isa::Portable),
    }
}

fn lane_store_of<T: Lane, F: Lane, const N: usize>(index: bool, value: bool) -> Exec<N> {
    match (index, value) {
        (true, true) => exec::<LaneStore<T, F, Each, Each>, N>(Isa::Portable),
        (true, false) => exec::<LaneStore<T, F, Each, Same>, N>(Isa::Portable),
        (false, true) => exec::<LaneStore<T, F, Same, Each>, N>(Isa::Portable),
        (false, false) => exec::<LaneStore<T, F, Same, Same>, N>(Isa::Portable),
    }
}

pub(in super::super) fn lane_store<const N: usize>(
    scalar: Scalar,
    wide: bool,
    [index, value]: [bool; 2],
) -> Exec<N> {
    match (scalar.wide(), wide) {
        (true, _) => lane_store_of::<u64, u64, N>(index, value),
        (false, true) => lane_store_of::<u32, u64, N>(index, value),
        (false, false) => lane_store_of::<u32, u32, N>(index, value),
    }
}
