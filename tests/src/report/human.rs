//! The report as text: a block for each kernel, a line for each answer.

use super::{KernelReport, Report, Skipped};
use crate::perturbed::{Overall, Tightness};
use crate::question::{Answer, Question, Verdict, Worst};
use crate::search::{Aim, Found};
use std::fmt::Write;

/// How to write.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Style {
    /// With terminal colours.
    pub colour: bool,
    /// With the worst row of every answer, not only of those that fall short.
    pub worst: bool,
}

#[derive(Clone, Copy)]
enum Paint {
    Good,
    Bad,
    Dim,
    Strong,
}

impl Style {
    fn paint(self, paint: Paint, text: &str) -> String {
        let code = match paint {
            Paint::Good => "32",
            Paint::Bad => "31;1",
            Paint::Dim => "2",
            Paint::Strong => "1",
        };
        if self.colour { format!("\x1b[{code}m{text}\x1b[0m") } else { text.to_owned() }
    }
}

/// The whole report.
#[must_use]
pub fn render(report: &Report, style: Style) -> String {
    let mut out = String::new();
    for kernel in &report.kernels {
        out += &render_kernel(kernel, style);
    }
    out += &summary(report, style);
    out
}

/// The block of one kernel.
#[must_use]
pub fn render_kernel(kernel: &KernelReport, style: Style) -> String {
    let mut out = style.paint(Paint::Strong, &kernel.name);
    let about = [kernel.cite.clone(), inputs(kernel)];
    for part in about.iter().filter(|part| !part.is_empty()) {
        let _ = write!(out, "   {part}");
    }
    out.push('\n');
    for answer in &kernel.answers {
        out += &line(answer, style);
        if (style.worst || answer.falls_short())
            && let Some(worst) = &answer.worst
        {
            let _ = writeln!(out, "               {}", worst_line(&kernel.name, worst));
        }
    }
    kernel.tightness.iter().for_each(|tightness| out += &tight(tightness));
    kernel.search.iter().for_each(|found| out += &searched(&kernel.name, found));
    out
}

/// How tight the bounds are.
fn tight(tightness: &Tightness) -> String {
    let Tightness { drivers, least, median, most, .. } = tightness;
    format!(
        "     {:<10} {} x the worst of {drivers} drivers in the median, {} to {} in 95 %\n",
        "tightness",
        short(*median),
        short(*least),
        short(*most)
    )
}

/// What a search found beyond the rows that were drawn.
fn searched(kernel: &str, found: &Found) -> String {
    let mut out = format!("     {:<10} {} rows near the worst\n", "search", found.rows);
    for find in &found.finds {
        let what = match find.aim {
            Aim::Bound => "bound, of the budget or the value",
            Aim::Error => "error, of the bound",
            Aim::Difference => "between routes, in ULP",
        };
        let (drawn, worst) = (short(find.drawn), short(find.found));
        let _ = match find.is_new() {
            true => writeln!(
                out,
                "               {what}: {drawn} drawn, {worst} found   echo '{}' | lobe eval {kernel} --args -",
                find.args
            ),
            false => writeln!(out, "               {what}: {drawn} drawn, nothing worse found"),
        };
    }
    out
}

fn inputs(kernel: &KernelReport) -> String {
    match (kernel.inputs, kernel.listed) {
        (0, _) => String::new(),
        (n, 0) => format!("{n} inputs"),
        (n, listed) => format!("{n} inputs, {listed} of them listed"),
    }
}

fn line(answer: &Answer, style: Style) -> String {
    let (mark, note) = match &answer.verdict {
        Verdict::Holds => (style.paint(Paint::Good, "ok"), String::new()),
        Verdict::FallsShort(why) => (style.paint(Paint::Bad, "NO"), why.clone()),
        Verdict::ExpectedFailure(why) => (style.paint(Paint::Dim, "no"), format!("expected: {why}")),
        Verdict::NotAsked(why) => (style.paint(Paint::Dim, "--"), style.paint(Paint::Dim, why)),
    };
    let parts = [answer.subject.clone(), figures(answer), counts(answer), note];
    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    format!("  {mark} {:<10} {}\n", answer.question.name(), parts.join("   "))
}

