//! Columns of lanes: one for each scalar of a value.
//!
//! Columns are shared and copied on write, so that loads, argument passing and the snapshots at ambiguous
//! branches cost a count, not a copy.

use super::error::{InterpError, Res};
use super::layout::Kind;
use super::mask::Mask;
use super::model::{Model, Pick};
use std::rc::Rc;

/// One scalar in every lane.
pub(super) enum Leaf<M: Model> {
    Float(Rc<Vec<M::F>>),
    Word(Rc<Vec<M::W>>),
    Bool(Rc<Vec<M::B>>),
}

impl<M: Model> Clone for Leaf<M> {
    fn clone(&self) -> Self {
        match self {
            Self::Float(v) => Self::Float(v.clone()),
            Self::Word(v) => Self::Word(v.clone()),
            Self::Bool(v) => Self::Bool(v.clone()),
        }
    }
}

const MISMATCH: InterpError = InterpError::Malformed("a scalar of one kind is used as another");

impl<M: Model> Leaf<M> {
    pub(super) fn from_floats(lanes: Vec<M::F>) -> Self {
        Self::Float(Rc::new(lanes))
    }
    pub(super) fn from_words(lanes: Vec<M::W>) -> Self {
        Self::Word(Rc::new(lanes))
    }
    pub(super) fn from_bools(lanes: Vec<M::B>) -> Self {
        Self::Bool(Rc::new(lanes))
    }

    /// Zero in every lane.
    pub(super) fn zero(m: &M, kind: Kind, lanes: usize) -> Self {
        match kind {
            Kind::F32 => Self::from_floats(vec![m.float(0.0, 0.0); lanes]),
            Kind::I32 | Kind::U32 => Self::from_words(vec![m.word(0); lanes]),
            Kind::Bool => Self::from_bools(vec![m.boolean(false); lanes]),
        }
    }

    pub(super) fn floats(&self) -> Res<&[M::F]> {
        match self {
            Self::Float(v) => Ok(v),
            Self::Word(_) | Self::Bool(_) => Err(MISMATCH),
        }
    }
    pub(super) fn words(&self) -> Res<&[M::W]> {
        match self {
            Self::Word(v) => Ok(v),
            Self::Float(_) | Self::Bool(_) => Err(MISMATCH),
        }
    }
    pub(super) fn bools(&self) -> Res<&[M::B]> {
        match self {
            Self::Bool(v) => Ok(v),
            Self::Float(_) | Self::Word(_) => Err(MISMATCH),
        }
    }

    /// Whether both are the same column, so that each lane is one number.
    pub(super) fn same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Float(a), Self::Float(b)) => Rc::ptr_eq(a, b),
            (Self::Word(a), Self::Word(b)) => Rc::ptr_eq(a, b),
            (Self::Bool(a), Self::Bool(b)) => Rc::ptr_eq(a, b),
            (Self::Float(_) | Self::Word(_) | Self::Bool(_), _) => false,
        }
    }

    /// Takes over the lanes of `from` that are on in `mask`.
    pub(super) fn blend(&mut self, from: &Self, mask: &Mask) -> Res<()> {
        match (self, from) {
            (Self::Float(to), Self::Float(from)) => blend(to, from, mask),
            (Self::Word(to), Self::Word(from)) => blend(to, from, mask),
            (Self::Bool(to), Self::Bool(from)) => blend(to, from, mask),
            (Self::Float(_) | Self::Word(_) | Self::Bool(_), _) => return Err(MISMATCH),
        }
        Ok(())
    }

    /// Joins `self` with `other` in the lanes that are on; `pick` says what of `other` is taken.
    pub(super) fn join(&mut self, m: &M, other: &Self, on: &Mask, pick: impl Fn(usize) -> Pick) -> Res<()> {
        match (self, other) {
            (Self::Float(a), Self::Float(b)) => merge(a, b, on, |l, a, b| m.join_f(b, a, pick(l))),
            (Self::Word(a), Self::Word(b)) => merge(a, b, on, |l, a, b| m.join_w(b, a, pick(l))),
            (Self::Bool(a), Self::Bool(b)) => merge(a, b, on, |l, a, b| m.join_b(b, a, pick(l))),
            (Self::Float(_) | Self::Word(_) | Self::Bool(_), _) => return Err(MISMATCH),
        }
        Ok(())
    }

    /// Lane `l` of the result is lane `l` of `sources[index(l)]`; the sources are of one kind.
    pub(super) fn gather(sources: &[&Self], lanes: usize, index: impl Fn(usize) -> usize) -> Res<Self> {
        let first = sources.first().ok_or(MISMATCH)?;
        Ok(match first {
            Self::Float(_) => {
                let columns = sources.iter().map(|s| s.floats()).collect::<Res<Vec<_>>>()?;
                Self::from_floats((0..lanes).map(|l| columns[index(l)][l]).collect())
            }
            Self::Word(_) => {
                let columns = sources.iter().map(|s| s.words()).collect::<Res<Vec<_>>>()?;
                Self::from_words((0..lanes).map(|l| columns[index(l)][l]).collect())
            }
            Self::Bool(_) => {
                let columns = sources.iter().map(|s| s.bools()).collect::<Res<Vec<_>>>()?;
                Self::from_bools((0..lanes).map(|l| columns[index(l)][l]).collect())
            }
        })
    }

    /// Sets one lane to that of `from`.
    pub(super) fn set_lane(&mut self, from: &Self, lane: usize) -> Res<()> {
        match (self, from) {
            (Self::Float(to), Self::Float(from)) => Rc::make_mut(to)[lane] = from[lane],
            (Self::Word(to), Self::Word(from)) => Rc::make_mut(to)[lane] = from[lane],
            (Self::Bool(to), Self::Bool(from)) => Rc::make_mut(to)[lane] = from[lane],
            (Self::Float(_) | Self::Word(_) | Self::Bool(_), _) => return Err(MISMATCH),
        }
        Ok(())
    }

    /// The 32 bits of each lane's value.
    pub(super) fn value_bits(&self, m: &M) -> Vec<u32> {
        match self {
            Self::Float(v) => v.iter().map(|x| m.value(*x).to_bits()).collect(),
            Self::Word(v) => v.iter().map(|x| m.word_value(*x)).collect(),
            Self::Bool(v) => v.iter().map(|x| u32::from(m.decision(*x))).collect(),
        }
    }

    /// Lanes that hold these bits.
    pub(super) fn from_value_bits(m: &M, kind: Kind, bits: impl Iterator<Item = u32>) -> Self {
        match kind {
            Kind::F32 => Self::from_floats(bits.map(f32::from_bits).map(|x| m.float(x, x.into())).collect()),
            Kind::I32 | Kind::U32 => Self::from_words(bits.map(|b| m.word(b)).collect()),
            Kind::Bool => Self::from_bools(bits.map(|b| m.boolean(b != 0)).collect()),
        }
    }
}

fn blend<T: Copy>(to: &mut Rc<Vec<T>>, from: &Rc<Vec<T>>, mask: &Mask) {
    if Rc::ptr_eq(to, from) {
    } else if mask.every() {
        *to = from.clone();
    } else {
        let to = Rc::make_mut(to);
        mask.lanes().for_each(|lane| to[lane] = from[lane]);
    }
}

fn merge<T: Copy>(a: &mut Rc<Vec<T>>, b: &Rc<Vec<T>>, on: &Mask, f: impl Fn(usize, T, T) -> T) {
    if !Rc::ptr_eq(a, b) {
        let a = Rc::make_mut(a);
        on.lanes().for_each(|lane| a[lane] = f(lane, a[lane], b[lane]));
    }
}
