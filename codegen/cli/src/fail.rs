//! How a run ends.

use lobe_backends::executor::ExecError;
use lobe_backends::routes::OpenError;
use lobe_codegen::emit::EmitError;
use lobe_codegen::lower::LowerError;
use lobe_golden::StoreError;
use lobe_golden::page::PageError;
use lobe_tests::expectation::ExpectationError;
use lobe_tests::explain::ExplainError;
use lobe_tests::export::ExportError;
use lobe_tests::figures::sheets::SheetError;
use lobe_tests::golden::CasesError;
use lobe_tests::judge::JudgeError;
use lobe_tests::metrics::ReadError;
use lobe_tests::oracle::{MappingError, TableError};
use lobe_tests::overhead::OverheadError;
use lobe_tests::proxies::ProxiesError;
use lobe_tests::race::RaceError;
use lobe_tests::render::FileError;
use lobe_tests::report::merge::MergeError;
use lobe_tests::throughput::BenchError;
use lobe_tests::value::RowError;
use std::path::PathBuf;
use std::process::ExitCode;

/// A run that came to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// All holds.
    Holds,
    /// Something fell short, as the report says.
    FellShort,
    /// Some input is none, as the report says.
    BadInput,
    /// What a process ended with that did the work.
    Code(u8),
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Holds => Self::SUCCESS,
            Outcome::FellShort => Self::from(1),
            Outcome::BadInput => Self::from(2),
            Outcome::Code(code) => Self::from(code),
        }
    }
}

/// A run that could not do what was asked.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Fail {
    #[error("there is no kernel `{name}`{}; `lobe list` names all {count}", suggestion.as_ref().map(|s| format!(", did you mean `{s}`?")).unwrap_or_default())]
    UnknownKernel { name: String, suggestion: Option<String>, count: usize },
    #[error("{0}")]
    Usage(String),
    #[error("{name}: {cause}")]
    Row { name: String, cause: RowError },
    #[error("{}: cannot be read: {cause}", path.display())]
    Read { path: PathBuf, cause: std::io::Error },
    #[error("{}: cannot be written: {cause}", path.display())]
    Write { path: PathBuf, cause: std::io::Error },
    #[error("the route {route} is missing: {what}")]
    Missing { route: String, what: String },
    #[error("standard output cannot be written: {0}")]
    Stdout(std::io::Error),
    #[error(transparent)]
    Expectation(#[from] ExpectationError),
    #[error(transparent)]
    Explain(#[from] ExplainError),
    #[error(transparent)]
    Export(#[from] ExportError),
    #[error(transparent)]
    Judge(#[from] JudgeError),
    #[error(transparent)]
    Table(#[from] TableError),
    #[error(transparent)]
    Open(#[from] OpenError),
    #[error(transparent)]
    Exec(#[from] ExecError),
    #[error(transparent)]
    Lower(#[from] LowerError),
    #[error(transparent)]
    Emit(#[from] EmitError),
    #[error(transparent)]
    Mapping(#[from] MappingError),
    #[error(transparent)]
    Merge(#[from] MergeError),
    #[error(transparent)]
    Proxies(#[from] ProxiesError),
    #[error(transparent)]
    Bench(#[from] BenchError),
    #[error(transparent)]
    Race(#[from] RaceError),
    #[error(transparent)]
    Overhead(#[from] OverheadError),
    #[error(transparent)]
    PictureFile(#[from] ReadError),
    #[error(transparent)]
    Picture(#[from] FileError),
    #[error(transparent)]
    Sheet(#[from] SheetError),
    #[error(transparent)]
    Golden(#[from] StoreError),
    #[error(transparent)]
    Page(#[from] PageError),
    #[error(transparent)]
    GoldenCases(#[from] CasesError),
    #[error("a defect of Lobe: {0}; please report it with the command that you gave")]
    Defect(String),
}

impl Fail {
    /// Prints the message and gives the exit code.
    pub(crate) fn report(&self) -> ExitCode {
        // A reader that went away (`lobe list | head -1`) is not worth a message.
        if !self.is_closed_pipe() {
            eprintln!("lobe: {self}");
        }
        ExitCode::from(self.code())
    }

    fn is_closed_pipe(&self) -> bool {
        matches!(self, Self::Stdout(cause) if cause.kind() == std::io::ErrorKind::BrokenPipe)
    }

    fn code(&self) -> u8 {
        match self {
            Self::Stdout(_) if self.is_closed_pipe() => 0,
            Self::Golden(
                StoreError::Incomplete { .. } | StoreError::Image { .. } | StoreError::Record { .. },
            ) => 1,
            Self::UnknownKernel { .. }
            | Self::Usage(_)
            | Self::Row { .. }
            | Self::Read { .. }
            | Self::Write { .. }
            | Self::Stdout(_)
            | Self::Expectation(_)
            | Self::Merge(_)
            | Self::Proxies(_)
            | Self::PictureFile(_)
            | Self::Golden(_)
            | Self::GoldenCases(_)
            | Self::Page(_)
            | Self::Export(
                ExportError::NothingKnown { .. }
                | ExportError::PartlyKnown { .. }
                | ExportError::Mixed { .. },
            )
            | Self::Table(_) => 2,
            Self::Open(_) | Self::Missing { .. } => 3,
            Self::Exec(_)
            | Self::Lower(_)
            | Self::Emit(_)
            | Self::Mapping(_)
            | Self::Judge(_)
            | Self::Explain(_)
            | Self::Export(ExportError::Exec(_) | ExportError::Disassembly { .. })
            | Self::Bench(_)
            | Self::Race(_)
            | Self::Overhead(_)
            | Self::Picture(_)
            | Self::Sheet(_)
            | Self::Defect(_) => 1,
        }
    }
}
