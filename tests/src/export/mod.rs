//! A case as one file for others: WGSL that `lobe run` takes too, a script for Amber, a test for LLVM's offload test
//! suite. What is run is the entry point that checks run on drivers, with the same buffers.
//!
//! Neither Amber nor the suite is needed to write these; the tests read them back, assemble, compile and run them.

mod amber;
mod case;
mod offload;
mod wgsl;

pub use case::{Buffer, Case, Expected, Wanted};

use lobe_backends::executor::ExecError;

/// What a case is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Form {
    /// A complete compute shader, with the inputs as options of `lobe run`.
    Wgsl,
    /// AmberScript, the shader as SPIR-V assembly.
    Amber,
    /// A `.test` of LLVM's offload test suite, the shader as HLSL.
    Offload,
}

/// Why a case cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The kernel does not run, or cannot be emitted.
    #[error(transparent)]
    Exec(#[from] ExecError),
    /// The file would expect nothing.
    #[error(
        "{kernel}: nothing is known of any scalar of the result at these arguments, so there is nothing to expect; \
         `lobe eval {kernel} --args - --shadow` shows what is known"
    )]
    NothingKnown {
        /// The kernel.
        kernel: &'static str,
    },
    /// Some scalars cannot be left out of a comparison.
    #[error(
        "{kernel}: nothing is known of `{path}` at these arguments, and the offload test suite compares whole buffers; \
         take the form wgsl or amber"
    )]
    PartlyKnown {
        /// The kernel.
        kernel: &'static str,
        /// The scalar.
        path: String,
    },
    /// One rule does not fit all scalars.
    #[error(
        "{kernel} returns floats beside integers, and the offload test suite compares a buffer by one rule; take the \
         form wgsl or amber"
    )]
    Mixed {
        /// The kernel.
        kernel: &'static str,
    },
    /// The words cannot be read back.
    #[error("{kernel}: its SPIR-V cannot be disassembled: {reason}")]
    Disassembly {
        /// The kernel.
        kernel: &'static str,
        /// Why.
        reason: String,
    },
}

/// Writes `case` as `form`.
///
/// # Errors
/// When the kernel cannot be emitted, or the form has no words for what is expected.
pub fn export(case: &Case<'_>, form: Form) -> Result<String, ExportError> {
    match form {
        Form::Wgsl => wgsl::write(case),
        Form::Amber => amber::write(case),
        Form::Offload => offload::write(case),
    }
}

/// Lines, each after `mark`; the empty ones without a blank at their end.
fn commented(mark: &str, lines: &[String]) -> String {
    lines.iter().map(|line| format!("{mark} {line}").trim_end().to_owned() + "\n").collect()
}

/// How far a float may be from the nearest f32 of the exact value, which is what a reader of the file has.
fn tolerance(exact: f64, bound: f64) -> f64 {
    let sum = bound + (exact - f64::from(exact as f32)).abs();
    // A sum is rounded, so it is taken a little wider.
    if sum == 0.0 { 0.0 } else { sum.next_up() }
}
