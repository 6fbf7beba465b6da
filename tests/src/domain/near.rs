//! Rows near others: steps of every size that stay in the domain.

use super::slot::{DomainError, Relation, Slot, slots};
use super::{Drawn, Rng, Sampler, bits, number, unit};
use lobe_codegen::def::FunctionDef;

/// At most so many parts of a row move at once.
const MOVES: usize = 3;
/// One row in so many is drawn anew, so that no search stays where it began.
const ANEW: usize = 16;

/// Draws rows near others.
#[derive(Clone, Debug)]
pub struct Neighbours {
    slots: Vec<Slot>,
    rng: Rng,
}

impl Neighbours {
    /// Of rows of `kernel`'s arguments; the same seed draws the same rows.
    ///
    /// # Errors
    /// When a domain is missing or does not fit.
    pub fn new(kernel: &'static FunctionDef, seed: u64) -> Result<Self, DomainError> {
        Ok(Self { slots: slots(kernel)?, rng: Rng::new(seed, &format!("near {}", kernel.name)) })
    }

    /// The generator behind it.
    pub fn rng(&mut self) -> &mut Rng {
        &mut self.rng
    }

    /// A row of the domain near `row`, which is one.
    pub fn near(&mut self, row: &[u32]) -> Vec<u32> {
        let mut sampler = Sampler { slots: &self.slots, rng: self.rng.clone() };
        let drawn = if sampler.rng.one_in(ANEW) { sampler.random_row() } else { sampler.near_row(row) };
        self.rng = sampler.rng;
        drawn
    }
}

impl Sampler<'_> {
    fn near_row(&mut self, row: &[u32]) -> Vec<u32> {
        let moves = 1 + self.rng.below(MOVES);
        let moved: Vec<usize> = (0..moves).map(|_| self.rng.below(self.slots.len())).collect();
        self.row(|this, slot, earlier| this.near_slot(slot, moved.contains(&slot), row, earlier))
    }

    fn near_slot(&mut self, slot: usize, moves: bool, row: &[u32], earlier: &[Drawn]) -> Vec<u32> {
        match &self.slots[slot] {
            Slot::Number { column, .. } if !moves => vec![row[*column]],
            Slot::Number { column, scalar, values } => {
                vec![number::near(*scalar, values, row[*column], &mut self.rng)]
            }
            Slot::Unit { column, n, relation } => {
                let before = &row[*column..column + n];
                self.near_unit(before, *relation, moves, earlier).unwrap_or_else(|| before.to_vec())
            }
        }
    }

    /// Where a unit vector goes; `None` if it stays.
    fn near_unit(
        &mut self,
        before: &[u32],
        relation: Relation,
        moves: bool,
        earlier: &[Drawn],
    ) -> Option<Vec<u32>> {
        let before: Vec<f32> = before.iter().map(|w| f32::from_bits(*w)).collect();
        match relation {
            Relation::Free if !moves => None,
            Relation::Free if self.rng.one_in(4) => {
                let peers = super::peers(earlier);
                Some(bits(unit::random(before.len(), &peers, &mut self.rng)))
            }
            Relation::Free => Some(bits(unit::near(&before, &mut self.rng))),
            Relation::NormalTo(z) => {
                let z = earlier.iter().find(|d| d.column == z)?;
                let to = if moves { unit::near(&before, &mut self.rng) } else { before };
                Some(bits(unit::made_normal_to(&z.vector, &to)))
            }
            Relation::Cross(..) => Some(bits(self.related(relation, earlier))),
        }
    }
}