fn figures(answer: &Answer) -> String {
    if answer.worst.is_none() || answer.question == Question::Agree {
        return String::new();
    }
    let what = match answer.question {
        Question::Robust => "of the budget",
        Question::Conformant => "of the bound",
        Question::Correct | Question::Agree => "of the permitted",
    };
    let spread = answer
        .distribution
        .as_ref()
        .map(|d| format!(" (half of the rows {}, 99 % {})", short(d.median), short(d.p99)));
    format!(
        "{} {what}{}   worst {} ULP, abs {}, rel {}",
        short(answer.share),
        spread.unwrap_or_default(),
        short(answer.ulp),
        short(answer.absolute),
        short(answer.relative)
    )
}

fn counts(answer: &Answer) -> String {
    let named = [(answer.ambiguous, "ambiguous"), (answer.indeterminate, "without a bound")];
    let named = named.iter().filter(|(n, _)| *n > 0).map(|(n, name)| format!("{n} {name}"));
    let cases =
        (answer.question == Question::Correct && answer.cases > 0).then(|| format!("{} rows", answer.cases));
    cases.into_iter().chain(named).collect::<Vec<_>>().join(", ")
}

/// The row at which an answer is worst, and how to run it again.
#[must_use]
pub fn worst_line(kernel: &str, worst: &Worst) -> String {
    let leaf = if worst.leaf.is_empty() { "result" } else { &worst.leaf };
    let again = match &worst.again {
        Some(command) => command.clone(),
        None => format!("echo '{}' | lobe eval {kernel} --args -", worst.args),
    };
    let (found, wanted) = (precise(worst.found), precise(worst.wanted));
    format!("{leaf} is {found}, wanted {wanted} ± {}   {again}", short(worst.permitted))
}

/// What a run came to.
#[must_use]
pub fn summary(report: &Report, style: Style) -> String {
    let tally = report.tally();
    let mut out = String::new();
    for skipped in &report.skipped {
        out += &skip_line(skipped, style);
    }
    for (function, rows) in &report.unmapped {
        let _ = writeln!(out, "  skipped    {rows} rows of {function}: no kernel is mapped to it");
    }
    if let Some(Overall { kernels, runs, median, most }) = report.tightness() {
        let (median, most) = (short(median), short(most));
        let _ = writeln!(
            out,
            "  tightness  the bounds of {kernels} kernels are {median} x the worst of {runs} permitted runs in the \
             median, {most} x at 95 % of the kernels"
        );
    }
    for part in &report.missing {
        let _ = writeln!(out, "  missing    {part}: no report of it is there");
    }
    let verdict = if report.holds() {
        style.paint(Paint::Good, "all holds")
    } else if tally.fall_short > 0 {
        style.paint(Paint::Bad, &format!("{} fall short", tally.fall_short))
    } else if !report.missing.is_empty() {
        style.paint(Paint::Bad, &format!("{} parts are missing", report.missing.len()))
    } else {
        style.paint(Paint::Bad, "nothing was asked")
    };
    let model = report.model.as_ref().map(|name| format!(", accuracy model {name}")).unwrap_or_default();
    let _ = writeln!(
        out,
        "{} {}, seed {}{model}: {verdict} ({} hold, {} expected failures, {} not asked, {} routes skipped)",
        report.kernels.len(),
        if report.command == "run" { "entry points" } else { "kernels" },
        report.seed,
        tally.hold,
        tally.expected_failures,
        tally.not_asked,
        report.skipped.len()
    );
    out
}

fn skip_line(skipped: &Skipped, style: Style) -> String {
    let text = format!("skipped {}: {}; {}", skipped.route, skipped.what, skipped.mend);
    format!("  {}\n", style.paint(Paint::Strong, &text))
}

fn short(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        a if (0.01..1000.0).contains(&a) => format!("{value:.2}"),
        a if a.is_finite() => format!("{value:.1e}"),
        _ => value.to_string(),
    }
}

fn precise(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        format!("{value:.9}")
    } else {
        format!("{value:.8e}")
    }
}
