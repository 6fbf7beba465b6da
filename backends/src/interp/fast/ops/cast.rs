//! Conversions, reinterpretations, copies.
#![allow(unsafe_code, reason = "one step on slots and cells at once")]

use super::super::super::program::Scalar;
use super::super::machine::{Lane, Machine};
use super::super::shape::{Ask, Body, Exec, Found, Same, Source, exec, one, target};
use super::super::{Inst, Isa};
use super::{functions, mask};
use lobe_codegen::math::scalar;
use std::marker::PhantomData;

functions! {
    Copy(a: u32) -> u32 = a;
    CopyWide(a: u64) -> u64 = a;
    FloatToI32(a: f32) -> i32 = scalar::to_i32(a);
    FloatToU32(a: f32) -> u32 = scalar::to_u32(a);
    I32ToFloat(a: i32) -> f32 = a as f32;
    U32ToFloat(a: u32) -> f32 = a as f32;
    BoolToFloat(a: u32) -> f32 = f32::from_bits(a & 1.0_f32.to_bits());
    BoolToWord(a: u32) -> u32 = a & 1;
    FloatToBool(a: f32) -> u32 = mask(a != 0.0);
    WordToBool(a: u32) -> u32 = mask(a != 0);
}

pub(super) fn copy<const N: usize>(scalar: Scalar, ask: Ask) -> Found<N> {
    if scalar.wide() { one::<CopyWide, N>(ask) } else { one::<Copy, N>(ask) }
}

/// The form of a conversion; none yet for 64 and 16 bits.
pub(super) fn convert<const N: usize>(from: Scalar, to: Scalar, ask: Ask) -> Option<Found<N>> {
    use Scalar as S;
    Some(match (from, to) {
        (S::F32, S::I32) => one::<FloatToI32, N>(ask),
        (S::F32, S::U32) => one::<FloatToU32, N>(ask),
        (S::F32, S::Bool) => one::<FloatToBool, N>(ask),
        (S::I32, S::F32) => one::<I32ToFloat, N>(ask),
        (S::U32, S::F32) => one::<U32ToFloat, N>(ask),
        (S::I32 | S::U32, S::Bool) => one::<WordToBool, N>(ask),
        (S::Bool, S::F32) => one::<BoolToFloat, N>(ask),
        (S::Bool, S::I32 | S::U32) => one::<BoolToWord, N>(ask),
        (S::I32, S::U32) | (S::U32, S::I32) => one::<Copy, N>(ask),
        (S::F32, S::F32) | (S::I32, S::I32) | (S::U32, S::U32) | (S::Bool, S::Bool) => one::<Copy, N>(ask),
        (S::F16 | S::F64 | S::I64 | S::U64, _) | (_, S::F16 | S::F64 | S::I64 | S::U64) => return None,
    })
}

/// Registers hold bits, so these are copies.
pub(super) fn bitcast<const N: usize>(from: Scalar, to: Scalar, ask: Ask) -> Option<Found<N>> {
    if from == Scalar::F16 || to == Scalar::F16 || from.bytes() != to.bytes() {
        return None;
    }
    Some(copy(to, ask))
}

struct Splat<T>(PhantomData<T>);

impl<T: Lane, const N: usize> Body<N> for Splat<T> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let a: T = Same::hold(m, i.s[0]);
            target::<T, N>(m, i.d).fill(a);
        }
        at + 1
    }
}

/// From a cell to all lanes of a slot.
pub(super) fn splat<const N: usize>(scalar: Scalar, isa: Isa) -> Exec<N> {
    if scalar.wide() { exec::<Splat<u64>, N>(isa) } else { exec::<Splat<u32>, N>(isa) }
}
