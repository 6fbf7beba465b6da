//! Atomic updates, lane by lane.
#![allow(unsafe_code, reason = "memory that other threads may use is reached by pointers")]
#![allow(
    clippy::needless_range_loop,
    reason = "lanes of several operands side by side, as the vectoriser likes them"
)]

use super::super::super::program::{Scalar, Update};
use super::super::machine::Machine;
use super::super::shape::{Body, Each, Exec, Source, exec, target};
use super::super::{Inst, Isa};
use super::atomics;
use std::sync::atomic::{AtomicI32, AtomicU32, Ordering::Relaxed};

/// Atomic update of buffer `n[0]` at `s[0] + n[1]` by `s[1]`, expecting `s[3]`, in the lanes of mask `s[2]`.
struct Atomic<const FUN: u8>;

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

/// `None` of types that have no atomics.
pub(in super::super) fn atomic<const N: usize>(scalar: Scalar, fun: Update) -> Option<Exec<N>> {
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
