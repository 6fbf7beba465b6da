//! Why a route gave no results.

use crate::gpu::GpuError;
use crate::translate::TranslateError;
use lobe_codegen::lower::LowerError;

/// An error of an interpreter or emitter, which have their own types.
pub(super) type Cause = Box<dyn std::error::Error + Send + Sync>;

/// Why a kernel could not be run on a route.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExecError {
    /// The kernel is not written in the kernel language.
    #[error("{0}")]
    Lower(#[from] LowerError),
    /// The kernel's module does not hold the kernel.
    #[error("{kernel}: the lowered module has no function of this name; this is a defect of Lobe")]
    Lost {
        /// The kernel.
        kernel: &'static str,
    },
    /// An entry point was given where a function is wanted.
    #[error("{kernel} is an entry point and has no arguments by value; run a function instead")]
    EntryPoint {
        /// The kernel.
        kernel: &'static str,
    },
    /// A function was given where an entry point is wanted.
    #[error("{kernel} is no entry point; give it a workgroup size and buffers")]
    NoEntryPoint {
        /// The kernel.
        kernel: &'static str,
    },
    /// A pipeline lacks the pass.
    #[error("the pipeline has no pass `{pass}`")]
    NoPass {
        /// The pass.
        pass: String,
    },
    /// A pipeline lacks the buffer.
    #[error("no pass of the pipeline has a buffer `{buffer}`")]
    NoBuffer {
        /// The buffer.
        buffer: String,
    },
    /// A pass cannot use a buffer.
    #[error("{pass}, buffer `{buffer}`: {reason}")]
    Buffer {
        /// The pass.
        pass: &'static str,
        /// The buffer.
        buffer: String,
        /// Why.
        reason: String,
    },
    /// The values are not what a buffer holds.
    #[error("an element of the buffer `{buffer}` has {expected} words, and a value {found}")]
    Element {
        /// The buffer.
        buffer: String,
        /// Scalars of an element.
        expected: usize,
        /// Scalars of the value.
        found: usize,
    },
    /// The arguments are not the kernel's.
    #[error("{kernel} takes {expected} words a row, the arguments have {found}")]
    Shape {
        /// The kernel.
        kernel: &'static str,
        /// Scalars of its parameters.
        expected: usize,
        /// Columns given.
        found: usize,
    },
    /// The Rust function panicked.
    #[error("{kernel} panicked on row {row}: {message}; a kernel must return a value for every input")]
    Panicked {
        /// The kernel.
        kernel: &'static str,
        /// Index of the row, from 0.
        row: usize,
        /// The panic's words.
        message: String,
    },
    /// The interpreter gave up.
    #[error("{kernel}: the interpreter gave up: {cause}")]
    Interp {
        /// The kernel.
        kernel: &'static str,
        /// Its words.
        cause: Cause,
    },
    /// The kernel cannot be emitted for this route.
    #[error("{kernel}: not emitted: {cause}")]
    Emit {
        /// The kernel.
        kernel: &'static str,
        /// The emitter's words.
        cause: Cause,
    },
    /// The route runs something else than a module.
    #[error(
        "{kernel}: the route {route} runs no module, so it tells nothing on the way; take `interp` or a driver"
    )]
    Untraced {
        /// The kernel.
        kernel: &'static str,
        /// The route.
        route: crate::route::Route,
    },
    /// A foreign compiler is missing or refused the artifact.
    #[error("{kernel}: {cause}")]
    Translate {
        /// The kernel.
        kernel: &'static str,
        /// The translator's words.
        cause: TranslateError,
    },
    /// The driver refused or failed.
    #[error("{kernel}: {cause}")]
    Gpu {
        /// The kernel.
        kernel: &'static str,
        /// What happened.
        cause: GpuError,
    },
}
