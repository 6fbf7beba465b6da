//! Question 3: does the result of a route lie inside the derived bound around the f64 value?

use super::distribution::Shares;
use super::expected::Expected;
use super::worst::{Extreme, Sample};
use super::{Answer, Batch, Question, Verdict};
use crate::expectation::Fault;
use lobe_backends::interp::ShadowColumn;
use lobe_backends::route::Route;
use lobe_codegen::data::Columns;
use std::collections::BTreeMap;

/// Collects the rows, route by route.
#[derive(Debug, Default)]
pub struct Conformant {
    routes: BTreeMap<usize, (Route, OfRoute)>,
}

#[derive(Debug, Default)]
struct OfRoute {
    cases: usize,
    ambiguous: usize,
    indeterminate: usize,
    outside: usize,
    extreme: Extreme,
    shares: Shares,
    failure: Option<String>,
}

impl Conformant {
    /// Takes a batch.
    pub fn absorb(&mut self, batch: &Batch<'_>) {
        self.take(batch, true);
    }

    /// Takes rows that were looked for: they lie where shares are large, so they tell nothing of how shares spread.
    pub fn absorb_found(&mut self, batch: &Batch<'_>) {
        self.take(batch, false);
    }

    fn take(&mut self, batch: &Batch<'_>, is_drawn: bool) {
        for (index, (route, output)) in batch.outputs.iter().enumerate() {
            let (_, of_route) =
                self.routes.entry(index).or_insert_with(|| (route.clone(), OfRoute::default()));
            match output {
                Ok(columns) => of_route.absorb(batch, columns, is_drawn),
                Err(why) => of_route.failure = Some(why.clone()),
            }
        }
    }

    /// An answer for each route.
    #[must_use]
    pub fn finish(self, expected: &Expected<'_>) -> Vec<Answer> {
        self.routes.into_values().map(|(route, of_route)| of_route.finish(&route, expected)).collect()
    }
}

impl OfRoute {
    fn absorb(&mut self, batch: &Batch<'_>, output: &Columns, is_drawn: bool) {
        self.cases += batch.args.rows;
        self.ambiguous += batch.n_ambiguous();
        for row in 0..batch.args.rows {
            match self.judge_row(batch, output, row, is_drawn) {
                Some(true) => {}
                Some(false) => self.outside += 1,
                None => self.indeterminate += 1,
            }
        }
    }

    /// Whether the row lies inside; `None` when the bound says nothing about part of it.
    fn judge_row(&mut self, batch: &Batch<'_>, output: &Columns, row: usize, is_drawn: bool) -> Option<bool> {
        let mut known = !batch.is_indeterminate(row);
        let (mut inside, mut share) = (true, 0.0_f64);
        for (leaf, column) in batch.shadow.columns.iter().enumerate().take(if known { usize::MAX } else { 0 })
        {
            let word = output.columns[leaf][row];
            match sample(column, row, word) {
                Some(sample) => {
                    inside &= self.extreme.take(sample, || batch.worst(row, leaf, sample));
                    share = share.max(sample.share());
                }
                None => known = false,
            }
        }
        let is_judged = known || !inside;
        if is_judged && is_drawn {
            self.shares.take(share);
        }
        is_judged.then_some(inside)
    }

    fn finish(self, route: &Route, expected: &Expected<'_>) -> Answer {
        let (fault, verdict) = match (self.failure, self.outside) {
            (Some(why), _) => (Some(Fault::Refused), Verdict::FallsShort(why)),
            (None, 0) => (None, Verdict::Holds),
            (None, n) => {
                let why = format!("{n} of {} rows lie outside the derived bound", self.cases);
                (Some(Fault::Beyond), Verdict::FallsShort(why))
            }
        };
        let verdict = expected.of_route(&route.to_string(), fault, verdict);
        Answer {
            cases: self.cases,
            indeterminate: self.indeterminate,
            ambiguous: self.ambiguous,
            distribution: self.shares.finish(),
            ..Answer::bare(Question::Conformant, route.to_string(), verdict).with(self.extreme)
        }
    }
}

/// The comparison of one scalar; `None` when the bound says nothing about it.
pub(crate) fn sample(column: &ShadowColumn, row: usize, word: u32) -> Option<Sample> {
    match column {
        ShadowColumn::Float { exact, bound, .. } => {
            let (wanted, permitted) = (exact[row], bound[row]);
            let found = f64::from(f32::from_bits(word));
            (wanted.is_finite() && permitted.is_finite()).then(|| Sample {
                found,
                wanted,
                error: (found - wanted).abs(),
                permitted,
            })
        }
        ShadowColumn::Word { value, known } => known[row].then(|| {
            let (found, wanted) = (f64::from(word), f64::from(value[row]));
            Sample { found, wanted, error: (found - wanted).abs(), permitted: 0.0 }
        }),
    }
}
