//! Addresses, loads, stores, atomics, inputs.
//!
//! Whatever an address is, it is clamped to its memory here, so that no program can leave it.
#![allow(unsafe_code, reason = "memory that other threads may use is reached by pointers")]
#![allow(
    clippy::needless_range_loop,
    reason = "lanes of several operands side by side, as the vectoriser likes them"
)]

mod atomics;
mod narrow;

pub(super) use atomics::number;

use super::super::program::op::Input;
use super::super::program::{Scalar, Update};
use super::machine::{Bound, Lane, Machine};
use super::shape::{Body, Each, Exec, Same, Source, exec, set_cell, target};
use super::{Inst, Isa};
use std::marker::PhantomData;
use std::sync::atomic::{AtomicI32, AtomicU32, Ordering::Relaxed};

impl Bound {
    /// The place of a scalar of `size` bytes; `None` in memory that is too short for any.
    #[inline(always)]
    fn at(self, address: u64, size: usize) -> Option<*mut u8> {
        let last = self.len.checked_sub(size)?;
        Some(self.ptr.wrapping_add((address as usize).min(last)))
    }

    /// Whether `index` runs through memory without gaps: then where it begins.
    #[inline(always)]
    fn run<const N: usize>(self, index: &[u32; N], offset: u32, size: usize) -> Option<*mut u8> {
        let step = size as u32;
        let mut apart = 0;
        for (lane, at) in index.iter().enumerate() {
            apart |= at ^ index[0].wrapping_add(lane as u32 * step);
        }
        let first = index[0] as usize + offset as usize;
        let fits = first + N * size <= self.len && index[0].checked_add(N as u32 * step).is_some();
        (apart == 0 && fits).then(|| self.ptr.wrapping_add(first))
    }
}

/// `d` = buffer `n[0]` at `s[0] + n[1]`.
struct Load<T>(PhantomData<T>);
/// The same where the address is one.
struct LoadSame<T>(PhantomData<T>);
/// Buffer `n[0]` at `s[0] + n[1]` = `s[1]` in the lanes of mask `s[2]`.
struct Store<T, I, S>(PhantomData<(T, I, S)>);
/// `d` = slot `n[0] + min(s[0] + n[1], n[2])`, lane by lane; the slots hold `F`.
struct LaneLoad<T, F, I>(PhantomData<(T, F, I)>);
/// The same, written in the lanes of mask `s[2]` with `s[1]`.
struct LaneStore<T, F, I, S>(PhantomData<(T, F, I, S)>);
/// `d` = `s[1] + min(s[0], last) * n[0]`, `last` by `n[1]` and `n[2]`.
struct Index<I, S>(PhantomData<(I, S)>);
struct IndexSame;
/// `d` = elements of `n[2]` bytes in buffer `n[0]` from byte `n[1]` on.
struct Length;
/// Atomic update of buffer `n[0]` at `s[0] + n[1]` by `s[1]`, expecting `s[3]`, in the lanes of mask `s[2]`.
struct Atomic<const FUN: u8>;
/// Fills `d` with input `n[0]`, part `n[1]`; `n[2]` says that it is a boolean.
struct Provide;

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

impl<const FUN: u8, const N: usize> Body<N> for Atomic<FUN> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let buffer = m.buffers[i.n[0] as usize];
        // SAFETY: slots as `Body` promises; addresses are clamped, and aligned since types are.
        unsafe {
            let index: &[u32; N] = Each::hold(m, i.s[0]);
            let value: &[u32; N] = Each::hold(m, i.s[1]);
            let mask: &[u32; N] = Each::hold(m, i.s[2]);
            let expected: &[u32; N] = Each::hold(m, i.s[3]);
            let old: &mut [u32; N] = target(m, i.d);
            for lane in 0..N {
                old[lane] = 0;
                let place = buffer.at(u64::from(index[lane]) + u64::from(i.n[1]), 4);
                if let (true, Some(place)) = (mask[lane] != 0, place) {
                    let word = place.map_addr(|a| a & !3).cast();
                    old[lane] = update::<FUN>(word, value[lane], expected[lane]);
                }
            }
        }
        at + 1
    }
}

