//! The file of a kernel's measured errors: Markdown that rustdoc shows, of which emitted comments carry the
//! first paragraph.
//!
//! The first paragraph and the rows of the bound, `native` and `interp` hold nothing that differs between
//! machines.
//! The rows of a driver end in `on DRIVER`, and a line of the list below the table says what it is.

use super::number::{about, at_most};
use super::{At, Figure, Measurement};
use lobe_backends::route::Route;
use std::path::{Path, PathBuf};

/// Numbers of a row that are named.
const N_ARGUMENTS: usize = 4;

/// Characters of a line.
const WIDTH: usize = 106;

/// A file, taken apart.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// What the emitted comment shows too.
    pub summary: String,
    /// Rows of the table: the driver, if it has one, and the row.
    pub rows: Vec<(Option<String>, String)>,
    /// The drivers: name and what it is.
    pub drivers: Vec<(String, String)>,
    /// The fingerprint of the definition, as it stands in the last line.
    pub definition: String,
}

const HEAD: &str = "| route | worst, of the budget | error | exact value | at |\n|---|---|---|---|---|";

/// The file of `kernel` in `folder`.
#[must_use]
pub fn path(folder: &Path, kernel: &str) -> PathBuf {
    folder.join(format!("{kernel}.md"))
}

impl File {
    /// What was measured.
    #[must_use]
    pub fn new(measured: &Measurement) -> Self {
        let mut rows = vec![(None, bound_row(&measured.bound))];
        rows.extend(route_rows(&measured.routes));
        let definition = format!("{:016x}", measured.definition);
        let mut drivers = measured.drivers.clone();
        drivers.sort();
        Self { summary: summary(measured), rows, drivers, definition }
    }

    /// The text of the file.
    #[must_use]
    pub fn render(&self) -> String {
        let mut out = format!("{}\n\n{HEAD}\n", self.summary);
        for (_, row) in &self.rows {
            out += &format!("{row}\n");
        }
        out.push('\n');
        for (name, what) in &self.drivers {
            out += &format!("- {name} is {what}\n");
        }
        if !self.drivers.is_empty() {
            out.push('\n');
        }
        out + &format!("<!-- definition {}; `lobe measure --write` writes this file -->\n", self.definition)
    }

    /// Reads a file; `None` for a text that is none.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let (summary, rest) = text.split_once("\n\n")?;
        let rest = rest.strip_prefix(HEAD)?;
        let mut file = Self {
            summary: summary.to_owned(),
            rows: Vec::new(),
            drivers: Vec::new(),
            definition: String::new(),
        };
        for line in rest.lines() {
            if line.starts_with('|') {
                file.rows.push((driver_of(line), line.to_owned()));
            } else if let Some((name, what)) = line.strip_prefix("- ").and_then(|l| l.split_once(" is ")) {
                file.drivers.push((name.to_owned(), what.to_owned()));
            } else if let Some(rest) = line.strip_prefix("<!-- definition ") {
                file.definition = rest.split(';').next()?.to_owned();
            }
        }
        (!file.definition.is_empty()).then_some(file)
    }

    /// What is as good as measured anew: the rows of `earlier` whose driver was not measured now, as long as
    /// the definition, the inputs and the seed are the same.
    ///
    /// With `only_same`, also instead of rows whose driver is another than that of `earlier` or not in it.
    pub fn take_over(&mut self, earlier: &Self, only_same: bool) -> Vec<String> {
        let mut taken = Vec::new();
        if earlier.definition != self.definition || inputs(&earlier.summary) != inputs(&self.summary) {
            return taken;
        }
        if only_same {
            let is_same = |d: &(String, String)| earlier.drivers.contains(d);
            self.drivers.retain(is_same);
            let kept: Vec<&str> = self.drivers.iter().map(|(name, _)| name.as_str()).collect();
            self.rows.retain(|(driver, _)| driver.as_deref().is_none_or(|d| kept.contains(&d)));
        }
        for (name, what) in &earlier.drivers {
            if self.drivers.iter().all(|(known, _)| known != name) {
                self.drivers.push((name.clone(), what.clone()));
                self.rows.extend(earlier.rows.iter().filter(|(d, _)| d.as_ref() == Some(name)).cloned());
                taken.push(name.clone());
            }
        }
        // In one order, whichever was measured now.
        self.drivers.sort();
        self.rows.sort_by(|(a, _), (b, _)| a.cmp(b));
        taken
    }
}

/// The words of the summary that say how many inputs there were.
fn inputs(summary: &str) -> Option<&str> {
    summary.rsplit("; ").next()
}

fn driver_of(row: &str) -> Option<String> {
    let cell = row.split('|').nth(1)?;
    cell.rsplit_once(" on ").map(|(_, driver)| driver.trim().to_owned())
}

/// The budgets and the worst errors, in lines: emitted comments are not wrapped again.
fn summary(measured: &Measurement) -> String {
    let mut out = String::new();
    for (path, text) in &measured.budgets {
        let of = if path.is_empty() {
            "Permitted error".to_owned()
        } else {
            format!("Permitted error of `{path}`")
        };
        out += &wrap(&format!("{of}: `{text}`."));
        out.push('\n');
    }
    let strict = measured.routes.iter().find(|(route, _)| matches!(route, Route::Native | Route::Interp));
    let strict =
        strict.map(|(_, figure)| format!(", {} in strict f32", strict_share(figure))).unwrap_or_default();
    out + &wrap(&format!(
        "Worst error: {}{strict}; {} inputs, seed {}.",
        bound_share(&measured.bound),
        measured.rows,
        measured.seed
    ))
}

