//! Filters of lobes and positions, on random sets.

use super::support::{check, close, rotation, unit};
use lobe_codegen::glam::{DVec3, Vec3};
use lobe_kernels::filter::{
    Moments, moments_empty, moments_merge, moments_merge4, moments_of_lobe, moments_of_position,
    moments_to_lobe, moments_to_lobe_paper, moments_variance_paper, planar_variance, toksvig_length_paper,
    toksvig_sharpness, toksvig_sharpness_paper, toksvig_spread,
};
use proptest::prelude::*;

/// A lobe: axis, sharpness, weight.
type Lobe = (Vec3, f32, f32);

fn lobes(n: usize) -> impl Strategy<Value = Vec<Lobe>> {
    let sharpness = (-3.0..6.0_f32).prop_map(|e| 10.0_f32.powf(e));
    prop::collection::vec((unit(), sharpness, 0.01..10.0_f32), n)
}

fn positions(n: usize) -> impl Strategy<Value = Vec<(Vec3, f32)>> {
    let axis = || -100.0..100.0_f32;
    let position = (axis(), axis(), axis()).prop_map(|(x, y, z)| Vec3::new(x, y, z));
    prop::collection::vec((position, 0.01..10.0_f32), n)
}

fn of_positions(list: &[(Vec3, f32)], origin: Vec3) -> Moments {
    let each = list.iter().map(|(x, w)| moments_of_position(*x, *w, origin));
    each.fold(moments_empty(), moments_merge)
}

fn of_lobes(list: &[Lobe], reference: Vec3) -> Moments {
    let each = list.iter().map(|(v, k, w)| moments_of_lobe(*v, *k, *w, reference));
    each.fold(moments_empty(), moments_merge)
}

/// Mean and trace of the covariance, in f64.
fn truth(list: &[(Vec3, f32)]) -> (DVec3, f64) {
    let weight: f64 = list.iter().map(|(_, w)| f64::from(*w)).sum();
    let mean = list.iter().map(|(x, w)| x.as_dvec3() * f64::from(*w)).sum::<DVec3>() / weight;
    let spread = list.iter().map(|(x, w)| (x.as_dvec3() - mean).length_squared() * f64::from(*w));
    (mean, spread.sum::<f64>() / weight)
}

fn same(a: Moments, b: Moments, tolerance: f64) -> Result<(), TestCaseError> {
    close(a.weight, b.weight.into(), tolerance * f64::from(b.weight), "weight")?;
    let scale = 1.0_f64.max(b.mean.length().into());
    close((a.mean - b.mean).length(), 0.0, tolerance * scale, "mean")?;
    close(a.spread, b.spread.into(), tolerance * (f64::from(b.spread) + scale), "spread")
}

#[test]
fn moments_of_positions_are_those_of_the_whole() {
    check((positions(20), -1e4..1e4_f32), |(list, far)| {
        let shift = Vec3::splat(far);
        let list: Vec<_> = list.into_iter().map(|(x, w)| (x + shift, w)).collect();
        let (mean, spread) = truth(&list);
        let moments = of_positions(&list, list[0].0);
        let found = list[0].0.as_dvec3() + moments.mean.as_dvec3();
        close((found - mean).length() as f32, 0.0, 1e-4, "mean")?;
        close(moments.spread, spread, 1e-5 * spread, "spread")
    });
}

#[test]
fn merging_is_commutative_and_associative() {
    check(positions(12), |list| {
        let part = |at: usize| of_positions(&list[at..at + 3], list[0].0);
        let (a, b, c, d) = (part(0), part(3), part(6), part(9));
        let whole = of_positions(&list, list[0].0);
        prop_assert_eq!(moments_merge(a, b).spread, moments_merge(b, a).spread);
        same(moments_merge(moments_merge(a, b), c), moments_merge(a, moments_merge(b, c)), 3e-6)?;
        same(moments_merge4(a, b, c, d), whole, 3e-6)?;
        same(moments_merge4(d, b, a, c), whole, 3e-6)?;
        let empty = moments_empty();
        same(moments_merge4(a, empty, b, empty), moments_merge(a, b), 1e-7)
    });
}

#[test]
fn empty_sets_give_nothing() {
    let none = moments_merge4(moments_empty(), moments_empty(), moments_empty(), moments_empty());
    let lobe = moments_to_lobe(none, Vec3::Z);
    assert_eq!((none.weight, none.mean, none.spread), (0.0, Vec3::ZERO, 0.0));
    assert_eq!((lobe.axis, lobe.sharpness), (Vec3::ZERO, 0.0));
}

