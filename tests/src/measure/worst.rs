//! The row at which a route, or the derived bound, takes the largest share of the budget.

use crate::domain::{Slot, slots};
use crate::question::{Batch, Sample};
use crate::subject::as_f64;
use lobe_backends::interp::ShadowColumn;
use lobe_codegen::data::Columns;

/// Collects the rows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Rows that were compared.
    pub compared: usize,
    /// Rows with NaN or infinity where the exact value is finite; of the bound: rows that have none.
    pub lost: usize,
    /// The largest share of the budget, and where.
    pub worst: Option<At>,
    /// Why the route did not run.
    pub failure: Option<String>,
}

/// A comparison and where it was made.
#[derive(Clone, Debug, PartialEq)]
pub struct At {
    /// The error, over what the budget permits.
    pub share: f64,
    /// The error.
    pub error: f64,
    /// The exact value.
    pub wanted: f64,
    /// The scalar of the result; empty for a result of one scalar.
    pub leaf: String,
    /// The numbers among the arguments.
    pub arguments: Vec<(String, f64)>,
}

impl Figure {
    /// The derived bounds of a batch, against its budgets.
    pub fn take_bound(&mut self, batch: &Batch<'_>) {
        for row in 0..batch.args.rows {
            let bounds = batch.shadow.columns.iter().enumerate().filter_map(|(leaf, column)| match column {
                ShadowColumn::Float { exact, bound, .. } => Some((leaf, exact[row], bound[row])),
                ShadowColumn::Word { .. } => None,
            });
            self.take_row(
                batch,
                row,
                bounds.map(|(leaf, wanted, error)| (leaf, wanted, wanted + error, error)),
            );
        }
    }

    /// What a route returned, against the exact values.
    pub fn take_output(&mut self, batch: &Batch<'_>, output: Result<&Columns, &String>) {
        let output = match output {
            Ok(output) => output,
            Err(why) => {
                self.failure = Some(why.clone());
                return;
            }
        };
        for row in 0..batch.args.rows {
            let values = batch.shadow.columns.iter().enumerate().filter_map(|(leaf, column)| match column {
                ShadowColumn::Float { exact, .. } if exact[row].is_finite() => {
                    let found = f64::from(f32::from_bits(output.columns[leaf][row]));
                    Some((leaf, exact[row], found, (found - exact[row]).abs()))
                }
                ShadowColumn::Float { .. } | ShadowColumn::Word { .. } => None,
            });
            self.take_row(batch, row, values);
        }
    }

    /// `values` are `(scalar, wanted, found, error)`.
    fn take_row(
        &mut self,
        batch: &Batch<'_>,
        row: usize,
        values: impl Iterator<Item = (usize, f64, f64, f64)>,
    ) {
        let (mut is_compared, mut is_lost) = (false, false);
        for (leaf, wanted, found, error) in values {
            let Some(permitted) = &batch.permitted[leaf] else { continue };
            if error.is_finite() {
                let sample = Sample { found, wanted, error, permitted: permitted[row] };
                self.take(sample, || At::new(batch, row, leaf, sample));
                is_compared = true;
            } else {
                is_lost = true;
            }
        }
        self.lost += usize::from(is_lost);
        self.compared += usize::from(is_compared && !is_lost);
    }

    fn take(&mut self, sample: Sample, at: impl FnOnce() -> At) {
        if self.worst.as_ref().is_none_or(|worst| sample.share() > worst.share) {
            self.worst = Some(at());
        }
    }
}

impl At {
    fn new(batch: &Batch<'_>, row: usize, leaf: usize, sample: Sample) -> Self {
        Self {
            share: sample.share(),
            error: sample.error,
            wanted: sample.wanted,
            leaf: batch.subject.program().results()[leaf].path.clone(),
            arguments: arguments(batch, row),
        }
    }
}

/// The numbers among the arguments: what varies beside directions.
fn arguments(batch: &Batch<'_>, row: usize) -> Vec<(String, f64)> {
    let leaves = batch.subject.program().params();
    let slots = slots(batch.subject.def()).unwrap_or_default();
    let number = |slot: Slot| {
        let Slot::Number { column, scalar, .. } = slot else { return None };
        Some((leaves[column].path.clone(), as_f64(scalar, batch.args.columns[column][row])))
    };
    slots.into_iter().filter_map(number).collect()
}
