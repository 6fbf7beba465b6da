//! Numbers of 16 bits in memory that lanes share.
#![allow(unsafe_code, reason = "memory that other threads may use is reached by pointers")]

use super::super::super::program::Scalar;
use super::super::super::scalar::half;
use super::super::Inst;
use super::super::machine::{Lane, Machine};
use super::super::shape::{Body, Each, Exec, Same, Source, plain, set_cell, target};
use std::marker::PhantomData;

/// How 16 bits are held in a register.
trait Narrow: 'static {
    type Held: Lane;
    fn hold(bits: u16) -> Self::Held;
    fn bits(held: Self::Held) -> u16;
}

struct Half;

impl Narrow for Half {
    type Held = f32;
    #[inline(always)]
    fn hold(bits: u16) -> f32 {
        half::from_bits(bits)
    }
    #[inline(always)]
    fn bits(held: f32) -> u16 {
        half::to_bits(held)
    }
}

impl Narrow for i16 {
    type Held = i32;
    #[inline(always)]
    fn hold(bits: u16) -> i32 {
        (bits as i16).into()
    }
    #[inline(always)]
    fn bits(held: i32) -> u16 {
        held as u16
    }
}

impl Narrow for u16 {
    type Held = u32;
    #[inline(always)]
    fn hold(bits: u16) -> u32 {
        bits.into()
    }
    #[inline(always)]
    fn bits(held: u32) -> u16 {
        held as u16
    }
}

/// `d` = buffer `n[0]` at `s[0] + n[1]`.
struct Load<W>(PhantomData<W>);
/// The same where the address is one.
struct LoadSame<W>(PhantomData<W>);
/// Buffer `n[0]` at `s[0] + n[1]` = `s[1]` in the lanes of mask `s[2]`.
struct Store<W, I, S>(PhantomData<(W, I, S)>);

impl<W: Narrow, const N: usize> Body<N> for Load<W> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let buffer = m.buffers[i.n[0] as usize];
        // SAFETY: slots as `Body` promises; addresses are clamped to the buffer.
        unsafe {
            let index: &[u32; N] = Each::hold(m, i.s[0]);
            let d: &mut [W::Held; N] = target(m, i.d);
            for (d, index) in d.iter_mut().zip(index) {
                let place = buffer.at(u64::from(*index) + u64::from(i.n[1]), 2);
                *d = W::hold(place.map_or(0, |p| p.cast::<u16>().read_unaligned()));
            }
        }
        at + 1
    }
}

impl<W: Narrow, const N: usize> Body<N> for LoadSame<W> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let buffer = m.buffers[i.n[0] as usize];
        // SAFETY: cells as `Body` promises; the address is clamped to the buffer.
        unsafe {
            let index: u32 = Same::hold(m, i.s[0]);
            let place = buffer.at(u64::from(index) + u64::from(i.n[1]), 2);
            let bits = place.map_or(0, |p| p.cast::<u16>().read_unaligned());
            set_cell(m, i.d, W::hold(bits));
        }
        at + 1
    }
}

impl<W: Narrow, I: Source, S: Source, const N: usize> Body<N> for Store<W, I, S> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let buffer = m.buffers[i.n[0] as usize];
        // SAFETY: slots as `Body` promises; addresses are clamped to the buffer.
        unsafe {
            let (index, value) = (I::hold::<u32, N>(m, i.s[0]), S::hold::<W::Held, N>(m, i.s[1]));
            let mask: &[u32; N] = Each::hold(m, i.s[2]);
            for (lane, active) in mask.iter().enumerate() {
                let place = buffer.at(u64::from(I::get(index, lane)) + u64::from(i.n[1]), 2);
                if let (true, Some(place)) = (*active != 0, place) {
                    place.cast::<u16>().write_unaligned(W::bits(S::get(value, lane)));
                }
            }
        }
        at + 1
    }
}

fn load_of<W: Narrow, const N: usize>(index: bool) -> Exec<N> {
    if index { plain::<Load<W>, N>() } else { plain::<LoadSame<W>, N>() }
}

/// Of a scalar of 16 bits.
pub(super) fn load<const N: usize>(scalar: Scalar, index: bool) -> Exec<N> {
    match scalar {
        Scalar::I16 => load_of::<i16, N>(index),
        Scalar::F16 => load_of::<Half, N>(index),
        _ => load_of::<u16, N>(index),
    }
}

fn store_of<W: Narrow, const N: usize>(index: bool, value: bool) -> Exec<N> {
    match (index, value) {
        (true, true) => plain::<Store<W, Each, Each>, N>(),
        (true, false) => plain::<Store<W, Each, Same>, N>(),
        (false, true) => plain::<Store<W, Same, Each>, N>(),
        (false, false) => plain::<Store<W, Same, Same>, N>(),
    }
}

/// Of a scalar of 16 bits.
pub(super) fn store<const N: usize>(scalar: Scalar, index: bool, value: bool) -> Exec<N> {
    match scalar {
        Scalar::F16 => store_of::<Half, N>(index, value),
        _ => store_of::<u16, N>(index, value),
    }
}
