//! Seeded faults: each kind is made, faults are noticed, and what is none is told apart.

use lobe_codegen::def::FunctionRef;
use lobe_codegen::prelude::*;
use lobe_tests::cases::Cases;
use lobe_tests::mutation::fault::Kind;
use lobe_tests::mutation::report::{KernelFaults, Outcome};
use lobe_tests::mutation::{Plan, mutate};
use std::collections::BTreeSet;

/// Something of every kind of fault.
#[kernel(domain(v = -4.0..=4.0, n = 1.0..=4.0))]
fn medley(v: Vec3, n: u32) -> f32 {
    let mut sum = 0.125;
    let mut i = 0u32;
    while i < n {
        sum += v.x * 0.37;
        i += 1;
    }
    if v.y > 0.0 {
        sum -= abs(v.z);
    }
    sum * sin(v.y)
}

/// A guard that no input needs: without it no bit changes.
#[kernel(domain(x = 0.5..=2.0))]
fn guarded(x: f32) -> f32 {
    max(x, 0.25) + x
}

/// The last factor is beneath the rounding of the logarithm before it.
#[kernel(domain(x = 0.9..=1.1))]
fn beneath_its_bound(x: f32) -> f32 {
    log(x) + 0.00000025
}

fn plan() -> Plan {
    Plan { inputs: 2000, seed: 7, equivalence: 200_000, cases: Cases::at("no-such-folder"), until: None }
}

fn faults(kernel: FunctionRef) -> KernelFaults {
    mutate(kernel, &plan()).expect("faults")
}

#[test]
fn every_kind_is_made_and_noticed() {
    let [kernel] = lobe_codegen::kernels![medley];
    let found = faults(kernel);
    let kinds: BTreeSet<Kind> = found.faults.iter().map(|(mutant, _)| mutant.kind).collect();
    let missing: Vec<&Kind> = Kind::ALL.iter().filter(|kind| !kinds.contains(kind)).collect();
    assert_eq!(missing, Vec::<&Kind>::new());
    for (mutant, outcome) in &found.faults {
        let is_noticed = matches!(outcome, Outcome::OutsideBound { .. } | Outcome::OtherBits { .. });
        let is_harmless = matches!(outcome, Outcome::Stillborn | Outcome::Equivalent { .. });
        assert!(is_noticed || is_harmless, "{mutant:?}: {outcome:?}");
    }
    let places = found.faults.iter().filter_map(|(mutant, _)| mutant.place);
    assert!(places.into_iter().any(|place| place.file.ends_with("mutation.rs") && place.text == "abs(v.z)"));
}

#[test]
fn a_change_that_no_input_shows_is_equivalent() {
    let [kernel] = lobe_codegen::kernels![guarded];
    let found = faults(kernel);
    let dropped = found.faults.iter().filter(|(mutant, _)| mutant.kind == Kind::Dropped);
    let outcomes: Vec<&Outcome> = dropped.map(|(_, outcome)| outcome).collect();
    assert!(
        outcomes.iter().any(|o| matches!(o, Outcome::Equivalent { rows } if *rows >= 200_000)),
        "{outcomes:?}"
    );
    assert!(outcomes.iter().any(|o| matches!(o, Outcome::OutsideBound { .. })), "{outcomes:?}");
}

#[test]
fn what_the_bound_must_permit_only_bits_tell() {
    let [kernel] = lobe_codegen::kernels![beneath_its_bound];
    let found = faults(kernel);
    let literal = found.faults.iter().find(|(mutant, _)| mutant.kind == Kind::LiteralBy1e4);
    assert!(matches!(literal, Some((_, Outcome::OtherBits { .. }))), "{literal:?}");
    let count = found.count(|_| true);
    assert!(count.score() > count.score_of_bound(), "{count:?}");
}

#[test]
fn the_same_seed_gives_the_same_outcomes() {
    let [kernel] = lobe_codegen::kernels![medley];
    let outcomes = |faults: KernelFaults| faults.faults.into_iter().map(|(_, o)| o).collect::<Vec<_>>();
    assert_eq!(outcomes(faults(kernel)), outcomes(faults(kernel)));
}
