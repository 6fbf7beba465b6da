//! Known faults of drivers: what is listed and there is expected, what is listed and gone fails, as what is not listed.

mod common;

use common::{Spoilt, check_by};
use lobe_backends::executor::{Executor, Native};
use lobe_codegen::data::Columns;
use lobe_codegen::def::FunctionRef;
use lobe_codegen::prelude::*;
use lobe_tests::expectation::{Expectation, Fault};
use lobe_tests::judge::Plan;
use lobe_tests::question::{Question, Verdict};
use lobe_tests::report::KernelReport;

/// Doubles.
#[kernel(domain(x = -10.0..=10.0), budget(1e-6 * abs(result) + 1e-30))]
fn doubled(x: f32) -> f32 {
    x + x
}

const DOUBLED: FunctionRef = lobe_codegen::kernels![doubled][0];

/// What the drivers of these tests say of themselves.
const CARD: &str = "Card 25.0.7 (LLVM 15)";

fn driver(route: &str, spoil: fn(&mut Columns)) -> Box<dyn Executor> {
    Box::new(Spoilt { route: route.parse().expect("a route"), spoil, driver: CARD })
}

/// Far off in the last row.
fn far(output: &mut Columns) {
    output.columns[0].iter_mut().last().into_iter().for_each(|word| *word ^= 0x40_0000);
}

/// Off by a bit in the last row.
fn near(output: &mut Columns) {
    output.columns[0].iter_mut().last().into_iter().for_each(|word| *word ^= 1);
}

fn fine(_: &mut Columns) {}

fn expect(route: &str, fails: Fault) -> Expectation {
    Expectation {
        subject: "doubled".to_owned(),
        route: route.to_owned(),
        driver: None,
        fails,
        reason: "it rounds to thirds".to_owned(),
        link: Some("https://example.org/7".to_owned()),
    }
}

fn judged(expected: &[Expectation], mut routes: Vec<Box<dyn Executor>>) -> KernelReport {
    routes.insert(0, Box::new(Native));
    check_by(DOUBLED, &Plan { expected: expected.to_vec(), ..common::plan(1000) }, &mut routes)
}

#[track_caller]
fn verdict(report: &KernelReport, question: Question, subject: &str) -> Verdict {
    let found = report.answers.iter().find(|a| a.question == question && a.subject == subject);
    found.unwrap_or_else(|| panic!("no answer of {subject}: {report:#?}")).verdict.clone()
}

fn expected() -> Verdict {
    Verdict::ExpectedFailure("it rounds to thirds, https://example.org/7".to_owned())
}

#[track_caller]
fn assert_short(verdict: &Verdict, parts: &[&str]) {
    let Verdict::FallsShort(why) = verdict else { panic!("{verdict:?} instead of falling short") };
    parts.iter().for_each(|part| assert!(why.contains(part), "no `{part}` in {why}"));
}

const CONFORMANT: Question = Question::Conformant;
const GONE: &str = "the expectation has to go or to change";

#[test]
fn a_fault_that_is_listed_is_expected() {
    for route in ["spirv@card", "*@card", "spirv@*"] {
        let report = judged(&[expect(route, Fault::Beyond)], vec![driver("spirv@card", far)]);
        assert_eq!(verdict(&report, CONFORMANT, "spirv@card"), expected(), "{route}");
        assert!(!report.falls_short(), "{report:#?}");
    }
}

#[test]
fn a_fault_that_is_not_listed_falls_short() {
    let of_another = Expectation { subject: "halved".to_owned(), ..expect("*", Fault::Beyond) };
    for list in [vec![], vec![of_another], vec![expect("spirv@other", Fault::Beyond)]] {
        let report = judged(&list, vec![driver("spirv@card", far)]);
        assert_short(&verdict(&report, CONFORMANT, "spirv@card"), &["1 of 1000 rows lie outside"]);
    }
}

#[test]
fn a_fault_of_another_version_of_the_driver_falls_short() {
    let of = |version: &str| Expectation { driver: Some(version.to_owned()), ..expect("*", Fault::Beyond) };
    let report = |version| judged(&[of(version)], vec![driver("spirv@card", far)]);
    assert_eq!(verdict(&report("25.0"), CONFORMANT, "spirv@card"), expected());
    assert_short(&verdict(&report("25.1"), CONFORMANT, "spirv@card"), &["1 of 1000 rows lie outside"]);
}

