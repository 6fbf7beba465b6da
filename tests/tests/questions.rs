//! A harness that cannot fail proves nothing: each question is put to a kernel that fails it.

mod common;

use common::{Spoilt, answer, check, check_on};
use lobe_backends::executor::{Interp, Native};
use lobe_backends::route::Route;
use lobe_codegen::data::Columns;
use lobe_codegen::prelude::*;
use lobe_tests::judge::{Plan, judge};
use lobe_tests::question::sanitized::SANITIZED;
use lobe_tests::question::{Question, Verdict};

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

/// Cancels, and says so.
#[kernel(domain(x = 1e3..=1e6), budget(1e-6 * abs(result)), not_robust = "a difference of near values")]
fn cancels_as_stated(x: f32) -> f32 {
    (x * 1.1 + 1.0) - x * 1.1
}

/// Says that it fails, and does not.
#[kernel(domain(x = 1.0..=2.0), budget(1e-6 * result), not_robust = "it is not true")]
fn holds_against_its_word(x: f32) -> f32 {
    x * 3.0
}

/// Says that it fails what it was never asked.
#[kernel(domain(x = 1.0..=2.0), not_robust = "no budget to exceed")]
fn fails_without_budget(x: f32) -> f32 {
    x * 3.0
}

/// States nothing.
#[kernel(domain(x = 1.0..=2.0))]
fn without_budget(x: f32) -> f32 {
    x * 3.0
}

/// Far from the function that it names.
#[kernel(domain(x = 0.0..=1.0), budget(1e-6), truth = exact_sine)]
fn far_from_truth(x: f32) -> f32 {
    x - x * x * x / 6.0
}
fn exact_sine(x: f64) -> f64 {
    x.sin()
}

/// Two parts with budgets of their own; the second is too tight.
#[kernel]
struct Pair {
    /// Exact.
    first: f32,
    /// Rounded.
    second: f32,
}

/// Fills a pair.
#[kernel(domain(x = 1.0..=2.0), budget(first = 1e-6, second = 1e-12))]
fn pair(x: f32) -> Pair {
    Pair { first: x, second: x / 3.0 }
}

/// Close to the function that it names.
#[kernel(domain(x = 0.0..=0.01), budget(1e-6), truth = exact_sine)]
fn close_to_truth(x: f32) -> f32 {
    x - x * x * x / 6.0
}

/// The budget of the whole is too tight for the second part, which has its own.
#[kernel(domain(x = 1.0..=2.0), budget(1e-12, second = 1e-6))]
fn pair_with_exception(x: f32) -> Pair {
    Pair { first: x, second: x / 3.0 }
}

/// Panics on some rows.
#[kernel(domain(n = 0.0..=8.0))]
fn panics(n: u32) -> f32 {
    let table = [1.0, 2.0, 3.0, 4.0];
    table[n as usize]
}

/// Has no domain.
#[kernel]
fn without_domain(x: f32) -> f32 {
    x
}

/// Gives birth to a NaN where x is 0, and leaves the table where n is 4.
#[kernel(domain(x = 0.0..=1.0, n = 0.0..=4.0))]
fn makes_mistakes(x: f32, n: u32) -> f32 {
    let table = [1.0, 2.0, 3.0, 4.0];
    table[n as usize] + x * 2.0 / x
}

const KERNELS: [lobe_codegen::def::FunctionRef; 13] = lobe_codegen::kernels![
    doubled,
    cancels,
    cancels_as_stated,
    holds_against_its_word,
    fails_without_budget,
    without_budget,
    far_from_truth,
    close_to_truth,
    pair,
    pair_with_exception,
    panics,
    without_domain,
    makes_mistakes,
];

fn named(name: &str) -> lobe_codegen::def::FunctionRef {
    KERNELS.into_iter().find(|k| k().name == name).expect("one of the above")
}

#[track_caller]
fn assert_short(verdict: &Verdict, part: &str) {
    match verdict {
        Verdict::FallsShort(why) => assert!(why.contains(part), "{why}"),
        other => panic!("{other:?} instead of falling short for {part}"),
    }
}

#[test]
fn a_sound_kernel_holds() {
    let report = check(named("doubled"));
    assert!(!report.falls_short(), "{report:#?}");
    assert_eq!(answer(&report, Question::Robust).verdict, Verdict::Holds);
    assert_eq!(answer(&report, Question::Conformant).cases, 1000);
    assert_eq!(answer(&report, Question::Agree).verdict, Verdict::Holds);
}

