//! Are the derived bounds sound, and are they tight? Drivers drawn by chance answer: each errs at every operation by
//! what its accuracy class permits, so none may leave the bound, and how near the worst of them comes says how tight
//! the bound is.

use crate::oracle::quantiles;
use crate::question::conformant::sample;
use crate::question::{Answer, Batch, Extreme, Question, Verdict, float};
use crate::report::KernelReport;
use lobe_codegen::data::Columns;

/// What is judged by it in a report.
pub const SUBJECT: &str = "perturbed";

/// Errors below the smallest normal number are what flushing makes of nothing, and say nothing of how tight a bound is.
const LEAST: f64 = f32::MIN_POSITIVE as f64;

/// How many times as large as the worst error found a bound is, scalar by scalar of each row.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Tightness {
    /// Drivers that ran each row.
    pub drivers: usize,
    /// Scalars of results with a bound above the smallest normal number, which is the least error that is told.
    pub scalars: usize,
    /// Where a driver came nearest to the bound.
    #[serde(with = "float")]
    pub least: f64,
    /// Of half of the scalars at most.
    #[serde(with = "float")]
    pub median: f64,
    /// Of 95 % of them at most.
    #[serde(with = "float")]
    pub most: f64,
}

/// How tight the bounds of many kernels are.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Overall {
    /// Kernels with bounds.
    pub kernels: usize,
    /// Runs, each of one row on one driver.
    pub runs: usize,
    /// The bound as a multiple of the worst error: in the median of a kernel's scalars, for half of the kernels at most.
    #[serde(with = "float")]
    pub median: f64,
    /// The same for 95 % of the kernels at most.
    #[serde(with = "float")]
    pub most: f64,
}

/// How tight the bounds of all kernels together are; `None` where no drivers were drawn.
pub(crate) fn overall(kernels: &[KernelReport]) -> Option<Overall> {
    let mut medians: Vec<f64> = kernels.iter().filter_map(|k| Some(k.tightness?.median)).collect();
    medians.sort_by(f64::total_cmp);
    let answers = kernels.iter().flat_map(|k| &k.answers).filter(|a| a.subject == SUBJECT);
    Some(Overall {
        kernels: medians.len(),
        runs: answers.map(|answer| answer.cases).sum(),
        median: quantiles::at(&medians, 0.5)?,
        most: quantiles::at(&medians, 0.95)?,
    })
}

/// Runs rows on drivers drawn by chance.
#[derive(Debug)]
pub(crate) struct Perturbed {
    drivers: usize,
    seed: u64,
    batches: u64,
    cases: usize,
    outside: usize,
    extreme: Extreme,
    ratios: Vec<f64>,
    failure: Option<String>,
}

impl Perturbed {
    pub(crate) fn new(drivers: usize, seed: u64) -> Self {
        Self {
            drivers,
            seed,
            batches: 0,
            cases: 0,
            outside: 0,
            extreme: Extreme::default(),
            ratios: vec![],
            failure: None,
        }
    }

    /// Runs a batch on every driver, and judges what they make of it.
    pub(crate) fn absorb(&mut self, batch: &Batch<'_>) {
        let mut shares = vec![vec![None; batch.args.rows]; batch.shadow.columns.len()];
        let begin = self.seed.wrapping_add(self.batches << 32);
        self.batches += 1;
        for driver in 0..self.drivers as u64 {
            match batch.subject.program().perturbed(batch.args, begin.wrapping_add(driver)) {
                Ok(output) => self.judge(batch, &output, &mut shares),
                Err(error) => self.failure = Some(error.to_string()),
            }
        }
        self.ratios.extend(shares.into_iter().flatten().flatten().map(|share: f64| 1.0 / share));
    }

    /// Judges the results of one driver; `shares` are the largest of the bounds that drivers used, column by column.
    fn judge(&mut self, batch: &Batch<'_>, output: &Columns, shares: &mut [Vec<Option<f64>>]) {
        self.cases += batch.args.rows;
        for row in (0..batch.args.rows).filter(|row| !batch.is_indeterminate(*row)) {
            for (leaf, shares) in shares.iter_mut().enumerate() {
                let found = sample(&batch.shadow.columns[leaf], row, output.columns[leaf][row]);
                let Some(sample) = found else { continue };
                self.outside += usize::from(!self.extreme.take(sample, || batch.worst(row, leaf, sample)));
                if sample.permitted > LEAST {
                    let used = sample.error.max(LEAST) / sample.permitted;
                    shares[row] = Some(shares[row].unwrap_or(0.0).max(used));
                }
            }
        }
    }

    /// The answer, and how tight the bounds are where there are any.
    pub(crate) fn finish(self) -> (Answer, Option<Tightness>) {
        let verdict = match (self.failure, self.outside) {
            (Some(why), _) => Verdict::FallsShort(why),
            (None, 0) => Verdict::Holds,
            (None, n) => Verdict::FallsShort(format!(
                "{n} results of {} permitted drivers lie outside the derived bound, so the bound is wrong",
                self.drivers
            )),
        };
        let answer = Answer { cases: self.cases, ..Answer::bare(Question::Conformant, SUBJECT, verdict) };
        (answer.with(self.extreme), tightness(self.drivers, self.ratios))
    }
}

fn tightness(drivers: usize, mut ratios: Vec<f64>) -> Option<Tightness> {
    ratios.sort_by(f64::total_cmp);
    Some(Tightness {
        drivers,
        scalars: ratios.len(),
        least: *ratios.first()?,
        median: quantiles::at(&ratios, 0.5)?,
        most: quantiles::at(&ratios, 0.95)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::judge::each_batch;
    use crate::subject::Subject;
    use lobe_codegen::prelude::*;

    /// Two roundings.
    #[kernel(domain(x = 1.0..=2.0))]
    fn two_roundings(x: f32) -> f32 {
        x / 3.0 + 0.1
    }

    /// What drivers that `spoil` changes come to on 100 rows.
    fn found(spoil: fn(&mut Columns)) -> (Answer, Option<Tightness>) {
        let subject = Subject::new(lobe_codegen::kernels![two_roundings][0]).expect("a kernel");
        let words = (0..100).map(|i| (1.0 + i as f32 / 100.0).to_bits()).collect();
        let args = Columns { columns: vec![words], rows: 100 };
        let mut perturbed = Perturbed::new(4, 7);
        each_batch(&subject, &args, &mut [], &mut |batch| {
            let mut output = batch.subject.program().perturbed(batch.args, 7).expect("a run");
            spoil(&mut output);
            let mut shares = vec![vec![None; batch.args.rows]];
            perturbed.judge(batch, &output, &mut shares);
            perturbed.ratios.extend(shares.into_iter().flatten().flatten().map(|share: f64| 1.0 / share));
        })
        .expect("bounds");
        perturbed.finish()
    }

    #[test]
    fn a_permitted_driver_is_inside_and_another_is_not() {
        let (answer, tightness) = found(|_| {});
        assert_eq!(answer.verdict, Verdict::Holds);
        let tightness = tightness.expect("bounds");
        assert!(tightness.least >= 1.0 && tightness.scalars == 100, "{tightness:?}");
        let (answer, tightness) = found(|output| output.columns[0][3] += 40);
        assert!(answer.falls_short() && tightness.expect("bounds").least < 1.0, "{answer:?}");
    }
}
