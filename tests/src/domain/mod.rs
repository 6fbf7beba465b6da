//! Inputs out of a kernel's stated domain: edge cases, evenly spaced, random, and listed ones.
//!
//! The same kernel, count and seed give the same rows, on every machine.

mod near;
mod number;
mod rng;
mod slot;
pub(crate) mod unit;

pub use near::Neighbours;
pub use rng::Rng;
pub use slot::{DomainError, Relation, Slot, Values, slots};

use lobe_codegen::data::Columns;
use lobe_codegen::def::FunctionDef;

/// Rows of arguments and where they come from: the families stand one after the other.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inputs {
    /// The rows.
    pub args: Columns,
    /// How many rows each family has, in order.
    pub families: Vec<(Family, usize)>,
}

/// Where rows come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Kept in a file, since something once went wrong there.
    Listed,
    /// Combinations of values at which something may change.
    Edge,
    /// Evenly spaced, by value and by exponent.
    Spaced,
    /// Drawn at random.
    Random,
}

/// At most this share of the rows are edge cases.
const EDGE_SHARE: usize = 4;
/// One row in so many is spaced.
const SPACED_SHARE: usize = 8;

impl Inputs {
    /// `n` rows out of `kernel`'s domain, after the `listed` ones.
    ///
    /// # Errors
    /// When a domain is missing or does not fit.
    pub fn draw(
        kernel: &'static FunctionDef,
        n: usize,
        seed: u64,
        listed: &Columns,
    ) -> Result<Self, DomainError> {
        let slots = slots(kernel)?;
        let mut sampler = Sampler { slots: &slots, rng: Rng::new(seed, kernel.name) };
        let all = sampler.n_edge_combinations();
        let n_edge = all.min(n.div_ceil(EDGE_SHARE));
        let n_spaced = ((n - n_edge) / SPACED_SHARE).min(n - n_edge);
        let mut rows = sampler.edge_rows(n_edge, all <= n_edge);
        rows.extend((0..n_spaced).map(|i| sampler.spaced_row(i, n_spaced)));
        rows.extend((n_edge + n_spaced..n).map(|_| sampler.random_row()));
        let mut args = Columns::zeros(width(&slots), 0);
        args.append(listed);
        args.append(&Columns::from_rows(width(&slots), &rows));
        let families = vec![
            (Family::Listed, listed.rows),
            (Family::Edge, n_edge),
            (Family::Spaced, n_spaced),
            (Family::Random, n - n_edge - n_spaced),
        ];
        Ok(Self { args, families })
    }

    /// The family of row `row`.
    #[must_use]
    pub fn family(&self, row: usize) -> Family {
        let mut end = 0;
        for (family, n) in &self.families {
            end += n;
            if row < end {
                return *family;
            }
        }
        Family::Random
    }
}

fn width(slots: &[Slot]) -> usize {
    slots
        .iter()
        .map(|slot| match slot {
            Slot::Number { .. } => 1,
            Slot::Unit { n, .. } => *n,
        })
        .sum()
}

struct Sampler<'a> {
    slots: &'a [Slot],
    rng: Rng,
}

