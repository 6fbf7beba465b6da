//! Judges kernels by tables of independent high-precision values.
//!
//! Any folder of tables serves, if its files are named `<function>.jsonl` and hold a row a line:
//! `fn`, `args` (numbers, vectors, or nested objects of them), `kind` (`formula-f64`: to be matched;
//! `exact-integral`: to measure an approximation error by), `value` (a number or members by name), and
//! optionally `variant`, `df32` (what rounding the arguments to f32 does to the value) and `tag`.
//! Which kernel a table speaks of is said by a [`Mapping`].
//!
//! Tolerances for matched rows: f64 `1e-11·|value| + 1e-9·2^24·df32`, f32 `8·df32 + 1e-6·|value|`; what is
//! permitted beyond is written in the mapping, with the reason.

mod feed;
mod mapping;
pub mod table;

pub use mapping::{Entry, Lane, Mapping, MappingError, Rule, Scale, Skip, Slack, Source, Transform};
pub use table::{Row, TableError};

use crate::cases::Cases;
use crate::question::{Answer, Extreme, Question, Sample, Verdict, Worst};
use crate::subject::{Subject, as_f64, covers};
use lobe_backends::executor::Executor;
use lobe_backends::interp::ShadowColumn;
use lobe_codegen::def::FunctionRef;
use std::collections::BTreeMap;

/// How a table came out.
#[derive(Debug, Default)]
pub struct TableReport {
    /// An answer for each entry and lane.
    pub answers: Vec<(String, Answer)>,
    /// Rows that no entry speaks of, by function, kind and variant.
    pub unmapped: BTreeMap<String, usize>,
}

/// The answers that the tables of `cases` give for a kernel, in f64.
#[must_use]
pub fn judge_kernel(subject: &Subject, mapping: &Mapping, cases: &Cases) -> Vec<Answer> {
    let mut answers = Vec::new();
    for entry in mapping.of_kernel(subject.def().name) {
        match table::read(&cases.table(&entry.function)) {
            Ok(rows) => answers.extend(judge_entry(subject, entry, &rows, &mut [])),
            Err(error) => answers.push(failed(entry, "f64", error.to_string())),
        }
    }
    if answers.is_empty() {
        let verdict = Verdict::NotAsked("no oracle table is mapped to it".to_owned());
        answers.push(Answer::bare(Question::Correct, "no table", verdict));
    }
    answers
}

/// Judges the rows of a table by every entry that speaks of them, in f64 and on `routes`.
///
/// `kernel` finds a kernel by its name.
pub fn judge_table(
    rows: &[Row],
    mapping: &Mapping,
    kernel: &dyn Fn(&str) -> Option<FunctionRef>,
    routes: &mut [Box<dyn Executor>],
) -> TableReport {
    let mut report = TableReport::default();
    let functions: std::collections::BTreeSet<&str> = rows.iter().map(|r| r.function.as_str()).collect();
    for entry in mapping.entries.iter().filter(|e| functions.contains(e.function.as_str())) {
        let answers = match kernel(&entry.kernel).map(Subject::new) {
            Some(Ok(subject)) => judge_entry(&subject, entry, rows, routes),
            Some(Err(error)) => vec![failed(entry, "f64", error.to_string())],
            None => vec![failed(entry, "f64", format!("there is no kernel `{}`", entry.kernel))],
        };
        report.answers.extend(answers.into_iter().map(|a| (entry.kernel.clone(), a)));
    }
    for row in rows.iter().filter(|row| !mapping.entries.iter().any(|e| speaks_of(e, row))) {
        let variant = row.variant.as_ref().map(|v| format!(", {v}")).unwrap_or_default();
        *report.unmapped.entry(format!("{} ({}{variant})", row.function, row.kind)).or_default() += 1;
    }
    report
}

fn speaks_of(entry: &Entry, row: &Row) -> bool {
    entry.function == row.function && entry.kind == row.kind && entry.variant == row.variant
}

fn skips(skip: &Skip, row: &Row) -> bool {
    let has_value = |(path, value): (&String, &f64)| {
        feed::numbers(&row.args, path).is_ok_and(|found| found.iter().all(|v| v == value))
    };
    skip.tag.as_ref().is_none_or(|text| row.tag.contains(text.as_str())) && skip.args.iter().all(has_value)
}

fn failed(entry: &Entry, lane: &str, why: String) -> Answer {
    Answer::bare(Question::Correct, format!("{}, {lane}", entry.label()), Verdict::FallsShort(why))
}

fn judge_entry(
    subject: &Subject,
    entry: &Entry,
    rows: &[Row],
    routes: &mut [Box<dyn Executor>],
) -> Vec<Answer> {
    let is_skipped = |row: &Row| entry.skip.iter().any(|skip| skips(skip, row));
    let rows: Vec<&Row> = rows.iter().filter(|row| speaks_of(entry, row) && !is_skipped(row)).collect();
    if rows.is_empty() {
        return vec![failed(entry, "f64", "the table holds no row of this kind and variant".to_owned())];
    }
    let fed = match feed::feed(subject.program(), entry, &rows) {
        Ok(fed) => fed,
        Err(why) => return vec![failed(entry, "f64", why)],
    };
    let judged = Judged { subject, entry, rows: &rows, fed: &fed };
    let mut answers = vec![judged.in_f64()];
    answers.extend(routes.iter_mut().map(|route| judged.on(route.as_mut())));
    answers
}

