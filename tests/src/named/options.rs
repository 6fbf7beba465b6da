//! What the tests of [`check!`](crate::check) may be told.

use crate::cases::Cases;
use crate::expectation::{self, Expectation, ExpectationError};
use lobe_codegen::accuracy::Model;
use std::path::Path;

/// Options of [`check!`](crate::check), each written as `name = value`.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    pub(super) inputs: usize,
    pub(super) seed: u64,
    model: &'static str,
    expectations: Option<&'static str>,
}

impl Options {
    /// Those of which nothing is said: 4,000 rows, seed 7.
    #[must_use]
    pub const fn new() -> Self {
        Self { inputs: 4000, seed: 7, model: "portable", expectations: None }
    }

    /// Rows of arguments to draw for each kernel.
    #[must_use]
    pub const fn inputs(self, inputs: usize) -> Self {
        Self { inputs, ..self }
    }

    /// Where the drawing begins; the same seed draws the same rows.
    #[must_use]
    pub const fn seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// What drivers are permitted: `portable`, or a specification that `lobe list --operations` names.
    #[must_use]
    pub const fn model(self, model: &'static str) -> Self {
        Self { model, ..self }
    }

    /// The file of known faults of drivers, as the package's folder names it; else `tests/cases/expectations.toml`, if it
    /// is there.
    #[must_use]
    pub const fn expectations(self, file: &'static str) -> Self {
        Self { expectations: Some(file), ..self }
    }

    /// The accuracy model.
    pub(super) fn accuracy(&self) -> Result<&'static Model, String> {
        Model::named(self.model).ok_or_else(|| {
            let names: Vec<&str> = Model::all().iter().map(|model| model.name).collect();
            format!("there is no accuracy model `{}`; there are {}", self.model, names.join(", "))
        })
    }

    /// The known faults, of a package in `folder`.
    pub(super) fn expected(&self, folder: &str, cases: &Cases) -> Result<Vec<Expectation>, ExpectationError> {
        match self.expectations {
            Some(file) => expectation::read(&Path::new(folder).join(file)),
            None => expectation::of_cases(cases),
        }
    }
}

impl Default for Options {
    fn default() -> Self {
        Self::new()
    }
}
