//! Question 2: is the derived error bound, valid for any driver that keeps the accuracy rules, inside the
//! budget that the kernel states?

use super::worst::{Extreme, Sample};
use super::{Answer, Batch, Question, Verdict};
use crate::subject::Subject;
use lobe_backends::interp::ShadowColumn;

/// The share of rows that may be left without a bound.
pub const INDETERMINATE_LIMIT: f64 = 1e-3;

/// Collects the rows.
#[derive(Debug, Default)]
pub struct Robust {
    rows: usize,
    ambiguous: usize,
    indeterminate: usize,
    over: usize,
    extreme: Extreme,
}

impl Robust {
    /// Takes a batch.
    pub fn absorb(&mut self, batch: &Batch<'_>) {
        self.rows += batch.args.rows;
        self.ambiguous += batch.n_ambiguous();
        for row in 0..batch.args.rows {
            if is_unbounded(batch, row) {
                self.indeterminate += 1;
            } else if !self.is_within(batch, row) {
                self.over += 1;
            }
        }
    }

    /// Takes rows that were looked for: they lie where the bound is large or lost, so what share of them has none says
    /// nothing.
    pub fn absorb_found(&mut self, batch: &Batch<'_>) {
        for row in (0..batch.args.rows).filter(|row| !is_unbounded(batch, *row)) {
            self.over += usize::from(!self.is_within(batch, row));
        }
    }

    fn is_within(&mut self, batch: &Batch<'_>, row: usize) -> bool {
        let mut within = true;
        for (leaf, column) in batch.shadow.columns.iter().enumerate() {
            if let (ShadowColumn::Float { exact, bound, .. }, Some(permitted)) =
                (column, &batch.permitted[leaf])
            {
                let (wanted, error, permitted) = (exact[row], bound[row], permitted[row]);
                let sample = Sample { found: wanted + error, wanted, error, permitted };
                within &= self.extreme.take(sample, || batch.worst(row, leaf, sample));
            }
        }
        within
    }

    /// The answer.
    #[must_use]
    pub fn finish(self, subject: &Subject) -> Answer {
        let verdict = self.verdict(subject);
        Answer {
            cases: self.rows,
            indeterminate: self.indeterminate,
            ambiguous: self.ambiguous,
            ..Answer::bare(Question::Robust, "", verdict).with(self.extreme)
        }
    }

    fn verdict(&self, subject: &Subject) -> Verdict {
        let has_budget = !subject.def().contract.budget.is_empty();
        match (subject.def().contract.not_robust, self.shortfall()) {
            (Some(reason), _) if !has_budget => Verdict::FallsShort(format!(
                "expected to fail ({reason}), but it states no budget that it could exceed; add budget(..)"
            )),
            (Some(reason), Some(_)) => Verdict::ExpectedFailure(reason.to_owned()),
            (Some(reason), None) => Verdict::FallsShort(format!(
                "expected to fail ({reason}), but it holds: remove `not_robust` from its contract"
            )),
            (None, _) if !has_budget => Verdict::NotAsked("no budget stated".to_owned()),
            (None, Some(why)) => Verdict::FallsShort(why),
            (None, None) => Verdict::Holds,
        }
    }

    fn shortfall(&self) -> Option<String> {
        if self.over > 0 {
            return Some(format!("the bound exceeds the budget on {} rows, {} drawn", self.over, self.rows));
        }
        let limit = INDETERMINATE_LIMIT * self.rows as f64;
        (self.indeterminate as f64 > limit).then(|| {
            format!(
                "{} of {} rows have no bound (a division, branch or domain that a driver may take either way); \
                 at most {} % are permitted",
                self.indeterminate,
                self.rows,
                INDETERMINATE_LIMIT * 100.0
            )
        })
    }
}

/// Whether some scalar of the row's result has no finite bound, or no known value.
fn is_unbounded(batch: &Batch<'_>, row: usize) -> bool {
    batch.is_indeterminate(row)
        || batch.shadow.columns.iter().any(|column| match column {
            ShadowColumn::Float { bound, exact, .. } => !bound[row].is_finite() || !exact[row].is_finite(),
            ShadowColumn::Word { known, .. } => !known[row],
        })
}
