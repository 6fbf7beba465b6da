//! What a check found, for people ([`human`], [`html`]), for programs ([`json`]) and for CI servers ([`junit`]); and how
//! reports of parts become one ([`merge`](mod@merge)).

pub mod html;
pub mod human;
pub mod json;
pub mod junit;
pub mod merge;
pub mod part;

pub use part::Part;

use crate::domain::Inputs;
use crate::perturbed::{self, Overall, Tightness};
use crate::question::distribution::bin_ends;
use crate::question::{Answer, Verdict};
use crate::search::Found;
use lobe_backends::executor::Executor;
use lobe_codegen::accuracy::Model;
use lobe_codegen::def::FunctionDef;
use std::collections::BTreeMap;

/// The outcome of a whole run.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Report {
    /// Of the JSON format; grows when a reader would have to change.
    pub schema: u32,
    /// Of Lobe.
    pub version: String,
    /// What was run, as `check`.
    pub command: String,
    /// Where the drawing of inputs began.
    pub seed: u64,
    /// What drivers are permitted, where that is not the default: the name of an accuracy model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    /// Routes that ran.
    pub routes: Vec<String>,
    /// What the driver of each route says of itself, its version with it, by the driver's name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub drivers: BTreeMap<String, String>,
    /// Routes that could have run and did not.
    pub skipped: Vec<Skipped>,
    /// Where the bins of every distribution end; one more, without an end, is for rows beyond the bound.
    #[serde(default)]
    pub bin_ends: Vec<f64>,
    /// Kernel by kernel.
    pub kernels: Vec<KernelReport>,
    /// Rows of tables that no kernel is mapped to, by function.
    pub unmapped: BTreeMap<String, usize>,
    /// Which part of a whole it is, if it is no whole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub part: Option<Part>,
    /// Parts of the whole that nothing is known of.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<String>,
}

/// A route that did not run.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Skipped {
    /// The route.
    pub route: String,
    /// What is missing.
    pub what: String,
    /// What to do about it.
    pub mend: String,
}

/// The outcome of one kernel.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct KernelReport {
    /// Its name.
    pub name: String,
    /// Subject it belongs to.
    pub family: String,
    /// Where its equation stands.
    pub cite: String,
    /// Rows drawn.
    pub inputs: usize,
    /// Rows out of files among them.
    pub listed: usize,
    /// The answers, in the order of the questions.
    pub answers: Vec<Answer>,
    /// The worst rows, where they were looked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub search: Option<Found>,
    /// How tight the derived bounds are, where drivers drawn by chance ran.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tightness: Option<Tightness>,
}

/// Answers by verdict.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Tally {
    /// Yes.
    pub hold: usize,
    /// No.
    pub fall_short: usize,
    /// No, as expected.
    pub expected_failures: usize,
    /// Nothing to ask.
    pub not_asked: usize,
}

impl Report {
    /// An empty report of `command`.
    #[must_use]
    pub fn new(command: &str, seed: u64) -> Self {
        Self {
            schema: json::SCHEMA,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            command: command.to_owned(),
            seed,
            model: None,
            routes: Vec::new(),
            drivers: BTreeMap::new(),
            skipped: Vec::new(),
            bin_ends: bin_ends(),
            kernels: Vec::new(),
            unmapped: Default::default(),
            part: None,
            missing: Vec::new(),
        }
    }

    /// The same of a run in which drivers were permitted what `accuracy` permits.
    #[must_use]
    pub fn with_accuracy(self, accuracy: &Model) -> Self {
        Self { model: accuracy.unusual_name().map(str::to_owned), ..self }
    }

    /// The same of a run on these routes.
    #[must_use]
    pub fn with_routes(mut self, executors: &[Box<dyn Executor>]) -> Self {
        self.routes = executors.iter().map(|e| e.route().to_string()).collect();
        let named = executors.iter().filter_map(|e| Some((e.route().driver()?, e.driver_info())));
        self.drivers = named.map(|(name, words)| (name.to_owned(), words.to_owned())).collect();
        self
    }

    /// Counts the answers.
    #[must_use]
    pub fn tally(&self) -> Tally {
        let mut tally = Tally::default();
        for answer in self.kernels.iter().flat_map(|k| &k.answers) {
            match answer.verdict {
                Verdict::Holds => tally.hold += 1,
                Verdict::FallsShort(_) => tally.fall_short += 1,
                Verdict::ExpectedFailure(_) => tally.expected_failures += 1,
                Verdict::NotAsked(_) => tally.not_asked += 1,
            }
        }
        tally
    }

    /// How tight the derived bounds are, where drivers drawn by chance ran.
    #[must_use]
    pub fn tightness(&self) -> Option<Overall> {
        perturbed::overall(&self.kernels)
    }

    /// Whether all holds, no part is missing, and something was asked at all; a part may have had nothing to ask.
    #[must_use]
    pub fn holds(&self) -> bool {
        let tally = self.tally();
        let cases: usize = self.kernels.iter().flat_map(|k| &k.answers).map(|a| a.cases).sum();
        let is_asked = self.part.is_some() || (tally.hold > 0 && cases > 0);
        tally.fall_short == 0 && self.missing.is_empty() && is_asked
    }
}

impl KernelReport {
    /// A report of `kernel` without answers.
    #[must_use]
    pub fn new(kernel: &FunctionDef) -> Self {
        Self {
            name: kernel.name.to_owned(),
            family: kernel.contract.family.to_owned(),
            cite: kernel.contract.cite.to_owned(),
            inputs: 0,
            listed: 0,
            answers: Vec::new(),
            search: None,
            tightness: None,
        }
    }

    /// A report of a kernel that does not exist.
    #[must_use]
    pub fn unknown(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            family: String::new(),
            cite: String::new(),
            inputs: 0,
            listed: 0,
            answers: Vec::new(),
            search: None,
            tightness: None,
        }
    }

    pub(crate) fn take_inputs(&mut self, inputs: &Inputs) {
        self.inputs = inputs.args.rows;
        let listed = inputs.families.iter().filter(|(family, _)| *family == crate::domain::Family::Listed);
        self.listed = listed.map(|(_, n)| n).sum();
    }

    /// Whether an answer falls short.
    #[must_use]
    pub fn falls_short(&self) -> bool {
        self.answers.iter().any(Answer::falls_short)
    }
}
