//! Forms without an instruction set of their own: for operations that call functions anyway, or are rare.

use super::super::machine::Machine;
use super::{
    Ask, Body, Each, Exec, Fn1, Fn2, Fn3, Found, Inst, One, Three, Two, Uniform, Uniform2, Uniform3, portable,
};

/// A step for any processor.
pub(in super::super) fn plain<K: Body<N>, const N: usize>() -> Exec<N> {
    let step: unsafe fn(&mut Machine<N>, &Inst<N>, usize) -> usize = portable::<K, N>;
    step
}

pub(in super::super) fn one_plain<F: Fn1, const N: usize>(ask: Ask) -> Found<N> {
    Some(if ask.varying[0] { plain::<One<F>, N>() } else { plain::<Uniform<F>, N>() })
}

pub(in super::super) fn two_plain<F: Fn2, const N: usize>(ask: Ask) -> Found<N> {
    match (ask.varying[0], ask.varying[1]) {
        (true, true) => Some(plain::<Two<F, Each, Each>, N>()),
        (false, false) => Some(plain::<Uniform2<F>, N>()),
        (true, false) | (false, true) => None,
    }
}

pub(in super::super) fn three_plain<F: Fn3, const N: usize>(ask: Ask) -> Found<N> {
    match ask.varying {
        [true, true, true, _] => Some(plain::<Three<F, Each, Each, Each>, N>()),
        [false, false, false, _] => Some(plain::<Uniform3<F>, N>()),
        _ => None,
    }
}
