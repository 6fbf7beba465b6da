//! Atomics for which processors have no instruction: on floats, and on 64 bits in all ways.
#![allow(unsafe_code, reason = "memory that other threads may use is reached by pointers")]

use super::super::super::program::{Scalar, Update};
use super::super::super::scalar::atomic::update;
use super::super::Inst;
use super::super::machine::Machine;
use super::super::shape::{Body, Each, Exec, Source, plain, target};
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering::Relaxed};

/// Updates, by number.
const UPDATES: [Update; 9] = [
    Update::Add,
    Update::Subtract,
    Update::And,
    Update::Xor,
    Update::Or,
    Update::Min,
    Update::Max,
    Update::Exchange,
    Update::CompareExchange,
];

/// The number of an update, for the step's `n[2]`.
pub(in super::super) fn number(fun: Update) -> u32 {
    UPDATES.iter().position(|u| *u == fun).unwrap_or(0) as u32
}

/// Update `n[2]` of buffer `n[0]` at `s[0] + n[1]` by `s[1]`, expecting `s[3]`, in the lanes of mask `s[2]`.
struct Float;
/// The same on 64 bits.
struct Wide<const SIGNED: bool>;

impl<const N: usize> Body<N> for Float {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let (buffer, fun) = (m.buffers[i.n[0] as usize], UPDATES[i.n[2] as usize]);
        // SAFETY: slots as `Body` promises; addresses are clamped, and aligned since types are.
        unsafe {
            let (index, value): (&[u32; N], &[u32; N]) = (Each::hold(m, i.s[0]), Each::hold(m, i.s[1]));
            let (mask, expected): (&[u32; N], &[u32; N]) = (Each::hold(m, i.s[2]), Each::hold(m, i.s[3]));
            let old: &mut [u32; N] = target(m, i.d);
            for lane in 0..N {
                old[lane] = 0;
                let place = buffer.at(u64::from(index[lane]) + u64::from(i.n[1]), 4);
                if let (true, Some(place)) = (mask[lane] != 0, place) {
                    let word = AtomicU32::from_ptr(place.map_addr(|a| a & !3).cast());
                    let new = |old: u32| {
                        let (value, expected) = (value[lane].into(), expected[lane].into());
                        Some(update(Scalar::F32, fun, old.into(), value, expected) as u32)
                    };
                    old[lane] = word.fetch_update(Relaxed, Relaxed, new).unwrap_or_else(|old| old);
                }
            }
        }
        at + 1
    }
}

impl<const SIGNED: bool, const N: usize> Body<N> for Wide<SIGNED> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let (buffer, fun) = (m.buffers[i.n[0] as usize], UPDATES[i.n[2] as usize]);
        let scalar = if SIGNED { Scalar::I64 } else { Scalar::U64 };
        // SAFETY: slots as `Body` promises; addresses are clamped, and aligned since types are.
        unsafe {
            let (index, value): (&[u32; N], &[u64; N]) = (Each::hold(m, i.s[0]), Each::hold(m, i.s[1]));
            let (mask, expected): (&[u32; N], &[u64; N]) = (Each::hold(m, i.s[2]), Each::hold(m, i.s[3]));
            let old: &mut [u64; N] = target(m, i.d);
            for lane in 0..N {
                old[lane] = 0;
                let place = buffer.at(u64::from(index[lane]) + u64::from(i.n[1]), 8);
                if let (true, Some(place)) = (mask[lane] != 0, place) {
                    let word = AtomicU64::from_ptr(place.map_addr(|a| a & !7).cast());
                    let new = |old: u64| Some(update(scalar, fun, old, value[lane], expected[lane]));
                    old[lane] = word.fetch_update(Relaxed, Relaxed, new).unwrap_or_else(|old| old);
                }
            }
        }
        at + 1
    }
}

/// Of f32, i64 or u64; `None` of other types.
pub(super) fn atomic<const N: usize>(scalar: Scalar) -> Option<Exec<N>> {
    match scalar {
        Scalar::F32 => Some(plain::<Float, N>()),
        Scalar::I64 => Some(plain::<Wide<true>, N>()),
        Scalar::U64 => Some(plain::<Wide<false>, N>()),
        Scalar::Bool | Scalar::I16 | Scalar::U16 | Scalar::I32 | Scalar::U32 | Scalar::F16 | Scalar::F64 => {
            None
        }
    }
}
