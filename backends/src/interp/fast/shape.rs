//! From a function of numbers to an operation on lanes.
//!
//! A family's file states functions ([`Fn1`], [`Fn2`], [`Fn3`], [`Fn4`]); here they become loops over lanes,
//! one for each way in which operands can be slots or cells, compiled for each instruction set.
//! The loops are trait methods with references as parameters: that is how the compiler learns that results
//! and operands do not overlap, and makes vectors of them without asking at run time.
#![allow(unsafe_code, reason = "functions compiled for instruction sets, which `Isa` found")]
#![allow(
    clippy::needless_range_loop,
    reason = "lanes of several operands side by side, as the vectoriser likes them"
)]

mod plain;

pub(super) use plain::{one_plain, plain, three_plain, two_plain};

use super::machine::{Lane, Machine};
use super::{Inst, Isa};
use std::marker::PhantomData;

/// A step of code: returns the next one.
pub(super) type Exec<const N: usize> = unsafe fn(&mut Machine<N>, &Inst<N>, usize) -> usize;

/// What a step does; always inlined into a function of each instruction set.
pub(super) trait Body<const N: usize> {
    /// # Safety
    /// The step's slots and cells exist in the machine, and its result's slot is no operand's.
    unsafe fn run(machine: &mut Machine<N>, inst: &Inst<N>, at: usize) -> usize;
}

