//! The CPU interpreter as an executor.

use super::trace::{self, Trace};
use super::{ExecError, Executor, Program};
use crate::route::Route;
use lobe_codegen::data::Columns;
use lobe_codegen::trace::Traced;

/// Interprets the naga module in strict f32.
#[derive(Debug, Default)]
pub struct Interp;

impl Executor for Interp {
    fn route(&self) -> &Route {
        &Route::Interp
    }

    fn run(&mut self, kernel: &Program, args: &Columns) -> Result<Columns, ExecError> {
        kernel.check_shape(args)?;
        let interpreter = kernel.interpreter()?;
        let outcome = interpreter.call(kernel.handle(), args);
        outcome.map_err(|cause| ExecError::Interp { kernel: kernel.name(), cause: cause.into() })
    }

    fn trace(&mut self, kernel: &Program, traced: &Traced, args: &Columns) -> Result<Trace, ExecError> {
        let outcome = trace::interpret(traced, args);
        outcome.map_err(|cause| ExecError::Interp { kernel: kernel.name(), cause: cause.into() })
    }
}
