//! What memory that lanes share holds.

use super::super::model::{Model, Pick};
use super::super::program::{Op, Scalar};
use super::super::resources::elements::Elements;
use super::super::scalar::eval::eval;
use std::collections::BTreeMap;
use std::ops::Range;

/// A word of shared memory.
pub(in super::super) enum Cell<M: Model> {
    /// As the dispatch found it.
    Bits(u32),
    Float(M::F),
    Word(M::W),
}

impl<M: Model> Clone for Cell<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: Model> Copy for Cell<M> {}

impl<M: Model> Cell<M> {
    pub(super) fn word(self, m: &M) -> M::W {
        match self {
            Self::Bits(bits) => m.word(bits.into()),
            Self::Float(a) => m.bits(a),
            Self::Word(a) => a,
        }
    }

    pub(super) fn float(self, m: &M) -> M::F {
        match self {
            Self::Bits(bits) => m.float_of_bits(m.word(bits.into())),
            Self::Float(a) => a,
            Self::Word(a) => m.float_of_bits(a),
        }
    }

    /// The same bits, of which drivers may have others.
    pub(super) fn forgotten(self, m: &M) -> Self {
        match self {
            Self::Bits(_) | Self::Word(_) => Self::Word(m.forget(self.word(m))),
            Self::Float(a) => Self::Float(m.unpromised(a)),
        }
    }
}

/// A buffer, or a workgroup variable.
pub(in super::super) struct Shared<M: Model> {
    pub(in super::super) cells: Vec<Cell<M>>,
    /// Floats of 16 and 64 bits that were stored, by their first byte: what is known of them beyond the words there.
    pub(in super::super) others: BTreeMap<usize, Other<M>>,
    /// Whether something may have been written that is not known where.
    pub(in super::super) spoiled: bool,
    /// Of a binding array, where its elements lie.
    pub(in super::super) elements: Option<Elements>,
}

/// A float of 16 or 64 bits.
pub(in super::super) struct Other<M: Model> {
    pub(in super::super) scalar: Scalar,
    pub(in super::super) float: M::F,
}

impl<M: Model> Shared<M> {
    pub(super) fn new(cells: Vec<Cell<M>>) -> Self {
        Self { cells, others: BTreeMap::new(), spoiled: false, elements: None }
    }

    /// The bytes of each buffer in it.
    pub(in super::super) fn ranges(&self) -> Vec<Range<usize>> {
        let whole = 0..4 * self.cells.len();
        self.elements.as_ref().map_or_else(|| vec![whole], |elements| elements.ranges().collect())
    }

    pub(super) fn get(&self, m: &M, at: usize) -> Cell<M> {
        let cell = self.cells.get(at).copied().unwrap_or(Cell::Bits(0));
        if self.spoiled { cell.forgotten(m) } else { cell }
    }

    /// The float of 16 or 64 bits that was stored at a byte, unless something else was since.
    pub(super) fn other(&self, m: &M, scalar: Scalar, at: usize) -> Option<M::F> {
        let other = self.others.get(&at).filter(|other| other.scalar == scalar)?;
        Some(if self.spoiled { m.unpromised(other.float) } else { other.float })
    }

    /// Forgets the floats of 16 and 64 bits of which bytes are written.
    pub(super) fn overwrite(&mut self, at: usize, bytes: u32) {
        let end = at + bytes as usize;
        while let Some(found) = self
            .others
            .range(at.saturating_sub(7)..end)
            .find_map(|(begin, other)| (begin + other.scalar.bytes() as usize > at).then_some(*begin))
        {
            self.others.remove(&found);
        }
    }
}

/// The number of 16 or 64 bits at a byte, as registers hold it; `cell` finds words.
pub(super) fn gathered<M: Model>(
    m: &M,
    scalar: Scalar,
    at: usize,
    cell: impl Fn(&M, usize) -> Cell<M>,
) -> M::W {
    let low = cell(m, at / 4).word(m);
    if scalar.wide() {
        return m.zip_w(low, cell(m, at / 4 + 1).word(m), |low, high| low | high << 32);
    }
    m.map_w(low, |word| held(scalar, word >> (8 * (at & 2)) & 0xffff))
}

/// What registers hold of 16 bits.
fn held(scalar: Scalar, half: u64) -> u64 {
    eval(Op::Bitcast(Scalar::U16, scalar), &[half]).unwrap_or(half)
}

/// The 16 bits of what registers hold.
pub(super) fn stored(scalar: Scalar, held: u64) -> u64 {
    eval(Op::Bitcast(scalar, Scalar::U16), &[held]).unwrap_or(held) & 0xffff
}

/// A word that is one of two.
pub(super) fn joined<M: Model>(m: &M, old: Cell<M>, new: Cell<M>, pick: Pick) -> Cell<M> {
    match (old, new) {
        (Cell::Float(_), _) | (_, Cell::Float(_)) => Cell::Float(m.join_f(new.float(m), old.float(m), pick)),
        (Cell::Bits(_) | Cell::Word(_), _) => Cell::Word(m.join_w(new.word(m), old.word(m), pick)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interp::strict::Strict;

    #[test]
    fn what_is_written_over_a_float_in_part_makes_an_end_of_it() {
        let mut shared: Shared<Strict> = Shared::new(vec![Cell::Bits(0); 8]);
        let begin =
            [(0, Scalar::F16), (2, Scalar::F16), (8, Scalar::F64), (16, Scalar::F16), (18, Scalar::F16)];
        shared.others.extend(begin.map(|(at, scalar)| (at, Other { scalar, float: 1.0 })));
        let mut left = |at, bytes| {
            shared.overwrite(at, bytes);
            shared.others.keys().copied().collect::<Vec<_>>()
        };
        assert_eq!(left(4, 4), [0, 2, 8, 16, 18]);
        assert_eq!(left(2, 2), [0, 8, 16, 18]);
        assert_eq!(left(12, 4), [0, 16, 18]);
        assert_eq!(left(16, 4), [0]);
        assert!(left(0, 8).is_empty());
    }
}
