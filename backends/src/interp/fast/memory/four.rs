//! Four neighbouring words of elements at once, turned from an element's words to a word's lanes.
#![allow(unsafe_code, reason = "memory that other threads may use is reached by pointers")]

use super::super::machine::{Lane, Machine};
use super::super::shape::{Body, Each, Exec, Source, exec};
use super::super::{Inst, Isa};
use super::element::array;
use std::marker::PhantomData;

/// `d`, `s[1]`, `s[2]`, `s[3]` = four words from `n[1]` on of element `s[0]` of array `n[0]`.
struct LoadFour<T>(PhantomData<T>);

/// Turns four words from each of some places.
trait Turn: 'static {
    /// How many places.
    const PLACES: usize;
    /// Writes to each target the words of the same rank, of places `first + offsets`.
    ///
    /// # Safety
    /// Places and targets exist, the former [`Self::PLACES`] offsets.
    unsafe fn turn(first: *const u8, offsets: &[u32], to: [*mut u32; 4]);
}

impl<T: Turn, const N: usize> Body<N> for LoadFour<T> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let (elements, _) = array(m, i);
        // SAFETY: slots as `Body` promises, of which unused results may share one; words lie in memory.
        unsafe {
            let index: &[u32; N] = Each::hold(m, i.s[0]);
            let offsets = elements.offsets(index);
            let slots: *mut [u32; N] = Lane::slots(m);
            let to = [i.d, i.s[1], i.s[2], i.s[3]].map(|slot| slots.add(slot as usize).cast::<u32>());
            if elements.fit(&offsets, i.n[1], 16) {
                let first = elements.memory.ptr.add(i.n[1] as usize);
                for (rank, offsets) in offsets.chunks_exact(T::PLACES).enumerate() {
                    T::turn(first.cast_const(), offsets, to.map(|t| t.add(rank * T::PLACES)));
                }
            } else {
                for (word, to) in to.into_iter().enumerate() {
                    for (lane, offset) in offsets.iter().enumerate() {
                        let found = elements.memory.len >= 4;
                        let place = elements.word(*offset, i.n[1] + 4 * word as u32);
                        to.add(lane).write(if found { place.read_unaligned() } else { 0 });
                    }
                }
            }
        }
        at + 1
    }
}

/// The way of any machine.
#[cfg(not(target_arch = "x86_64"))]
struct Portable;

#[cfg(not(target_arch = "x86_64"))]
impl Turn for Portable {
    const PLACES: usize = 4;

    #[inline(always)]
    unsafe fn turn(first: *const u8, offsets: &[u32], to: [*mut u32; 4]) {
        // SAFETY: as the caller promises.
        unsafe {
            let row = |at: usize| first.add(offsets[at] as usize).cast::<[u32; 4]>().read_unaligned();
            let rows = [row(0), row(1), row(2), row(3)];
            for (word, to) in to.into_iter().enumerate() {
                to.cast::<[u32; 4]>().write_unaligned(rows.map(|row| row[word]));
            }
        }
    }
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::Turn;
    use std::arch::x86_64::{
        _mm_loadu_ps, _mm_movehl_ps, _mm_movelh_ps, _mm_storeu_ps, _mm_unpackhi_ps, _mm_unpacklo_ps,
        _mm512_castps_pd, _mm512_castps128_ps512, _mm512_insertf32x4, _mm512_storeu_pd, _mm512_unpackhi_pd,
        _mm512_unpackhi_ps, _mm512_unpacklo_pd, _mm512_unpacklo_ps,
    };

    /// The way of any x86-64.
    pub(super) struct Four;
    /// The way of AVX-512.
    pub(super) struct Sixteen;

    impl Turn for Four {
        const PLACES: usize = 4;

        #[inline(always)]
        unsafe fn turn(first: *const u8, offsets: &[u32], to: [*mut u32; 4]) {
            // SAFETY: as the caller promises; the instructions are those of any x86-64.
            unsafe {
                let row = |at: usize| _mm_loadu_ps(first.add(offsets[at] as usize).cast());
                let (a, b, c, d) = (row(0), row(1), row(2), row(3));
                let (ab, cd) = (_mm_unpacklo_ps(a, b), _mm_unpacklo_ps(c, d));
                let (ab_high, cd_high) = (_mm_unpackhi_ps(a, b), _mm_unpackhi_ps(c, d));
                _mm_storeu_ps(to[0].cast(), _mm_movelh_ps(ab, cd));
                _mm_storeu_ps(to[1].cast(), _mm_movehl_ps(cd, ab));
                _mm_storeu_ps(to[2].cast(), _mm_movelh_ps(ab_high, cd_high));
                _mm_storeu_ps(to[3].cast(), _mm_movehl_ps(cd_high, ab_high));
            }
        }
    }

    impl Turn for Sixteen {
        const PLACES: usize = 16;

        #[inline(always)]
        unsafe fn turn(first: *const u8, offsets: &[u32], to: [*mut u32; 4]) {
            // SAFETY: as the caller promises; steps with AVX-512 are for machines that have it.
            unsafe { sixteen(first, offsets, to) };
        }
    }

    /// # Safety
    /// As of [`Turn::turn`].
    #[target_feature(enable = "avx512f")]
    #[inline]
    unsafe fn sixteen(first: *const u8, offsets: &[u32], to: [*mut u32; 4]) {
        // SAFETY: as the caller promises.
        unsafe {
            let row = |at: usize| _mm_loadu_ps(first.add(offsets[at] as usize).cast());
            // Every fourth place, so that each quarter is turned where it is.
            let rows = |at: usize| {
                let rows = _mm512_castps128_ps512(row(at));
                let rows = _mm512_insertf32x4::<1>(rows, row(at + 4));
                let rows = _mm512_insertf32x4::<2>(rows, row(at + 8));
                _mm512_insertf32x4::<3>(rows, row(at + 12))
            };
            let (a, b, c, d) = (rows(0), rows(1), rows(2), rows(3));
            let (ab, ab_high) = (_mm512_unpacklo_ps(a, b), _mm512_unpackhi_ps(a, b));
            let (cd, cd_high) = (_mm512_unpacklo_ps(c, d), _mm512_unpackhi_ps(c, d));
            let [ab, ab_high, cd, cd_high] = [ab, ab_high, cd, cd_high].map(|x| _mm512_castps_pd(x));
            _mm512_storeu_pd(to[0].cast(), _mm512_unpacklo_pd(ab, cd));
            _mm512_storeu_pd(to[1].cast(), _mm512_unpackhi_pd(ab, cd));
            _mm512_storeu_pd(to[2].cast(), _mm512_unpacklo_pd(ab_high, cd_high));
            _mm512_storeu_pd(to[3].cast(), _mm512_unpackhi_pd(ab_high, cd_high));
        }
    }
}

#[cfg(target_arch = "x86_64")]
pub(in super::super) fn load_four<const N: usize>(isa: Isa) -> Exec<N> {
    match isa {
        Isa::Avx512 if N.is_multiple_of(16) => exec::<LoadFour<x86::Sixteen>, N>(isa),
        _ => exec::<LoadFour<x86::Four>, N>(isa),
    }
}

#[cfg(not(target_arch = "x86_64"))]
pub(in super::super) fn load_four<const N: usize>(isa: Isa) -> Exec<N> {
    exec::<LoadFour<Portable>, N>(isa)
}
