//! Properties of virtual spherical lights and spherical-Gaussian lights.

mod light;
mod many;
mod pair;
mod spherical;

use crate::support::unit;
use lobe_codegen::glam::{DVec3, Vec3};
use lobe_kernels::asg::Asg;
use lobe_kernels::vsgl::Vsgl;
use proptest::prelude::*;
use std::f64::consts::TAU;

pub(super) fn decades(low: f32, high: f32) -> impl Strategy<Value = f32> {
    (low..high).prop_map(|e| 10.0_f32.powf(e))
}

pub(super) fn light() -> impl Strategy<Value = Vsgl> {
    let variance = prop_oneof![1 => Just(0.0), 9 => decades(-6.0, 2.0)];
    (unit(), decades(-1.0, 1.0), variance, unit(), decades(-3.0, 4.0), decades(-2.0, 2.0)).prop_map(
        |(dir, dist, variance, axis, sharpness, intensity)| Vsgl {
            mean: dist * dir,
            variance,
            axis,
            sharpness,
            intensity,
        },
    )
}

pub(super) fn frame(z: Vec3, lambda: f32, mu: f32) -> Asg {
    let (x, y) = z.any_orthonormal_pair();
    Asg { z, x, y, lambda, mu, amplitude: 1.0 }
}

/// `∫ f dw` by the midpoint rule in polar coordinates about `axis`, to the angle where `1 - cos` is `depth`.
pub(super) fn integrate(axis: Vec3, depth: f64, f: impl Fn(DVec3) -> f64) -> f64 {
    let (axis, n, m) = (axis.as_dvec3().normalize(), 800, 128);
    let (x, y) = axis.any_orthonormal_pair();
    let ring = |i: i32| {
        let s = (f64::from(i) + 0.5) / f64::from(n);
        let down = depth * s * s;
        let (c, r) = (1.0 - down, (down * (2.0 - down)).max(0.0).sqrt());
        let along = |j: i32| {
            let phi = TAU * (f64::from(j) + 0.5) / f64::from(m);
            f(axis * c + (x * phi.cos() + y * phi.sin()) * r)
        };
        (0..m).map(along).sum::<f64>() * TAU / f64::from(m) * depth * 2.0 * s / f64::from(n)
    };
    (0..n).map(ring).sum()
}
