//! Rows of arguments through a function.

use super::super::finding::{Checks, Finding};
use super::super::model::Model;
use super::super::program::{Scalar, Value};
use super::super::shadow::Shadow;
use super::super::strict::Strict;
use super::super::{ShadowColumn, ShadowColumns};
use super::column::{Column, Family, family};
use super::input::Inputs;
use super::watch::{self, Watch};
use super::{Code, Machine, Res};
use lobe_codegen::data::Columns;
use rayon::prelude::*;
use std::ops::Range;

/// Rows that are computed together.
const LANES: usize = 256;

/// The same in the shadow lane, whose tape shall stay in a cache.
const SHADOW_LANES: usize = 16;

/// A function's code with its arguments.
#[derive(Clone, Copy)]
pub(in super::super) struct Call<'a> {
    pub(in super::super) code: &'a Code,
    pub(in super::super) args: &'a Columns,
    pub(in super::super) exact: Option<&'a [Vec<f64>]>,
    pub(in super::super) fuel: u64,
}

impl<'a> Call<'a> {
    /// The results' words; each batch has a model of its own, by its first row.
    pub(in super::super) fn words<M: Model>(self, model: impl Fn(usize) -> M + Sync) -> Res<Columns> {
        let parts = chunks(self.args.rows, LANES)
            .into_par_iter()
            .map(|rows| {
                let machine = self.batch(model(rows.start), &rows)?;
                let words = |value: &Value| Ok(machine.result(*value)?.words(&machine.model));
                let columns = self.code.program.results.iter().map(words).collect::<Res<Vec<_>>>()?;
                Ok(Columns { columns, rows: rows.len() })
            })
            .collect::<Res<Vec<_>>>()?;
        let mut out = Columns::zeros(self.code.program.results.len(), 0);
        parts.iter().for_each(|part| out.append(part));
        Ok(out)
    }

    /// The results with their bounds.
    pub(in super::super) fn shadow(self, model: impl Fn() -> Shadow + Sync) -> Res<ShadowColumns> {
        let parts = chunks(self.args.rows, SHADOW_LANES)
            .into_par_iter()
            .map(|rows| self.batch(model(), &rows)?.outcome())
            .collect::<Res<Vec<_>>>()?;
        let program = &self.code.program;
        let mut out = no_rows(program.results.iter().map(|v| program.scalar(*v)));
        parts.into_iter().for_each(|part| append(&mut out, part));
        Ok(out)
    }

    /// Runs all rows, looking for mistakes.
    pub(in super::super) fn sanitize(self, checks: Checks) -> Res<Vec<Finding>> {
        let parts = chunks(self.args.rows, LANES)
            .into_par_iter()
            .map(|rows| {
                let mut machine = self.machine(Strict, &rows);
                machine.watch = Some(Watch::new(checks));
                machine.watch_begin();
                let outcome = machine.run().and_then(|()| machine.watch_results());
                watch::findings(outcome, machine.watch.take())
            })
            .collect::<Res<Vec<_>>>()?;
        Ok(watch::first_of_each(parts.into_iter().flatten(), checks))
    }

    /// Runs some rows.
    pub(super) fn batch<M: Model>(self, model: M, rows: &Range<usize>) -> Res<Machine<'a, M>> {
        let mut machine = self.machine(model, rows);
        machine.run()?;
        Ok(machine)
    }

    fn machine<M: Model>(self, model: M, rows: &Range<usize>) -> Machine<'a, M> {
        let inputs = Inputs::Rows { args: self.args, exact: self.exact, first: rows.start };
        Machine::new(self.code, model, inputs, rows.len(), self.fuel)
    }
}

/// The ranges of rows that are computed together, `lanes` at a time.
pub(super) fn chunks(rows: usize, lanes: usize) -> Vec<Range<usize>> {
    (0..rows).step_by(lanes).map(|start| start..rows.min(start + lanes)).collect()
}

impl<M: Model> Machine<'_, M> {
    /// A result in all lanes, wherever they are.
    fn result(&self, value: Value) -> Res<Column<M>> {
        match value {
            Value::Reg(reg) => Ok(self.registers[reg.0 as usize].clone()),
            Value::Const(_) => {
                let mut column = Column::zero(&self.model, self.program.scalar(value), self.lanes);
                self.copy(value, &mut column)?;
                Ok(column)
            }
        }
    }
}

impl Machine<'_, Shadow> {
    fn outcome(&self) -> Res<ShadowColumns> {
        let columns = self.program.results.iter().map(|v| Ok(self.told(&self.result(*v)?)));
        let columns = columns.collect::<Res<Vec<_>>>()?;
        let unbounded = |row: usize| columns.iter().any(|c| !holds(c, row));
        let indeterminate = |row: usize| self.flags.lost[row] || (self.flags.tainted[row] && unbounded(row));
        let indeterminate = (0..self.lanes).map(indeterminate).collect();
        Ok(ShadowColumns {
            rows: self.lanes,
            ambiguous: self.flags.ambiguous.clone(),
            indeterminate,
            columns,
        })
    }

    fn told(&self, column: &Column<Shadow>) -> ShadowColumn {
        let lost = &self.flags.lost;
        match column {
            Column::Float(lanes) => ShadowColumn::Float {
                value: lanes.iter().map(|a| a.value as f32).collect(),
                exact: lanes.iter().map(|a| a.exact).collect(),
                bound: lanes
                    .iter()
                    .zip(lost)
                    .map(|(a, lost)| if *lost { f64::INFINITY } else { self.model.bound(*a) })
                    .collect(),
            },
            Column::Word(lanes) => ShadowColumn::Word {
                value: lanes.iter().map(|a| a.value as u32).collect(),
                known: lanes.iter().zip(lost).map(|(a, lost)| a.known && !lost).collect(),
            },
            Column::Bool(lanes) => ShadowColumn::Word {
                value: lanes.iter().map(|a| a.value.into()).collect(),
                known: lanes.iter().zip(lost).map(|(a, lost)| !a.ambiguous && !lost).collect(),
            },
        }
    }
}

/// Whether something is promised.
fn holds(column: &ShadowColumn, row: usize) -> bool {
    match column {
        ShadowColumn::Float { bound, .. } => bound[row].is_finite(),
        ShadowColumn::Word { known, .. } => known[row],
    }
}

/// Columns of these scalars without rows.
fn no_rows(scalars: impl Iterator<Item = Scalar>) -> ShadowColumns {
    let empty = |scalar: Scalar| match family::<Shadow>(scalar) {
        Family::Float => ShadowColumn::Float { value: Vec::new(), exact: Vec::new(), bound: Vec::new() },
        Family::Word | Family::Bool => ShadowColumn::Word { value: Vec::new(), known: Vec::new() },
    };
    ShadowColumns { columns: scalars.map(empty).collect(), ..ShadowColumns::default() }
}

/// Appends rows of the same scalars.
fn append(to: &mut ShadowColumns, from: ShadowColumns) {
    to.rows += from.rows;
    to.ambiguous.extend(from.ambiguous);
    to.indeterminate.extend(from.indeterminate);
    for pair in to.columns.iter_mut().zip(from.columns) {
        match pair {
            (
                ShadowColumn::Float { value, exact, bound },
                ShadowColumn::Float { value: v, exact: e, bound: b },
            ) => {
                value.extend(v);
                exact.extend(e);
                bound.extend(b);
            }
            (ShadowColumn::Word { value, known }, ShadowColumn::Word { value: v, known: k }) => {
                value.extend(v);
                known.extend(k);
            }
            (ShadowColumn::Float { .. } | ShadowColumn::Word { .. }, _) => {}
        }
    }
}
