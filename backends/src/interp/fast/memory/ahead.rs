//! Asks for memory before it is needed, where elements are used by the number of the invocation.
//!
//! A processor foresees accesses that follow each other closely, but between those of one batch and the next
//! lie many steps.
#![allow(unsafe_code, reason = "hints about memory")]

use super::super::machine::Machine;
use super::element::{Array, Elements};
use std::ops::Range;

const LINE: usize = 64;

/// Bytes of a batch's elements that are asked for at once.
const FEW: usize = 1024;

/// How many batches ahead few bytes are asked for.
const DISTANCE: usize = 4;

/// No lines.
const NONE: Range<*const u8> = std::ptr::null()..std::ptr::null();

/// The lines that a batch of steps is going to ask for, one at each step: of two arrays, one after the other.
#[derive(Debug, Clone)]
pub(in super::super) struct Ahead([Range<*const u8>; 2]);

impl Ahead {
    pub(in super::super) const NOTHING: Self = Self([NONE; 2]);

    /// Asks for a line, if one is left.
    #[inline(always)]
    pub(in super::super) fn step(&mut self) -> bool {
        let Some(lines) = self.0.iter_mut().find(|lines| lines.start < lines.end) else {
            return false;
        };
        ask(lines.start);
        lines.start = lines.start.wrapping_add(LINE);
        true
    }
}

/// A hint that memory at an address, whatever it is, will be needed.
#[inline(always)]
fn ask(address: *const u8) {
    #[cfg(target_arch = "x86_64")]
    // SAFETY: it touches no memory; any x86-64 has it.
    unsafe {
        std::arch::x86_64::_mm_prefetch::<{ std::arch::x86_64::_MM_HINT_T0 }>(address.cast());
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = address;
}

/// The bytes of some elements, as far as they exist.
fn bytes(elements: Elements, range: Range<usize>) -> Range<*const u8> {
    let stride = elements.stride as usize;
    let end = (elements.count as usize * stride).min(elements.memory.len);
    let address = |at: usize| elements.memory.ptr.wrapping_add(end.min(at * stride)).cast_const();
    address(range.start)..address(range.end)
}

/// Asks for what small elements take in batches to come; the two largest are left to the steps of this one.
pub(in super::super) fn ahead<const N: usize>(m: &Machine<N>) -> Ahead {
    if !m.position.line {
        return Ahead::NOTHING;
    }
    let mut next = Ahead::NOTHING;
    let mut largest = [0; 2];
    for array in m.arrays.iter().filter(|a: &&Array| a.by_number) {
        let stride = array.stride as usize;
        let distance = if N * stride <= FEW { DISTANCE } else { 1 };
        let first = m.position.first + distance * N;
        let elements = Elements::of(m, *array);
        if elements.past {
            continue;
        }
        let lines = bytes(elements, first..first + N);
        if N * stride <= FEW {
            let mut few = Ahead([lines, NONE]);
            while few.step() {}
        } else if let Some(at) = largest.iter().position(|other| stride > *other) {
            largest[at..].rotate_right(1);
            next.0[at..].rotate_right(1);
            (next.0[at], largest[at]) = (lines, stride);
        }
    }
    next
}