/// # Safety
/// The word exists and is aligned.
unsafe fn update<const FUN: u8>(word: *mut u32, value: u32, expected: u32) -> u32 {
    // SAFETY: as the caller promises; all threads use the word so.
    let (word, signed) = unsafe { (AtomicU32::from_ptr(word), AtomicI32::from_ptr(word.cast())) };
    match FUN {
        0 => word.fetch_add(value, Relaxed),
        1 => word.fetch_sub(value, Relaxed),
        2 => word.fetch_and(value, Relaxed),
        3 => word.fetch_xor(value, Relaxed),
        4 => word.fetch_or(value, Relaxed),
        5 => word.fetch_min(value, Relaxed),
        6 => word.fetch_max(value, Relaxed),
        7 => word.swap(value, Relaxed),
        8 => word.compare_exchange(expected, value, Relaxed, Relaxed).unwrap_or_else(|old| old),
        9 => signed.fetch_min(value as i32, Relaxed) as u32,
        _ => signed.fetch_max(value as i32, Relaxed) as u32,
    }
}

impl<const N: usize> Body<N> for Provide {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        let d: &mut [u32; N] = unsafe { target(m, i.d) };
        m.provide(i.n, d);
        at + 1
    }
}

impl<const N: usize> Machine<N> {
    fn provide(&self, [kind, part, boolean]: [u32; 3], d: &mut [u32; N]) {
        let p = self.position;
        if kind == 0 {
            // SAFETY: a column has as many rows as the batch has lanes, from its first row on.
            let column =
                unsafe { std::slice::from_raw_parts(self.columns[part as usize].add(p.first), p.live) };
            d[p.live..].fill(0);
            if boolean == 0 {
                d[..p.live].copy_from_slice(column);
            } else {
                d.iter_mut().zip(column).for_each(|(d, c)| *d = u32::from(*c != 0).wrapping_neg());
            }
            return;
        }
        let axis = part as usize;
        if kind == 1 && axis == 0 && p.size[1..] == [1, 1] && p.groups[1..] == [1, 1] {
            d.iter_mut().zip(p.first as u32..).for_each(|(d, id)| *d = id);
            return;
        }
        self.each_invocation(|lane, local, group, index| {
            d[lane] = match kind {
                1 => group[axis].wrapping_mul(p.size[axis]).wrapping_add(local[axis]),
                2 => local[axis],
                3 => index,
                5 => index % p.subgroup.max(1),
                6 => index / p.subgroup.max(1),
                _ => group[axis],
            };
        });
    }

    /// Calls `f` with lane, place in the workgroup, workgroup and index in it.
    fn each_invocation(&self, mut f: impl FnMut(usize, [u32; 3], [u32; 3], u32)) {
        let p = self.position;
        let volume: usize = p.size.iter().map(|n| *n as usize).product();
        let split = |at: usize, size: [u32; 3]| {
            let (w, h) = (size[0].max(1) as usize, size[1].max(1) as usize);
            [at % w, at / w % h, at / (w * h)].map(|n| n as u32)
        };
        let (mut workgroup, mut index) = (p.first / volume.max(1), p.first % volume.max(1));
        let (mut group, mut local) = (split(workgroup, p.groups), split(index, p.size));
        for lane in 0..N {
            f(lane, local, group, index as u32);
            index += 1;
            local[0] += 1;
            if local[0] == p.size[0] {
                local = [0, local[1] + 1, local[2]];
                if local[1] == p.size[1] {
                    local = [0, 0, local[2] + 1];
                }
            }
            if index == volume {
                (index, workgroup, local) = (0, workgroup + 1, [0; 3]);
                group = split(workgroup, p.groups);
            }
        }
    }
}

/// The kind and part of a lane input, as [`Provide`] takes them; `None` for uniform ones.
pub(super) fn input(input: Input) -> Option<[u32; 2]> {
    match input {
        Input::Column(column) => Some([0, column]),
        Input::GlobalInvocationId(axis) => Some([1, axis.into()]),
        Input::LocalInvocationId(axis) => Some([2, axis.into()]),
        Input::LocalInvocationIndex => Some([3, 0]),
        Input::WorkGroupId(axis) => Some([4, axis.into()]),
        Input::SubgroupInvocationId => Some([5, 0]),
        Input::SubgroupId => Some([6, 0]),
        Input::NumWorkGroups(_) | Input::WorkGroupSize(_) | Input::SubgroupSize | Input::NumSubgroups => None,
    }
}

/// A uniform built-in: `n[0]` which, `n[1]` the axis.
struct ProvideSame;

