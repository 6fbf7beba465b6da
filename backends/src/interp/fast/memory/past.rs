//! Stores past the caches: what no invocation will read needs no place there, nor the lines that it fills to be
//! fetched first.
#![allow(unsafe_code, reason = "memory that other threads may use is reached by pointers")]

use super::super::shape::Source;

/// Bytes of a buffer from which on that pays: less may well be in the caches when the host reads it.
pub(super) const LARGE: usize = 8 << 20;

/// Stores a batch's words from `to` on, if they lie as such stores need. [`settle`] must follow before anything else
/// touches them.
///
/// # Safety
/// There is memory of `N` words, and `value` is what [`Source::hold`] gives.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) unsafe fn store<S: Source, const N: usize>(to: *mut u32, value: S::Held<'_, u32, N>) -> bool {
    const TOGETHER: usize = 4;
    if !to.addr().is_multiple_of(TOGETHER * size_of::<u32>()) || !N.is_multiple_of(TOGETHER) {
        return false;
    }
    for first in (0..N).step_by(TOGETHER) {
        let words: [u32; TOGETHER] = std::array::from_fn(|k| S::get(value, first + k));
        // SAFETY: as the caller promises; the place is aligned.
        unsafe {
            use std::arch::x86_64::{_mm_loadu_si128, _mm_stream_si128};
            _mm_stream_si128(to.add(first).cast(), _mm_loadu_si128(words.as_ptr().cast()));
        }
    }
    true
}

/// No such stores here.
///
/// # Safety
/// None needed.
#[cfg(not(target_arch = "x86_64"))]
#[inline(always)]
pub(super) unsafe fn store<S: Source, const N: usize>(_: *mut u32, _: S::Held<'_, u32, N>) -> bool {
    false
}

/// Waits for this thread's stores past the caches.
pub(in super::super) fn settle() {
    #[cfg(target_arch = "x86_64")]
    // SAFETY: it orders stores and does no more; any x86-64 has it.
    unsafe {
        std::arch::x86_64::_mm_sfence();
    }
}