fn bound_share(bound: &Figure) -> String {
    let share = share(bound);
    match bound.lost {
        0 => format!("{share} of it by the derived bound (any driver that keeps the rules)"),
        n => format!(
            "{share} of it by the derived bound (any driver that keeps the rules; none on {n} inputs)"
        ),
    }
}

fn strict_share(figure: &Figure) -> String {
    match figure.lost {
        0 => share(figure),
        n => format!("{} (NaN or infinity on {n} inputs)", share(figure)),
    }
}

/// Breaks `text` at blanks.
fn wrap(text: &str) -> String {
    let mut out = String::new();
    let mut length = 0;
    for word in text.split_whitespace() {
        let n = word.chars().count();
        if length > 0 && length + 1 + n > WIDTH {
            out.push('\n');
            length = 0;
        } else if length > 0 {
            out.push(' ');
            length += 1;
        }
        out.push_str(word);
        length += n;
    }
    out
}

fn share(figure: &Figure) -> String {
    figure.worst.as_ref().map_or_else(|| "none".to_owned(), |worst| at_most(worst.share))
}

fn bound_row(bound: &Figure) -> String {
    row("derived bound, any driver", bound, "no bound")
}

/// A row for each group of routes that have the same figures, native and interp first.
fn route_rows(routes: &[(Route, Figure)]) -> Vec<(Option<String>, String)> {
    let mut groups: Vec<(Option<&str>, &Figure, Vec<String>)> = Vec::new();
    for (route, figure) in routes {
        let name = match route {
            Route::Native | Route::Interp => format!("`{route}`"),
            Route::Gpu { road, .. } => format!("`{}`", road.name()),
        };
        match groups.iter_mut().find(|(driver, known, _)| *driver == route.driver() && *known == figure) {
            Some((_, _, names)) => names.push(name),
            None => groups.push((route.driver(), figure, vec![name])),
        }
    }
    groups.sort_by_key(|(driver, ..)| *driver);
    let line = |(driver, figure, names): (Option<&str>, &Figure, Vec<String>)| {
        let on = driver.map(|d| format!(" on {d}")).unwrap_or_default();
        let name = format!("{}{on}", names.join(", "));
        (driver.map(str::to_owned), row(&name, figure, "NaN or infinity"))
    };
    groups.into_iter().map(line).collect()
}

fn row(name: &str, figure: &Figure, lost: &str) -> String {
    if let Some(why) = &figure.failure {
        return format!("| {name} | did not run: {} | | | |", why.lines().next().unwrap_or_default());
    }
    let lost = match figure.lost {
        0 => String::new(),
        n => format!("; {lost} on {n} inputs"),
    };
    match &figure.worst {
        Some(at) => format!(
            "| {name} | {}{lost} | {} | {} | {} |",
            at_most(at.share),
            at_most(at.error),
            about(at.wanted),
            place(at)
        ),
        None => format!("| {name} | nothing to compare{lost} | | | |"),
    }
}

fn place(at: &At) -> String {
    let mut parts = Vec::new();
    if !at.leaf.is_empty() {
        parts.push(format!("of `{}`", at.leaf));
    }
    parts.extend(at.arguments.iter().take(N_ARGUMENTS).map(|(path, v)| format!("`{path}` {}", about(*v))));
    if at.arguments.len() > N_ARGUMENTS {
        parts.push("..".to_owned());
    }
    parts.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(drivers: &[(&str, &str)]) -> File {
        let row = |name: &str| (Some(name.to_owned()), format!("| `spirv` on {name} | 0.1 | 1e-9 | 1 | |"));
        let mut rows = vec![(None, "| `native` | 0.1 | 1e-9 | 1 | |".to_owned())];
        rows.extend(drivers.iter().map(|(name, _)| row(name)));
        let drivers = drivers.iter().map(|(name, what)| ((*name).to_owned(), (*what).to_owned())).collect();
        let summary = "Measured: 1;\nstrict: 2; 10 inputs, seed 7.".to_owned();
        File { summary, rows, drivers, definition: "00ff".to_owned() }
    }

    #[test]
    fn a_file_reads_back_as_it_was_written() {
        let file = file(&[("lavapipe", "llvmpipe 1"), ("nix", "a card is here")]);
        assert_eq!(File::parse(&file.render()), Some(file));
        assert_eq!(File::parse("something else\n\n"), None);
    }

    #[test]
    fn a_driver_that_is_not_here_keeps_its_rows() {
        let earlier = file(&[("lavapipe", "1"), ("nix", "1")]);
        let mut now = file(&[("nix", "1")]);
        assert_eq!(now.take_over(&earlier, false), ["lavapipe"]);
        assert_eq!(now, earlier);
    }

    #[test]
    fn another_driver_version_is_measured_anew_and_not_compared() {
        let earlier = file(&[("nix", "1")]);
        let mut written = file(&[("nix", "2")]);
        assert!(written.take_over(&earlier, false).is_empty());
        assert_eq!(written.drivers[0].1, "2");
        let mut compared = file(&[("nix", "2"), ("new", "1")]);
        assert_eq!(compared.take_over(&earlier, true), ["nix"]);
        assert_eq!(compared, earlier);
    }

    #[test]
    fn nothing_is_taken_over_from_another_definition() {
        let earlier = File { definition: "1".to_owned(), ..file(&[("nix", "1")]) };
        assert!(file(&[]).take_over(&earlier, true).is_empty());
    }
}
