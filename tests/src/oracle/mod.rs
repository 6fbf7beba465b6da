//! Judges kernels by tables of independent high-precision values.
//!
//! Any folder of tables serves, if its files are named `<function>.jsonl` and hold a row a line:
//! `fn`, `args` (numbers, vectors, or nested objects of them), `kind` (`formula-f64`: to be matched;
//! `exact-integral`: to measure an approximation error by), `value` (a number or members by name), and
//! optionally `variant`, `df32` (what rounding the arguments to f32 does to the value) and `tag`.
//! Which kernel a table speaks of is said by a [`Mapping`].
//!
//! Tolerances for matched rows: f64 `1e-11·|value| + 1e-9·2^24·df32`, f32 `8·df32 + 1e-6·|value|`, on a driver
//! the derived bound besides, and so everywhere for a row without `df32`; what is permitted beyond is written
//! in the mapping, with the reason.

mod compare;
mod feed;
pub mod lists;
mod mapping;
pub(crate) mod quantiles;
pub mod table;

pub use mapping::{
    Entry, Lane, Mapping, MappingError, Member, Quantile, Rule, Scale, Skip, Slack, Source, Transform,
};
pub use table::{Row, TableError};

use crate::cases::Cases;
use crate::question::{Answer, Question, Verdict};
use crate::subject::Subject;
use compare::Judged;
use lobe_backends::executor::Executor;
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
/// `kernel` finds a kernel by its name; those of [`lists`] need not be among them.
pub fn judge_table(
    rows: &[Row],
    mapping: &Mapping,
    kernel: &dyn Fn(&str) -> Option<FunctionRef>,
    routes: &mut [Box<dyn Executor>],
) -> TableReport {
    let mut report = TableReport::default();
    let functions: std::collections::BTreeSet<&str> = rows.iter().map(|r| r.function.as_str()).collect();
    for entry in mapping.entries.iter().filter(|e| functions.contains(e.function.as_str())) {
        let found = kernel(&entry.kernel).or_else(|| lists::find(&entry.kernel));
        let answers = match found.map(Subject::new) {
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

/// Whether `skip` speaks of the row, all of it or part of it.
fn applies(skip: &Skip, row: &Row) -> bool {
    let has_value = |(path, value): (&String, &f64)| {
        feed::numbers(&row.args, path).is_ok_and(|found| found.iter().all(|v| v == value))
    };
    let lies_between = |(name, (low, high)): (&String, &(f64, f64))| {
        feed::quantity(name, row, f64::NAN).is_ok_and(|found| *low <= found && found <= *high)
    };
    skip.tag.as_ref().is_none_or(|text| row.tag.contains(text.as_str()))
        && skip.args.iter().all(has_value)
        && skip.between.iter().all(lies_between)
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
    let is_skipped = |row: &Row| entry.skip.iter().any(|skip| skip.parts.is_empty() && applies(skip, row));
    let rows: Vec<&Row> = rows.iter().filter(|row| speaks_of(entry, row) && !is_skipped(row)).collect();
    if rows.is_empty() {
        return vec![failed(entry, "f64", "the table holds no row of this kind and variant".to_owned())];
    }
    if let Some(member) = entry.result.values().find(|m| !rows.iter().any(|row| compare::states(row, m))) {
        let named =
            if member.path().is_empty() { String::new() } else { format!(" for `{}`", member.path()) };
        return vec![failed(entry, "f64", format!("no row has a value{named}"))];
    }
    let fed = match feed::feed(subject.program(), entry, &rows) {
        Ok(fed) => fed,
        Err(why) => return vec![failed(entry, "f64", why)],
    };
    let judged = Judged::new(subject, entry, &rows, &fed);
    let mut answers = vec![judged.in_f64()];
    answers.extend(routes.iter_mut().map(|route| judged.on(route.as_mut())));
    answers
}
