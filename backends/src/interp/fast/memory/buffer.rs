//! Loads and stores of memory that lanes share.
#![allow(unsafe_code, reason = "memory that other threads may use is reached by pointers")]
#![allow(
    clippy::needless_range_loop,
    reason = "lanes of several operands side by side, as the vectoriser likes them"
)]

use super::super::super::program::Scalar;
use super::super::machine::{Lane, Machine};
use super::super::shape::{Body, Each, Exec, Same, Source, exec, set_cell, target};
use super::super::{Inst, Isa};
use super::narrow;
use std::marker::PhantomData;

/// `d` = buffer `n[0]` at `s[0] + n[1]`.
struct Load<T>(PhantomData<T>);
/// The same where the address is one.
struct LoadSame<T>(PhantomData<T>);
/// `d`, `s[1]`, `s[2]`, `s[3]`, as many as `n[2]` says, = words of buffer `n[0]` from `s[0] + n[1]` on.
struct LoadSameWords;
/// Buffer `n[0]` at `s[0] + n[1]` = `s[1]` in the lanes of mask `s[2]`.
struct Store<T, I, S>(PhantomData<(T, I, S)>);

impl<T: Lane, const N: usize> Body<N> for Load<T> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let buffer = m.buffers[i.n[0] as usize];
        let size = size_of::<T>();
        // SAFETY: slots as `Body` promises; addresses are clamped to the buffer.
        unsafe {
            let index: &[u32; N] = Each::hold(m, i.s[0]);
            let d: &mut [T; N] = target(m, i.d);
            if let Some(from) = buffer.run(index, i.n[1], size) {
                *d = from.cast::<[T; N]>().read_unaligned();
            } else if buffer.len >= size {
                let last = buffer.len - size;
                for lane in 0..N {
                    let address = (index[lane] as usize + i.n[1] as usize).min(last);
                    d[lane] = buffer.ptr.add(address).cast::<T>().read_unaligned();
                }
            } else {
                d.fill(T::from_cell(0));
            }
        }
        at + 1
    }
}

impl<T: Lane, const N: usize> Body<N> for LoadSame<T> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let buffer = m.buffers[i.n[0] as usize];
        // SAFETY: cells as `Body` promises; the address is clamped to the buffer.
        unsafe {
            let index: u32 = Same::hold(m, i.s[0]);
            let place = buffer.at(u64::from(index) + u64::from(i.n[1]), size_of::<T>());
            let value = place.map_or(T::from_cell(0), |p| p.cast::<T>().read_unaligned());
            set_cell(m, i.d, value);
        }
        at + 1
    }
}

impl<const N: usize> Body<N> for LoadSameWords {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let buffer = m.buffers[i.n[0] as usize];
        // SAFETY: cells as `Body` promises; addresses are clamped to the buffer.
        unsafe {
            let index: u32 = Same::hold(m, i.s[0]);
            let begin = u64::from(index) + u64::from(i.n[1]);
            for (word, to) in [i.d, i.s[1], i.s[2], i.s[3]].into_iter().take(i.n[2] as usize).enumerate() {
                let place = buffer.at(begin + 4 * word as u64, 4);
                set_cell(m, to, place.map_or(0, |p| p.cast::<u32>().read_unaligned()));
            }
        }
        at + 1
    }
}

impl<T: Lane, I: Source, S: Source, const N: usize> Body<N> for Store<T, I, S> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let buffer = m.buffers[i.n[0] as usize];
        let size = size_of::<T>();
        // SAFETY: slots as `Body` promises; addresses are clamped to the buffer.
        unsafe {
            let index = I::hold::<u32, N>(m, i.s[0]);
            let value = S::hold::<T, N>(m, i.s[1]);
            let mask: &[u32; N] = Each::hold(m, i.s[2]);
            let full = mask.iter().fold(u32::MAX, |all, m| all & m) == u32::MAX;
            let mut addresses = [0; N];
            for lane in 0..N {
                addresses[lane] = I::get(index, lane);
            }
            if full && let Some(to) = buffer.run(&addresses, i.n[1], size) {
                let mut values = [T::from_cell(0); N];
                for lane in 0..N {
                    values[lane] = S::get(value, lane);
                }
                to.cast::<[T; N]>().write_unaligned(values);
            } else if buffer.len >= size {
                let last = buffer.len - size;
                for lane in 0..N {
                    if mask[lane] != 0 {
                        let address = (addresses[lane] as usize + i.n[1] as usize).min(last);
                        buffer.ptr.add(address).cast::<T>().write_unaligned(S::get(value, lane));
                    }
                }
            }
        }
        at + 1
    }
}

pub(in super::super) fn load<const N: usize>(scalar: Scalar, index: bool, isa: Isa) -> Exec<N> {
    match (scalar, index) {
        (s, _) if s.bytes() == 2 => narrow::load(s, index),
        (s, true) if s.wide() => exec::<Load<u64>, N>(isa),
        (s, false) if s.wide() => exec::<LoadSame<u64>, N>(isa),
        (_, true) => exec::<Load<u32>, N>(isa),
        (_, false) => exec::<LoadSame<u32>, N>(isa),
    }
}

/// Of 32 bits, where the address is one.
pub(in super::super) fn load_word<const N: usize>(isa: Isa) -> Exec<N> {
    exec::<LoadSame<u32>, N>(isa)
}

/// The same, of up to four neighbours.
pub(in super::super) fn load_words<const N: usize>(isa: Isa) -> Exec<N> {
    exec::<LoadSameWords, N>(isa)
}

// Stores go lane by lane: wider vectors would not help.

fn store_of<T: Lane, const N: usize>(index: bool, value: bool) -> Exec<N> {
    match (index, value) {
        (true, true) => exec::<Store<T, Each, Each>, N>(Isa::Portable),
        (true, false) => exec::<Store<T, Each, Same>, N>(Isa::Portable),
        (false, true) => exec::<Store<T, Same, Each>, N>(Isa::Portable),
        (false, false) => exec::<Store<T, Same, Same>, N>(Isa::Portable),
    }
}

pub(in super::super) fn store<const N: usize>(scalar: Scalar, index: bool, value: bool) -> Exec<N> {
    match scalar {
        s if s.bytes() == 2 => narrow::store(s, index, value),
        s if s.wide() => store_of::<u64, N>(index, value),
        _ => store_of::<u32, N>(index, value),
    }
}
