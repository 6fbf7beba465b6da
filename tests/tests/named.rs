//! Tests that `check!` writes: what they ask, how they fail, and what they leave for a report.
//!
//! `tests/own-kernels` has them run by cargo; kernels that fail are only here, and asked by hand.

use lobe_codegen::def::FunctionRef;
use lobe_codegen::prelude::*;
use lobe_tests::named::{Options, Tests};
use lobe_tests::question::Question;
use lobe_tests::report::{Report, merge};
use std::path::Path;

/// Doubles.
#[kernel(domain(x = -10.0..=10.0), budget(1e-6 * abs(result) + 1e-30))]
fn doubled(x: f32) -> f32 {
    x + x
}

/// Cancels: the budget leaves no room for it.
#[kernel(domain(x = 1e3..=1e6), budget(1e-6 * abs(result) + 1e-30))]
fn cancels(x: f32) -> f32 {
    (x * 1.1 + 1.0) - x * 1.1
}

/// States no domain.
#[kernel]
fn everywhere(x: f32) -> f32 {
    x
}

lobe_tests::check!(doubled, inputs = 300, seed = 9, routes = [native, interp]);

const DOUBLED: FunctionRef = lobe_tests::kernels![doubled][0];
const CANCELS: FunctionRef = lobe_tests::kernels![cancels][0];

fn tests(routes: &'static [&'static str], options: Options) -> Tests {
    let kernels = &["cancels", "doubled"];
    Tests { package: "mine", folder: "no-such-folder", module: "mine::check", kernels, routes, options }
}

const BOTH: &[&str] = &["native", "interp"];

fn report(kernel: FunctionRef, test: &str) -> Report {
    tests(BOTH, Options::new().inputs(500)).report(kernel, test).expect("a report")
}

#[test]
fn a_test_asks_what_it_is_named_after() {
    for (test, question, subject) in [
        ("robust", Question::Robust, ""),
        ("sanitized", Question::Robust, "sanitized"),
        ("native", Question::Conformant, "native"),
        ("interp", Question::Conformant, "interp"),
        ("agree", Question::Agree, "native = interp"),
    ] {
        let report = report(DOUBLED, test);
        let [answer] = &report.kernels[0].answers[..] else { panic!("{test}: {report:#?}") };
        assert_eq!(
            (answer.question, answer.subject.as_str(), answer.cases),
            (question, subject, 500),
            "{test}"
        );
        assert!(report.holds(), "{test}");
    }
    assert_eq!(report(DOUBLED, "robust").routes, Vec::<String>::new(), "no driver is opened");
}

#[test]
fn a_failure_says_what_lobe_check_says_and_how_to_run_it_again() {
    let tests = tests(BOTH, Options::new());
    let failure = format!("{:?}", tests.run(CANCELS, "robust").expect_err("a failure"));
    for part in [
        "cancels   4000 inputs",
        "NO robust",
        "the bound exceeds the budget on",
        "result is ",
        "mkdir -p tests/cases && echo '{\"x\":\"0x1.",
        " >> tests/cases/cancels.jsonl && cargo test -p mine check::cancels::robust",
    ] {
        assert!(failure.contains(part), "no `{part}` in {failure}");
    }
    let everywhere = lobe_tests::kernels![everywhere][0];
    let failure = format!("{:?}", tests.run(everywhere, "interp").expect_err("a failure"));
    assert!(failure.contains("no domain is stated for `x`"), "{failure}");
}

#[test]
fn what_is_no_route_or_model_is_named() {
    let failure =
        format!("{:?}", tests(&["metal_m1"], Options::new()).run(DOUBLED, "metal_m1").expect_err("none"));
    assert!(failure.contains("doubled: `metal_m1` names no route"), "{failure}");
    let failure = tests(BOTH, Options::new().model("opengl")).report(DOUBLED, "robust").expect_err("none");
    assert!(failure.contains("no accuracy model `opengl`; there are portable, "), "{failure}");
    let failure = tests(BOTH, Options::new().expectations("none.toml")).report(DOUBLED, "native");
    assert!(failure.expect_err("none").contains("none.toml: cannot be read"));
}

#[test]
fn a_missing_driver_is_told_and_asks_nothing() {
    let report = tests(&["spirv_no_such_card"], Options::new()).report(DOUBLED, "spirv_no_such_card");
    let report = report.expect("a report");
    assert_eq!((report.kernels.len(), report.skipped[0].route.as_str()), (0, "spirv@no-such-card"));
    assert!(report.skipped[0].what.contains("no Vulkan driver `no-such-card`"), "{report:?}");
}

