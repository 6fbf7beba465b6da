//! Reflectance models, their lobes and their sampling.

mod lobe;
mod model;
mod ndf;
mod sampling;

use crate::support::direction;
use lobe_codegen::glam::{Vec2, Vec3};
use lobe_kernels::brdf::Material;
use lobe_tests::domain::Rng;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

pub(super) fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance, "{what}: {a} against {b}, tolerance {tolerance:e}");
}

/// Above the horizon of `z`, down to 1e-3 from it.
pub(super) fn upper() -> impl Strategy<Value = Vec3> {
    (1e-3..=1.0_f64, 0.0..TAU).prop_map(|(z, phi)| direction(z, phi))
}

pub(super) fn alpha() -> impl Strategy<Value = f32> {
    (0.02_f32.ln()..0.0).prop_map(f32::exp)
}

pub(super) fn colour() -> impl Strategy<Value = Vec3> {
    (0.0..=1.0_f32, 0.0..=1.0_f32, 0.0..=1.0_f32).prop_map(|(r, g, b)| Vec3::new(r, g, b))
}

pub(super) fn material() -> impl Strategy<Value = Material> {
    (colour(), colour(), 0.0..=1.0_f32, alpha()).prop_map(|(diffuse_albedo, f0, f90, alpha)| Material {
        diffuse_albedo,
        f0,
        f90,
        alpha,
    })
}

/// Two uniform numbers, as kernels make them.
pub(super) fn pair(rng: &mut Rng) -> Vec2 {
    let mut one = || (rng.bits() >> 40) as f32 / 16_777_216.0;
    Vec2::new(one(), one())
}

/// `∫ f(θ) sin θ dθ dφ` over the upper hemisphere for what is flat about `z`, fine near it: midpoint rule in `s`,
/// `tan θ = width s/(1 - s)`.
pub(super) fn about_z(width: f64, f: impl Fn(Vec3) -> f64) -> f64 {
    let n = 20_000;
    (0..n)
        .map(|i| {
            let s = (f64::from(i) + 0.5) / f64::from(n);
            let theta = (width * s / (1.0 - s)).atan();
            let slope = width / (1.0 - s).powi(2) * theta.cos().powi(2);
            f(direction(theta.cos(), 0.3)) * theta.sin() * slope * TAU / f64::from(n)
        })
        .sum()
}

/// `∫ f dw` over the upper hemisphere, midpoint rule in polar coordinates about `axis`, fine near it.
pub(super) fn about(axis: Vec3, width: f64, f: impl Fn(Vec3) -> f64) -> f64 {
    let axis = axis.as_dvec3().normalize();
    let (x, y) = axis.any_orthonormal_pair();
    let (n, m) = (700, 360);
    let mut sum = 0.0;
    for i in 0..n {
        let s = (f64::from(i) + 0.5) / f64::from(n);
        // θ = width s/(1 - s k), so that s = 1 is π.
        let k = 1.0 - width / PI;
        let theta = width * s / (1.0 - s * k);
        let weight = width / (1.0 - s * k).powi(2) * theta.sin() / f64::from(n) * TAU / f64::from(m);
        for j in 0..m {
            let phi = TAU * (f64::from(j) + 0.5) / f64::from(m);
            let dir = axis * theta.cos() + (x * phi.cos() + y * phi.sin()) * theta.sin();
            if dir.z > 0.0 {
                sum += f(dir.as_vec3()) * weight;
            }
        }
    }
    sum
}
