//! Results against the values of a table.

use super::feed::{self, Fed};
use super::mapping::{Entry, Lane, Member, Rule};
use super::table::Row;
use super::{applies, failed, quantiles};
use crate::question::{Answer, Extreme, Question, Sample, Verdict, Worst};
use crate::subject::{Subject, as_f64, covers};
use lobe_backends::executor::Executor;
use lobe_backends::interp::ShadowColumn;
use lobe_backends::route::Route;
use std::cell::OnceCell;

/// The rows of a table that an entry speaks of, fed to its kernel.
pub(super) struct Judged<'a> {
    subject: &'a Subject,
    entry: &'a Entry,
    rows: &'a [&'a Row],
    fed: &'a Fed,
    /// The derived bound of each scalar of the result, row by row.
    bounds: OnceCell<Result<Vec<Vec<f64>>, String>>,
}

impl<'a> Judged<'a> {
    /// Of `rows`, fed as `fed`.
    pub(super) fn new(subject: &'a Subject, entry: &'a Entry, rows: &'a [&'a Row], fed: &'a Fed) -> Self {
        Self { subject, entry, rows, fed, bounds: OnceCell::new() }
    }

    /// The formula, in f64.
    pub(super) fn in_f64(&self) -> Answer {
        let shadow = match self.subject.program().shadow(&self.fed.args, Some(&self.fed.exact)) {
            Ok(shadow) => shadow,
            Err(error) => return failed(self.entry, "f64", error.to_string()),
        };
        let columns = shadow.columns.into_iter().map(|column| match column {
            ShadowColumn::Float { exact, .. } => exact,
            ShadowColumn::Word { value, .. } => value.into_iter().map(f64::from).collect(),
        });
        self.compare("f64", Lane::F64, &columns.collect::<Vec<_>>(), None)
    }

    /// What a route returns.
    pub(super) fn on(&self, route: &mut dyn Executor) -> Answer {
        let name = route.route().to_string();
        let output = match route.run(self.subject.program(), &self.fed.args) {
            Ok(output) => output,
            Err(error) => return failed(self.entry, &name, error.to_string()),
        };
        let leaves = self.subject.program().results().iter().zip(output.columns);
        let columns = leaves.map(|(leaf, words)| words.into_iter().map(|w| as_f64(leaf.scalar, w)).collect());
        let columns = columns.collect::<Vec<_>>();
        let is_driver = !matches!(route.route(), Route::Native | Route::Interp);
        match self.bounds.get_or_init(|| self.derive()) {
            Ok(bounds) => self.compare(&name, Lane::F32, &columns, Some(&Bounds { bounds, is_driver })),
            Err(why) => failed(self.entry, &name, why.clone()),
        }
    }

    /// What the accuracy rules and the rounding of the arguments permit.
    fn derive(&self) -> Result<Vec<Vec<f64>>, String> {
        let shadow = self.subject.program().shadow(&self.fed.args, Some(&self.fed.exact));
        let columns = shadow.map_err(|e| e.to_string())?.columns.into_iter().map(|column| match column {
            ShadowColumn::Float { bound, .. } => bound,
            ShadowColumn::Word { value, .. } => vec![0.0; value.len()],
        });
        Ok(columns.collect())
    }

    fn compare(&self, name: &str, lane: Lane, results: &[Vec<f64>], bounds: Option<&Bounds<'_>>) -> Answer {
        let (mut extreme, mut wrong, mut compared) = (Extreme::default(), 0, 0);
        let mut ratios = Vec::new();
        for (index, row) in self.rows.iter().enumerate() {
            let of_row = |columns: &[Vec<f64>]| columns.iter().map(|column| column[index]).collect();
            let found: Vec<f64> = of_row(results);
            let bound = bounds.map(|b| RowBound { bound: of_row(b.bounds), is_driver: b.is_driver });
            match self.row_samples(row, lane, &found, bound.as_ref()) {
                Ok(samples) => {
                    compared += usize::from(!samples.is_empty());
                    let mut within = true;
                    for (leaf, sample) in samples {
                        within &= extreme.take(sample, || self.worst(index, leaf, sample));
                        ratios.extend((sample.wanted != 0.0).then(|| sample.found / sample.wanted));
                    }
                    wrong += usize::from(!within);
                }
                Err(why) => return failed(self.entry, name, format!("line {}: {why}", row.line)),
            }
        }
        let label = format!("{}, {name}", self.entry.label());
        if self.entry.rule == Rule::Distribution {
            return quantiles::answer(label, &self.entry.quantiles, ratios, compared);
        }
        let verdict = match (compared, wrong) {
            (0, _) => Verdict::FallsShort("no row has a value".to_owned()),
            (_, 0) => Verdict::Holds,
            (cases, n) => self.short(lane, format!("{n} of {cases} rows are farther off than permitted")),
        };
        Answer { cases: compared, ..Answer::bare(Question::Correct, label, verdict).with(extreme) }
    }

    /// The formula of a variant that is not robust can be right in f64 all the same, but not in f32.
    fn short(&self, lane: Lane, why: String) -> Verdict {
        let contract = &self.subject.def().contract;
        match (lane, contract.not_robust, contract.variant_of) {
            (Lane::F32, Some(reason), Some(_)) => Verdict::ExpectedFailure(reason.to_owned()),
            _ => Verdict::FallsShort(why),
        }
    }

    fn row_samples(
        &self,
        row: &Row,
        lane: Lane,
        found: &[f64],
        bound: Option<&RowBound>,
    ) -> Result<Vec<(usize, Sample)>, String> {
        let mut samples = Vec::new();
        for (part, member) in self.entry.result.iter().filter(|(part, _)| !self.is_skipped(row, part)) {
            // A row may leave out what it has no value for, as where no light arrives.
            if !states(row, member) {
                continue;
            }
            let (wanted, df32) = wanted(row, member)?;
            let leaves = self.subject.program().results().iter().enumerate();
            let leaves: Vec<usize> = leaves.filter(|(_, l)| covers(part, &l.path)).map(|(i, _)| i).collect();
            if leaves.len() != wanted.len() {
                let (n, m) = (leaves.len(), wanted.len());
                return Err(format!("`{part}` of the result has {n} scalars, the value {m}"));
            }
            let sign = if self.entry.free_sign.contains(part) { sign(&leaves, found, &wanted) } else { 1.0 };
            for (at, leaf) in leaves.into_iter().enumerate() {
                let df32 = df32.get(at).copied();
                // Where the table does not say what rounding the arguments does, the derived bound does.
                let derived = bound.filter(|b| b.is_driver || df32.is_none()).map_or(0.0, |b| b.bound[leaf]);
                let permitted = self.permitted(row, lane, part, wanted[at], df32.unwrap_or(0.0))?
                    + derived * self.times(row)?.abs();
                samples.push((leaf, self.sample(row, sign * found[leaf], wanted[at], permitted)?));
            }
        }
        Ok(samples)
    }

    fn is_skipped(&self, row: &Row, part: &str) -> bool {
        self.entry.skip.iter().any(|skip| skip.parts.iter().any(|p| covers(p, part)) && applies(skip, row))
    }

    /// The column by which the result is multiplied before it is compared.
    fn times(&self, row: &Row) -> Result<f64, String> {
        match &self.entry.times {
            Some(column) => Ok(feed::numbers(&row.args, column)?.first().copied().unwrap_or(f64::NAN)),
            None => Ok(1.0),
        }
    }

    fn sample(&self, row: &Row, found: f64, wanted: f64, permitted: f64) -> Result<Sample, String> {
        let found = found * self.times(row)?;
        Ok(Sample { found, wanted, error: (found - wanted).abs(), permitted })
    }

    fn permitted(&self, row: &Row, lane: Lane, part: &str, wanted: f64, df32: f64) -> Result<f64, String> {
        let base = match (self.entry.rule, lane) {
            (Rule::Match, Lane::F64) => 1e-11 * wanted.abs() + 1e-9 * 2f64.powi(24) * df32 + 1e-300,
            // Below the smallest normal number a driver may flush to zero.
            (Rule::Match, Lane::F32 | Lane::Both) => {
                8.0 * df32 + 1e-6 * wanted.abs() + f64::from(f32::MIN_POSITIVE) * self.times(row)?.abs()
            }
            (Rule::Approximate | Rule::Distribution, _) => f64::from(f32::MIN_POSITIVE),
        };
        let applying = self.entry.slack.iter().filter(|s| {
            (s.lane == lane || s.lane == Lane::Both)
                && (s.parts.is_empty() || s.parts.iter().any(|p| covers(p, part)))
        });
        applying.into_iter().try_fold(base, |sum, s| Ok(sum + s.factor * feed::scale(&s.of, row, wanted)?))
    }

    fn worst(&self, index: usize, leaf: usize, sample: Sample) -> Worst {
        let path = &self.subject.program().results()[leaf].path;
        Worst::at(self.subject.def(), &self.fed.args.row(index), path, sample)
    }
}

