//! A scalar in every lane, by what a model has for it.

use super::super::mask::Mask;
use super::super::model::{Model, Pick};
use super::super::program::{Constant, Scalar};
use super::{MISMATCH, Res};

/// What a model has for a scalar.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Family {
    Float,
    /// Integers, and floats that models know as bits only.
    Word,
    Bool,
}

pub(super) fn family<M: Model>(scalar: Scalar) -> Family {
    match scalar {
        scalar if M::has(scalar) => Family::Float,
        Scalar::Bool => Family::Bool,
        Scalar::I16
        | Scalar::U16
        | Scalar::I32
        | Scalar::U32
        | Scalar::I64
        | Scalar::U64
        | Scalar::F16
        | Scalar::F32
        | Scalar::F64 => Family::Word,
    }
}

/// One scalar in every lane.
pub(in super::super) enum Column<M: Model> {
    Float(Vec<M::F>),
    Word(Vec<M::W>),
    Bool(Vec<M::B>),
}

impl<M: Model> Clone for Column<M> {
    fn clone(&self) -> Self {
        match self {
            Self::Float(v) => Self::Float(v.clone()),
            Self::Word(v) => Self::Word(v.clone()),
            Self::Bool(v) => Self::Bool(v.clone()),
        }
    }
}

impl<M: Model> Default for Column<M> {
    fn default() -> Self {
        Self::Word(Vec::new())
    }
}

impl<M: Model> Column<M> {
    /// Zero in every lane.
    pub(super) fn zero(m: &M, scalar: Scalar, lanes: usize) -> Self {
        match family::<M>(scalar) {
            Family::Float => Self::Float(vec![m.float(0.0, 0.0); lanes]),
            Family::Word => Self::Word(vec![m.word(0); lanes]),
            Family::Bool => Self::Bool(vec![m.boolean(false); lanes]),
        }
    }

    /// Whether it holds such scalars.
    pub(super) fn holds(&self, scalar: Scalar) -> bool {
        match self {
            Self::Float(_) => family::<M>(scalar) == Family::Float,
            Self::Word(_) => family::<M>(scalar) == Family::Word,
            Self::Bool(_) => family::<M>(scalar) == Family::Bool,
        }
    }

    /// How many lanes it has; none before something was stored.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::Float(v) => v.len(),
            Self::Word(v) => v.len(),
            Self::Bool(v) => v.len(),
        }
    }

    /// Sets one lane to that of `from`.
    pub(super) fn set(&mut self, from: &Self, lane: usize) -> Res<()> {
        match (self, from) {
            (Self::Float(to), Self::Float(from)) => to[lane] = from[lane],
            (Self::Word(to), Self::Word(from)) => to[lane] = from[lane],
            (Self::Bool(to), Self::Bool(from)) => to[lane] = from[lane],
            (Self::Float(_) | Self::Word(_) | Self::Bool(_), _) => return Err(MISMATCH),
        }
        Ok(())
    }

    /// Drivers may have anything in this lane.
    pub(super) fn forget(&mut self, m: &M, lane: usize) {
        match self {
            Self::Float(v) => v[lane] = m.unpromised(v[lane]),
            Self::Word(v) => v[lane] = m.forget(v[lane]),
            Self::Bool(v) => {
                let word = m.forget(super::cast::number(m, v[lane]));
                v[lane] = m.compare_w(word, m.word(0), |a, b| a != b);
            }
        }
    }

    /// Takes over the lanes of `from` that are on in `mask`.
    pub(super) fn take(&mut self, from: &Self, mask: &Mask) -> Res<()> {
        match (self, from) {
            (Self::Float(to), Self::Float(from)) => mask.lanes().for_each(|l| to[l] = from[l]),
            (Self::Word(to), Self::Word(from)) => mask.lanes().for_each(|l| to[l] = from[l]),
            (Self::Bool(to), Self::Bool(from)) => mask.lanes().for_each(|l| to[l] = from[l]),
            (Self::Float(_) | Self::Word(_) | Self::Bool(_), _) => return Err(MISMATCH),
        }
        Ok(())
    }

    /// Joins with `other` in the lanes that are on; `pick` says what of `other` is taken.
    pub(super) fn join(&mut self, m: &M, other: &Self, on: &Mask, pick: impl Fn(usize) -> Pick) -> Res<()> {
        match (self, other) {
            (Self::Float(a), Self::Float(b)) => on.lanes().for_each(|l| a[l] = m.join_f(b[l], a[l], pick(l))),
            (Self::Word(a), Self::Word(b)) => on.lanes().for_each(|l| a[l] = m.join_w(b[l], a[l], pick(l))),
            (Self::Bool(a), Self::Bool(b)) => on.lanes().for_each(|l| a[l] = m.join_b(b[l], a[l], pick(l))),
            (Self::Float(_) | Self::Word(_) | Self::Bool(_), _) => return Err(MISMATCH),
        }
        Ok(())
    }

    /// Its 32-bit words on the f32 path; a boolean is 0 or 1.
    pub(super) fn words(&self, m: &M) -> Vec<u32> {
        match self {
            Self::Float(v) => v.iter().map(|x| m.value(*x).to_bits()).collect(),
            Self::Word(v) => v.iter().map(|x| m.word_value(*x) as u32).collect(),
            Self::Bool(v) => v.iter().map(|x| u32::from(m.decision(*x))).collect(),
        }
    }
}

/// A scalar that is the same in every lane.
pub(super) enum Single<M: Model> {
    Float(M::F),
    Word(M::W),
    Bool(M::B),
}

impl<M: Model> Single<M> {
    pub(super) fn constant(m: &M, constant: &Constant) -> Self {
        match family::<M>(constant.scalar) {
            Family::Float if constant.scalar == Scalar::F64 => {
                Self::Float(m.double().float_of_bits(m.word(constant.bits)))
            }
            Family::Float => {
                let value = f32::from_bits(constant.bits as u32);
                Self::Float(by_width!(*m, constant.scalar, m => m.float(value, constant.exact)))
            }
            Family::Word => Self::Word(m.word(constant.bits)),
            Family::Bool => Self::Bool(m.boolean(constant.bits != 0)),
        }
    }
}

/// An operand in the lanes.
pub(super) enum Operand<'a, T> {
    Each(&'a [T]),
    Same(T),
}

impl<T: Copy> Operand<'_, T> {
    pub(super) fn at(&self, lane: usize) -> T {
        match self {
            Self::Each(lanes) => lanes[lane],
            Self::Same(value) => *value,
        }
    }
}
