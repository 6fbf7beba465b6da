//! The Rust function itself, row by row.

use super::{ExecError, Executor, Program};
use crate::route::Route;
use lobe_codegen::data::{Columns, WordReader};
use lobe_codegen::quietly;
use rayon::prelude::*;

/// Rows that one thread takes at a time.
const CHUNK: usize = 1024;

/// Calls the function that rustc compiled.
#[derive(Debug, Default)]
pub struct Native;

impl Executor for Native {
    fn route(&self) -> &Route {
        &Route::Native
    }

    fn run(&mut self, kernel: &Program, args: &Columns) -> Result<Columns, ExecError> {
        kernel.check_shape(args)?;
        let native = kernel.def().native.ok_or(ExecError::EntryPoint { kernel: kernel.name() })?;
        let width = kernel.results().len();
        let starts: Vec<usize> = (0..args.rows).step_by(CHUNK).collect();
        let chunks: Vec<Columns> = starts
            .par_iter()
            .map(|&start| {
                let range = start..(start + CHUNK).min(args.rows);
                rows(kernel.name(), native, width, args, range)
            })
            .collect::<Result<_, _>>()?;
        let mut out = Columns::zeros(width, 0);
        chunks.iter().for_each(|chunk| out.append(chunk));
        Ok(out)
    }
}

fn rows(
    kernel: &'static str,
    native: fn(&mut WordReader<'_>, &mut Vec<u32>),
    width: usize,
    args: &Columns,
    range: std::ops::Range<usize>,
) -> Result<Columns, ExecError> {
    let mut out = Columns::zeros(width, range.len());
    let first = range.start;
    let mut at = first;
    let outcome = quietly(|| {
        let mut words = Vec::with_capacity(width);
        for row in range {
            at = row;
            words.clear();
            native(&mut WordReader::new(&args.row(row)), &mut words);
            for (column, word) in out.columns.iter_mut().zip(&words) {
                column[row - first] = *word;
            }
        }
    });
    match outcome {
        Ok(()) => Ok(out),
        Err(message) => Err(ExecError::Panicked { kernel, row: at, message }),
    }
}
