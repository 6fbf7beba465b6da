//! Elements of arrays at the lanes' indices: 32-bit words of them.
#![allow(unsafe_code, reason = "memory that other threads may use is reached by pointers")]
#![allow(
    clippy::needless_range_loop,
    reason = "lanes of several operands side by side, as the vectoriser likes them"
)]

use super::super::super::program::Count;
use super::super::machine::{Bound, Machine};
use super::super::shape::{Body, Each, Exec, Same, Source, exec, target};
use super::super::{Inst, Isa};
use super::past;
use std::marker::PhantomData;

/// The elements that a step chooses from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) struct Array {
    pub(in super::super) buffer: u32,
    pub(in super::super) count: Count,
    pub(in super::super) stride: u32,
    /// Whether the index is the number of the invocation along the first axis.
    pub(in super::super) by_number: bool,
    /// Whether the program stores its elements once and does no more with its buffer.
    pub(in super::super) once: bool,
}

/// `d` = word at `n[1]` of element `s[0]` of array `n[0]`.
struct Load;
/// Word at `n[1]` of element `s[0]` of array `n[0]` = `s[1]` in the lanes of mask `s[2]`.
struct Store<S>(PhantomData<S>);

/// An array in memory.
#[derive(Clone, Copy)]
pub(super) struct Elements {
    pub(super) memory: Bound,
    pub(super) count: u32,
    pub(super) stride: u32,
    /// Whether stores go past the caches.
    pub(super) past: bool,
}

impl Elements {
    #[inline(always)]
    pub(super) fn of<const N: usize>(m: &Machine<N>, array: Array) -> Self {
        let memory = m.buffers[array.buffer as usize];
        let count = match array.count {
            Count::Fixed(count) => count,
            Count::Runtime { buffer, begin } => {
                let bytes = m.buffers[buffer as usize].len.saturating_sub(begin as usize);
                (bytes / array.stride.max(1) as usize).min(u32::MAX as usize) as u32
            }
        };
        let past = array.once && array.by_number && array.stride == 4 && memory.len >= past::LARGE;
        Self { memory, count, stride: array.stride, past }
    }

    /// Offsets of the lanes' elements.
    #[inline(always)]
    pub(super) fn offsets<const N: usize>(self, index: &[u32; N]) -> [u32; N] {
        let last = self.count.saturating_sub(1);
        let mut offsets = [0; N];
        for lane in 0..N {
            offsets[lane] = index[lane].min(last).wrapping_mul(self.stride);
        }
        offsets
    }

    /// Whether `bytes` of each of these elements, from `offset` on, lie in memory.
    #[inline(always)]
    pub(super) fn fit<const N: usize>(self, offsets: &[u32; N], offset: u32, bytes: usize) -> bool {
        let furthest = offsets.iter().fold(0, |most: u32, at| most.max(*at));
        furthest as usize + offset as usize + bytes <= self.memory.len
    }

    /// The words at `offset` of all elements that lanes use, if they lie one after the other.
    #[inline(always)]
    fn run<const N: usize>(self, index: &[u32; N], ordered: bool, offset: u32) -> Option<*mut [u32; N]> {
        let first = index[0] as usize;
        let within = self.stride == 4 && first + N <= self.count as usize;
        let begin = first * 4 + offset as usize;
        let fits = within && begin + N * 4 <= self.memory.len;
        (fits && (ordered || consecutive(index))).then(|| self.memory.ptr.wrapping_add(begin).cast())
    }

    /// The place of a word, clamped to memory that has at least one.
    #[inline(always)]
    pub(super) fn word(self, at: u32, offset: u32) -> *mut u32 {
        let last = self.memory.len.saturating_sub(4);
        self.memory.ptr.wrapping_add((at as usize + offset as usize).min(last)).cast()
    }
}

#[inline(always)]
fn consecutive<const N: usize>(index: &[u32; N]) -> bool {
    let mut apart = 0;
    for lane in 0..N {
        apart |= index[lane] ^ index[0].wrapping_add(lane as u32);
    }
    apart == 0
}

/// The array of a step, and whether lanes use consecutive elements for certain.
#[inline(always)]
pub(super) fn array<const N: usize>(m: &Machine<N>, i: &Inst<N>) -> (Elements, bool) {
    let array = m.arrays[i.n[0] as usize];
    (Elements::of(m, array), array.by_number && m.position.line)
}

impl<const N: usize> Body<N> for Load {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let (elements, ordered) = array(m, i);
        // SAFETY: slots as `Body` promises; words lie in memory.
        unsafe {
            let index: &[u32; N] = Each::hold(m, i.s[0]);
            let d: &mut [u32; N] = target(m, i.d);
            if let Some(words) = elements.run(index, ordered, i.n[1]) {
                *d = words.read_unaligned();
            } else if elements.memory.len >= 4 {
                let offsets = elements.offsets(index);
                if elements.fit(&offsets, i.n[1], 4) {
                    let first = elements.memory.ptr.add(i.n[1] as usize);
                    for lane in 0..N {
                        d[lane] = first.add(offsets[lane] as usize).cast::<u32>().read_unaligned();
                    }
                } else {
                    for lane in 0..N {
                        d[lane] = elements.word(offsets[lane], i.n[1]).read_unaligned();
                    }
                }
            } else {
                d.fill(0);
            }
        }
        at + 1
    }
}

impl<S: Source, const N: usize> Body<N> for Store<S> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let (elements, ordered) = array(m, i);
        // The first slot is the mask of lanes that exist.
        let whole = i.s[2] == 0 && m.position.live == N;
        // SAFETY: slots as `Body` promises; words lie in memory.
        unsafe {
            let index: &[u32; N] = Each::hold(m, i.s[0]);
            let value = S::hold::<u32, N>(m, i.s[1]);
            let mask: &[u32; N] = Each::hold(m, i.s[2]);
            let full = whole || mask.iter().fold(u32::MAX, |all, m| all & m) == u32::MAX;
            if full && let Some(words) = elements.run(index, ordered, i.n[1]) {
                if elements.past && past::store::<S, N>(words.cast(), value) {
                    return at + 1;
                }
                for lane in 0..N {
                    words.cast::<u32>().add(lane).write_unaligned(S::get(value, lane));
                }
            } else if elements.memory.len >= 4 {
                let offsets = elements.offsets(index);
                for lane in 0..N {
                    if mask[lane] != 0 {
                        elements.word(offsets[lane], i.n[1]).write_unaligned(S::get(value, lane));
                    }
                }
            }
        }
        at + 1
    }
}

pub(in super::super) fn load_element<const N: usize>(isa: Isa) -> Exec<N> {
    exec::<Load, N>(isa)
}

pub(in super::super) fn store_element<const N: usize>(value: bool, isa: Isa) -> Exec<N> {
    if value { exec::<Store<Each>, N>(isa) } else { exec::<Store<Same>, N>(isa) }
}