/// Derived bounds of the scalars of the result, column by column, for a route.
struct Bounds<'a> {
    bounds: &'a [Vec<f64>],
    is_driver: bool,
}

/// Those of one row.
struct RowBound {
    bound: Vec<f64>,
    is_driver: bool,
}

/// Whether the row has a value for `member`.
pub(super) fn states(row: &Row, member: &Member) -> bool {
    feed::member(&row.value, member.path()).is_some_and(|value| !value.is_null())
}

/// By which sign the found vector comes nearer to the wanted one.
fn sign(leaves: &[usize], found: &[f64], wanted: &[f64]) -> f64 {
    let along: f64 = leaves.iter().zip(wanted).map(|(leaf, w)| found[*leaf] * w).sum();
    if along < 0.0 { -1.0 } else { 1.0 }
}

/// The numbers of a member, and what rounding the arguments does to each.
fn wanted(row: &Row, member: &Member) -> Result<(Vec<f64>, Vec<f64>), String> {
    let values = feed::numbers(&row.value, member.path())?;
    let df32 = feed::numbers(&row.df32, member.path()).unwrap_or_default();
    Ok(match member {
        Member::Plain(_) => (values, df32),
        Member::Ln { .. } => {
            let relative = df32.iter().zip(&values).map(|(d, v)| d / v.abs()).collect();
            (values.into_iter().map(f64::ln).collect(), relative)
        }
    })
}
