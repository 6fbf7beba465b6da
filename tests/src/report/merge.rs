//! One report out of parts.
//!
//! It does not show how the whole was split, nor in which order the parts came: the same answers give the same bytes.

use super::part::Whole;
use super::{KernelReport, Report, json};
use crate::question::Question;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Why there is no one report.
#[derive(Debug, thiserror::Error)]
pub enum MergeError {
    /// A file or folder cannot be read.
    #[error("{}: cannot be read: {cause}", path.display())]
    Read {
        /// Which.
        path: PathBuf,
        /// The system's words.
        cause: std::io::Error,
    },
    /// A file is no report.
    #[error("{}: is no report of `lobe check --format json`: {cause}", path.display())]
    Form {
        /// Which.
        path: PathBuf,
        /// Where, and what is wrong there.
        cause: serde_json::Error,
    },
    /// There is none.
    #[error("{paths}: no report (*.json) is there; LOBE_REPORT_DIR=DIR makes tests leave theirs in DIR")]
    Nothing {
        /// Where it was looked for.
        paths: String,
    },
    /// Two reports are of different runs.
    #[error(
        "{first} has {what} {one}, {second} has {other}: they are not parts of one run; run both with the same"
    )]
    Disagree {
        /// In what they differ.
        what: &'static str,
        /// A file.
        first: String,
        /// What it says.
        one: String,
        /// The other.
        second: String,
        /// What that says.
        other: String,
    },
    /// A part is there twice, and not the same.
    #[error("{first} and {second} are both the part {part} and differ: remove the one that is out of date")]
    Twice {
        /// Which.
        part: String,
        /// A file.
        first: String,
        /// The other.
        second: String,
    },
}

/// The reports in files, and in the files `*.json` of folders, with their names.
///
/// # Errors
/// When there is none, or one cannot be read.
pub fn read(paths: &[PathBuf]) -> Result<Vec<(String, Report)>, MergeError> {
    let mut files = Vec::new();
    for path in paths {
        files.extend(if path.is_dir() { reports_in(path)? } else { vec![path.clone()] });
    }
    if files.is_empty() {
        let names: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
        return Err(MergeError::Nothing { paths: names.join(", ") });
    }
    files.into_iter().map(|path| Ok((path.display().to_string(), one(&path)?))).collect()
}

fn reports_in(folder: &Path) -> Result<Vec<PathBuf>, MergeError> {
    let fail = |cause| MergeError::Read { path: folder.to_owned(), cause };
    let entries: Vec<_> = std::fs::read_dir(folder).and_then(Iterator::collect).map_err(fail)?;
    let paths = entries.into_iter().map(|entry: std::fs::DirEntry| entry.path());
    let mut found: Vec<PathBuf> = paths.filter(|p| p.extension().is_some_and(|e| e == "json")).collect();
    found.sort();
    Ok(found)
}

fn one(path: &Path) -> Result<Report, MergeError> {
    let text = std::fs::read_to_string(path);
    let text = text.map_err(|cause| MergeError::Read { path: path.to_owned(), cause })?;
    json::parse(&text).map_err(|cause| MergeError::Form { path: path.to_owned(), cause })
}

/// The report that `reports`, each with its name, are parts of.
///
/// What no part brings is told in [`Report::missing`].
///
/// # Errors
/// When they are not of one run.
pub fn merge(reports: Vec<(String, Report)>) -> Result<Report, MergeError> {
    agree(&reports)?;
    let mut merged = match reports.first() {
        Some((_, first)) => Report { model: first.model.clone(), ..Report::new(&first.command, first.seed) },
        None => return Err(MergeError::Nothing { paths: "no file".to_owned() }),
    };
    let mut wholes: BTreeMap<Option<Whole>, Vec<(String, Report)>> = BTreeMap::new();
    for (name, report) in reports {
        let whole = report.part.as_ref().map(|part| part.whole.clone());
        wholes.entry(whole).or_default().push((name, report));
    }
    for (whole, parts) in wholes {
        match whole {
            Some(whole) => merged.take_whole(&whole, parts)?,
            None => parts.into_iter().for_each(|(_, report)| {
                merged.kernels.extend(report.kernels.iter().cloned());
                merged.take_surroundings(report);
            }),
        }
    }
    Ok(merged)
}

