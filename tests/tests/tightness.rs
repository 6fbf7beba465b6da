//! The derived bounds of the whole library are sound, and tight: no driver drawn by chance leaves them, and the worst of
//! a few comes near. `lobe check --perturbed 100` asks the same of a million runs a kernel.

mod common;

use lobe_tests::judge::{Plan, judge};
use lobe_tests::perturbed::SUBJECT;
use lobe_tests::report::Report;

const SEED: u64 = 7;

/// A bound may be so many times the worst error found: for half of the kernels, and for 95 % of them.
const MEDIAN: f64 = 8.0;
const MOST: f64 = 64.0;

#[test]
fn no_permitted_driver_leaves_a_bound_and_the_worst_come_near() {
    let mut report = Report::new("check", SEED);
    let plan = Plan { seed: SEED, drivers: 20, ..common::plan(100) };
    report.kernels = lobe_kernels::registry::KERNELS
        .iter()
        .map(|kernel| judge(*kernel, &plan, &mut [], &|_| {}))
        .collect();
    for kernel in &report.kernels {
        let answer = kernel.answers.iter().find(|answer| answer.subject == SUBJECT);
        let answer = answer.unwrap_or_else(|| panic!("{}: {:?}", kernel.name, kernel.answers));
        assert!(!answer.falls_short(), "{}, seed {SEED}: {answer:?}", kernel.name);
    }
    let tightness = report.tightness().expect("bounds");
    assert!(tightness.median <= MEDIAN && tightness.most <= MOST, "seed {SEED}: {tightness:?}");
}
