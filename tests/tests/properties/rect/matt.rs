//! The form factor, and lobes on a matt surface.

use super::level;
use crate::support::{check, close, unit};
use lobe_codegen::glam::DVec3;
use lobe_codegen::prelude::*;
use lobe_kernels::rect::Rectangle;
use lobe_kernels::rect::diffuse::{rect_diffuse_glossy, rect_form_factor};
use proptest::prelude::*;
use std::f64::consts::PI;

/// The form factor by the midpoint rule over the rectangle.
fn form_factor(rectangle: Rectangle, position: DVec3, normal: DVec3) -> f64 {
    let n = 400;
    let (x, facing) = (rectangle.tangent.as_dvec3(), rectangle.normal.as_dvec3());
    let y = facing.cross(x);
    let (hx, hy) = (f64::from(rectangle.half_x), f64::from(rectangle.half_y));
    let at = |i: i32| (2.0 * f64::from(i) + 1.0) / f64::from(n) - 1.0;
    let mut sum = 0.0;
    for i in 0..n {
        for j in 0..n {
            let way = rectangle.position.as_dvec3() + at(i) * hx * x + at(j) * hy * y - position;
            let w = way.normalize();
            sum += w.dot(normal).max(0.0) * (-w.dot(facing)).max(0.0) / way.length_squared();
        }
    }
    sum * 4.0 * hx * hy / f64::from(n * n) / PI
}

#[test]
fn the_form_factor_is_the_integral_whatever_the_horizon_cuts() {
    let places = (-2.0..2.0_f32, -2.0..2.0_f32, 0.3..3.0_f32);
    check((0.2..2.0_f32, 0.2..2.0_f32, places, unit()), |(hx, hy, (x, y, z), normal)| {
        let position = Vec3::new(x, y, z);
        let exact = form_factor(level(hx, hy), position.as_dvec3(), normal.as_dvec3());
        let found = rect_form_factor(level(hx, hy), position, normal);
        close(found, exact, 1e-4 + 2e-3 * exact, "form factor")?;
        let under = rect_form_factor(level(hx, hy), Vec3::new(x, y, -z), normal);
        prop_assert_eq!(under, 0.0);
        Ok(())
    });
    // A rectangle without end fills the hemisphere.
    assert!((rect_form_factor(level(1e2, 1e2), Vec3::new(0.0, 0.0, 1e-2), Vec3::NEG_Z) - 1.0).abs() < 1e-4);
}

#[test]
fn a_sharp_lobe_lights_a_matt_surface_by_its_cosine() {
    check((unit(), unit(), 0.0..1.0_f32), |(axis, normal, albedo)| {
        let found = rect_diffuse_glossy(axis, 2e4, 3e4, 5.0, normal, albedo);
        let cosine = axis.as_dvec3().dot(normal.as_dvec3()).max(0.0);
        close(found, f64::from(albedo) * 5.0 * cosine / PI, 5e-3 * f64::from(albedo), "radiance")
    });
}