struct Judged<'a> {
    subject: &'a Subject,
    entry: &'a Entry,
    rows: &'a [&'a Row],
    fed: &'a feed::Fed,
}

impl Judged<'_> {
    fn in_f64(&self) -> Answer {
        let shadow = match self.subject.program().shadow(&self.fed.args, Some(&self.fed.exact)) {
            Ok(shadow) => shadow,
            Err(error) => return failed(self.entry, "f64", error.to_string()),
        };
        let columns = shadow.columns.into_iter().map(|column| match column {
            ShadowColumn::Float { exact, .. } => exact,
            ShadowColumn::Word { value, .. } => value.into_iter().map(f64::from).collect(),
        });
        self.compare("f64", Lane::F64, &columns.collect::<Vec<_>>())
    }

    fn on(&self, route: &mut dyn Executor) -> Answer {
        let name = route.route().to_string();
        let output = match route.run(self.subject.program(), &self.fed.args) {
            Ok(output) => output,
            Err(error) => return failed(self.entry, &name, error.to_string()),
        };
        let leaves = self.subject.program().results().iter().zip(output.columns);
        let columns = leaves.map(|(leaf, words)| words.into_iter().map(|w| as_f64(leaf.scalar, w)).collect());
        self.compare(&name, Lane::F32, &columns.collect::<Vec<_>>())
    }

    fn compare(&self, name: &str, lane: Lane, results: &[Vec<f64>]) -> Answer {
        let (mut extreme, mut wrong, mut compared) = (Extreme::default(), 0, 0);
        for (index, row) in self.rows.iter().enumerate() {
            let found: Vec<f64> = results.iter().map(|column| column[index]).collect();
            match self.row_samples(row, lane, &found) {
                Ok(samples) => {
                    compared += usize::from(!samples.is_empty());
                    let mut within = true;
                    for (leaf, sample) in samples {
                        within &= extreme.take(sample, || self.worst(index, leaf, sample));
                    }
                    wrong += usize::from(!within);
                }
                Err(why) => return failed(self.entry, name, format!("line {}: {why}", row.line)),
            }
        }
        let verdict = match (compared, wrong) {
            (0, _) => Verdict::FallsShort("no row has a value".to_owned()),
            (_, 0) => Verdict::Holds,
            (cases, n) => self.short(lane, format!("{n} of {cases} rows are farther off than permitted")),
        };
        let answer = Answer::bare(Question::Correct, format!("{}, {name}", self.entry.label()), verdict);
        Answer { cases: compared, ..answer.with(extreme) }
    }

    /// The formula of a kernel that is not robust can be right in f64 all the same, but not in f32.
    fn short(&self, lane: Lane, why: String) -> Verdict {
        match (lane, self.subject.def().contract.not_robust) {
            (Lane::F32, Some(reason)) => Verdict::ExpectedFailure(reason.to_owned()),
            (Lane::F64 | Lane::Both, _) | (Lane::F32, None) => Verdict::FallsShort(why),
        }
    }

    fn row_samples(&self, row: &Row, lane: Lane, found: &[f64]) -> Result<Vec<(usize, Sample)>, String> {
        let mut samples = Vec::new();
        for (part, member) in &self.entry.result {
            let value =
                feed::member(&row.value, member).ok_or_else(|| format!("the value has no `{member}`"))?;
            if value.is_null() {
                continue;
            }
            let wanted = feed::numbers(&row.value, member)?;
            let df32 = feed::numbers(&row.df32, member).unwrap_or_default();
            let leaves = self.subject.program().results().iter().enumerate();
            let leaves: Vec<usize> = leaves.filter(|(_, l)| covers(part, &l.path)).map(|(i, _)| i).collect();
            if leaves.len() != wanted.len() {
                let (n, m) = (leaves.len(), wanted.len());
                return Err(format!("`{part}` of the result has {n} scalars, the value {m}"));
            }
            for (at, leaf) in leaves.into_iter().enumerate() {
                let df32 = df32.get(at).copied().unwrap_or(0.0);
                samples.push((leaf, self.sample(row, lane, found[leaf], wanted[at], df32)?));
            }
        }
        Ok(samples)
    }

    fn sample(&self, row: &Row, lane: Lane, found: f64, wanted: f64, df32: f64) -> Result<Sample, String> {
        let times = match &self.entry.times {
            Some(column) => feed::numbers(&row.args, column)?.first().copied().unwrap_or(f64::NAN),
            None => 1.0,
        };
        let found = found * times;
        let base = match (self.entry.rule, lane) {
            (Rule::Match, Lane::F64) => 1e-11 * wanted.abs() + 1e-9 * 2f64.powi(24) * df32 + 1e-300,
            // Below the smallest normal number a driver may flush to zero.
            (Rule::Match, Lane::F32 | Lane::Both) => {
                8.0 * df32 + 1e-6 * wanted.abs() + f64::from(f32::MIN_POSITIVE) * times.abs()
            }
            (Rule::Approximate, _) => f64::from(f32::MIN_POSITIVE),
        };
        let slack = self.entry.slack.iter().filter(|s| s.lane == lane || s.lane == Lane::Both);
        let permitted = base + slack.map(|s| s.factor * feed::scale(s.of, row, wanted)).sum::<f64>();
        Ok(Sample { found, wanted, error: (found - wanted).abs(), permitted })
    }

    fn worst(&self, index: usize, leaf: usize, sample: Sample) -> Worst {
        let path = &self.subject.program().results()[leaf].path;
        Worst::at(self.subject.def(), &self.fed.args.row(index), path, sample)
    }
}