impl Sampler<'_> {
    /// Edge values of each slot.
    fn n_edges(&self) -> Vec<usize> {
        let peers = |before: usize, n: usize| {
            let is_one =
                |s: &&Slot| matches!(s, Slot::Unit { n: m, relation, .. } if *m == n && is_peer(*relation));
            self.slots[..before].iter().filter(is_one).count()
        };
        let count = |(index, slot): (usize, &Slot)| match slot {
            Slot::Number { scalar, values, .. } => number::edges(*scalar, values).len(),
            Slot::Unit { n, relation: Relation::Free, .. } => unit::n_edges(*n, peers(index, *n)),
            Slot::Unit { relation: Relation::NormalTo(_) | Relation::Cross(..), .. } => 1,
        };
        self.slots.iter().enumerate().map(count).collect()
    }

    fn n_edge_combinations(&self) -> usize {
        self.n_edges().into_iter().fold(1, usize::saturating_mul)
    }

    /// All combinations when they fit; else each slot's edges in turn among random edges of the others.
    fn edge_rows(&mut self, n: usize, is_complete: bool) -> Vec<Vec<u32>> {
        let (counts, numbers) = (self.n_edges(), self.edge_numbers());
        let pick = |row: usize, rng: &mut Rng| -> Vec<Option<usize>> {
            let mut rest = row;
            let turn = row % counts.len().max(1);
            let choose = |(slot, count): (usize, &usize)| {
                let index = if is_complete { rest % count } else { (row / counts.len()) % count };
                rest /= count;
                if is_complete || slot == turn {
                    Some(index)
                } else {
                    (!rng.one_in(4)).then(|| rng.below(*count))
                }
            };
            counts.iter().enumerate().map(choose).collect()
        };
        (0..n)
            .map(|row| {
                let picks = pick(row, &mut self.rng);
                self.row(|this, slot, earlier| {
                    this.edge_or_random(slot, picks[slot].map(|index| (index, &numbers[slot][..])), earlier)
                })
            })
            .collect()
    }

    /// Edge values of each slot that is a number.
    fn edge_numbers(&self) -> Vec<Vec<u32>> {
        let words = |slot: &Slot| match slot {
            Slot::Number { scalar, values, .. } => number::edges(*scalar, values),
            Slot::Unit { .. } => Vec::new(),
        };
        self.slots.iter().map(words).collect()
    }

    /// `pick`: the rank of an edge case, and those of a number.
    fn edge_or_random(&mut self, slot: usize, pick: Option<(usize, &[u32])>, earlier: &[Drawn]) -> Vec<u32> {
        let Some((index, numbers)) = pick else { return self.random(slot, earlier) };
        match &self.slots[slot] {
            Slot::Number { .. } => vec![numbers[index]],
            Slot::Unit { n, relation: Relation::Free, .. } => {
                bits(unit::edge(*n, index, &peers(earlier), &mut self.rng))
            }
            Slot::Unit { relation, .. } => bits(self.related(*relation, earlier)),
        }
    }

    fn random(&mut self, slot: usize, earlier: &[Drawn]) -> Vec<u32> {
        match &self.slots[slot] {
            Slot::Number { scalar, values, .. } => vec![number::random(*scalar, values, &mut self.rng)],
            Slot::Unit { n, relation: Relation::Free, .. } => {
                bits(unit::random(*n, &peers(earlier), &mut self.rng))
            }
            Slot::Unit { relation, .. } => bits(self.related(*relation, earlier)),
        }
    }

    fn related(&mut self, relation: Relation, earlier: &[Drawn]) -> Vec<f32> {
        let at = |column: usize| earlier.iter().find(|d| d.column == column).map_or(&[][..], |d| &d.vector);
        match relation {
            Relation::Free => unit::random(3, &peers(earlier), &mut self.rng),
            Relation::NormalTo(z) => unit::normal_to(at(z), &mut self.rng),
            Relation::Cross(z, x) => unit::cross(at(z), at(x)),
        }
    }

    fn random_row(&mut self) -> Vec<u32> {
        self.row(Self::random)
    }

    /// Slot `k` runs through its values at its own speed (Kronecker's sequence), so that a few thousand
    /// rows fill any number of slots evenly; a single slot is spaced exactly.
    fn spaced_row(&mut self, i: usize, n: usize) -> Vec<u32> {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let is_single = self.slots.len() == 1;
        self.row(|this, slot, earlier| match &this.slots[slot] {
            Slot::Number { scalar, values, .. } => {
                let fraction = if is_single {
                    (i / 2) as f64 / (n.div_ceil(2).saturating_sub(1)).max(1) as f64
                } else {
                    (0.5 + i as f64 * GOLDEN.powi(slot as i32 % 12 + 1)).fract()
                };
                vec![number::at(*scalar, values, fraction.min(1.0), i % 2 == 1)]
            }
            Slot::Unit { .. } => this.random(slot, earlier),
        })
    }

    fn row(&mut self, mut draw: impl FnMut(&mut Self, usize, &[Drawn]) -> Vec<u32>) -> Vec<u32> {
        let mut words = Vec::new();
        let mut earlier = Vec::new();
        for slot in 0..self.slots.len() {
            let drawn = draw(self, slot, &earlier);
            if let Slot::Unit { column, relation, .. } = self.slots[slot] {
                let vector = drawn.iter().map(|w| f32::from_bits(*w)).collect();
                earlier.push(Drawn { column, is_peer: is_peer(relation), vector });
            }
            words.extend(drawn);
        }
        words
    }
}

/// Whether later vectors are put into relation to it; the third axis of a frame tells nothing new.
fn is_peer(relation: Relation) -> bool {
    match relation {
        Relation::Free | Relation::NormalTo(_) => true,
        Relation::Cross(..) => false,
    }
}

/// A unit vector of the row that is being drawn.
struct Drawn {
    column: usize,
    is_peer: bool,
    vector: Vec<f32>,
}

/// The vectors that a later one is put into relation to.
fn peers(earlier: &[Drawn]) -> Vec<&[f32]> {
    earlier.iter().filter(|d| d.is_peer).map(|d| &*d.vector).collect()
}

fn bits(vector: Vec<f32>) -> Vec<u32> {
    vector.into_iter().map(f32::to_bits).collect()
}
