//! The search finds what drawing misses, in the domain, and the same again.

mod common;

use common::plan;
use lobe_backends::executor::{Interp, Native};
use lobe_codegen::def::FunctionRef;
use lobe_codegen::prelude::*;
use lobe_tests::cases::Cases;
use lobe_tests::judge::{Plan, judge};
use lobe_tests::question::{Answer, Question, Verdict};
use lobe_tests::report::KernelReport;
use lobe_tests::search::{Aim, Find, Limit};
use lobe_tests::value::parse_rows;

/// Within its budget but near one point.
#[kernel(domain(x = 0.0..=1000.0, y = 0.0..=1000.0), budget(1e-6))]
fn cancels_in_a_corner(x: f32, y: f32) -> f32 {
    let far = abs(x - 437.5) + abs(y - 812.25);
    1e-7 * x * x / (far * far + 1e-3)
}

/// Without a bound near one point.
#[kernel(domain(x = 0.0..=1000.0), budget(1e-3 * abs(result)))]
fn unbounded_at_a_point(x: f32) -> f32 {
    1.0 + 1.0 / abs(x - 437.5)
}

/// A frame, turned.
#[kernel(domain(z = unit, x = normal_to(z), y = cross(z, x), angle = -4.0..=4.0, n = 1..=9))]
fn turned(z: Vec3, x: Vec3, y: Vec3, angle: f32, n: u32) -> f32 {
    dot(z, x) * angle + dot(cross(x, y), z) * n as f32
}

/// Exact.
#[kernel(domain(n = 0..=9), budget(0.0))]
fn exact(n: u32) -> u32 {
    n * 2
}

fn searched(kernel: FunctionRef, rounds: usize) -> KernelReport {
    let plan = Plan { search: Some(Limit::Rounds(rounds)), ..plan(200) };
    judge(kernel, &plan, &mut [Box::new(Native), Box::new(Interp)], &|_| {})
}

fn find(report: &KernelReport, aim: Aim) -> Option<&Find> {
    report.search.as_ref().and_then(|found| found.finds.iter().find(|find| find.aim == aim))
}

fn robust(report: &KernelReport) -> &Answer {
    common::answer(report, Question::Robust)
}

#[test]
fn what_drawing_misses_is_found_and_judged() {
    let kernel = lobe_codegen::kernels![cancels_in_a_corner][0];
    assert_eq!(robust(&searched(kernel, 0)).verdict, Verdict::Holds);
    let report = searched(kernel, 20);
    assert!(robust(&report).falls_short(), "{:?}", report.search);
    let find = find(&report, Aim::Bound).expect("a find");
    assert!(find.is_new() && find.found > 1.0, "{find:?}");
}

#[test]
fn where_the_bound_is_lost_a_search_goes_without_changing_the_share_that_drawing_measures() {
    let report = searched(lobe_codegen::kernels![unbounded_at_a_point][0], 10);
    let found = common::answer(&report, Question::Conformant);
    assert!(found.indeterminate > 0, "{found:?}");
    assert_eq!(
        found.distribution.as_ref().map(|d| d.rows),
        Some(200),
        "only drawn rows say how shares spread"
    );
    assert!(robust(&report).indeterminate == 0 && robust(&report).cases == 200, "{:?}", robust(&report));
}

#[test]
fn the_same_seed_finds_the_same_rows() {
    let kernel = lobe_codegen::kernels![cancels_in_a_corner][0];
    let search = |rounds| serde_json::to_string(&searched(kernel, rounds).search).expect("JSON");
    assert_eq!(search(3), search(3));
}

#[test]
fn rows_stay_in_the_domain() {
    let kernel = lobe_codegen::kernels![turned][0];
    let mut near = lobe_tests::domain::Neighbours::new(kernel(), 7).expect("a domain");
    let inputs =
        lobe_tests::domain::Inputs::draw(kernel(), 50, 7, &lobe_codegen::data::Columns::zeros(11, 0));
    let mut row = inputs.expect("inputs").args.row(0);
    for _ in 0..20_000 {
        row = near.near(&row);
        let float = |at: usize| f64::from(f32::from_bits(row[at]));
        let vector = |at: usize| [float(at), float(at + 1), float(at + 2)];
        let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let (z, x, y) = (vector(0), vector(3), vector(6));
        for (a, b, wanted) in [(z, z, 1.0), (x, x, 1.0), (y, y, 1.0), (z, x, 0.0), (z, y, 0.0), (x, y, 0.0)] {
            assert!((dot(a, b) - wanted).abs() < 1e-6, "{row:?}");
        }
        assert!(float(9).abs() <= 4.0 && (1..=9).contains(&row[10]), "{row:?}");
    }
}

#[test]
fn a_kernel_without_errors_gives_nothing_to_look_for() {
    let report = searched(lobe_codegen::kernels![exact][0], 5);
    let found = report.search.expect("a search");
    assert!(found.finds.is_empty() && found.rows == 0, "{found:?}");
}

#[test]
fn rows_that_are_kept_are_listed() {
    let folder = tempfile::tempdir().expect("a folder");
    let cases = Cases::at(folder.path());
    let kernel = lobe_codegen::kernels![cancels_in_a_corner][0];
    let report = searched(kernel, 3);
    let finds = report.search.iter().flat_map(|found| &found.finds).map(|find| &find.args);
    cases.keep("cancels_in_a_corner", finds.clone()).expect("a file");
    cases.keep("cancels_in_a_corner", finds).expect("a file");
    let listed = cases.listed(kernel()).expect("rows");
    assert!(listed.rows > 0 && listed.rows.is_multiple_of(2));
    let again = report.search.iter().flat_map(|found| &found.finds).map(|find| find.args.to_string());
    let text = again.collect::<Vec<_>>().join("\n");
    assert_eq!(parse_rows(kernel(), &text).expect("rows"), listed.slice(0..listed.rows / 2));
}