#[test]
fn rows_and_known_faults_of_the_package_are_taken() {
    let package = tempfile::tempdir().expect("a folder").keep();
    let folder: &'static str = package.display().to_string().leak();
    let cases = package.join("tests").join("cases");
    std::fs::create_dir_all(&cases).expect("writable");
    std::fs::write(cases.join("doubled.jsonl"), "{\"x\": 3}\n{\"x\": \"0x1p-3\"}\n").expect("writable");
    let fault = "[[expected]]\nsubject = 'doubled'\nroute = 'interp'\nfails = 'beyond'\nreason = 'none'\n";
    std::fs::write(cases.join("expectations.toml"), fault).expect("writable");
    let tests = Tests { folder, ..tests(BOTH, Options::new().inputs(100)) };
    let native = tests.report(DOUBLED, "native").expect("a report");
    assert_eq!((native.kernels[0].inputs, native.kernels[0].listed, native.holds()), (102, 2, true));
    let interp = format!("{:?}", tests.run(DOUBLED, "interp").expect_err("a fault that is gone"));
    assert!(interp.contains("not beyond as expected (none): the expectation has to go"), "{interp}");
    std::fs::remove_dir_all(package).expect("removable");
}

#[test]
fn the_parts_of_tests_are_one_report_in_any_order() {
    let names = ["correct", "robust", "sanitized", "native", "interp", "agree"];
    let all = [("cancels", CANCELS), ("doubled", DOUBLED)];
    let parts = all
        .iter()
        .flat_map(|(name, kernel)| names.map(|test| (format!("{name}.{test}"), report(*kernel, test))));
    let mut parts: Vec<(String, Report)> = parts.collect();
    let text = |parts: &[(String, Report)]| {
        lobe_tests::report::json::render(&merge::merge(parts.to_vec()).expect("a report"))
    };
    let forth = text(&parts);
    parts.reverse();
    assert_eq!(text(&parts), forth);
    // A part that is there twice is there.
    parts.push(parts[3].clone());
    assert_eq!(text(&parts), forth);

    let merged = merge::merge(parts.clone()).expect("a report");
    let kernels: Vec<&str> = merged.kernels.iter().map(|kernel| kernel.name.as_str()).collect();
    assert_eq!((kernels, merged.routes.join(" ")), (vec!["cancels", "doubled"], BOTH.join(" ")));
    let subjects: Vec<&str> = merged.kernels[1].answers.iter().map(|a| a.subject.as_str()).collect();
    assert_eq!(subjects, ["no table", "", "sanitized", "native", "interp", "native = interp"]);
    assert!(merged.part.is_none() && merged.missing.is_empty() && !merged.holds(), "cancels does not hold");
}

#[test]
fn parts_that_are_not_of_one_run_are_refused_and_missing_ones_told() {
    let named = |name: &str, report: Report| (name.to_owned(), report);
    let native = report(DOUBLED, "native");
    let merged = merge::merge(vec![named("a", native.clone())]).expect("a report");
    assert_eq!((merged.missing.len(), merged.holds()), (11, false));
    assert!(
        merged.missing.contains(&"doubled::robust of mine mine::check".to_owned()),
        "{:?}",
        merged.missing
    );

    let of = |options: Options| tests(BOTH, options).report(DOUBLED, "interp").expect("a report");
    let other_version = Report { version: "0.0.9".to_owned(), ..report(DOUBLED, "interp") };
    let drivers = [("card".to_owned(), "25.1".to_owned())].into();
    let other_driver = Report { drivers, ..report(DOUBLED, "interp") };
    let native = Report { drivers: [("card".to_owned(), "25.0".to_owned())].into(), ..native };
    let mut changed = native.clone();
    changed.kernels[0].answers[0].cases += 1;
    for (other, why) in [
        (of(Options::new().inputs(400)), "a has inputs 500, b has 400: they are not parts of one run"),
        (of(Options::new().inputs(500).seed(8)), "a has seed 7, b has 8"),
        (of(Options::new().inputs(500).model("vulkan")), "a has accuracy model portable, b has vulkan"),
        (other_version, "b has 0.0.9"),
        (other_driver, "a has driver 25.0, b has 25.1"),
        (changed, "a and b are both the part doubled::native and differ"),
    ] {
        let refused = merge::merge(vec![named("a", native.clone()), named("b", other)]);
        let told = refused.expect_err(why).to_string();
        assert!(told.contains(why), "{told}");
    }
    assert!(merge::merge(Vec::new()).is_err());
    let nowhere = merge::read(&[Path::new("no-such.json").to_owned()]).expect_err("none");
    assert!(nowhere.to_string().contains("no-such.json: cannot be read"), "{nowhere}");
}
