//! Conversions, reinterpretations, copies.
#![allow(unsafe_code, reason = "one step on slots and cells at once")]

use super::super::super::program::Scalar;
use super::super::super::scalar::convert::{self as numbers, Half, Number, Truth};
use super::super::super::scalar::half;
use super::super::machine::{Lane, Machine};
use super::super::shape::{Ask, Body, Exec, Fn1, Found, Same, Source, exec, one, one_plain, target};
use super::super::{Inst, Isa};
use super::{functions, mask};
use std::marker::PhantomData;

functions! {
    Copy(a: u32) -> u32 = a;
    CopyWide(a: u64) -> u64 = a;
    FloatToI32(a: f32) -> i32 = numbers::to_i32(a);
    FloatToU32(a: f32) -> u32 = numbers::to_u32(a);
    I32ToFloat(a: i32) -> f32 = a as f32;
    U32ToFloat(a: u32) -> f32 = a as f32;
    BoolToFloat(a: u32) -> f32 = f32::from_bits(a & 1.0_f32.to_bits());
    BoolToWord(a: u32) -> u32 = a & 1;
    FloatToBool(a: f32) -> u32 = mask(a != 0.0);
    WordToBool(a: u32) -> u32 = mask(a != 0);
    FloatToHalf(a: f32) -> f32 = half::round(a);
    HalfBits(a: f32) -> u32 = half::to_bits(a).into();
    HalfBitsSigned(a: f32) -> i32 = (half::to_bits(a) as i16).into();
    BitsHalf(a: u32) -> f32 = half::from_bits(a as u16);
    Extended(a: u32) -> i32 = (a as u16 as i16).into();
    Low(a: u32) -> u32 = a & 0xffff;
}

pub(super) fn copy<const N: usize>(scalar: Scalar, ask: Ask) -> Found<N> {
    if scalar.wide() { one::<CopyWide, N>(ask) } else { one::<Copy, N>(ask) }
}

/// The form of a conversion.
pub(super) fn convert<const N: usize>(from: Scalar, to: Scalar, ask: Ask) -> Found<N> {
    use Scalar as S;
    match (from, to) {
        (S::F32, S::I32) => one::<FloatToI32, N>(ask),
        (S::F32, S::U32) => one::<FloatToU32, N>(ask),
        (S::F32, S::Bool) => one::<FloatToBool, N>(ask),
        (S::F32, S::F16) => one::<FloatToHalf, N>(ask),
        (S::I32, S::F32) => one::<I32ToFloat, N>(ask),
        (S::U32, S::F32) => one::<U32ToFloat, N>(ask),
        (S::I32 | S::U32, S::Bool) => one::<WordToBool, N>(ask),
        (S::Bool, S::F32) => one::<BoolToFloat, N>(ask),
        (S::Bool, S::I32 | S::U32) => one::<BoolToWord, N>(ask),
        (S::I32, S::U32) | (S::U32, S::I32) => one::<Copy, N>(ask),
        // Of 16 bits are held as of 32.
        (S::F16, S::F32) | (S::I16, S::I32 | S::U32) | (S::U16, S::I32 | S::U32) => one::<Copy, N>(ask),
        (from, to) if from == to => copy(from, ask),
        (S::Bool, to) => from_type::<Truth, N>(to, ask),
        (S::I16, to) => from_type::<i16, N>(to, ask),
        (S::U16, to) => from_type::<u16, N>(to, ask),
        (S::I32, to) => from_type::<i32, N>(to, ask),
        (S::U32, to) => from_type::<u32, N>(to, ask),
        (S::I64, to) => from_type::<i64, N>(to, ask),
        (S::U64, to) => from_type::<u64, N>(to, ask),
        (S::F16, to) => from_type::<Half, N>(to, ask),
        (S::F32, to) => from_type::<f32, N>(to, ask),
        (S::F64, to) => from_type::<f64, N>(to, ask),
    }
}

/// From type `A` to type `B`.
struct Converted<A, B>(PhantomData<(A, B)>);

impl<A: Number<Held: Lane>, B: Number<Held: Lane>> Fn1 for Converted<A, B> {
    type A = A::Held;
    type R = B::Held;
    #[inline(always)]
    fn eval(a: A::Held) -> B::Held {
        numbers::convert::<A, B>(a)
    }
}

fn from_type<A: Number<Held: Lane>, const N: usize>(to: Scalar, ask: Ask) -> Found<N> {
    match to {
        Scalar::Bool => one_plain::<Converted<A, Truth>, N>(ask),
        Scalar::I16 => one_plain::<Converted<A, i16>, N>(ask),
        Scalar::U16 => one_plain::<Converted<A, u16>, N>(ask),
        Scalar::I32 => one_plain::<Converted<A, i32>, N>(ask),
        Scalar::U32 => one_plain::<Converted<A, u32>, N>(ask),
        Scalar::I64 => one_plain::<Converted<A, i64>, N>(ask),
        Scalar::U64 => one_plain::<Converted<A, u64>, N>(ask),
        Scalar::F16 => one_plain::<Converted<A, Half>, N>(ask),
        Scalar::F32 => one_plain::<Converted<A, f32>, N>(ask),
        Scalar::F64 => one_plain::<Converted<A, f64>, N>(ask),
    }
}

/// Registers hold bits, so these are copies, except where 16 bits are held in 32.
pub(super) fn bitcast<const N: usize>(from: Scalar, to: Scalar, ask: Ask) -> Option<Found<N>> {
    use Scalar as S;
    if from.bytes() != to.bytes() {
        return None;
    }
    Some(match (from, to) {
        (S::F16, S::I16) => one::<HalfBitsSigned, N>(ask),
        (S::F16, S::U16) => one::<HalfBits, N>(ask),
        (S::I16 | S::U16, S::F16) => one::<BitsHalf, N>(ask),
        (S::U16, S::I16) => one::<Extended, N>(ask),
        (S::I16, S::U16) => one::<Low, N>(ask),
        (_, to) => copy(to, ask),
    })
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
