//! The disk around the specular peak: its area, its frame and its lobe.

use super::scene;
use crate::support::{check, close, unit};
use lobe_codegen::glam::{DVec3, Mat3};
use lobe_codegen::prelude::*;
use lobe_kernels::asg::asg_integral_paper;
use lobe_kernels::rect::disk::{
    rect_coverage, rect_coverage_bounds, rect_coverage_paper, rect_disk_area, rect_disk_bounds,
    rect_disk_radius,
};
use lobe_kernels::rect::light::{
    rect_asg_from_disk, rect_bandwidth_paper, rect_bandwidth_slope, rect_disk_frame,
};
use lobe_kernels::rect::peak::rect_specular_peak;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// Area of a disk within a rectangle by slices across, of which there are 40000.
fn sliced(half: [f64; 2], center: [f64; 2], r: f64) -> f64 {
    let n = 40000;
    let slice = |i: i32| {
        // In the angle, so that the ends are fine.
        let angle = PI * (f64::from(i) + 0.5) / f64::from(n) - FRAC_PI_2;
        let (x, half_chord) = (center[0] + r * angle.sin(), r * angle.cos());
        let top = (center[1] + half_chord).min(half[1]);
        let bottom = (center[1] - half_chord).max(-half[1]);
        if x.abs() > half[0] { 0.0 } else { (top - bottom).max(0.0) * half_chord * PI / f64::from(n) }
    };
    (0..n).map(slice).sum()
}

#[test]
fn the_area_is_that_of_the_intersection() {
    let numbers = (0.1..2.0_f64, 0.1..2.0_f64, -3.0..3.0_f64, -3.0..3.0_f64, 0.05..3.0_f64);
    check(numbers, |(hx, hy, cx, cy, r)| {
        let exact = sliced([hx, hy], [cx, cy], r);
        let (hx, hy, cx, cy, r) = (hx as f32, hy as f32, cx as f32, cy as f32, r as f32);
        let area = rect_disk_area(hx, hy, cx, cy, r);
        close(area, exact, 3e-4 * f64::from(r * r), "S_I")?;
        let bounds = rect_disk_bounds(hx, hy, cx, cy, r);
        let slack = 1e-5 * r * r;
        prop_assert!(area >= 0.0 && area <= bounds + slack, "{area} is not within {bounds}");
        prop_assert!(bounds <= 4.0 * (r * r).min(hx * hy) + slack);
        prop_assert!(rect_disk_area(hx, hy, cx, cy, 1.1 * r) >= area - slack, "it falls with the radius");
        prop_assert!((rect_disk_area(hx, hy, -cx, cy, r) - area).abs() <= slack, "it is not symmetric");
        prop_assert!((rect_disk_area(hy, hx, cy, cx, r) - area).abs() <= slack, "it is not symmetric");
        Ok(())
    });
}

#[test]
fn the_share_of_a_disk_has_its_limits() {
    // A disk inside, a rectangle inside, both apart although their bounding boxes overlap.
    assert!((rect_coverage(2.0, 2.0, 0.5, 0.2, 1.0) - 1.0).abs() < 1e-6);
    assert_eq!(rect_coverage_bounds(2.0, 2.0, 0.5, 0.2, 1.0), 1.0);
    assert!((f64::from(rect_coverage_paper(2.0, 2.0, 0.5, 0.2, 1.0)) - 4.0 / PI).abs() < 1e-6);
    assert_eq!(rect_disk_area(0.25, 0.5, 0.1, 0.2, 100.0), 0.5);
    assert_eq!(rect_disk_area(1.0, 1.0, 1.9, 1.9, 1.0), 0.0);
    assert_eq!(rect_disk_bounds(1.0, 1.0, 1.9, 1.9, 1.0), 0.0);
    assert_eq!(rect_disk_radius(3.0, 0.1, 2.0, 10.0, 10.0), 3.0 * 0.1 * 2.0);
    assert!((f64::from(rect_disk_radius(3.0, 1.0, 2.0, 0.5, 0.5)) - (1.0 / PI).sqrt()).abs() < 1e-6);
}

#[test]
fn at_the_peak_the_half_vector_is_the_normal() {
    check(scene(), |(rectangle, _, light, receiver, _)| {
        let peak = rect_specular_peak(rectangle, light.direction, receiver.position);
        let half = (light.direction + peak.reflected).as_dvec3().normalize();
        prop_assert!(half.cross(DVec3::Z).length() < 1e-5, "half vector {half}");
        prop_assert!(peak.position.z.abs() < 1e-5, "off the plane: {}", peak.position);
        prop_assert!(
            ((receiver.position - peak.position).length() - peak.dist).abs() <= 1e-5 * (1.0 + peak.dist)
        );
        Ok(())
    });
}

#[test]
fn the_frame_is_orthonormal_and_the_lobe_has_the_energy() {
    check((unit(), unit(), unit(), 0.01..0.6_f32), |(axis, normal, tangent, size)| {
        let frame = rect_disk_frame(axis, normal, tangent);
        let product = frame.transpose() * frame;
        prop_assert!(product.abs_diff_eq(Mat3::IDENTITY, 1e-5), "{frame}");
        let seen = if axis.dot(normal) < 0.0 { normal } else { -normal };
        let lobe = rect_asg_from_disk(2.0 * axis, Vec3::ZERO, seen, tangent, 3.0, 2.0 * size);
        close(lobe.amplitude * asg_integral_paper(lobe.lambda, lobe.mu), 3.0, 1e-4, "energy")?;
        prop_assert!(lobe.mu >= lobe.lambda);
        Ok(())
    });
    // Seen from straight above the tangent is the axis.
    assert_eq!(rect_disk_frame(Vec3::NEG_Z, Vec3::Z, Vec3::X).y_axis, Vec3::X);
}

#[test]
fn the_bandwidths_differ_by_their_slope() {
    check((0.01..4.0_f32, 0.05..0.9_f32), |(ratio, cos)| {
        let difference = rect_bandwidth_paper(ratio * cos) - rect_bandwidth_paper(ratio);
        let stated = rect_bandwidth_slope(ratio, cos) * (1.0 - cos * cos);
        close(difference, f64::from(stated), 1e-5 * f64::from(stated) / f64::from(1.0 - cos), "μ - λ")
    });
}
