//! The four questions asked of every kernel: correct, robust, conformant, agree.
//!
//! Each is an accumulator that takes the rows batch by batch and answers at the end.
//! No tolerance is written here: what is permitted comes from the kernel's stated budget, from the shadow
//! lane's derived bound, or is equality.

pub mod agree;
pub mod conformant;
pub mod correct;
pub mod distribution;
pub mod expected;
pub mod robust;
pub mod sanitized;
mod worst;

pub(crate) use worst::float;
pub use worst::{Extreme, Sample, Worst, ulp};

use crate::subject::{Permitted, Subject};
use distribution::Distribution;
use lobe_backends::interp::ShadowColumns;
use lobe_backends::route::Route;
use lobe_codegen::data::Columns;

/// A question.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Question {
    /// Does the f64 value match an independent one?
    Correct,
    /// Is the derived rounding-error bound inside the budget?
    Robust,
    /// Does a route's result lie inside the derived bound?
    Conformant,
    /// Are routes that must agree equal bit for bit?
    Agree,
}

impl Question {
    /// Its name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Correct => "correct",
            Self::Robust => "robust",
            Self::Conformant => "conformant",
            Self::Agree => "agree",
        }
    }
}

/// How a question came out.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(tag = "verdict", content = "why", rename_all = "snake_case")]
pub enum Verdict {
    /// Yes.
    Holds,
    /// No.
    FallsShort(String),
    /// No, as the kernel's contract or an [expectation](crate::expectation) says; the reason it gives.
    ExpectedFailure(String),
    /// There was nothing to ask, or to ask with.
    NotAsked(String),
}

/// The answer to one question, on one route or group of routes where the question has them.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Answer {
    /// The question.
    pub question: Question,
    /// What it was asked of: a route, routes that must agree, a table; empty for the kernel itself.
    pub subject: String,
    /// How it came out.
    #[serde(flatten)]
    pub verdict: Verdict,
    /// Rows judged.
    pub cases: usize,
    /// Rows that the derived bound says nothing about.
    pub indeterminate: usize,
    /// Rows in which a comparison or rounding could fall either way.
    pub ambiguous: usize,
    /// Largest share of what is permitted; more than 1 falls short.
    #[serde(with = "worst::float")]
    pub share: f64,
    /// Largest absolute error (of the derived bound, for `robust`).
    #[serde(with = "worst::float")]
    pub absolute: f64,
    /// Largest error relative to the exact value, where that is a normal f32.
    #[serde(with = "worst::float")]
    pub relative: f64,
    /// Largest error in units in the last place of an f32 at the exact value, where that is normal.
    #[serde(with = "worst::float")]
    pub ulp: f64,
    /// The row with the largest share.
    pub worst: Option<Worst>,
    /// How rows spread over the share of the bound that they use, where a route was judged by it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub distribution: Option<Distribution>,
}

impl Answer {
    /// An answer without figures.
    #[must_use]
    pub fn bare(question: Question, subject: impl Into<String>, verdict: Verdict) -> Self {
        Self {
            question,
            subject: subject.into(),
            verdict,
            cases: 0,
            indeterminate: 0,
            ambiguous: 0,
            share: 0.0,
            absolute: 0.0,
            relative: 0.0,
            ulp: 0.0,
            worst: None,
            distribution: None,
        }
    }

    /// With the figures of `extreme`.
    #[must_use]
    pub fn with(self, extreme: Extreme) -> Self {
        let Extreme { share, absolute, relative, ulp, worst } = extreme;
        Self { share, absolute, relative, ulp, worst, ..self }
    }

    /// Whether the answer is no, unexpectedly.
    #[must_use]
    pub fn falls_short(&self) -> bool {
        matches!(self.verdict, Verdict::FallsShort(_))
    }
}

/// Rows of arguments with all that was computed from them.
#[derive(Debug)]
pub struct Batch<'a> {
    /// The kernel.
    pub subject: &'a Subject,
    /// The arguments.
    pub args: &'a Columns,
    /// f32 value, f64 value and bound.
    pub shadow: &'a ShadowColumns,
    /// What the budgets permit.
    pub permitted: &'a Permitted,
    /// What the routes returned; a route that failed gives the reason.
    pub outputs: &'a [(Route, Result<Columns, String>)],
}

impl Batch<'_> {
    /// Whether the bound says nothing about row `row` as a whole.
    #[must_use]
    pub fn is_indeterminate(&self, row: usize) -> bool {
        self.shadow.indeterminate.get(row).copied().unwrap_or(false)
    }

    pub(crate) fn worst(&self, row: usize, leaf: usize, sample: Sample) -> Worst {
        let path = &self.subject.program().results()[leaf].path;
        Worst::at(self.subject.def(), &self.args.row(row), path, sample)
    }

    fn n_ambiguous(&self) -> usize {
        self.shadow.ambiguous.iter().filter(|a| **a).count()
    }
}
