//! `lobe list --operations`: what specifications permit drivers.

use crate::output::ListFormat;
use lobe_codegen::accuracy::{Accuracy, Model, Rounding, Row, Subnormal};
use serde_json::{Value, json};
use std::fmt::Write;

/// The tables of `models`.
pub(crate) fn listing(models: &[&Model], format: ListFormat) -> String {
    match format {
        ListFormat::Human => models.iter().map(|model| human(model)).collect::<Vec<_>>().join("\n"),
        ListFormat::Json => {
            let models: Vec<Value> = models.iter().map(|model| as_json(model)).collect();
            format!("{:#}\n", json!({ "schema": 1, "models": models }))
        }
    }
}

fn human(model: &Model) -> String {
    let mut out = format!("{}: {}\n", model.name, model.title);
    for (what, says, section) in rules(model) {
        let _ = writeln!(out, "    {what:<14} {says}   [{section}]");
    }
    for row in model.rows() {
        let half = if row.f16 == row.f32 { String::new() } else { format!("; f16: {}", worst(row.f16)) };
        let name = row.operation.to_string();
        let _ = writeln!(out, "    {name:<14} {}{half}   [{}]", worst(row.f32), row.section);
    }
    out
}

fn as_json(model: &Model) -> Value {
    let rules = rules(model)
        .map(|(what, says, section)| (what.to_owned(), json!({ "is": says, "section": section })));
    json!({
        "name": model.name,
        "title": model.title,
        "rules": Value::Object(rules.into_iter().collect()),
        "operations": model.rows().iter().map(operation).collect::<Vec<_>>(),
    })
}

fn operation(row: &Row) -> Value {
    let classes = |classes: &[Accuracy]| classes.iter().map(ToString::to_string).collect::<Vec<_>>();
    json!({
        "operation": row.operation.to_string(),
        "f32": classes(row.f32),
        "f16": classes(row.f16),
        "section": row.section,
    })
}

fn worst(classes: &[Accuracy]) -> String {
    let classes: Vec<String> = classes.iter().map(ToString::to_string).collect();
    match classes.as_slice() {
        [one] => one.clone(),
        all => format!("the worst of {}", all.join(" | ")),
    }
}

/// What a rule is about, what it says, and where that is said.
fn rules(model: &Model) -> [(&'static str, &'static str, &'static str); 5] {
    let subnormal = match model.rules.subnormal.0 {
        Subnormal::MayFlush => "may be flushed to zero",
        Subnormal::Flushed => "are flushed to zero",
    };
    let rounding = match model.rules.rounding.0 {
        Rounding::Either => "either neighbour",
        Rounding::Nearest => "the nearest",
    };
    let permitted = |is_so| if is_so { "permitted" } else { "not permitted" };
    let double = if model.rules.double.0 { "as f32, with its ULP" } else { "no promise" };
    [
        ("subnormal", subnormal, model.rules.subnormal.1),
        ("rounding", rounding, model.rules.rounding.1),
        ("contraction", permitted(model.rules.contraction.0), model.rules.contraction.1),
        ("reassociation", permitted(model.rules.reassociation.0), model.rules.reassociation.1),
        ("f64", double, model.rules.double.1),
    ]
}
