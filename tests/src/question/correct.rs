//! Question 1: does the formula match an independent value?
//!
//! Tables of high-precision values are judged in [`crate::oracle`].
//! Here stands the part for kernels that name the exact function they approximate: the distance of the
//! f32 result from it, approximation and rounding together, against the budget.

use super::worst::{Extreme, Sample};
use super::{Answer, Batch, Question, Verdict};
use crate::subject::Subject;
use lobe_backends::route::Route;
use lobe_codegen::def::{Scalar, Truth};

/// Compares `native` (or `interp`) with the exact function.
#[derive(Debug, Default)]
pub struct Approximation {
    cases: usize,
    over: usize,
    extreme: Extreme,
}

impl Approximation {
    /// Takes a batch.
    pub fn absorb(&mut self, batch: &Batch<'_>) {
        let Some(truth) = batch.subject.def().contract.truth else { return };
        let strict = batch.outputs.iter().find(|(route, _)| matches!(route, Route::Native | Route::Interp));
        let (Some((_, Ok(output))), Some(Some(permitted))) = (strict, batch.permitted.first()) else {
            return;
        };
        self.cases += batch.args.rows;
        for (row, &permitted) in permitted.iter().enumerate() {
            let Some(wanted) = value(truth, batch, row) else { return };
            let found = f64::from(f32::from_bits(output.columns[0][row]));
            // Below the smallest normal f32 a result may be flushed to zero, which is no fault of the formula.
            let error = (found - wanted).abs();
            let permitted = permitted + f64::from(f32::MIN_POSITIVE);
            let sample = Sample { found, wanted, error, permitted };
            self.over += usize::from(!self.extreme.take(sample, || batch.worst(row, 0, sample)));
        }
    }

    /// The answer; `None` for a kernel that names no exact function.
    #[must_use]
    pub fn finish(self, subject: &Subject) -> Option<Answer> {
        subject.def().contract.truth?;
        let verdict = match (self.cases, self.over) {
            (0, _) => Verdict::NotAsked("needs a budget, and the route native or interp".to_owned()),
            (_, 0) => Verdict::Holds,
            (cases, over) => Verdict::FallsShort(format!(
                "the result is farther than the budget from the exact function on {over} of {cases} rows"
            )),
        };
        let answer = Answer::bare(Question::Correct, "the exact function", verdict).with(self.extreme);
        Some(Answer { cases: self.cases, ..answer })
    }
}

fn value(truth: Truth, batch: &Batch<'_>, row: usize) -> Option<f64> {
    let params = batch.subject.program().params();
    let arg = |index: usize| {
        let is_float = params.get(index).is_some_and(|leaf| leaf.scalar == Scalar::F32);
        is_float.then(|| f64::from(f32::from_bits(batch.args.columns[index][row])))
    };
    Some(match truth {
        Truth::Unary(exact) => exact(arg(0)?),
        Truth::Binary(exact) => exact(arg(0)?, arg(1)?),
    })
}
