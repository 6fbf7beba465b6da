//! Addresses, loads, stores, atomics, inputs.
//!
//! Whatever an address is, it is clamped to its memory here, so that no program can leave it.

mod address;
mod ahead;
mod atomic;
mod atomics;
mod buffer;
mod element;
mod four;
mod input;
mod lane;
mod narrow;
mod past;

pub(super) use address::{index, length};
pub(super) use ahead::{Ahead, ahead};
pub(super) use atomic::atomic;
pub(super) use atomics::number;
pub(super) use buffer::{load, load_word, load_words, store};
pub(super) use element::{Array, load_element, store_element};
pub(super) use four::load_four;
pub(super) use input::{input, provide, provide_same};
pub(super) use lane::{lane_load, lane_store};
pub(super) use past::settle;

use super::machine::Bound;

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
