//! What became of the faults.

use super::fault::{Kind, Mutant};
use std::collections::BTreeMap;

/// What became of one.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[serde(tag = "outcome", rename_all = "kebab-case")]
pub enum Outcome {
    /// A result lies outside its bound, or there is none.
    OutsideBound {
        /// Which.
        how: String,
    },
    /// Bits differ from those of other roads to the same driver, within the bound.
    OtherBits {
        /// The largest share of a bound.
        share: f64,
        /// Rows with other bits.
        rows: usize,
    },
    /// No bit changes on the inputs of a check, but on others.
    Missed {
        /// Rows that were run until one changed.
        rows: usize,
    },
    /// No bit was seen to change.
    Unseen {
        /// Rows that were run.
        rows: usize,
    },
    /// No bit changes on as many rows as prove it.
    Equivalent {
        /// Rows that were run.
        rows: usize,
    },
    /// It is no valid module.
    Stillborn,
    /// The time was over.
    NotTried,
}

/// The faults of a kernel.
#[derive(Debug, Clone)]
pub struct KernelFaults {
    /// The kernel.
    pub kernel: &'static str,
    /// Each with what became of it.
    pub faults: Vec<(Mutant, Outcome)>,
}

/// How many ended how.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, serde::Serialize)]
pub struct Count {
    /// Noticed by the bound.
    pub by_bound: usize,
    /// Noticed only by bits that differ from those of other roads.
    pub by_bits: usize,
    /// Not noticed on the inputs of a check.
    pub missed: usize,
    /// Not seen to change anything, on fewer rows than prove it.
    pub unseen: usize,
    /// Proved to change nothing.
    pub equivalent: usize,
    /// Not tried in time.
    pub not_tried: usize,
}

impl Count {
    /// The share that a check notices of those that are faults; 1 where there are none.
    #[must_use]
    pub fn score(&self) -> f64 {
        self.share(self.by_bound + self.by_bits)
    }

    /// The share that the bound notices alone, as of a fault that all roads to a driver have.
    #[must_use]
    pub fn score_of_bound(&self) -> f64 {
        self.share(self.by_bound)
    }

    fn share(&self, of: usize) -> f64 {
        let faults = self.by_bound + self.by_bits + self.missed + self.unseen;
        if faults == 0 { 1.0 } else { of as f64 / faults as f64 }
    }

    fn note(&mut self, outcome: &Outcome) {
        match outcome {
            Outcome::OutsideBound { .. } => self.by_bound += 1,
            Outcome::OtherBits { .. } => self.by_bits += 1,
            Outcome::Missed { .. } => self.missed += 1,
            Outcome::Unseen { .. } => self.unseen += 1,
            Outcome::Equivalent { .. } => self.equivalent += 1,
            Outcome::NotTried => self.not_tried += 1,
            Outcome::Stillborn => {}
        }
    }
}

impl std::ops::Add for Count {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            by_bound: self.by_bound + other.by_bound,
            by_bits: self.by_bits + other.by_bits,
            missed: self.missed + other.missed,
            unseen: self.unseen + other.unseen,
            equivalent: self.equivalent + other.equivalent,
            not_tried: self.not_tried + other.not_tried,
        }
    }
}

impl KernelFaults {
    pub(super) fn new(kernel: &'static str, mutants: Vec<Mutant>, outcomes: Vec<Outcome>) -> Self {
        Self { kernel, faults: mutants.into_iter().zip(outcomes).collect() }
    }

    /// How the faults for which `wanted` holds ended.
    #[must_use]
    pub fn count(&self, wanted: impl Fn(Kind) -> bool) -> Count {
        let mut count = Count::default();
        self.faults
            .iter()
            .filter(|(mutant, _)| wanted(mutant.kind))
            .for_each(|(_, outcome)| count.note(outcome));
        count
    }
}

/// How the faults of several kernels ended, kind by kind.
#[must_use]
pub fn by_kind(kernels: &[KernelFaults]) -> BTreeMap<Kind, Count> {
    let mut all: BTreeMap<Kind, Count> = BTreeMap::new();
    for (mutant, outcome) in kernels.iter().flat_map(|k| &k.faults) {
        all.entry(mutant.kind).or_default().note(outcome);
    }
    all
}
