//! An explanation as text.

use super::{Decision, Explanation, Outcome, Step};
use std::fmt::Write;

/// The report, a line feed at its end.
#[must_use]
pub fn render(found: &Explanation) -> String {
    let mut out = format!("{} on {}, {}\n", found.kernel, found.route, found.arguments);
    for result in &found.results {
        out += &outcome(result);
    }
    let _ = writeln!(
        out,
        "  {} numbers written down, {} operations judged on the operands that the route had",
        found.records, found.judged
    );
    if !found.same_bits {
        out += "  without the traces the route returns other bits: it compiles the kernel differently then\n";
    }
    out += &breaches(found);
    out += &shares(found);
    out
}

fn outcome(result: &Outcome) -> String {
    let name = if result.path.is_empty() { "result" } else { &result.path };
    let limit = |what: &str, limit: Option<f64>| limit.map_or(String::new(), |x| format!(", {what} {x:.3e}"));
    format!(
        "  {name} {}, exact {}: off by {:.3e} ({:.1} ULP{}{})\n",
        result.value,
        result.exact,
        result.error.abs(),
        result.ulp,
        limit("permitted", result.permitted),
        limit("budget", result.budget)
    )
}

/// What breaks the rules.
fn breaches(found: &Explanation) -> String {
    let mut out = String::new();
    if let Some(step) = &found.broken {
        out += &format!("\nthe first operation that breaks its rule:\n{}", self::step(step));
    }
    if let Some(step) = found.outside.as_ref().filter(|s| found.broken.as_ref().is_none_or(|b| !same(b, s))) {
        out += &format!("\nthe first value outside what any driver may compute:\n{}", self::step(step));
    }
    if let Some(Decision { step, ambiguous }) = &found.decision {
        let may = if *ambiguous { "drivers may take it either way" } else { "no driver may" };
        out += &format!("\na decision that the interpreter takes otherwise ({may}):\n{}", self::step(step));
    }
    if out.is_empty() {
        out = "\nevery operation keeps its rule\n".to_owned();
    }
    out
}

fn same(a: &Step, b: &Step) -> bool {
    (&a.function, &a.naga, a.execution) == (&b.function, &b.naga, b.execution)
}

/// Where the error comes from.
fn shares(found: &Explanation) -> String {
    let result = &found.results[found.explained];
    let percent = |x: f64| if result.error != 0.0 { (100.0 * x / result.error).round() + 0.0 } else { 0.0 };
    let Some(first) = found.shares.first() else {
        return "\nno operation's error reaches the result\n".to_owned();
    };
    let part = |step: &Step| percent(step.effect.unwrap_or(0.0));
    let mut out = format!("\nthe error enters here ({:.0} % of the result's):\n{}", part(first), step(first));
    for next in &found.shares[1..] {
        let _ = writeln!(out, "  then {:.0} % at {}", part(next), brief(next));
    }
    let _ = writeln!(out, "  the formula itself, and what is left: {:.0} %", percent(found.formula_error));
    if found.left_out > 0 {
        let _ = writeln!(out, "  {} smaller errors were not put in", found.left_out);
    }
    out
}

fn brief(step: &Step) -> String {
    let text = step.rust.as_deref().unwrap_or(&step.naga);
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let text =
        if text.chars().count() > 60 { text.chars().take(58).collect::<String>() + ".." } else { text };
    let place = step.place.as_deref().unwrap_or(&step.function);
    let execution =
        if step.execution > 1 { format!(" (execution {})", step.execution) } else { String::new() };
    format!("`{text}`  {place}{execution}")
}

fn step(step: &Step) -> String {
    let mut out = format!("  {}\n", brief(step));
    let mut row = |name: &str, text: &str| {
        let _ = writeln!(out, "    {name:10} {text}");
    };
    row("naga", &format!("{}: {}", step.function, step.naga));
    for line in &step.lines {
        row(line.target.title(), &format!("line {}: {}", line.line, line.text));
    }
    for operand in &step.operands {
        let name = operand.rust.as_deref().map(|t| format!("{t} = ")).unwrap_or_default();
        row("operand", &format!("{name}{}", operand.values.join(", ")));
    }
    row("value", &step.value);
    if let Some(exact) = &step.exact {
        row("exact", exact);
    }
    if let Some(ulp) = step.ulp {
        let permitted =
            step.permitted_ulp.map_or("nothing is promised".to_owned(), |p| format!("permitted {p:.1}"));
        row("error", &format!("{ulp:.1} ULP, {permitted}"));
    }
    if let Some([low, high]) = &step.permitted {
        row("permitted", &format!("{low} ..= {high}"));
    }
    if let Some([low, high]) = &step.permitted_from_arguments {
        row("in all", &format!("{low} ..= {high} from the arguments on"));
    }
    if step.contracted {
        row("", "a product and a sum were contracted, as is permitted");
    }
    if step.reordered {
        row("", "the terms of a sum were taken in another order, as is permitted");
    }
    row("rule", &step.rule);
    out
}