#[test]
fn a_fault_that_is_gone_falls_short() {
    let report = judged(&[expect("spirv@card", Fault::Beyond)], vec![driver("spirv@card", fine)]);
    let parts = ["it is within the bound, not beyond as expected (it rounds to thirds", GONE];
    assert_short(&verdict(&report, CONFORMANT, "spirv@card"), &parts);
    // Where the route did not run, nothing is known of it.
    assert!(!judged(&[expect("spirv@card", Fault::Beyond)], vec![]).falls_short());
}

#[test]
fn another_fault_than_the_listed_falls_short() {
    let report = judged(&[expect("*@card", Fault::Refused)], vec![driver("spirv@card", far)]);
    let parts = ["1 of 1000 rows lie outside", "it is beyond, not refused as expected", GONE];
    assert_short(&verdict(&report, CONFORMANT, "spirv@card"), &parts);
}

const GROUP: &str = "2 routes @card";

fn pair(expected: &[Expectation], spoil: fn(&mut Columns)) -> KernelReport {
    judged(expected, vec![driver("spirv@card", fine), driver("wgsl+naga@card", spoil)])
}

#[test]
fn routes_that_differ_are_excused_by_either_of_them() {
    for route in ["wgsl+naga@card", "spirv@card", "*@card"] {
        let report = pair(&[expect(route, Fault::Differs)], near);
        assert_eq!(verdict(&report, Question::Agree, GROUP), expected(), "{route}");
    }
    let report = pair(&[], near);
    assert_short(&verdict(&report, Question::Agree, GROUP), &["wgsl+naga@card differs from spirv@card"]);
}

#[test]
fn a_route_that_is_known_to_be_wrong_may_differ() {
    let report = pair(&[expect("wgsl+naga@card", Fault::Beyond)], far);
    assert_eq!(verdict(&report, Question::Agree, GROUP), expected());
    assert!(!report.falls_short(), "{report:#?}");
    // Wrong or not, it need not differ.
    let both = judged(
        &[expect("*@card", Fault::Beyond)],
        vec![driver("spirv@card", far), driver("wgsl+naga@card", far)],
    );
    assert_eq!(verdict(&both, Question::Agree, GROUP), Verdict::Holds);
}

#[test]
fn a_difference_that_is_gone_falls_short() {
    let report = pair(&[expect("wgsl+naga@card", Fault::Differs)], fine);
    let parts = ["equal to the other routes, not differs as expected", GONE];
    assert_short(&verdict(&report, Question::Agree, GROUP), &parts);
    // A route alone has none to differ from.
    let alone = judged(&[expect("*@card", Fault::Differs)], vec![driver("spirv@card", fine)]);
    assert!(!alone.falls_short(), "{alone:#?}");
}

#[test]
fn one_excuse_is_none_for_another_route() {
    let three =
        vec![driver("spirv@card", fine), driver("wgsl+naga@card", near), driver("hlsl+dxc@card", near)];
    let report = judged(&[expect("hlsl+dxc@card", Fault::Differs)], three);
    assert_short(
        &verdict(&report, Question::Agree, "3 routes @card"),
        &["wgsl+naga@card differs from spirv@card"],
    );
}

/// What a kernel says of itself is no matter of drivers.
#[kernel(domain(x = 1e3..=1e6), budget(1e-6 * abs(result)), not_robust = "a difference of near values")]
fn cancels(x: f32) -> f32 {
    (x * 1.1 + 1.0) - x * 1.1
}

#[test]
fn what_a_kernel_states_stands_apart() {
    let kernel = lobe_codegen::kernels![cancels][0];
    let list = [Expectation { subject: "cancels".to_owned(), ..expect("spirv@card", Fault::Beyond) }];
    let plan = Plan { expected: list.to_vec(), ..common::plan(1000) };
    let report = check_by(kernel, &plan, &mut [driver("spirv@card", far)]);
    let stated = Verdict::ExpectedFailure("a difference of near values".to_owned());
    assert_eq!(verdict(&report, Question::Robust, ""), stated);
    assert_eq!(verdict(&report, CONFORMANT, "spirv@card"), expected());
}