impl<const N: usize> Body<N> for ProvideSame {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let p = m.position;
        let axis = i.n[1] as usize;
        let value = match i.n[0] {
            0 => p.groups[axis],
            1 => p.size[axis],
            3 => p.subgroup,
            4 => p.size.iter().product::<u32>().div_ceil(p.subgroup.max(1)),
            _ => {
                let volume: usize = p.size.iter().map(|n| *n as usize).product();
                let at = p.first / volume.max(1);
                let (w, h) = (p.groups[0].max(1) as usize, p.groups[1].max(1) as usize);
                [at % w, at / w % h, at / (w * h)][axis] as u32
            }
        };
        // SAFETY: as `Body` promises.
        unsafe { set_cell(m, i.d, value) };
        at + 1
    }
}

pub(super) fn provide<const N: usize>(isa: Isa) -> Exec<N> {
    exec::<Provide, N>(isa)
}

pub(super) fn provide_same<const N: usize>(isa: Isa) -> Exec<N> {
    exec::<ProvideSame, N>(isa)
}

pub(super) fn length<const N: usize>(isa: Isa) -> Exec<N> {
    exec::<Length, N>(isa)
}

pub(super) fn index<const N: usize>(index: bool, base: bool, isa: Isa) -> Exec<N> {
    match (index, base) {
        (true, true) => exec::<Index<Each, Each>, N>(isa),
        (true, false) => exec::<Index<Each, Same>, N>(isa),
        (false, true) => exec::<Index<Same, Each>, N>(isa),
        (false, false) => exec::<IndexSame, N>(isa),
    }
}

pub(super) fn load<const N: usize>(scalar: Scalar, index: bool, isa: Isa) -> Exec<N> {
    match (scalar, index) {
        (s, _) if s.bytes() == 2 => narrow::load(s, index),
        (s, true) if s.wide() => exec::<Load<u64>, N>(isa),
        (s, false) if s.wide() => exec::<LoadSame<u64>, N>(isa),
        (_, true) => exec::<Load<u32>, N>(isa),
        (_, false) => exec::<LoadSame<u32>, N>(isa),
    }
}

// From here on steps go lane by lane: wider vectors would not help.

fn store_of<T: Lane, const N: usize>(index: bool, value: bool) -> Exec<N> {
    match (index, value) {
        (true, true) => exec::<Store<T, Each, Each>, N>(Isa::Portable),
        (true, false) => exec::<Store<T, Each, Same>, N>(Isa::Portable),
        (false, true) => exec::<Store<T, Same, Each>, N>(Isa::Portable),
        (false, false) => exec::<Store<T, Same, Same>, N>(Isa::Portable),
    }
}

pub(super) fn store<const N: usize>(scalar: Scalar, index: bool, value: bool) -> Exec<N> {
    match scalar {
        s if s.bytes() == 2 => narrow::store(s, index, value),
        s if s.wide() => store_of::<u64, N>(index, value),
        _ => store_of::<u32, N>(index, value),
    }
}

pub(super) fn lane_load<const N: usize>(scalar: Scalar, wide: bool, index: bool) -> Exec<N> {
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

pub(super) fn lane_store<const N: usize>(scalar: Scalar, wide: bool, [index, value]: [bool; 2]) -> Exec<N> {
    match (scalar.wide(), wide) {
        (true, _) => lane_store_of::<u64, u64, N>(index, value),
        (false, true) => lane_store_of::<u32, u64, N>(index, value),
        (false, false) => lane_store_of::<u32, u32, N>(index, value),
    }
}

/// `None` of types that have no atomics.
pub(super) fn atomic<const N: usize>(scalar: Scalar, fun: Update) -> Option<Exec<N>> {
    if scalar.wide() || scalar.float() {
        return atomics::atomic(scalar);
    }
    Some(match fun {
        Update::Add => exec::<Atomic<0>, N>(Isa::Portable),
        Update::Subtract => exec::<Atomic<1>, N>(Isa::Portable),
        Update::And => exec::<Atomic<2>, N>(Isa::Portable),
        Update::Xor => exec::<Atomic<3>, N>(Isa::Portable),
        Update::Or => exec::<Atomic<4>, N>(Isa::Portable),
        Update::Min if scalar.signed() => exec::<Atomic<9>, N>(Isa::Portable),
        Update::Min => exec::<Atomic<5>, N>(Isa::Portable),
        Update::Max if scalar.signed() => exec::<Atomic<10>, N>(Isa::Portable),
        Update::Max => exec::<Atomic<6>, N>(Isa::Portable),
        Update::Exchange => exec::<Atomic<7>, N>(Isa::Portable),
        Update::CompareExchange => exec::<Atomic<8>, N>(Isa::Portable),
    })
}
