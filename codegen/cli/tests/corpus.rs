//! Modules of our own that cover all that the interpreter executes (`tests/cases/corpus`), as a user would run them: on
//! every route of this machine, by the interpreter's judge, and on drivers drawn by chance.
//!
//! Integers are the same bits, floats are within the bound that is derived, or that the module states where none is.
//! What drivers and compilers get wrong is in `tests/cases/expectations.toml`.

mod common;

use common::{lobe, text};
use serde_json::Value;
use std::collections::BTreeSet;

const CORPUS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/cases/corpus");
const EXPECTATIONS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/cases/expectations.toml");

/// Fewer modules than this would not cover the operations.
const FEWEST: usize = 80;

/// The reports of all modules, with these options.
fn reports(options: &[&str]) -> Vec<Value> {
    let args = [&["run", "--batch", CORPUS, "--format", "json", "--timeout", "60"], options].concat();
    let said = text(&lobe(&args).stdout);
    let lines = said.lines().map(|line| serde_json::from_str(line).expect("JSON"));
    lines.filter(|line: &Value| line["file"].is_string()).collect()
}

/// What is wrong with a report; a module that is refused lies in the folder of those.
fn faults(report: &Value) -> Vec<String> {
    let (file, status) = (report["file"].as_str().unwrap_or_default(), &report["status"]);
    if file.contains("/refused/") {
        let is_refused = *status == "refused";
        return if is_refused { Vec::new() } else { vec![format!("{file} is {status}, not refused")] };
    }
    if !report["message"].is_null() {
        return vec![format!("{file} is {status}: {}", report["message"])];
    }
    let routes = report["routes"].as_array().into_iter().flatten();
    let bad = routes.filter(|route| !holds(route));
    bad.map(|route| format!("{file} by {route}")).collect()
}

fn holds(route: &Value) -> bool {
    let is_drawn = route["route"].as_str().is_some_and(|name| name.starts_with("perturbed"));
    match route["status"].as_str() {
        Some("equal" | "within") => true,
        // An integer that depends on how floats were rounded has no one value.
        Some("unjudged") if is_drawn => true,
        _ => route["expected"].is_string(),
    }
}

fn assert_all_hold(reports: &[Value]) {
    assert!(reports.len() >= FEWEST, "{} modules, there should be {FEWEST}", reports.len());
    let faults: Vec<String> = reports.iter().flat_map(faults).collect();
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn every_route_agrees_with_the_interpreter() {
    let reports = reports(&["--expectations", EXPECTATIONS, "--route", "ready"]);
    assert_all_hold(&reports);
    let names = reports.iter().flat_map(|r| r["routes"].as_array().into_iter().flatten());
    let names: BTreeSet<&str> = names.filter_map(|route| route["route"].as_str()).collect();
    if !["spirv@lavapipe", "wgsl+naga@lavapipe", "hlsl+dxc@lavapipe"].iter().all(|name| names.contains(name))
    {
        common::skip(&format!("lavapipe and DXC, among {names:?}"), "run tests/setup.sh");
    }
}

#[test]
fn the_judge_and_drivers_drawn_by_chance_agree_with_the_interpreter() {
    let drawn = ["judge", "perturbed:1", "perturbed:2", "perturbed:3"].map(|name| ["--route", name]);
    assert_all_hold(&reports(drawn.as_flattened()));
}

#[test]
fn drivers_drawn_by_chance_stay_within_the_bound_on_the_edges_of_types_too() {
    let args = ["run", "--batch", CORPUS, "--check", "--inputs", "40", "--drivers", "4", "--route", "interp"];
    let said = text(&lobe(&[&args[..], &["--format", "json"]].concat()).stdout);
    let report: Value = serde_json::from_str(&said).expect("JSON");
    let kernels = report["kernels"].as_array().expect("modules");
    let drawn =
        kernels.iter().flat_map(|k| k["answers"].as_array().into_iter().flatten().map(move |a| (k, a)));
    let drawn: Vec<(&Value, &Value)> = drawn.filter(|(_, a)| a["subject"] == "perturbed").collect();
    assert!(drawn.len() >= FEWEST, "{} modules, there should be {FEWEST}", drawn.len());
    for (module, answer) in drawn {
        assert_eq!(answer["verdict"], "holds", "{}: {answer}", module["name"]);
    }
}

#[test]
fn every_module_can_be_looked_through_for_mistakes() {
    let reports = reports(&["--route", "interp", "--sanitize"]);
    let is_fine = |r: &&Value| ["ok", "findings", "refused"].iter().any(|status| r["status"] == *status);
    let bad: Vec<&Value> = reports.iter().filter(|r| !is_fine(r)).collect();
    assert!(bad.is_empty(), "{bad:?}");
}

#[test]
fn a_fault_that_is_gone_or_not_expected_would_be_found() {
    let route = |status: &str| serde_json::json!({ "route": "spirv@x", "status": status });
    let report = |route: Value| serde_json::json!({ "file": "a.wgsl", "status": "ok", "routes": [route] });
    for (status, is_fine) in [("equal", true), ("beyond", false), ("refused", false), ("unexpected", false)] {
        assert_eq!(faults(&report(route(status))).is_empty(), is_fine, "{status}");
    }
}
