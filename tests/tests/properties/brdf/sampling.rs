//! Frames, and samples against their densities.

use super::{alpha, pair, upper};
use crate::support::{check, close, direction, seed, unit};
use lobe_codegen::glam::{Vec2, Vec3};
use lobe_kernels::brdf::sampling::{
    circle_of_turn, cosine_hemisphere_pdf, cosine_sample_hemisphere, frame_to_local, frame_to_world,
    ggx_half_vector_pdf, ggx_sample_half_vector, ggx_sample_visible_normal, ggx_visible_normal_pdf, mirror,
    orthonormal_frame,
};
use lobe_tests::domain::Rng;
use proptest::prelude::*;
use std::f64::consts::TAU;

#[test]
fn frames_are_orthonormal_and_invert() {
    check((unit(), unit()), |(n, d)| {
        let f = orthonormal_frame(n);
        let gaps = [f.x.dot(f.y), f.y.dot(f.z), f.z.dot(f.x), f.x.length() - 1.0, f.y.length() - 1.0];
        prop_assert!(gaps.iter().all(|g| g.abs() < 1e-6), "{gaps:?}");
        prop_assert!((f.z.cross(f.x) - f.y).length() < 1e-6, "right-handed");
        prop_assert!((frame_to_world(f, frame_to_local(f, d)) - d).length() < 2e-6);
        Ok(())
    });
}

#[test]
fn the_circle_is_that_of_sine_and_cosine() {
    check(0.0..=1.0_f32, |turn| {
        let (sin, cos) = (TAU * f64::from(turn)).sin_cos();
        let found = circle_of_turn(turn);
        close(found.x, cos, 3e-7, "cosine")?;
        close(found.y, sin, 3e-7, "sine")
    });
    for (turn, at) in [(0.0, [1.0, 0.0]), (0.25, [0.0, 1.0]), (0.5, [-1.0, 0.0]), (0.75, [0.0, -1.0])] {
        assert!((circle_of_turn(turn) - Vec2::from(at)).length() < 2e-7, "{turn}");
    }
}

/// Counts of samples by height and azimuth against the density's integrals over the same cells: chi-square over its
/// degrees of freedom, in standard deviations.
fn chi_square(samples: &[Vec3], total: usize, pdf: impl Fn(Vec3) -> f64) -> f64 {
    let (rows, columns, fine) = (24_usize, 12_usize, 24_usize);
    let mut counts = vec![0.0; rows * columns];
    for s in samples {
        let row = (((f64::from(s.z) + 1.0) / 2.0 * rows as f64) as usize).min(rows - 1);
        let turn = f64::from(s.y).atan2(f64::from(s.x)).rem_euclid(TAU) / TAU;
        counts[row * columns + ((turn * columns as f64) as usize).min(columns - 1)] += 1.0;
    }
    let (mut chi, mut cells, mut rest) = (0.0, 0.0, (0.0, 0.0));
    for row in 0..rows {
        for column in 0..columns {
            let mut expected = 0.0;
            for (i, j) in (0..fine * fine).map(|k| (k / fine, k % fine)) {
                let z = -1.0 + 2.0 * (row as f64 + (i as f64 + 0.5) / fine as f64) / rows as f64;
                let phi = TAU * (column as f64 + (j as f64 + 0.5) / fine as f64) / columns as f64;
                expected += pdf(direction(z, phi));
            }
            let solid_angle = 2.0 * TAU / (rows * columns * fine * fine) as f64;
            let (expected, count) = (expected * solid_angle * total as f64, counts[row * columns + column]);
            if expected < 10.0 {
                rest = (rest.0 + expected, rest.1 + count);
            } else {
                chi += (count - expected) * (count - expected) / expected;
                cells += 1.0;
            }
        }
    }
    // Thinly filled cells count as one.
    chi += (rest.1 - rest.0) * (rest.1 - rest.0) / rest.0.max(10.0);
    (chi - cells) / (2.0 * cells).sqrt()
}

#[test]
fn samples_follow_their_densities() {
    let seed = seed();
    let mut rng = Rng::new(seed, "densities");
    let n = 120_000;
    let flat: Vec<Vec3> = (0..n).map(|_| cosine_sample_hemisphere(pair(&mut rng))).collect();
    let off = chi_square(&flat, n, |l| f64::from(cosine_hemisphere_pdf(l.z)));
    assert!(off < 6.0, "seed {seed}: cosine, {off} standard deviations");
    for (alpha, cosine) in [(0.25_f32, 0.9), (0.5, 0.3), (1.0, 0.7), (1.0, 0.05)] {
        let view = direction(cosine, 2.0);
        let seen = |rng: &mut Rng| mirror(view, ggx_sample_visible_normal(view, alpha, pair(rng)));
        let visible: Vec<Vec3> = (0..n).map(|_| seen(&mut rng)).collect();
        let pdf = |l: Vec3| {
            if (l + view).z > 0.0 { f64::from(ggx_visible_normal_pdf(alpha, Vec3::Z, l, view)) } else { 0.0 }
        };
        let off = chi_square(&visible, n, pdf);
        assert!(off < 6.0, "seed {seed}: visible normals {alpha} {cosine}, {off} standard deviations");
        let plain = |rng: &mut Rng| mirror(view, ggx_sample_half_vector(alpha, pair(rng)));
        // Half vectors that face away from the view mirror it below the horizon, where the density is 0.
        let halves: Vec<Vec3> = (0..n).map(|_| plain(&mut rng)).filter(|l| (*l + view).z > 0.0).collect();
        let off = chi_square(&halves, n, |l| f64::from(ggx_half_vector_pdf(alpha, Vec3::Z, l, view)));
        assert!(off < 6.0, "seed {seed}: half vectors {alpha} {cosine}, {off} standard deviations");
    }
}

fn uniform_pair() -> impl Strategy<Value = Vec2> {
    (0.0..0.9999_f32, 0.0..0.9999_f32).prop_map(|(x, y)| Vec2::new(x, y))
}

#[test]
fn sampled_normals_are_units_above_the_horizon() {
    check((upper(), alpha(), uniform_pair()), |(view, alpha, u)| {
        let normals = [
            ggx_sample_visible_normal(view, alpha, u),
            ggx_sample_half_vector(alpha, u),
            cosine_sample_hemisphere(u),
        ];
        prop_assert!(normals.iter().all(|h| (h.length() - 1.0).abs() < 2e-6 && h.z > 0.0), "{normals:?}");
        prop_assert!(normals[0].dot(view) > -1e-6, "a visible normal faces the view");
        Ok(())
    });
}