/// Whether all are of one run.
fn agree(reports: &[(String, Report)]) -> Result<(), MergeError> {
    type Say = fn(&Report) -> String;
    let all: [(&'static str, Say); 5] = [
        ("schema", |r| r.schema.to_string()),
        ("version", |r| r.version.clone()),
        ("command", |r| r.command.clone()),
        ("seed", |r| r.seed.to_string()),
        ("accuracy model", |r| r.model.clone().unwrap_or_else(|| "portable".to_owned())),
    ];
    let mut pairs = reports.iter().zip(reports.iter().skip(1));
    pairs.try_for_each(|(one, other)| all.iter().try_for_each(|(what, say)| same(what, *say, one, other)))?;
    same_drivers(reports)
}

/// Whether all speak of the same drivers by the same names.
fn same_drivers(reports: &[(String, Report)]) -> Result<(), MergeError> {
    let mut known: BTreeMap<&str, (&str, &str)> = BTreeMap::new();
    for (file, report) in reports {
        for (driver, words) in &report.drivers {
            let &mut (first, one) = known.entry(driver).or_insert((file, words));
            if one != words {
                return Err(MergeError::Disagree {
                    what: "driver",
                    first: first.to_owned(),
                    one: one.to_owned(),
                    second: file.clone(),
                    other: words.clone(),
                });
            }
        }
    }
    Ok(())
}

fn same(
    what: &'static str,
    say: fn(&Report) -> String,
    (first, a): &(String, Report),
    (second, b): &(String, Report),
) -> Result<(), MergeError> {
    let (one, other) = (say(a), say(b));
    if one == other {
        return Ok(());
    }
    Err(MergeError::Disagree { what, first: first.clone(), one, second: second.clone(), other })
}

impl Report {
    /// Takes the parts of one whole.
    fn take_whole(&mut self, whole: &Whole, parts: Vec<(String, Self)>) -> Result<(), MergeError> {
        let inputs = |r: &Self| r.part.as_ref().map_or(0, |part| part.inputs).to_string();
        let mut pairs = parts.iter().zip(parts.iter().skip(1));
        pairs.try_for_each(|(one, other)| same("inputs", inputs, one, other))?;
        let mut by_name: BTreeMap<String, (String, Self)> = BTreeMap::new();
        for (file, report) in parts {
            let name = report.part.as_ref().map(|part| part.name.clone()).unwrap_or_default();
            match by_name.get(&name) {
                Some((first, known)) if json::render(known) != json::render(&report) => {
                    return Err(MergeError::Twice { part: name, first: first.clone(), second: file });
                }
                _ => by_name.insert(name, (file, report)),
            };
        }
        let mut found: Vec<KernelReport> = Vec::new();
        for name in &whole.parts {
            match by_name.remove(name) {
                Some((_, mut report)) => {
                    found.append(&mut report.kernels);
                    self.take_surroundings(report);
                }
                None => self.missing.push(format!("{name} of {}", whole.whole)),
            }
        }
        for name in &whole.kernels {
            let own = found.iter().filter(|kernel| kernel.name == *name).cloned();
            self.kernels.extend(own.reduce(joined));
        }
        Ok(())
    }

    /// Takes all but the kernels.
    fn take_surroundings(&mut self, report: Self) {
        let new = |route: &String| !self.routes.contains(route);
        let routes: Vec<String> = report.routes.into_iter().filter(new).collect();
        self.routes.extend(routes);
        self.drivers.extend(report.drivers);
        let new = |skipped: &super::Skipped| !self.skipped.contains(skipped);
        let skipped: Vec<_> = report.skipped.into_iter().filter(new).collect();
        self.skipped.extend(skipped);
        self.unmapped.extend(report.unmapped);
        self.missing.extend(report.missing);
    }
}

/// Two reports of a kernel as one; its answers by question, as a check of the whole gives them.
fn joined(mut first: KernelReport, second: KernelReport) -> KernelReport {
    first.inputs = first.inputs.max(second.inputs);
    first.listed = first.listed.max(second.listed);
    first.search = first.search.or(second.search);
    first.tightness = first.tightness.or(second.tightness);
    first.answers.extend(second.answers);
    first.answers.sort_by_key(|answer| match answer.question {
        Question::Correct => 0,
        Question::Robust => 1,
        Question::Conformant => 2,
        Question::Agree => 3,
    });
    first
}
