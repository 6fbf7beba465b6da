//! Rows of arguments through a function.

use super::super::error::{InterpError, Res};
use super::super::program::Scalar;
use super::machine::{Machine, Position};
use super::{Code, LANES, Stop};
use lobe_codegen::data::Columns;
use rayon::prelude::*;
use std::ops::Range;

/// Calls the code on each row.
pub(in super::super) fn call(code: &Code<LANES>, args: &Columns, fuel: u64) -> Res<Columns> {
    let parts = chunks(args.rows, rayon::current_num_threads())
        .into_par_iter()
        .map(|rows| part(code, args, rows, fuel))
        .collect::<Res<Vec<_>>>()?;
    let mut out = Columns::zeros(code.results.len(), 0);
    parts.iter().for_each(|part| out.append(part));
    Ok(out)
}

/// Ranges of rows that a thread takes at once: whole batches, some for each thread.
fn chunks(rows: usize, threads: usize) -> Vec<Range<usize>> {
    let share = rows.div_ceil(threads.max(1) * 4);
    let size = share.next_multiple_of(LANES).max(LANES);
    (0..rows).step_by(size).map(|start| start..rows.min(start + size)).collect()
}

fn part(code: &Code<LANES>, args: &Columns, rows: Range<usize>, fuel: u64) -> Res<Columns> {
    let mut machine = Machine::new(code, fuel);
    machine.columns = args.columns.iter().map(|c| c.as_ptr()).collect();
    let mut out = Columns::zeros(code.results.len(), rows.len());
    for first in rows.clone().step_by(LANES) {
        let live = LANES.min(rows.end - first);
        machine.fuel = fuel;
        machine.place(Position { first, live, ..Position::default() });
        finish(code, &mut machine)?;
        for (column, (value, place, varying)) in out.columns.iter_mut().zip(&code.results) {
            let boolean = code.program.scalar(*value) == Scalar::Bool;
            let target = &mut column[first - rows.start..][..live];
            machine.read(*place, *varying, boolean, target);
        }
    }
    Ok(out)
}

/// Runs a batch to its end. Rows are on their own: a barrier waits for nobody.
fn finish(code: &Code<LANES>, machine: &mut Machine<LANES>) -> Result<(), InterpError> {
    let mut at = 0;
    loop {
        match code.run(machine, at) {
            Stop::Barrier { next, .. } | Stop::Apart { next, .. } => at = next,
            stop @ (Stop::Done | Stop::OutOfFuel { .. }) => return code.error(stop).map_or(Ok(()), Err),
        }
    }
}
