//! Which operation a wrong or poor result comes from.
//!
//! The kernel is run by a route with its [traces](lobe_codegen::trace): each number that it computes is written down.
//! Three things are asked of them.
//!
//! - [`local`]: did an operation return what its accuracy rule permits, *for the operands that the route had*? The first
//!   that did not broke the rules, whatever came before it.
//! - [`chain`]: did a value leave what any permitted driver may have computed *from the arguments*? Or was a decision
//!   taken that the interpreter took otherwise?
//! - [`share`]: what does each operation's own error do to the result? It is put into the kernel in real numbers, alone.
//!   So the operation is found that spoils a result although it keeps its rule.
//!
//! [`line`](mod@line) finds the lines of WGSL, SPIR-V and HLSL, [`rule`](mod@rule) says the rule, [`human`] writes the report.
//!
//! A trace makes a driver store what it would have kept in registers, so it may contract or reorder less than without:
//! whether the results are the same bits is part of the answer.

pub mod chain;
pub mod human;
pub mod line;
pub mod local;
mod reorder;
mod report;
pub mod rule;
pub mod share;
pub mod value;

pub use report::{Decision, Explanation, Operand, Outcome, Step};

use crate::subject::Subject;
use lobe_backends::executor::{ExecError, Executor};
use lobe_backends::interp::InterpError;
use lobe_codegen::data::Columns;
use lobe_codegen::trace::{TraceError, record};

/// Scalars that are written down at most.
pub const CAPACITY: u32 = 1 << 16;

/// Why nothing can be explained.
#[derive(Debug, thiserror::Error)]
pub enum ExplainError {
    /// The route does not run the kernel.
    #[error(transparent)]
    Exec(#[from] ExecError),
    /// The kernel has no traces.
    #[error(transparent)]
    Trace(#[from] TraceError),
    /// The interpreter does not run it.
    #[error("the interpreter gave up: {0}")]
    Interp(#[from] InterpError),
    /// There is nothing to explain.
    #[error("{kernel} returns no float, so there is no error to explain")]
    NoFloat {
        /// The kernel.
        kernel: &'static str,
    },
    /// It computes too much.
    #[error(
        "{kernel} computes more than {CAPACITY} numbers on this row; explain a kernel that it calls instead"
    )]
    TooLong {
        /// The kernel.
        kernel: &'static str,
    },
}

/// Explains what `route` does with `subject` on `row`, one row of arguments.
///
/// # Errors
/// When the route or the interpreter does not run it, or it computes too many numbers.
pub fn explain(
    subject: &Subject,
    route: &mut dyn Executor,
    row: &Columns,
) -> Result<Explanation, ExplainError> {
    let program = subject.program();
    program.check_shape(row)?;
    let traced = record(program.module(), program.handle(), CAPACITY)?;
    let trace = route.trace(program, &traced, row)?;
    if trace.records.len() >= CAPACITY as usize {
        return Err(ExplainError::TooLong { kernel: program.name() });
    }
    let plain = route.run(program, row)?;
    let values = value::values(&traced.sites, &trace.records);
    let judged = local::judge(program.module(), &values)?;
    let chain = chain::chain(&traced, row, &trace.records)?;
    let outcomes = report::outcomes(subject, row, &trace.results)?;
    let leaf = report::worst(&outcomes).ok_or(ExplainError::NoFloat { kernel: program.name() })?;
    let shares = share::shares(program, row, (&traced.sites, &values, &judged), leaf)?;
    let found = report::Found { program, sites: &traced.sites, values, judged, chain, shares };
    Ok(found.explanation(route.route().to_string(), row, outcomes, leaf, plain == trace.results))
}

/// `error` in ULP of a number as large as `exact`: 2^-23 of its magnitude, and at least 2^-149.
#[must_use]
pub fn ulps(error: f64, exact: f64) -> f64 {
    let smallest = 2f64.powi(-149);
    error.abs() / (exact.abs() * f64::from(f32::EPSILON)).max(smallest)
}
