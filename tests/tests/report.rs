//! Reports as others read them: JSON by its schema, the page as a browser shows it.

mod common;

use common::{Spoilt, browser, plan};
use lobe_backends::executor::{Executor, Interp, Native};
use lobe_codegen::prelude::*;
use lobe_tests::judge::{Plan, judge};
use lobe_tests::question::{Answer, Question, Verdict};
use lobe_tests::report::part::Share;
use lobe_tests::report::{Report, Skipped, html, json};
use lobe_tests::search::Limit;
use serde_json::Value;
use std::path::Path;

/// Doubles a part of a lobe.
#[kernel(family = "first", domain(x = -10.0..=10.0, n = 0..=9), budget(1e-6 * abs(result) + 1e-30))]
fn scaled(x: f32, n: u32) -> f32 {
    x / 3.0 + n as f32
}

/// Cancels, and says so.
#[kernel(domain(x = 1e3..=1e6), budget(1e-6 * abs(result)), not_robust = "a difference of near values")]
fn cancels(x: f32) -> f32 {
    (x * 1.1 + 1.0) - x * 1.1
}

/// Gives birth to a NaN where x is 0.
#[kernel(domain(x = 0.0..=1.0))]
fn makes_mistakes(x: f32) -> f32 {
    x * 2.0 / x
}

/// A text that would end a script, and an attribute.
const HOSTILE: &str = "\"><script>alert(1)</script><!--{{report}}";

/// A report with all that a report may hold: failures and expected ones, finds, mistakes, infinities, what is missing.
fn report() -> Report {
    let mut report = Report::new("check", 7);
    report.routes = ["native", "interp", "spirv@broken"].map(str::to_owned).to_vec();
    report.drivers.insert("broken".to_owned(), "a card, 1.0".to_owned());
    report.skipped = vec![Skipped {
        route: "spirv@lavapipe".to_owned(),
        what: "no driver".to_owned(),
        mend: "install it".to_owned(),
    }];
    report.model = Some("vulkan".to_owned());
    report.part = "1/2".parse().ok().map(|share: Share| share.part(vec!["scaled".to_owned()], 200));
    report.missing.push("2/2 of lobe check".to_owned());
    report.unmapped.insert("gamma (formula-f64)".to_owned(), 3);
    let plan = Plan { sanitize: true, drivers: 3, search: Some(Limit::Rounds(2)), ..plan(200) };
    for kernel in lobe_codegen::kernels![scaled, cancels, makes_mistakes] {
        let broken = Spoilt {
            route: "spirv@broken".parse().expect("a route"),
            spoil: spoil_last,
            driver: "a card, 1.0",
        };
        let mut routes: [Box<dyn Executor>; 3] = [Box::new(Native), Box::new(Interp), Box::new(broken)];
        report.kernels.push(judge(kernel, &plan, &mut routes, &|_| {}));
    }
    report
}

fn spoil_last(output: &mut lobe_codegen::data::Columns) {
    output.columns[0].iter_mut().last().into_iter().for_each(|word| *word = f32::NAN.to_bits());
}

fn hostile() -> Report {
    let mut report = report();
    report.kernels[0].name = HOSTILE.to_owned();
    report.kernels[0].answers.push(Answer::bare(
        Question::Correct,
        HOSTILE,
        Verdict::FallsShort(format!("because {HOSTILE}")),
    ));
    report
}

fn schema() -> jsonschema::Validator {
    let text = include_str!("../schema/report-1.json");
    let schema: Value = serde_json::from_str(text).expect("JSON");
    jsonschema::validator_for(&schema).expect("a schema")
}

#[track_caller]
fn assert_follows(text: &str) -> Value {
    let value: Value = serde_json::from_str(text).expect("JSON");
    let errors: Vec<String> =
        schema().iter_errors(&value).map(|e| format!("{}: {e}", e.instance_path())).collect();
    assert!(errors.is_empty(), "{}", errors.join("\n"));
    value
}

#[test]
fn every_report_follows_its_schema() {
    let report = report();
    let value = assert_follows(&json::render(&report));
    let text = value.to_string();
    for part in
        ["falls_short", "expected_failure", "not_asked", "\"inf\"", "sanitized", "finds", "distribution"]
    {
        assert!(text.contains(part), "the report shows no {part}, so the schema was not asked about it");
    }
    assert_follows(&json::render(&hostile()));
    assert_follows(&json::render(&Report::new("oracle", 0)));
}

#[test]
fn the_schema_knows_every_member_and_describes_it() {
    let mut value = assert_follows(&json::compact(&report()));
    let places =
        ["", "/kernels/0", "/kernels/0/answers/0", "/kernels/0/search", "/part", "/tightness", "/tally"];
    for place in places {
        let object = value.pointer_mut(place).and_then(Value::as_object_mut).expect("an object");
        object.insert("unknown".to_owned(), Value::Null);
        assert!(!schema().is_valid(&value), "{place:?} may have members that the schema does not know");
        value.pointer_mut(place).and_then(Value::as_object_mut).expect("an object").remove("unknown");
    }
    assert!(schema().is_valid(&value));
}