#[test]
fn a_bound_over_the_budget_falls_short_and_names_the_row() {
    let report = check(named("cancels"));
    let robust = answer(&report, Question::Robust);
    assert_short(&robust.verdict, "exceeds the budget");
    let worst = robust.worst.as_ref().expect("a row");
    assert!(worst.args["x"].as_str().is_some_and(|x| x.starts_with("0x1.")), "{worst:?}");
    assert!(robust.share > 1.0);
}

#[test]
fn a_failure_that_is_expected_is_none() {
    let report = check(named("cancels_as_stated"));
    let expected = Verdict::ExpectedFailure("a difference of near values".to_owned());
    assert_eq!(answer(&report, Question::Robust).verdict, expected);
    assert!(!report.falls_short());
}

#[test]
fn an_expected_failure_that_passes_fails() {
    let report = check(named("holds_against_its_word"));
    assert_short(&answer(&report, Question::Robust).verdict, "but it holds");
    let report = check(named("fails_without_budget"));
    assert_short(&answer(&report, Question::Robust).verdict, "no budget");
}

#[test]
fn no_budget_is_reported_and_no_failure() {
    let report = check(named("without_budget"));
    let expected = Verdict::NotAsked("no budget stated".to_owned());
    assert_eq!(answer(&report, Question::Robust).verdict, expected);
    assert!(!report.falls_short());
}

#[test]
fn distance_from_the_exact_function_is_measured() {
    let report = check(named("far_from_truth"));
    let correct = answer(&report, Question::Correct);
    assert_eq!(correct.subject, "no table", "the oracle answers first");
    let correct = report.answers.iter().find(|a| a.subject == "the exact function").expect("an answer");
    assert_short(&correct.verdict, "farther than the budget");
    assert!(
        (0.008..0.0082).contains(&correct.absolute),
        "x - x³/6 errs by 0.0081 at 1: {}",
        correct.absolute
    );
}

#[test]
fn nearness_to_the_exact_function_holds() {
    let report = check(named("close_to_truth"));
    let correct = report.answers.iter().find(|a| a.subject == "the exact function").expect("an answer");
    assert_eq!((&correct.verdict, correct.cases), (&Verdict::Holds, 1000));
}

#[test]
fn the_nearest_budget_counts() {
    let report = check(named("pair_with_exception"));
    assert_eq!(answer(&report, Question::Robust).verdict, Verdict::Holds);
}

#[test]
fn each_part_of_a_result_has_its_own_budget() {
    let report = check(named("pair"));
    let robust = answer(&report, Question::Robust);
    assert_short(&robust.verdict, "exceeds the budget");
    assert_eq!(robust.worst.as_ref().map(|w| w.leaf.as_str()), Some("second"));
}

#[test]
fn a_panic_of_the_native_form_is_an_answer() {
    let report = check_on(named("panics"), &mut [Box::new(Native)]);
    assert_short(&answer(&report, Question::Conformant).verdict, "panicked on row 1:");
}

#[test]
fn a_missing_domain_is_named() {
    let report = check(named("without_domain"));
    assert_short(&report.answers[0].verdict, "no domain is stated for `x`");
}

fn spoilt(name: &str, spoil: fn(&mut Columns)) -> Box<Spoilt> {
    Box::new(Spoilt { route: name.parse().expect("a route"), spoil, driver: "" })
}

/// The last row's result, its words changed.
fn last(output: &mut Columns, change: fn(u32) -> u32) {
    if let Some(word) = output.columns[0].last_mut() {
        *word = change(*word);
    }
}

#[test]
fn a_route_outside_the_bound_is_caught() {
    let mut routes: [Box<dyn lobe_backends::executor::Executor>; 2] =
        [Box::new(Native), spoilt("spirv@broken", |o| last(o, |w| w ^ 0x40_0000))];
    let report = check_on(named("doubled"), &mut routes);
    let verdict = |subject: &str| {
        let found =
            report.answers.iter().find(|a| a.question == Question::Conformant && a.subject == subject);
        found.expect("an answer").verdict.clone()
    };
    assert_eq!(verdict("native"), Verdict::Holds);
    assert_short(&verdict("spirv@broken"), "1 of 1000 rows lie outside");
}

