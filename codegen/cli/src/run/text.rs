//! Reports of runs, for people and for programs.

use crate::output::{Format, json_line};
use lobe_tests::shader::compare::Compared;
use lobe_tests::shader::report::{Mistake, Report, RouteReport, Status};
use serde_json::json;
use std::collections::BTreeMap;

/// Version of the format.
const SCHEMA: u32 = 1;

/// A report as a line of JSON.
pub(super) fn json(report: &Report) -> String {
    json_line(SCHEMA, report)
}

/// A report as a line.
pub(super) fn line(report: &Report) -> String {
    let mut text = format!("{:8} {}", report.status.name(), report.subject());
    if let Some(message) = &report.message {
        text += &format!(": {}", brief(message));
    }
    if let Some(first) = report.findings.first() {
        text += &format!("; {} findings, {}", report.findings.len(), mistake(first));
    }
    for found in report
        .routes
        .iter()
        .filter(|r| r.expected.is_none())
        .filter(|r| r.message.is_some() || r.buffers.iter().any(is_worth))
    {
        let why = found.message.as_deref().map(brief).unwrap_or_default();
        let buffers: Vec<String> = found.buffers.iter().filter(|b| is_worth(b)).map(buffer).collect();
        text += &format!("; {} {} {why}{}", found.route, found.status.name(), buffers.join(", "));
    }
    text + "\n"
}

/// A message of a compiler in one line: what is wrong, where, and its last note.
fn brief(message: &str) -> String {
    let mut lines = message.lines().map(str::trim).filter(|l| !l.is_empty());
    let first = lines.next().unwrap_or_default().to_owned();
    let mut place = "";
    let mut note = "";
    for line in lines {
        place = line.split_once("┌─ ").map_or(place, |(_, at)| at);
        note = line.strip_prefix("= ").unwrap_or(note);
    }
    let place = if place.is_empty() { String::new() } else { format!(", at {place}") };
    let note = if note.is_empty() { String::new() } else { format!(", {note}") };
    first + &place + &note
}

/// A report with all that it says.
pub(super) fn whole(report: &Report) -> String {
    if report.inputs.is_empty() && report.routes.is_empty() {
        let message = report.message.as_deref().unwrap_or_default();
        return format!("{}: {}\n{message}\n", report.subject(), report.status.name());
    }
    let size = |sides: [u32; 3]| sides.map(|n| n.to_string()).join("x");
    let mut text = format!(
        "{}: {} workgroups of {} invocations{}\n",
        report.subject(),
        size(report.workgroups),
        size(report.workgroup_size),
        report.model.as_ref().map(|name| format!(", accuracy model {name}")).unwrap_or_default()
    );
    for input in &report.inputs {
        text += &format!("  input  {} ({}) {} bytes, {}\n", input.name, input.place, input.bytes, input.from);
    }
    report.routes.iter().for_each(|route| text += &one(route));
    report.findings.iter().for_each(|found| text += &format!("  {}\n", mistake(found)));
    if report.routes.is_empty() && report.message.is_none() {
        text += "  it ran on interp and was compared with no other route\n";
    }
    let message = report.message.as_ref().map(|m| format!(": {m}")).unwrap_or_default();
    text + &format!("{}{message}\n", report.status.name())
}

fn one(route: &RouteReport) -> String {
    let mut text = format!("  {:22} {}", route.route, route.status.name());
    if let Some(reason) = &route.expected {
        text += &format!(", as expected: {reason}");
    }
    if let Some(message) = &route.message {
        text += &format!(": {}", message.trim_end().replace('\n', "\n    "));
    }
    for found in &route.buffers {
        text += &format!("\n    {}", buffer(found));
    }
    text + "\n"
}

pub(super) fn mistake(found: &Mistake) -> String {
    let at = found.at.map(|(line, column)| format!(" at {line}:{column}")).unwrap_or_default();
    format!("finding {}{at}: {}", found.kind, found.message)
}

/// Whether a line has something to say about a buffer.
fn is_worth(compared: &Compared) -> bool {
    compared.differing > 0
}

pub(super) fn buffer(compared: &Compared) -> String {
    let Compared { buffer, scalars, differing, max_ulp, .. } = compared;
    let Some(first) = &compared.first else {
        return format!("{buffer}: {scalars} scalars equal");
    };
    let ulp = first.ulp.map(|n| format!(", {n} ULP apart")).unwrap_or_default();
    let bound = first.bound.map(|b| format!(", bound {b:e}")).unwrap_or_default();
    let most = if *max_ulp > 0 { format!(", by at most {max_ulp} ULP") } else { String::new() };
    let (path, interp, found) = (&first.path, &first.interp, &first.found);
    format!(
        "{buffer}: {differing} of {scalars} scalars differ{most}; {path} is {found}, on interp {interp}{ulp}{bound}"
    )
}

/// How many ended how.
pub(super) fn summary(tally: &BTreeMap<Status, usize>, format: Format) -> String {
    let runs: usize = tally.values().sum();
    match format {
        Format::Json | Format::Junit => {
            let counts: BTreeMap<&str, usize> = tally.iter().map(|(s, n)| (s.name(), *n)).collect();
            json_line(SCHEMA, &json!({ "summary": { "runs": runs, "counts": counts } }))
        }
        Format::Human => {
            let counts: Vec<String> = tally.iter().map(|(s, n)| format!("{n} {}", s.name())).collect();
            format!("{runs} runs: {}\n", counts.join(", "))
        }
    }
}
