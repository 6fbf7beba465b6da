//! What became of the faults.

use super::fault::{Kind, Mutant};
use std::collections::BTreeMap;

/// What became of one.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[serde(tag = "outcome", rename_all = "kebab-case")]
pub enum Outcome {
    /// It was noticed.
    Killed {
        /// By what.
        how: String,
    },
    /// All its results are within their bounds.
    Survived {
        /// The largest share of a bound.
        share: f64,
        /// Whether no bit was seen to change.
        same: bool,
    },
    /// No bit changes on so many rows.
    Equivalent {
        /// Rows.
        rows: usize,
    },
    /// It is no valid module.
    Stillborn,
    /// The time was over.
    NotTried,
}

impl Outcome {
    /// The same after another look.
    #[must_use]
    pub fn worse(self, other: Self) -> Self {
        match (self, other) {
            (Self::Survived { share: a, same: x }, Self::Survived { share: b, same: y }) => {
                Self::Survived { share: a.max(b), same: x && y }
            }
            (_, other) => other,
        }
    }
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
    /// Noticed.
    pub killed: usize,
    /// Not noticed, and they change something.
    pub survived: usize,
    /// They change nothing on as many rows as prove it.
    pub equivalent: usize,
    /// They were not seen to change anything, on fewer rows.
    pub undecided: usize,
    /// Not tried in time.
    pub not_tried: usize,
}

impl Count {
    /// The share that was noticed of those that are faults; 1 where there are none.
    #[must_use]
    pub fn score(&self) -> f64 {
        let faults = self.killed + self.survived + self.undecided;
        if faults == 0 { 1.0 } else { self.killed as f64 / faults as f64 }
    }

    fn add(&mut self, outcome: &Outcome) {
        match outcome {
            Outcome::Killed { .. } => self.killed += 1,
            Outcome::Survived { same: false, .. } => self.survived += 1,
            Outcome::Survived { same: true, .. } => self.undecided += 1,
            Outcome::Equivalent { .. } => self.equivalent += 1,
            Outcome::NotTried => self.not_tried += 1,
            Outcome::Stillborn => {}
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
        self.faults.iter().filter(|(mutant, _)| wanted(mutant.kind)).for_each(|(_, o)| count.add(o));
        count
    }
}

/// How the faults of several kernels ended, kind by kind.
#[must_use]
pub fn by_kind(kernels: &[KernelFaults]) -> BTreeMap<Kind, Count> {
    let mut all: BTreeMap<Kind, Count> = BTreeMap::new();
    for (mutant, outcome) in kernels.iter().flat_map(|k| &k.faults) {
        all.entry(mutant.kind).or_default().add(outcome);
    }
    all
}