unsafe fn portable<K: Body<N>, const N: usize>(m: &mut Machine<N>, inst: &Inst<N>, at: usize) -> usize {
    // SAFETY: as the caller promises.
    unsafe { K::run(m, inst, at) }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,f16c,bmi1,bmi2,lzcnt,popcnt")]
unsafe fn avx2<K: Body<N>, const N: usize>(m: &mut Machine<N>, inst: &Inst<N>, at: usize) -> usize {
    // SAFETY: as the caller promises.
    unsafe { K::run(m, inst, at) }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,f16c,bmi1,bmi2,lzcnt,popcnt,avx512f,avx512bw,avx512cd,avx512dq,avx512vl")]
unsafe fn avx512<K: Body<N>, const N: usize>(m: &mut Machine<N>, inst: &Inst<N>, at: usize) -> usize {
    // SAFETY: as the caller promises.
    unsafe { K::run(m, inst, at) }
}

/// The step for an instruction set.
pub(super) fn exec<K: Body<N>, const N: usize>(isa: Isa) -> Exec<N> {
    match isa {
        Isa::Portable => portable::<K, N>,
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => avx2::<K, N>,
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => avx512::<K, N>,
        #[cfg(not(target_arch = "x86_64"))]
        Isa::Avx2 | Isa::Avx512 => portable::<K, N>,
    }
}

/// Where an operand comes from.
pub(super) trait Source: 'static {
    /// The operand while a loop runs.
    type Held<'a, T: Lane, const N: usize>: Copy;
    /// # Safety
    /// The slot or cell exists, and nothing writes the slot while it is held.
    unsafe fn hold<'a, T: Lane, const N: usize>(m: &mut Machine<N>, at: u32) -> Self::Held<'a, T, N>;
    /// The operand of a lane.
    fn get<T: Lane, const N: usize>(held: Self::Held<'_, T, N>, lane: usize) -> T;
}

/// One value a lane.
pub(super) struct Each;
/// One value for all lanes.
pub(super) struct Same;

impl Source for Each {
    type Held<'a, T: Lane, const N: usize> = &'a [T; N];
    #[inline(always)]
    unsafe fn hold<'a, T: Lane, const N: usize>(m: &mut Machine<N>, at: u32) -> Self::Held<'a, T, N> {
        // SAFETY: the slot exists.
        unsafe { &*T::slots(m).add(at as usize) }
    }
    #[inline(always)]
    fn get<T: Lane, const N: usize>(held: Self::Held<'_, T, N>, lane: usize) -> T {
        held[lane]
    }
}

impl Source for Same {
    type Held<'a, T: Lane, const N: usize> = T;
    #[inline(always)]
    unsafe fn hold<'a, T: Lane, const N: usize>(m: &mut Machine<N>, at: u32) -> Self::Held<'a, T, N> {
        // SAFETY: the cell exists.
        T::from_cell(unsafe { *m.cells().add(at as usize) })
    }
    #[inline(always)]
    fn get<T: Lane, const N: usize>(held: Self::Held<'_, T, N>, _: usize) -> T {
        held
    }
}

/// The lanes that take a result.
///
/// # Safety
/// The slot exists and nothing else is held of it.
#[inline(always)]
pub(super) unsafe fn target<'a, T: Lane, const N: usize>(m: &mut Machine<N>, at: u32) -> &'a mut [T; N] {
    // SAFETY: as the caller promises.
    unsafe { &mut *T::slots(m).add(at as usize) }
}

/// Sets a cell.
///
/// # Safety
/// The cell exists.
#[inline(always)]
pub(super) unsafe fn set_cell<T: Lane, const N: usize>(m: &mut Machine<N>, at: u32, value: T) {
    // SAFETY: as the caller promises.
    unsafe { *m.cells().add(at as usize) = value.to_cell() }
}

/// How many numbers long formulas take abreast: as many as fill a processor's waits.
pub(super) const ABREAST: usize = 8;
const _: () = assert!(super::LANES.is_multiple_of(ABREAST));

/// A long function of lanes that lie an eighth of all apart, for the loop over them to become vectors.
///
/// A macro, since closures of such a size are not inlined.
macro_rules! abreast {
    ($d:ident, $n:ident, $several:path, $(|$lane:ident| $operand:expr),+) => {
        for first in 0..$n / $crate::interp::fast::shape::ABREAST {
            let results = $several($({
                let $lane = first;
                let mut operands = [$operand; $crate::interp::fast::shape::ABREAST];
                for k in 1..$crate::interp::fast::shape::ABREAST {
                    let $lane = first + k * ($n / $crate::interp::fast::shape::ABREAST);
                    operands[k] = $operand;
                }
                operands
            }),+);
            for k in 0..$crate::interp::fast::shape::ABREAST {
                $d[first + k * ($n / $crate::interp::fast::shape::ABREAST)] = results[k];
            }
        }
    };
}
pub(super) use abreast;

/// A function of one number.
pub(super) trait Fn1: 'static {
    type A: Lane;
    type R: Lane;
    /// Whether it is so long that numbers abreast are done sooner.
    const LONG: bool = false;
    fn eval(a: Self::A) -> Self::R;
    #[inline(always)]
    fn several<const K: usize>(a: [Self::A; K]) -> [Self::R; K] {
        let mut results = [Self::eval(a[0]); K];
        for k in 1..K {
            results[k] = Self::eval(a[k]);
        }
        results
    }
    #[inline(always)]
    fn lanes<const N: usize>(d: &mut [Self::R; N], a: &[Self::A; N]) {
        if Self::LONG {
            abreast!(d, N, Self::several, |lane| a[lane]);
        } else {
            for lane in 0..N {
                d[lane] = Self::eval(a[lane]);
            }
        }
    }
}

/// A function of two numbers.
pub(super) trait Fn2: 'static {
    type A: Lane;
    type B: Lane;
    type R: Lane;
    /// As of [`Fn1`].
    const LONG: bool = false;
    fn eval(a: Self::A, b: Self::B) -> Self::R;
    #[inline(always)]
    fn several<const K: usize>(a: [Self::A; K], b: [Self::B; K]) -> [Self::R; K] {
        let mut results = [Self::eval(a[0], b[0]); K];
        for k in 1..K {
            results[k] = Self::eval(a[k], b[k]);
        }
        results
    }
    #[inline(always)]
    fn lanes<S: Source, T: Source, const N: usize>(
        d: &mut [Self::R; N],
        a: S::Held<'_, Self::A, N>,
        b: T::Held<'_, Self::B, N>,
    ) {
        if Self::LONG {
            abreast!(d, N, Self::several, |lane| S::get(a, lane), |lane| T::get(b, lane));
        } else {
            for lane in 0..N {
                d[lane] = Self::eval(S::get(a, lane), T::get(b, lane));
            }
        }
    }
}

