//! Indices to addresses, and lengths.
#![allow(unsafe_code, reason = "steps on slots and cells at once")]
#![allow(
    clippy::needless_range_loop,
    reason = "lanes of several operands side by side, as the vectoriser likes them"
)]

use super::super::machine::Machine;
use super::super::shape::{Body, Each, Exec, Same, Source, exec, set_cell, target};
use super::super::{Inst, Isa};
use std::marker::PhantomData;

/// `d` = `s[1] + min(s[0], last) * n[0]`, `last` by `n[1]` and `n[2]`.
struct Index<I, S>(PhantomData<(I, S)>);
struct IndexSame;
/// `d` = elements of `n[2]` bytes in buffer `n[0]` from byte `n[1]` on.
struct Length;

/// The last element that an index may mean.
#[inline(always)]
fn last<const N: usize>(m: &Machine<N>, n: [u32; 3]) -> u32 {
    let count = match n[2] {
        0 => n[1],
        buffer => {
            let bytes = m.buffers[buffer as usize - 1].len.saturating_sub(n[1] as usize);
            (bytes / (n[0].max(1) as usize)).min(u32::MAX as usize) as u32
        }
    };
    count.saturating_sub(1)
}

impl<I: Source, S: Source, const N: usize> Body<N> for Index<I, S> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let (last, stride) = (last(m, i.n), i.n[0]);
        // SAFETY: as `Body` promises.
        unsafe {
            let (index, base) = (I::hold::<u32, N>(m, i.s[0]), S::hold::<u32, N>(m, i.s[1]));
            let d: &mut [u32; N] = target(m, i.d);
            for lane in 0..N {
                let scaled = I::get(index, lane).min(last).wrapping_mul(stride);
                d[lane] = S::get(base, lane).wrapping_add(scaled);
            }
        }
        at + 1
    }
}

impl<const N: usize> Body<N> for IndexSame {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let (last, stride) = (last(m, i.n), i.n[0]);
        // SAFETY: as `Body` promises.
        unsafe {
            let (index, base): (u32, u32) = (Same::hold(m, i.s[0]), Same::hold(m, i.s[1]));
            set_cell(m, i.d, base.wrapping_add(index.min(last).wrapping_mul(stride)));
        }
        at + 1
    }
}

impl<const N: usize> Body<N> for Length {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let bytes = m.buffers[i.n[0] as usize].len.saturating_sub(i.n[1] as usize);
        let count = bytes / i.n[2].max(1) as usize;
        // SAFETY: as `Body` promises.
        unsafe { set_cell(m, i.d, count.min(u32::MAX as usize) as u32) };
        at + 1
    }
}

pub(in super::super) fn length<const N: usize>(isa: Isa) -> Exec<N> {
    exec::<Length, N>(isa)
}

pub(in super::super) fn index<const N: usize>(index: bool, base: bool, isa: Isa) -> Exec<N> {
    match (index, base) {
        (true, true) => exec::<Index<Each, Each>, N>(isa),
        (true, false) => exec::<Index<Each, Same>, N>(isa),
        (false, true) => exec::<Index<Same, Each>, N>(isa),
        (false, false) => exec::<IndexSame, N>(isa),
    }
}
