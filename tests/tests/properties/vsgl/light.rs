//! Shading by a spherical-Gaussian light.

use super::{decades, light};
use crate::support::{check, close, rotation, unit};
use lobe_codegen::glam::Vec3;
use lobe_kernels::sg::{Sg, sg_integral};
use lobe_kernels::vsgl::{Vsgl, vsgl_diffuse, vsgl_incoming, vsgl_light, vsgl_specular, vsgl_specular_axis};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

#[test]
fn a_constant_light_has_the_irradiance_of_a_point() {
    check((light(), unit(), decades(-2.0, 3.0)), |(light, dir, d)| {
        let light = Vsgl { sharpness: 0.0, variance: light.variance.min(1e-2 * d * d), ..light };
        let incoming = vsgl_incoming(light, light.mean - d * dir);
        prop_assume!(incoming.log_amplitude < 60.0);
        let whole = f64::from(incoming.log_amplitude).exp() * f64::from(sg_integral(incoming.sharpness));
        let d2 = f64::from((light.mean - (light.mean - d * dir)).length_squared());
        let wanted = f64::from(light.intensity) / d2;
        close((whole / wanted) as f32, 1.0, 2e-4, "c/D²")
    });
}

#[test]
fn both_forms_of_the_radiance_agree() {
    check((light(), unit()), |(light, position)| {
        let (sg, stable) = (vsgl_incoming(light, position), vsgl_light(light, position));
        prop_assert_eq!((sg.axis, sg.sharpness), (stable.axis, stable.sharpness));
        let ln = (f64::from(stable.density) * (1.0 + f64::from(stable.sharpness))).ln();
        let log_amplitude = ln + f64::from(stable.log_shift);
        close(sg.log_amplitude, log_amplitude, 1e-5 + 1e-6 * log_amplitude.abs(), "log amplitude")
    });
}

#[test]
fn a_light_without_extent_is_a_point_light() {
    check((light(), unit(), unit(), unit()), |(light, position, normal, view)| {
        let point = Vsgl { variance: 0.0, ..light };
        let towards = light.mean.as_dvec3() - position.as_dvec3();
        let (d2, dir) = (towards.length_squared(), towards.normalize());
        prop_assume!(d2 > 1e-2);
        let axis = light.axis.as_dvec3().normalize();
        // -dir against the emission's axis, by the chord.
        let exponent = -0.5 * f64::from(light.sharpness) * (dir + axis).length_squared();
        let irradiance = f64::from(light.intensity) * exponent.exp() / d2;
        let scale = irradiance * (1e-5 + 1e-6 * f64::from(light.sharpness)) + 1e-30;
        let cosine = dir.dot(normal.as_dvec3().normalize());
        let wanted = irradiance * cosine.max(0.0) / PI;
        close(vsgl_diffuse(point, position, normal, 1.0), wanted, 4e-4 * irradiance + scale, "diffuse")?;
        let facing = f64::from(normal.dot(view));
        prop_assume!(facing > 0.1);
        let (n, o) = (normal.as_dvec3().normalize(), view.as_dvec3().normalize());
        let mirror = 2.0 * n.dot(o) * n - o;
        let across = o.cross(n);
        prop_assume!(across.length() > 0.01);
        let x = across.normalize();
        let y = mirror.cross(x);
        let bandwidth = 0.25 / 0.09;
        let along_x = bandwidth / n.dot(o).powi(2) * dir.dot(x).powi(2);
        let lobe = dir.dot(mirror).max(0.0) * (-along_x - bandwidth * dir.dot(y).powi(2)).exp();
        let found = vsgl_specular(point, position, normal, view, 0.3, 2.0);
        close(found, 2.0 * lobe * irradiance, 1e-4 * irradiance + 4.0 * scale, "specular")
    });
}

#[test]
fn normal_incidence_needs_no_frame() {
    check((light(), unit()), |(light, normal)| {
        let position = Vec3::ZERO;
        let at = |view: Vec3| vsgl_specular(light, position, normal, view, 0.3, 1.0);
        let (x, _) = normal.any_orthonormal_pair();
        let straight = f64::from(at(normal));
        prop_assert!(straight.is_finite());
        let scale = f64::from(light.intensity) * 40.0 / f64::from(light.mean.length_squared());
        close(at((normal + 1e-6 * x).normalize()), straight, 1e-3 * straight + 1e-5 * scale, "nearly")
    });
}

#[test]
fn shading_is_invariant_under_rotation() {
    check((light(), unit(), unit(), rotation()), |(light, normal, view, turn)| {
        let soft =
            Vsgl { sharpness: light.sharpness.min(100.0), variance: light.variance.max(1e-2), ..light };
        let turned = Vsgl { mean: turn * soft.mean, axis: (turn * soft.axis).normalize(), ..soft };
        let (n, o) = ((turn * normal).normalize(), (turn * view).normalize());
        let incoming = vsgl_light(soft, Vec3::ZERO);
        let scale = f64::from(incoming.density * incoming.log_shift.exp()) * TAU;
        let before = f64::from(vsgl_diffuse(soft, Vec3::ZERO, normal, 0.5));
        close(vsgl_diffuse(turned, Vec3::ZERO, n, 0.5), before, 2e-3 * scale + 1e-30, "diffuse")?;
        prop_assume!(normal.dot(view) > 0.2);
        let before = f64::from(vsgl_specular(soft, Vec3::ZERO, normal, view, 0.5, 1.0));
        close(vsgl_specular(turned, Vec3::ZERO, n, o, 0.5, 1.0), before, 2e-3 * scale + 1e-30, "specular")
    });
}

#[test]
fn specular_axis_is_between_the_lobes_and_always_there() {
    check((unit(), unit(), decades(-2.0, 5.0), decades(-2.0, 5.0)), |(a, b, ka, kb)| {
        let sg = |axis, sharpness| Sg { axis, sharpness, log_amplitude: 0.0 };
        let axis = vsgl_specular_axis(sg(a, ka), sg(b, kb));
        prop_assume!((ka * a + kb * b).length() > 1e-3 * ka.max(kb));
        let wanted = (ka * a + kb * b).normalize();
        close((axis - wanted).length(), 0.0, 2e-3, "between")?;
        let opposed = vsgl_specular_axis(sg(-b, kb), sg(b, kb));
        close((opposed - b).length(), 0.0, 1e-6, "opposed")
    });
}