/// A function of three numbers.
pub(super) trait Fn3: 'static {
    type A: Lane;
    type B: Lane;
    type C: Lane;
    type R: Lane;
    /// As of [`Fn1`].
    const LONG: bool = false;
    fn eval(a: Self::A, b: Self::B, c: Self::C) -> Self::R;
    #[inline(always)]
    fn several<const K: usize>(a: [Self::A; K], b: [Self::B; K], c: [Self::C; K]) -> [Self::R; K] {
        let mut results = [Self::eval(a[0], b[0], c[0]); K];
        for k in 1..K {
            results[k] = Self::eval(a[k], b[k], c[k]);
        }
        results
    }
    #[inline(always)]
    fn lanes<S: Source, T: Source, U: Source, const N: usize>(
        d: &mut [Self::R; N],
        a: S::Held<'_, Self::A, N>,
        b: T::Held<'_, Self::B, N>,
        c: U::Held<'_, Self::C, N>,
    ) {
        if Self::LONG {
            abreast!(d, N, Self::several, |lane| S::get(a, lane), |lane| T::get(b, lane), |lane| U::get(
                c, lane
            ));
        } else {
            for lane in 0..N {
                d[lane] = Self::eval(S::get(a, lane), T::get(b, lane), U::get(c, lane));
            }
        }
    }
}

/// A function of four numbers of a kind.
pub(super) trait Fn4: 'static {
    type A: Lane;
    type C: Lane;
    fn eval(a: Self::A, b: Self::A, c: Self::C, d: Self::C) -> Self::A;
}

struct One<F>(PhantomData<F>);
struct Two<F, S, T>(PhantomData<(F, S, T)>);
struct Three<F, S, T, U>(PhantomData<(F, S, T, U)>);
struct Four<F>(PhantomData<F>);
/// All operands are the same in all lanes, and so is the result.
struct Uniform<F>(PhantomData<F>);
struct Uniform2<F>(PhantomData<F>);
struct Uniform3<F>(PhantomData<F>);
struct Uniform4<F>(PhantomData<F>);

impl<F: Fn1, const N: usize> Body<N> for One<F> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let a = Each::hold(m, i.s[0]);
            F::lanes(target(m, i.d), a);
        }
        at + 1
    }
}

impl<F: Fn2, S: Source, T: Source, const N: usize> Body<N> for Two<F, S, T> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let (a, b) = (S::hold(m, i.s[0]), T::hold(m, i.s[1]));
            F::lanes::<S, T, N>(target(m, i.d), a, b);
        }
        at + 1
    }
}

impl<F: Fn3, S: Source, T: Source, U: Source, const N: usize> Body<N> for Three<F, S, T, U> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let (a, b, c) = (S::hold(m, i.s[0]), T::hold(m, i.s[1]), U::hold(m, i.s[2]));
            F::lanes::<S, T, U, N>(target(m, i.d), a, b, c);
        }
        at + 1
    }
}

impl<F: Fn4, const N: usize> Body<N> for Four<F> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let (a, b): (&[F::A; N], &[F::A; N]) = (Each::hold(m, i.s[0]), Each::hold(m, i.s[1]));
            let (c, e): (&[F::C; N], &[F::C; N]) = (Each::hold(m, i.s[2]), Each::hold(m, i.s[3]));
            let d: &mut [F::A; N] = target(m, i.d);
            for lane in 0..N {
                d[lane] = F::eval(a[lane], b[lane], c[lane], e[lane]);
            }
        }
        at + 1
    }
}

impl<F: Fn1, const N: usize> Body<N> for Uniform<F> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let a = Same::hold(m, i.s[0]);
            set_cell(m, i.d, F::eval(a));
        }
        at + 1
    }
}

impl<F: Fn2, const N: usize> Body<N> for Uniform2<F> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let (a, b) = (Same::hold(m, i.s[0]), Same::hold(m, i.s[1]));
            set_cell(m, i.d, F::eval(a, b));
        }
        at + 1
    }
}

impl<F: Fn3, const N: usize> Body<N> for Uniform3<F> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let (a, b, c) = (Same::hold(m, i.s[0]), Same::hold(m, i.s[1]), Same::hold(m, i.s[2]));
            set_cell(m, i.d, F::eval(a, b, c));
        }
        at + 1
    }
}

impl<F: Fn4, const N: usize> Body<N> for Uniform4<F> {
    #[inline(always)]
    unsafe fn run(m: &mut Machine<N>, i: &Inst<N>, at: usize) -> usize {
        // SAFETY: as `Body` promises.
        unsafe {
            let (a, b) = (Same::hold(m, i.s[0]), Same::hold(m, i.s[1]));
            let (c, e) = (Same::hold(m, i.s[2]), Same::hold(m, i.s[3]));
            set_cell(m, i.d, F::eval(a, b, c, e));
        }
        at + 1
    }
}

/// Which operands are slots, and for which instruction set.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ask {
    pub(super) isa: Isa,
    pub(super) varying: [bool; 4],
}

