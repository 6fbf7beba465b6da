//! Polynomials by Horner's rule, each product and each sum rounded.
#![allow(unsafe_code, reason = "steps on slots and cells at once")]
#![allow(
    clippy::needless_range_loop,
    reason = "lanes of several operands side by side, as the vectoriser likes them"
)]

use super::super::Inst;
use super::super::machine::{Lane, Machine};
use super::super::shape::{Ask, Body, Each, Found, Same, Source, exec, set_cell, target};

/// `d` = polynomial in `s[0]` with `COUNT` coefficients in the cells from `n[0]` on, and, if `BEGUN`, `s[1]` before them.
struct Polynomial<const COUNT: usize, const BEGUN: bool>;
/// The same where operands are the same in all lanes; `n[1]` coefficients, and `n[2]` says whether it has begun.
struct Uniform;

/// Coefficients from a cell on.
///
/// # Safety
/// The cells exist.
#[inline(always)]
unsafe fn coefficient<const N: usize>(m: &mut Machine<N>, first: u32, at: usize) -> f32 {
    // SAFETY: as the caller promises.
    f32::from_cell(unsafe { *m.cells().add(first as usize + at) })
}

impl<const COUNT: usize, const BEGUN: bool, const N: usize> Body<N> for Polynomial<COUNT, BEGUN> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises; the coefficients are constants of the program.
        unsafe {
            let mut c = [0.0; COUNT];
            for (at, c) in c.iter_mut().enumerate() {
                *c = coefficient(m, i.n[0], at);
            }
            let (x, begin): (&[f32; N], &[f32; N]) = (Each::hold(m, i.s[0]), Each::hold(m, i.s[1]));
            lanes::<COUNT, BEGUN, N>(target(m, i.d), x, begin, c);
        }
        at + 1
    }
}

#[inline(always)]
fn lanes<const COUNT: usize, const BEGUN: bool, const N: usize>(
    d: &mut [f32; N],
    x: &[f32; N],
    begin: &[f32; N],
    c: [f32; COUNT],
) {
    for lane in 0..N {
        let mut sum = if BEGUN { begin[lane] * x[lane] + c[0] } else { c[0] };
        for at in 1..COUNT {
            sum = sum * x[lane] + c[at];
        }
        d[lane] = sum;
    }
}

impl<const N: usize> Body<N> for Uniform {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        let [first, count, begun] = i.n;
        // SAFETY: as `Body` promises; the coefficients are constants of the program.
        unsafe {
            let (x, begin): (f32, f32) = (Same::hold(m, i.s[0]), Same::hold(m, i.s[1]));
            let from = coefficient(m, first, 0);
            let from = if begun == 0 { from } else { begin * x + from };
            let sum = (1..count as usize).fold(from, |sum, at| sum * x + coefficient(m, first, at));
            set_cell(m, i.d, sum);
        }
        at + 1
    }
}

/// The form for `count` coefficients, of which `passes::horner` makes no more than there are forms.
pub(super) fn find<const N: usize>(count: u32, begun: bool, ask: Ask) -> Found<N> {
    let [x, begin, ..] = ask.varying;
    match (x, begin) {
        (false, false) => return Some(exec::<Uniform, N>(ask.isa)),
        (true, begin) if begin == begun => {}
        (true | false, _) => return None,
    }
    macro_rules! forms {
        ($($count:literal)*) => {
            match (count, begun) {
                $(($count, false) => Some(exec::<Polynomial<$count, false>, N>(ask.isa)),)*
                $(($count, true) => Some(exec::<Polynomial<$count, true>, N>(ask.isa)),)*
                _ => None,
            }
        };
    }
    forms! { 2 3 4 5 6 7 8 9 10 }
}