#[test]
fn variance_of_a_uniform_disk() {
    check((unit(), 1e-2..1e2_f32, 0.0..1e3_f32), |(normal, radius, far)| {
        let (x, y) = normal.any_orthonormal_pair();
        let rings = (0..64_u16).flat_map(|i| (0..64_u16).map(move |j| (i, j)));
        let list: Vec<_> = rings
            .map(|(i, j)| {
                let r = radius * ((f32::from(i) + 0.5) / 64.0).sqrt();
                let phi = std::f32::consts::TAU * f32::from(j) / 64.0;
                (Vec3::splat(far) + r * (x * phi.cos() + y * phi.sin()), 1.0)
            })
            .collect();
        let planar = planar_variance(of_positions(&list, Vec3::splat(far)).spread);
        // Coordinates of 1000 are rounded to 6e-5; 4096 steps of a running mean add up.
        let rounding = 4.0 * f64::from(far) * 6e-8 / f64::from(radius);
        let wanted = f64::from(radius * radius) / 4.0;
        close(planar, wanted, wanted * (1e-4 + rounding), "a quarter of the squared radius")
    });
}

#[test]
fn the_papers_variance_is_lost_far_from_the_origin() {
    let list: Vec<_> = (0..4096_u16)
        .map(|i| (Vec3::new(1000.0 + 0.1 * (f32::from(i) * 0.7).sin(), 1000.0, 1000.0), 1.0))
        .collect();
    let (_, spread) = truth(&list);
    let mut squares = 0.0_f32;
    let mut sum = Vec3::ZERO;
    for (x, _) in &list {
        squares += x.dot(*x);
        sum += *x;
    }
    let paper = f64::from(moments_variance_paper(squares / 4096.0, sum / 4096.0));
    assert!((paper - spread).abs() > 0.5 * spread, "{paper:e} against {spread:e}");
    let found = f64::from(of_positions(&list, list[0].0).spread);
    assert!((found - spread).abs() < 1e-5 * spread, "{found:e} against {spread:e}");
}

#[test]
fn a_lobe_alone_stays_as_it_is() {
    check(lobes(1), |list| {
        let (axis, k, _) = list[0];
        let reference = toksvig_length_paper(k) * axis;
        let lobe = moments_to_lobe(of_lobes(&list, reference), reference);
        close(lobe.sharpness, k.into(), 2e-6 * f64::from(k), "sharpness")?;
        close((lobe.axis - axis).length(), 0.0, 1e-6, "axis")?;
        close(toksvig_sharpness(toksvig_spread(k)), k.into(), 4e-7 * f64::from(k.max(1.0)), "there and back")
    });
}

#[test]
fn the_papers_sharpness_is_lost_near_length_1() {
    // 1 - |m| has six digits less than |m|.
    let k = 1e6_f32;
    let back = toksvig_sharpness_paper(toksvig_length_paper(k));
    assert!((back / k - 1.0).abs() > 1e-3, "{back}");
    let lobe = moments_to_lobe_paper(toksvig_length_paper(k) * Vec3::new(0.6, 0.64, 0.48));
    assert!((lobe.sharpness / k - 1.0).abs() > 1e-3, "{}", lobe.sharpness);
}

#[test]
fn equal_sharp_lobes_keep_their_sharpness() {
    check((unit(), 1e4..1e6_f32), |(axis, k)| {
        let (x, y) = axis.any_orthonormal_pair();
        // Axes that differ by a fifth of the lobes' width.
        let tilt = 0.2 / k.sqrt();
        let axes = [axis + tilt * x, axis - tilt * x, axis + tilt * y, axis - tilt * y].map(Vec3::normalize);
        let list = axes.map(|v| (v, k, 1.0));
        let reference = toksvig_length_paper(k) * axes[0];
        let found = moments_to_lobe(of_lobes(&list, reference), reference);
        // 1 - |m|: that of each lobe, and half the variance of the axes, as rounded.
        let mean = axes.iter().map(|v| v.as_dvec3().normalize()).sum::<DVec3>() / 4.0;
        let len = f64::from(k) / (f64::from(k) + 1.0) * mean.length();
        let short = 1.0 - mean.length() + mean.length() / (f64::from(k) + 1.0);
        // Unit vectors are rounded to 6e-8, against a tilt of 2e-4 and more.
        close(found.sharpness, len / short, 1e-3 * len / short, "sharpness")
    });
}

#[test]
fn filtering_is_invariant_under_rotation_and_does_not_depend_on_the_reference() {
    check((lobes(8), rotation(), unit()), |(list, turn, reference)| {
        let before = moments_to_lobe(of_lobes(&list, reference), reference);
        let turned: Vec<_> = list.iter().map(|(v, k, w)| ((turn * *v).normalize(), *k, *w)).collect();
        let after = moments_to_lobe(of_lobes(&turned, Vec3::ZERO), Vec3::ZERO);
        close(after.sharpness, before.sharpness.into(), 1e-5 * (1.0 + f64::from(before.sharpness)), "k")?;
        prop_assume!(before.sharpness > 1e-2);
        close((turn * before.axis - after.axis).length(), 0.0, 3e-4, "axis")
    });
}

#[test]
fn a_filtered_lobe_is_no_sharper_than_the_sharpest() {
    check(lobes(8), |list| {
        let sharpest = list.iter().map(|(_, k, _)| *k).fold(0.0, f32::max);
        let lobe = moments_to_lobe(of_lobes(&list, Vec3::ZERO), Vec3::ZERO);
        prop_assert!(lobe.sharpness <= sharpest * 1.001 && lobe.sharpness >= 0.0, "{lobe:?}");
        Ok(())
    });
}
