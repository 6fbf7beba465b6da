//! Random directions, frames and lobes, and quadrature over the sphere.

use lobe_codegen::glam::{DVec3, Mat3, Quat, Vec3};
use lobe_kernels::asg::Asg;
use lobe_kernels::sg::Sg;
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};

/// The seed of a test, printed: `LOBE_SEED`, or one of the clock's.
pub(crate) fn seed() -> u64 {
    let seed: u64 = match std::env::var("LOBE_SEED").ok().and_then(|s| s.parse().ok()) {
        Some(seed) => seed,
        None => std::time::SystemTime::UNIX_EPOCH.elapsed().map_or(7, |t| t.as_nanos() as u64),
    };
    println!("seed {seed} (repeat with LOBE_SEED={seed})");
    seed
}

/// Runs `test` on values of `strategy`, 256 of them or as many as `LOBE_CASES` says, from a printed seed.
pub(crate) fn check<S: Strategy>(strategy: S, test: impl Fn(S::Value) -> Result<(), TestCaseError>) {
    let seed = seed();
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let cases = std::env::var("LOBE_CASES").ok().and_then(|s| s.parse().ok()).unwrap_or(256);
    let config = ProptestConfig { failure_persistence: None, cases, ..ProptestConfig::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &bytes));
    if let Err(error) = runner.run(&strategy, test) {
        panic!("seed {seed}: {error}");
    }
}

/// The unit vector at height `z` and azimuth `phi`.
pub(crate) fn direction(z: f64, phi: f64) -> Vec3 {
    let r = (1.0 - z * z).max(0.0).sqrt();
    DVec3::new(r * phi.cos(), r * phi.sin(), z).normalize().as_vec3()
}

/// Unit vectors.
pub(crate) fn unit() -> impl Strategy<Value = Vec3> {
    (-1.0..=1.0_f64, 0.0..std::f64::consts::TAU).prop_map(|(z, phi)| direction(z, phi))
}

/// Log-uniform over the useful decades, and 0 now and then.
pub(crate) fn sharpness() -> impl Strategy<Value = f32> {
    prop_oneof![1 => Just(0.0), 9 => (-6.0..5.0_f32).prop_map(|e| 10.0_f32.powf(e))]
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

/// An isotropic lobe.
pub(crate) fn lobe() -> impl Strategy<Value = Sg> {
    (unit(), sharpness(), -2.0..2.0_f32).prop_map(|(axis, sharpness, log_amplitude)| Sg {
        axis,
        sharpness,
        log_amplitude,
    })
}

/// An anisotropic lobe of bandwidths within `10^low ..= 10^high`.
pub(crate) fn anisotropic(low: f32, high: f32) -> impl Strategy<Value = Asg> {
    (unit(), unit(), low..high, low..high, 0.1..10.0_f32).prop_filter_map(
        "a tangent",
        |(z, aside, lambda, mu, amplitude)| {
            let x = (aside - z * z.dot(aside)).try_normalize()?;
            let (lambda, mu) = (10.0_f32.powf(lambda), 10.0_f32.powf(mu));
            Some(Asg { z, x, y: z.cross(x), lambda, mu, amplitude })
        },
    )
}

/// `∫ f(w) exp(k (w·axis - 1)) dw` by the midpoint rule in polar coordinates around the axis, over the part
/// of the sphere where the lobe is above e^-60 of its peak.
pub(crate) fn integrate(axis: Vec3, k: f32, f: impl Fn(DVec3) -> f64) -> f64 {
    let (axis, k) = (axis.as_dvec3().normalize(), f64::from(k));
    let (x, y) = axis.any_orthonormal_pair();
    let depth = (60.0 / k).min(2.0);
    let (n, m) = (600, 200);
    let mut sum = 0.0;
    for i in 0..n {
        // Quadratic spacing: fine near the axis.
        let s = (f64::from(i) + 0.5) / f64::from(n);
        let down = depth * s * s;
        let weight = (-k * down).exp() * depth * 2.0 * s / f64::from(n);
        let (c, r) = (1.0 - down, (down * (2.0 - down)).max(0.0).sqrt());
        let ring: f64 = (0..m)
            .map(|j| {
                let phi = std::f64::consts::TAU * (f64::from(j) + 0.5) / f64::from(m);
                f(axis * c + (x * phi.cos() + y * phi.sin()) * r)
            })
            .sum();
        sum += weight * ring * std::f64::consts::TAU / f64::from(m);
    }
    sum
}
