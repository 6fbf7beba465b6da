//! Looks for the rows at which a kernel is worst: by steps from the worst that are known, without gradients.
//!
//! Three aims are hunted at once: the derived bound, an observed error as a share of it, and the difference between
//! routes. Every row found is judged like those that were drawn.

use crate::domain::Neighbours;
use crate::judge::{JudgeError, each_batch};
use crate::question::conformant::sample;
use crate::question::{Batch, ulp};
use crate::subject::Subject;
use crate::value::{Floats, args_json};
use lobe_backends::executor::Executor;
use lobe_backends::interp::ShadowColumn;
use lobe_codegen::data::Columns;
use lobe_codegen::def::FunctionDef;
use serde_json::Value;
use std::time::{Duration, Instant};

/// Rows of a round: enough for every driver, little enough that the next round knows more soon.
const ROUND: usize = 2048;
/// Rows that are remembered for each aim.
const ELITE: usize = 24;

/// How long to look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// For each kernel so long; how far that leads depends on the machine.
    Time(Duration),
    /// So many rounds; the same seed finds the same rows.
    Rounds(usize),
}

/// What is to be large.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Aim {
    /// The bound, as a share of the budget, or of the value where no budget is stated.
    Bound,
    /// A route's error as a share of the bound.
    Error,
    /// The difference between routes, in ULP of the exact value.
    Difference,
}

const AIMS: [Aim; 3] = [Aim::Bound, Aim::Error, Aim::Difference];

/// The worst row for an aim.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Find {
    /// The aim.
    pub aim: Aim,
    /// The worst among drawn and listed rows.
    #[serde(with = "crate::question::float")]
    pub drawn: f64,
    /// The worst of all.
    #[serde(with = "crate::question::float")]
    pub found: f64,
    /// Where that is, floats in hexadecimal, as `lobe eval` reads them.
    pub args: Value,
}

impl Find {
    /// Whether the search found a row that is worse than those drawn.
    #[must_use]
    pub fn is_new(&self) -> bool {
        self.found > self.drawn
    }
}

/// What a search came to.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Found {
    /// Rows that were tried.
    pub rows: usize,
    /// The worst for each aim that has any.
    pub finds: Vec<Find>,
}

/// Remembers the worst rows.
#[derive(Debug, Default)]
pub(crate) struct Hunt {
    elites: [Elite; AIMS.len()],
    rows: usize,
}

/// The worst rows for an aim, the worst first.
#[derive(Debug, Default)]
struct Elite {
    rows: Vec<(f64, Vec<u32>)>,
    drawn: f64,
}

impl Elite {
    fn take(&mut self, score: f64, row: impl FnOnce() -> Vec<u32>) {
        let least = self.rows.last().map_or(0.0, |(score, _)| *score);
        if score <= 0.0 || (self.rows.len() == ELITE && score <= least) {
            return;
        }
        let at = self.rows.partition_point(|(other, _)| *other >= score);
        let row = row();
        if self.rows.iter().any(|(_, other)| *other == row) {
            return;
        }
        self.rows.insert(at, (score, row));
        self.rows.truncate(ELITE);
    }
}

impl Hunt {
    /// Takes rows that were judged.
    pub(crate) fn absorb(&mut self, batch: &Batch<'_>) {
        for row in (0..batch.args.rows).filter(|row| !batch.is_indeterminate(*row)) {
            for (aim, elite) in AIMS.into_iter().zip(&mut self.elites) {
                elite.take(score(aim, batch, row), || batch.args.row(row));
            }
        }
    }