/// A form of an operation. `None` where there is no form for these operands; they become slots then.
pub(super) type Found<const N: usize> = Option<Exec<N>>;

/// Uniform values are computed once a batch, so any instruction set does.
fn once<K: Body<N>, const N: usize>() -> Exec<N> {
    exec::<K, N>(Isa::Portable)
}

pub(super) fn one<F: Fn1, const N: usize>(ask: Ask) -> Found<N> {
    Some(match ask.varying[0] {
        true => exec::<One<F>, N>(ask.isa),
        false => once::<Uniform<F>, N>(),
    })
}

/// Where one operand is a cell: not for the portable set, which is spared the many forms.
fn mixed<K: Body<N>, const N: usize>(isa: Isa) -> Found<N> {
    match isa {
        Isa::Portable => None,
        #[cfg(target_arch = "x86_64")]
        Isa::Avx2 => Some(avx2::<K, N>),
        #[cfg(target_arch = "x86_64")]
        Isa::Avx512 => Some(avx512::<K, N>),
        #[cfg(not(target_arch = "x86_64"))]
        Isa::Avx2 | Isa::Avx512 => None,
    }
}

/// In all forms: for what is frequent and short.
pub(super) fn two<F: Fn2, const N: usize>(ask: Ask) -> Found<N> {
    match (ask.varying[0], ask.varying[1]) {
        (false, true) => mixed::<Two<F, Same, Each>, N>(ask.isa),
        (true, false) => mixed::<Two<F, Each, Same>, N>(ask.isa),
        (true, true) | (false, false) => two_alike::<F, N>(ask),
    }
}

/// Where operands can change places: `passes::order` puts a uniform one second.
pub(super) fn two_commuting<F: Fn2, const N: usize>(ask: Ask) -> Found<N> {
    match (ask.varying[0], ask.varying[1]) {
        (true, false) => mixed::<Two<F, Each, Same>, N>(ask.isa),
        (true, true) | (false, false) | (false, true) => two_alike::<F, N>(ask),
    }
}

/// On slots only, or on cells only.
pub(super) fn two_alike<F: Fn2, const N: usize>(ask: Ask) -> Found<N> {
    match (ask.varying[0], ask.varying[1]) {
        (true, true) => Some(exec::<Two<F, Each, Each>, N>(ask.isa)),
        (false, false) => Some(once::<Uniform2<F>, N>()),
        (true, false) | (false, true) => None,
    }
}

/// With cells for the second and third operand: for what is frequent and short.
pub(super) fn three<F: Fn3, const N: usize>(ask: Ask) -> Found<N> {
    let [a, b, c, _] = ask.varying;
    match (a, b, c) {
        (true, true, false) => mixed::<Three<F, Each, Each, Same>, N>(ask.isa),
        (true, false, true) => mixed::<Three<F, Each, Same, Each>, N>(ask.isa),
        (true, false, false) => mixed::<Three<F, Each, Same, Same>, N>(ask.isa),
        (true, true, true) | (false, _, _) => three_alike::<F, N>(ask),
    }
}

/// The same, and with a cell for the first operand beside a slot for the second.
pub(super) fn three_any<F: Fn3, const N: usize>(ask: Ask) -> Found<N> {
    let [a, b, c, _] = ask.varying;
    match (a, b, c) {
        (false, true, true) => mixed::<Three<F, Same, Each, Each>, N>(ask.isa),
        (false, true, false) => mixed::<Three<F, Same, Each, Same>, N>(ask.isa),
        (true, _, _) | (false, false, _) => three::<F, N>(ask),
    }
}

/// On slots only, or on cells only.
pub(super) fn three_alike<F: Fn3, const N: usize>(ask: Ask) -> Found<N> {
    let [a, b, c, _] = ask.varying;
    match (a, b, c) {
        (true, true, true) => Some(exec::<Three<F, Each, Each, Each>, N>(ask.isa)),
        (false, false, false) => Some(once::<Uniform3<F>, N>()),
        _ => None,
    }
}

/// On slots only, or on cells only.
pub(super) fn four_alike<F: Fn4, const N: usize>(ask: Ask) -> Found<N> {
    match ask.varying {
        [true, true, true, true] => Some(exec::<Four<F>, N>(ask.isa)),
        [false, false, false, false] => Some(once::<Uniform4<F>, N>()),
        _ => None,
    }
}
