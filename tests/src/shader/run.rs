//! One job, from the file to the reports.

use super::entry::Trial;
use super::job::{Entry, GivenUp, Job, Step};
use super::machine::MachineError;
use super::report::{Report, Status};
use super::routes::Routes;
use lobe_backends::interp::InterpError;
use lobe_codegen::ValidModule;
use lobe_codegen::foreign::{self, ForeignError, Language, Source};
use std::path::Path;

/// Why there is no comparison.
pub(super) struct Stop {
    pub(super) status: Status,
    pub(super) message: String,
}

/// What a step gives.
pub(super) type Res<T> = Result<T, Stop>;

/// An end with these words.
pub(super) fn stop<T>(status: Status, message: impl Into<String>) -> Res<T> {
    Err(Stop { status, message: message.into() })
}

/// Runs `job` on the interpreter and on its routes; `begin` hears of each step before it is taken.
pub fn run(job: &Job, routes: &mut Routes, begin: &mut dyn FnMut(&Step)) -> Vec<Report> {
    let mut steps = Steps { job, begin };
    match read(&mut steps) {
        Ok((source, module, entries)) => {
            entries.iter().map(|entry| Trial::report(&mut steps, routes, &source, &module, entry)).collect()
        }
        Err(Stop { status, message }) => vec![Report::of(steps.file(), None, status, message)],
    }
}

/// The steps of a job as they are taken.
pub(super) struct Steps<'s> {
    pub(super) job: &'s Job,
    begin: &'s mut dyn FnMut(&Step),
}

impl Steps<'_> {
    pub(super) fn file(&self) -> String {
        self.job.file.display().to_string()
    }

    /// Says what comes next, unless it is known to end badly.
    pub(super) fn begin(&mut self, entry: Option<&str>, name: &str) -> Result<(), GivenUp> {
        let step = Step { entry: entry.map(str::to_owned), name: name.to_owned() };
        if let Some(known) = self.job.given_up.iter().find(|g| g.step == step) {
            return Err(known.clone());
        }
        (self.begin)(&step);
        Ok(())
    }
}

/// The file, its module, and the entry points to run.
fn read(steps: &mut Steps<'_>) -> Res<(Source, ValidModule, Vec<String>)> {
    steps.begin(None, "read")?;
    let (job, name) = (steps.job, steps.file());
    let Some(language) = Language::of(&job.file) else {
        return stop(Status::Error, format!("{name}: ends in none of .wgsl, .spv, .glsl, .comp"));
    };
    let bytes = std::fs::read(&job.file);
    let bytes = bytes.or_else(|e| stop(Status::Error, format!("{name}: cannot be read: {e}")))?;
    let source = Source { name, language, bytes };
    let module = foreign::read(&source)?;
    let entries = match &job.entry {
        Entry::Named(wanted) => vec![foreign::choose(&source, &module, Some(wanted))?],
        Entry::Only => vec![foreign::choose(&source, &module, None)?],
        Entry::Each => match foreign::choose(&source, &module, None) {
            Err(ForeignError::SeveralEntries { entries, .. }) => entries,
            other => vec![other?],
        },
    };
    Ok((source, module, entries))
}

impl From<GivenUp> for Stop {
    fn from(given_up: GivenUp) -> Self {
        Self { status: given_up.status, message: format!("{}: {}", given_up.step.name, given_up.message) }
    }
}

impl From<ForeignError> for Stop {
    fn from(error: ForeignError) -> Self {
        let status = match error {
            ForeignError::Encoding { .. } | ForeignError::Parse { .. } | ForeignError::Invalid { .. } => {
                Status::Invalid
            }
            ForeignError::Panicked { .. } => Status::Crashed,
            ForeignError::NoEntry { .. } | ForeignError::Unsupported { .. } => Status::Refused,
            ForeignError::SeveralEntries { .. }
            | ForeignError::UnknownEntry { .. }
            | ForeignError::Override { .. } => Status::Error,
        };
        Self { status, message: error.to_string() }
    }
}

impl From<MachineError> for Stop {
    fn from(error: MachineError) -> Self {
        let status = match error {
            MachineError::Interp(InterpError::OutOfFuel { .. }) => Status::Timeout,
            MachineError::Interp(InterpError::NonUniformBarrier { .. }) => Status::Findings,
            MachineError::Interp(_) => Status::Refused,
            MachineError::Texture(_) => Status::Error,
            MachineError::Panicked(_) => Status::Crashed,
        };
        Self { status, message: error.to_string() }
    }
}

/// Whether a file of this name may be a shader.
#[must_use]
pub fn is_shader(path: &Path) -> bool {
    Language::of(path).is_some()
}