#[test]
fn schemas_are_schemas_and_describe_every_member() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("schema");
    let mut n = 0;
    for entry in std::fs::read_dir(folder).expect("readable") {
        let path = entry.expect("an entry").path();
        let text = std::fs::read_to_string(&path).expect("readable");
        let schema: Value = serde_json::from_str(&text).expect("JSON");
        assert!(jsonschema::meta::is_valid(&schema), "{}: no schema", path.display());
        assert_described(&schema, &path.display().to_string());
        n += 1;
    }
    assert!(n > 5, "only {n} schemas");
}

/// Each member has a description, of its own or that of what it refers to.
fn assert_described(value: &Value, path: &str) {
    for (name, part) in value.as_object().into_iter().flatten() {
        let path = format!("{path}/{name}");
        if name == "properties" {
            for (member, schema) in part.as_object().into_iter().flatten() {
                let is_described = schema.get("description").is_some() || schema.get("$ref").is_some();
                assert!(path.contains("/if") || path.contains("/then") || is_described, "{path}/{member}");
            }
        }
        assert_described(part, &path);
    }
}

/// The report within a page.
fn embedded(page: &str) -> Value {
    let (_, rest) = page.split_once("<script type=\"application/json\" id=\"report\">").expect("a report");
    let (text, _) = rest.split_once("</script>").expect("an end");
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn a_page_holds_the_report_and_nothing_of_it_is_markup() {
    let report = hostile();
    let page = html::render(&report);
    let value: Value = serde_json::from_str(&json::compact(&report)).expect("JSON");
    assert_eq!(embedded(&page), value);
    assert_eq!(page.matches("</script>").count(), 2, "the report and the script end, and nothing else does");
    assert!(!page.contains("<script>alert"));
    for loading in ["src=", "href=", "url(", "@import", "fetch("] {
        assert!(!page.contains(loading), "the page loads something: {loading}");
    }
}

#[test]
fn a_browser_shows_the_matrix_and_the_details_of_the_cell_that_the_address_names() {
    let page = html::render(&report());
    let Some(shown) = browser::show(&page, "#scaled/conformant%20spirv%40broken", "") else { return };
    for part in [
        "<title>Lobe check: ✗ ",
        "a card, 1.0",
        "spirv@lavapipe",
        "accuracy model vulkan",
        "rows lie outside the derived bound",
        "How rows use the bound",
        "lobe explain scaled --input",
        "lobe eval scaled --args - --hex --route spirv@broken",
        "a difference of near values",
    ] {
        assert!(shown.contains(part), "the page shows no {part:?}");
    }
    assert!(shown.contains("aria-selected=\"true\""), "the cell is not marked");
}

#[test]
fn a_browser_takes_hostile_names_for_texts() {
    let page = html::render(&hostile());
    let script = "
        const name = document.querySelector('#matrix tbody th').firstChild.data;
        document.body.dataset.told = `${document.scripts.length} ${name === report.kernels[0].name}`;
    ";
    let Some(shown) = browser::show(&page, "#", script) else { return };
    assert!(shown.contains("data-told=\"2 true\""), "a name became markup: {shown}");
}

#[test]
fn a_browser_filters_sorts_and_is_walked_by_keys() {
    let script = "
        const told = [];
        const names = () => [...document.querySelectorAll('#matrix tbody th')].map((th) => th.firstChild.data).join(' ');
        const key = (key) => document.activeElement.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
        told.push(names());
        key('f'); told.push(names()); key('f');
        filter.value = 'NEAR values'; filter.dispatchEvent(new Event('input')); told.push(names());
        filter.value = ''; filter.dispatchEvent(new Event('input'));
        sort.value = 'name'; sort.dispatchEvent(new Event('change')); told.push(names());
        document.querySelector('#matrix tbody th').focus();
        key('ArrowDown'); key('ArrowRight'); key('Enter'); // Nothing stands there.
        key('ArrowDown'); key('Enter');
        told.push(decodeURIComponent(location.hash));
        addEventListener('hashchange', () => {
            told.push(document.querySelector('#detail h2').firstChild.data);
            key('Escape');
            told.push(document.getElementById('detail').hidden);
            document.body.dataset.told = told.join('; ');
        });
    ";
    let mut report = report();
    report.kernels[2].answers.retain(|answer| answer.verdict == Verdict::Holds);
    let Some(shown) = browser::show(&html::render(&report), "", script) else { return };
    let (_, rest) = shown.split_once("data-told=\"").unwrap_or_else(|| panic!("nothing is told by {shown}"));
    let told: Vec<&str> = rest.split_once('"').expect("an end").0.split("; ").collect();
    let wanted = [
        "scaled cancels makes_mistakes",
        "scaled cancels",
        "cancels",
        "cancels makes_mistakes scaled",
        "#scaled/correct",
        "scaled",
        "true",
    ];
    assert_eq!(told, wanted);
}