#[test]
fn the_spread_of_shares_counts_every_row_that_was_judged() {
    let mut routes: [Box<dyn lobe_backends::executor::Executor>; 2] =
        [Box::new(Native), spoilt("spirv@broken", |o| last(o, |w| w ^ 0x40_0000))];
    let report = check_on(named("doubled"), &mut routes);
    let of = |subject: &str| {
        let found =
            report.answers.iter().find(|a| a.question == Question::Conformant && a.subject == subject);
        found.and_then(|answer| answer.distribution.clone()).expect("a distribution")
    };
    let (native, broken) = (of("native"), of("spirv@broken"));
    assert_eq!((native.rows, native.median, native.counts[0]), (1000, 0.0, 1000), "a sum of equals is exact");
    assert_eq!((broken.rows, broken.p99, broken.counts.last()), (1000, 0.0, Some(&1)));
    assert!(report.answers.iter().all(|a| a.distribution.is_some() == (a.question == Question::Conformant)));
}

#[test]
fn nan_where_a_number_is_wanted_is_caught() {
    let mut routes: [Box<dyn lobe_backends::executor::Executor>; 1] =
        [spoilt("spirv@broken", |o| last(o, |_| f32::NAN.to_bits()))];
    let report = check_on(named("doubled"), &mut routes);
    assert_short(&answer(&report, Question::Conformant).verdict, "1 of 1000 rows lie outside");
}

#[test]
fn one_bit_between_routes_of_a_driver_is_caught() {
    let mut routes: [Box<dyn lobe_backends::executor::Executor>; 3] =
        [Box::new(Interp), spoilt("spirv@card", |_| {}), spoilt("wgsl+naga@card", |o| last(o, |w| w ^ 1))];
    let report = check_on(named("doubled"), &mut routes);
    let agree = report.answers.iter().find(|a| a.subject == "2 routes @card").expect("an answer");
    assert_short(&agree.verdict, "wgsl+naga@card differs from spirv@card on 1 of 1000 rows");
    let strict = report.answers.iter().find(|a| a.subject == "native = interp").expect("an answer");
    assert!(matches!(strict.verdict, Verdict::NotAsked(_)), "one route alone agrees with nobody");
}

#[test]
fn nan_payloads_may_differ() {
    let mut routes: [Box<dyn lobe_backends::executor::Executor>; 2] = [
        spoilt("spirv@card", |o| last(o, |_| 0x7fc0_0000)),
        spoilt("wgsl+naga@card", |o| last(o, |_| 0xffc0_0001)),
    ];
    let report = check_on(named("doubled"), &mut routes);
    assert_eq!(answer(&report, Question::Agree).subject, "native = interp");
    let agree = report.answers.iter().find(|a| a.subject == "2 routes @card").expect("an answer");
    assert_eq!(agree.verdict, Verdict::Holds);
}

#[test]
fn the_route_of_a_failing_executor_says_why() {
    let route: Route = "spirv@x".parse().expect("a route");
    let mut routes: [Box<dyn lobe_backends::executor::Executor>; 1] = [Box::new(Failing(route))];
    let report = check_on(named("doubled"), &mut routes);
    assert_short(&answer(&report, Question::Conformant).verdict, "entry point");
}

struct Failing(Route);

impl lobe_backends::executor::Executor for Failing {
    fn route(&self) -> &Route {
        &self.0
    }
    fn run(
        &mut self,
        kernel: &lobe_backends::executor::Program,
        _: &Columns,
    ) -> Result<Columns, lobe_backends::executor::ExecError> {
        Err(lobe_backends::executor::ExecError::EntryPoint { kernel: kernel.name() })
    }
}

#[test]
fn mistakes_are_told_with_their_rust_lines_where_they_are_looked_for() {
    let judged = |index: usize| {
        let plan = Plan { sanitize: true, ..common::plan(1000) };
        let report = judge(KERNELS[index], &plan, &mut [Box::new(Interp)], &|_| {});
        let found = report.answers.into_iter().find(|a| a.subject == SANITIZED);
        found.expect("an answer").verdict
    };
    assert_eq!(judged(0), Verdict::Holds, "doubled");
    let Verdict::FallsShort(why) = judged(12) else { panic!("no mistakes") };
    for part in ["NanBirth at ", "questions.rs:", "`x * 2.0 / x`", "OutOfBounds at ", "\"n\":4"] {
        assert!(why.contains(part), "no {part} in {why}");
    }
    assert_eq!(check(KERNELS[12]).answers.iter().filter(|a| a.subject == SANITIZED).count(), 0);
}
