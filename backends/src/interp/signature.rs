//! Columns of arguments against the parameters of a function.

use super::lower::{self, Reader};
use super::program::Program;
use super::{InterpError, Interpreter};
use lobe_codegen::data::Columns;
use naga::{Function, Handle};

impl Interpreter<'_> {
    /// The program of `f`, whose parameters the columns fit.
    pub(super) fn lowered(
        &self,
        f: Handle<Function>,
        args: &Columns,
        exact: Option<&[Vec<f64>]>,
        reader: Reader,
    ) -> Result<Program, InterpError> {
        let program = lower::function(self.module, f, reader)?;
        self.fitting(&program, f, args, exact)?;
        Ok(program)
    }

    /// Whether the columns fit the parameters of `f`.
    pub(super) fn fitting(
        &self,
        program: &Program,
        f: Handle<Function>,
        args: &Columns,
        exact: Option<&[Vec<f64>]>,
    ) -> Result<(), InterpError> {
        let expected = program.columns;
        let function = || self.module.module().functions[f].name.clone().unwrap_or_default();
        if args.width() != expected || args.columns.iter().any(|c| c.len() != args.rows) {
            return Err(InterpError::Arguments { function: function(), expected, found: args.width() });
        }
        if exact.is_some_and(|e| e.len() != expected || e.iter().any(|c| c.len() != args.rows)) {
            return Err(InterpError::ExactColumns { function: function(), expected });
        }
        Ok(())
    }
}
