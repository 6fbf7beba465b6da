//! A check of golden images for people.

use super::report::{Change, Item, Report, RouteReport, RouteVerdict, Verdict};
use std::fmt::Write;

/// A case: a line, and what is to be said of it.
#[must_use]
pub fn item(item: &Item) -> String {
    let [width, height] = item.size;
    let mut text = format!("{:12} {:32} {width} x {height}", item.verdict.name(), item.name());
    if let Some(worst) = item.routes.iter().max_by(|a, b| a.shares[3].0.total_cmp(&b.shares[3].0)) {
        let _ =
            write!(text, ", {} routes, share {:.3} by {}", item.routes.len(), worst.shares[3].0, worst.route);
        let unknown = item.routes.iter().map(|route| route.pixels.indeterminate).max().unwrap_or_default();
        if unknown > 0 {
            let _ = write!(text, ", {unknown} pixels without bound");
        }
    }
    text.push('\n');
    if let Some(proof) = item.proof.as_ref().filter(|_| !item.rendered) {
        let _ = writeln!(text, "             {proof}");
    }
    if !item.why.is_empty() {
        let _ = writeln!(text, "             {}", item.why);
    }
    item.routes.iter().filter_map(route).for_each(|line| {
        let _ = writeln!(text, "             {line}");
    });
    text
}

/// A route of which something is to be said.
fn route(route: &RouteReport) -> Option<String> {
    let changed = match route.change {
        Change::Same | Change::New => None,
        Change::Mathematics => Some("other bits: the mathematics changed"),
        Change::Emission => Some("other bits: what is emitted changed"),
        Change::Driver => Some("other bits: the driver changed"),
        Change::Unexplained => Some("other bits, of the same text on the same driver"),
    };
    let verdict = match route.verdict {
        RouteVerdict::Inside => None,
        RouteVerdict::Outside | RouteVerdict::Failed => Some(route.why.as_str()),
        RouteVerdict::Indeterminate => Some("too many pixels without bound"),
    };
    let said: Vec<&str> = verdict.into_iter().chain(changed).collect();
    (!said.is_empty()).then(|| format!("{}: {}", route.route, said.join("; ")))
}

/// The last lines.
#[must_use]
pub fn summary(report: &Report) -> String {
    let mut text = String::new();
    for skipped in &report.skipped {
        let _ = writeln!(text, "skipped      {}: {} ({})", skipped.route, skipped.what, skipped.mend);
    }
    for dead in &report.dead {
        let _ = writeln!(text, "dead         {dead}: no case names it; `lobe golden prune` removes it");
    }
    if report.interrupted {
        text += "interrupted  a decision was broken off: run `lobe golden check` where it may write\n";
    }
    let tally = &report.tally;
    let good = tally.holds + tally.restated;
    let _ = writeln!(
        text,
        "{good} hold, {} do not, {} bytes of goldens",
        report.items.len() - good,
        report.bytes
    );
    let decided = |item: &&Item| {
        matches!(item.verdict, Verdict::Missing | Verdict::Changed | Verdict::Damaged | Verdict::Restated)
    };
    if let (Some(folder), Some(first)) = (&report.pending, report.items.iter().find(decided)) {
        let name = first.name();
        let _ =
            writeln!(text, "{folder} holds what is to be decided: lobe golden accept {name} --reason WHY");
    }
    text
}
