//! What the property tests of a family draw from, and how they compare.

#![allow(dead_code, reason = "each test file uses some of it")]

use lobe_codegen::glam::{DVec3, Mat3, Quat, Vec3};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};

/// Runs `test` on values of `strategy`, 256 of them, from a printed seed; `LOBE_SEED=n` repeats a run.
pub(crate) fn check<S: Strategy>(strategy: S, test: impl Fn(S::Value) -> Result<(), TestCaseError>) {
    let seed: u64 = match std::env::var("LOBE_SEED").ok().and_then(|s| s.parse().ok()) {
        Some(seed) => seed,
        None => std::time::SystemTime::UNIX_EPOCH.elapsed().map_or(7, |t| t.as_nanos() as u64),
    };
    println!("seed {seed} (repeat with LOBE_SEED={seed})");
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &bytes));
    if let Err(error) = runner.run(&strategy, test) {
        panic!("seed {seed}: {error}");
    }
}

/// Unit vectors.
pub(crate) fn unit() -> impl Strategy<Value = Vec3> {
    (-1.0..=1.0_f64, 0.0..std::f64::consts::TAU).prop_map(|(z, phi)| {
        let r = (1.0 - z * z).sqrt();
        DVec3::new(r * phi.cos(), r * phi.sin(), z).normalize().as_vec3()
    })
}

/// Rotations.
pub(crate) fn rotation() -> impl Strategy<Value = Mat3> {
    (unit(), 0.0..6.0_f32).prop_map(|(axis, angle)| Mat3::from_quat(Quat::from_axis_angle(axis, angle)))
}

/// Whether `a` is `b` to within `tolerance`.
pub(crate) fn close(a: f32, b: f64, tolerance: f64, what: &str) -> Result<(), TestCaseError> {
    prop_assert!((f64::from(a) - b).abs() <= tolerance, "{what}: {a} against {b}, tolerance {tolerance:e}");
    Ok(())
}