    /// Looks on from the rows that were taken; `take` judges each batch of new ones.
    pub(crate) fn run(
        &mut self,
        subject: &Subject,
        (limit, seed): (Limit, u64),
        routes: &mut [Box<dyn Executor>],
        take: &mut dyn FnMut(&Batch<'_>),
    ) -> Result<(), JudgeError> {
        for elite in &mut self.elites {
            elite.drawn = elite.rows.first().map_or(0.0, |(score, _)| *score);
        }
        let begin = Instant::now();
        let mut neighbours = Neighbours::new(subject.def(), seed)?;
        for round in 0.. {
            let over = match limit {
                Limit::Time(time) => begin.elapsed() >= time,
                Limit::Rounds(rounds) => round >= rounds,
            };
            let rows = self.round(&mut neighbours);
            if over || rows.is_empty() {
                break;
            }
            self.rows += rows.len();
            let args = Columns::from_rows(subject.program().params().len(), &rows);
            each_batch(subject, &args, routes, &mut |batch| {
                self.absorb(batch);
                take(batch);
            })?;
        }
        Ok(())
    }

    /// Rows near the worst, the very worst most often; none for a kernel without arguments or without errors.
    fn round(&self, neighbours: &mut Neighbours) -> Vec<Vec<u32>> {
        let hunted: Vec<&Elite> = self.elites.iter().filter(|e| !e.rows.is_empty()).collect();
        let draw = |neighbours: &mut Neighbours| {
            let elite = hunted[neighbours.rng().below(hunted.len())];
            let at = (neighbours.rng().unit().powi(2) * elite.rows.len() as f64) as usize;
            let (_, row) = &elite.rows[at];
            (!row.is_empty()).then(|| neighbours.near(row))
        };
        (0..if hunted.is_empty() { 0 } else { ROUND }).filter_map(|_| draw(neighbours)).collect()
    }

    /// The worst of all.
    pub(crate) fn finish(self, kernel: &FunctionDef) -> Found {
        let find = |(aim, elite): (Aim, Elite)| {
            let (found, row) = elite.rows.into_iter().next()?;
            Some(Find { aim, drawn: elite.drawn, found, args: args_json(kernel, &row, Floats::Hex) })
        };
        Found { rows: self.rows, finds: AIMS.into_iter().zip(self.elites).filter_map(find).collect() }
    }
}

/// How bad a row is; 0 where that is not known.
fn score(aim: Aim, batch: &Batch<'_>, row: usize) -> f64 {
    let columns = batch.shadow.columns.iter().enumerate();
    let worst = columns.map(|(leaf, column)| match aim {
        Aim::Bound => bound(batch, leaf, column, row),
        Aim::Error => error(batch, leaf, column, row),
        Aim::Difference => difference(batch, leaf, column, row),
    });
    worst.filter(|score| !score.is_nan()).fold(0.0, f64::max)
}

fn bound(batch: &Batch<'_>, leaf: usize, column: &ShadowColumn, row: usize) -> f64 {
    match column {
        ShadowColumn::Float { exact, bound, .. } if bound[row].is_finite() => {
            let value = exact[row].abs().max(f32::MIN_POSITIVE.into());
            bound[row] / batch.permitted[leaf].as_ref().map_or(value, |permitted| permitted[row])
        }
        ShadowColumn::Float { .. } | ShadowColumn::Word { .. } => 0.0,
    }
}

fn error(batch: &Batch<'_>, leaf: usize, column: &ShadowColumn, row: usize) -> f64 {
    let outputs = batch.outputs.iter().filter_map(|(_, output)| output.as_ref().ok());
    let shares = outputs.filter_map(|output| sample(column, row, output.columns[leaf][row]));
    shares.map(|sample| sample.share()).fold(0.0, f64::max)
}

fn difference(batch: &Batch<'_>, leaf: usize, column: &ShadowColumn, row: usize) -> f64 {
    let ShadowColumn::Float { exact, .. } = column else {
        return 0.0;
    };
    let outputs = batch.outputs.iter().filter_map(|(_, output)| output.as_ref().ok());
    let values = outputs.map(|output| f64::from(f32::from_bits(output.columns[leaf][row])));
    let (least, most) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), v| (l.min(v), m.max(v)));
    (most - least) / ulp(exact[row])
}
