//! One bounce by sampling and by quadrature; rays and spotlights.

use super::NOTHING;
use super::rows::ROWS;
use lobe_codegen::glam::{DVec3, Vec2, Vec3};
use lobe_kernels::brdf::Material;
use lobe_kernels::reference::light::{angle_between, spot_irradiance};
use lobe_kernels::reference::one_bounce::{
    OneBounce, one_bounce_area_integrand, one_bounce_density, one_bounce_estimate, one_bounce_ndf_transfer,
    one_bounce_sample, one_bounce_transfer,
};
use lobe_kernels::reference::random::random_pair;
use lobe_kernels::reference::rectangle::{rectangle_intersect, rectangle_is_met, rectangle_point};
use lobe_kernels::reference::running_mean::{
    RunningMean, luminance, running_mean_add, running_mean_standard_error,
};
use lobe_tests::domain::Rng;

/// RunningMean of `n` contributions `f(direction, distance)`, 0 where the rectangle is missed, a strategy of `strategies`
/// drawn for each.
fn sampled(
    bounce: OneBounce,
    pixel: u32,
    n: u32,
    strategies: &[u32],
    f: impl Fn(Vec3, f32) -> f32,
) -> RunningMean {
    (0..n).fold(NOTHING, |running, index| {
        let pick = (random_pair(pixel, index, 0).x * strategies.len() as f32) as usize;
        let dir = one_bounce_sample(bounce, strategies[pick], random_pair(pixel, index, 1));
        let meeting = rectangle_intersect(bounce.rectangle, bounce.position, dir);
        running_mean_add(running, if rectangle_is_met(meeting) { f(dir, meeting.z) } else { 0.0 })
    })
}

fn judged(running: RunningMean, truth: f64, what: &str) {
    let (mean, error) = (f64::from(running.mean), f64::from(running_mean_standard_error(running)));
    let off = (mean - truth) / error;
    println!("{what}: {mean} ± {error}, truth {truth}: {off} standard errors");
    // Beside the noise, what f32 does to a sum of a million numbers.
    assert!((mean - truth).abs() <= 4.0 * error + 1e-5 * truth, "{what}: {mean} ± {error}, truth {truth}");
    assert!(error < 0.02 * truth, "{what}: too noisy to say anything, {error} of {truth}");
}

#[test]
fn estimates_agree_with_quadrature() {
    for (index, row) in ROWS.iter().enumerate() {
        let bounce = row.bounce();
        let contribution =
            |dir, dist| one_bounce_ndf_transfer(bounce, dir) / one_bounce_density(bounce, dir, dist);
        let running = sampled(bounce, index as u32, 200_000, &[0, 1, 2, 3], contribution);
        judged(running, row.radiance, &format!("row {index}"));
    }
}

/// The integral over the rectangle by the midpoint rule, in the formulas as printed and in f64.
fn by_area(bounce: OneBounce, n: u32) -> DVec3 {
    let mut sum = DVec3::ZERO;
    for (i, j) in (0..n * n).map(|k| (k / n, k % n)) {
        let u = Vec2::new((i as f32 + 0.5) / n as f32, (j as f32 + 0.5) / n as f32);
        sum += printed_integrand(bounce, rectangle_point(bounce.rectangle, u));
    }
    let area = 4.0 * f64::from(bounce.rectangle.half_x) * f64::from(bounce.rectangle.half_y);
    sum * area / f64::from(n * n)
}

fn printed_integrand(bounce: OneBounce, place: Vec3) -> DVec3 {
    let offset = place.as_dvec3() - bounce.position.as_dvec3();
    let w = offset.normalize();
    let (n_a, n_b) = (bounce.rectangle.normal.as_dvec3(), bounce.normal.as_dvec3());
    let light = bounce.light.as_dvec3();
    let cosines = n_a.dot(light).max(0.0) * n_b.dot(w).max(0.0) * (-n_a.dot(w)).max(0.0);
    printed_brdf(bounce.material, n_b, w, bounce.view.as_dvec3())
        * printed_brdf(bounce.rectangle_material, n_a, light, -w)
        * cosines
        / offset.length_squared()
}

fn printed_brdf(material: Material, n: DVec3, l: DVec3, v: DVec3) -> DVec3 {
    if n.dot(l) <= 0.0 || n.dot(v) <= 0.0 {
        return DVec3::ZERO;
    }
    let (h, a2) = ((l + v).normalize(), f64::from(material.alpha).powi(2));
    let d = a2 / (std::f64::consts::PI * (n.dot(h).powi(2) * (a2 - 1.0) + 1.0).powi(2));
    let root = |c: f64| (a2 + (1.0 - a2) * c * c).sqrt();
    let visibility = 0.5 / (n.dot(l) * root(n.dot(v)) + n.dot(v) * root(n.dot(l)));
    let f0 = material.f0.as_dvec3();
    let fresnel = f0 + (DVec3::splat(f64::from(material.f90)) - f0) * (1.0 - v.dot(h)).powi(5);
    material.diffuse_albedo.as_dvec3() / std::f64::consts::PI + d * visibility * fresnel
}

fn coloured(index: usize) -> OneBounce {
    let mut bounce = ROWS[index].bounce();
    bounce.material.diffuse_albedo = Vec3::new(0.5, 0.3, 0.1);
    bounce.material.f0 = Vec3::new(0.04, 0.05, 0.06);
    bounce.rectangle_material.diffuse_albedo = Vec3::new(0.1, 0.2, 0.6);
    bounce.rectangle_material.f0 = Vec3::new(0.9, 0.6, 0.2);
    bounce
}

#[test]
fn whole_surfaces_agree_with_quadrature_of_the_printed_formulas() {
    for index in [4, 5, 7, 8] {
        let bounce = coloured(index);
        let truth = by_area(bounce, 700).as_vec3();
        let contribution = |dir, dist| luminance(one_bounce_estimate(bounce, dir, dist));
        let running = sampled(bounce, 100 + index as u32, 100_000, &[0, 1, 2, 3], contribution);
        judged(running, luminance(truth).into(), &format!("surfaces of row {index}"));
    }
}

#[test]
fn one_strategy_alone_agrees_with_all() {
    let bounce = coloured(8);
    let area = 4.0 * bounce.rectangle.half_x * bounce.rectangle.half_y;
    let uniform = (0..100_000).fold(NOTHING, |running, index| {
        let place = rectangle_point(bounce.rectangle, random_pair(7, index, 5));
        running_mean_add(running, area * luminance(one_bounce_area_integrand(bounce, place)))
    });
    let by_area = sampled(bounce, 8, 100_000, &[0], |dir, dist| {
        luminance(one_bounce_transfer(bounce, dir)) * area / (dist * dist)
    });
    let truth = f64::from(luminance(self::by_area(bounce, 700).as_vec3()));
    judged(uniform, truth, "by area");
    judged(by_area, truth, "by area, over directions");
}

#[test]
fn the_integrand_is_the_printed_one() {
    let seed = 11;
    let mut rng = Rng::new(seed, "integrand");
    for row in &ROWS {
        let mut bounce = row.bounce();
        bounce.material.diffuse_albedo = Vec3::new(0.5, 0.3, 0.1);
        bounce.rectangle_material.f0 = Vec3::new(0.9, 0.6, 0.2);
        for _ in 0..200 {
            let u = Vec2::new(rng.unit() as f32, rng.unit() as f32);
            let place = rectangle_point(bounce.rectangle, u);
            let (found, wanted) =
                (one_bounce_area_integrand(bounce, place), printed_integrand(bounce, place));
            let gap = (found.as_dvec3() - wanted).abs().max_element();
            let sharpest = f64::from(bounce.material.alpha.min(bounce.rectangle_material.alpha));
            let grazing = f64::from(bounce.normal.dot(bounce.view)).min(0.05);
            let permitted = 1e-5 / sharpest / grazing * wanted.max_element() + 1e-7;
            assert!(gap <= permitted, "{found} against {wanted}");
        }
    }
}

#[test]
fn rays_meet_the_points_they_were_aimed_at() {
    let mut rng = Rng::new(3, "rays");
    for row in &ROWS {
        let bounce = row.bounce();
        for _ in 0..100 {
            let u = Vec2::new(rng.range(0.01, 0.99) as f32, rng.range(0.01, 0.99) as f32);
            let place = rectangle_point(bounce.rectangle, u);
            let dir = (place - bounce.position).normalize();
            let meeting = rectangle_intersect(bounce.rectangle, bounce.position, dir);
            if bounce.rectangle.normal.dot(dir) > -0.05 {
                continue;
            }
            assert!(rectangle_is_met(meeting), "{meeting}");
            let gap = (Vec2::new(meeting.x, meeting.y) - (2.0 * u - Vec2::ONE)).abs().max_element();
            assert!(
                gap < 2e-4 && (meeting.z / (place - bounce.position).length() - 1.0).abs() < 2e-5,
                "{gap}"
            );
            let behind = rectangle_intersect(bounce.rectangle, bounce.position, -dir);
            assert!(!rectangle_is_met(behind), "{behind}");
        }
    }
}

#[test]
fn a_spotlight_falls_off_linearly_in_the_angle() {
    let mut rng = Rng::new(13, "spot");
    let direction = |rng: &mut Rng| DVec3::new(rng.normal(), rng.normal(), rng.normal()).normalize();
    for _ in 0..2000 {
        let (axis, apart) = (direction(&mut rng), direction(&mut rng));
        let light = -(axis + apart * 10f64.powf(rng.range(-4.0, 0.5))).normalize();
        let (outer, blend, dist) = (rng.range(0.02, 1.5), rng.range(0.01, 0.5), rng.range(0.1, 10.0));
        let (near, far) = (axis.as_vec3(), light.as_vec3());
        let angle = near.as_dvec3().normalize().cross(-far.as_dvec3().normalize()).length();
        let angle = angle.atan2(-near.as_dvec3().dot(far.as_dvec3()));
        let truth = ((outer - angle) / blend).clamp(0.0, 1.0) / (dist * dist);
        let found = spot_irradiance(near, outer as f32, blend as f32, far, dist as f32);
        let gap = (f64::from(found) - truth).abs();
        assert!(gap <= (1e-6 + 1e-6 / blend) / (dist * dist), "{found} against {truth}");
        if angle < 1.57 {
            let between = f64::from(angle_between(near, -far));
            assert!((between - angle).abs() < 3e-7 * angle + 1e-7, "{between} against {angle}");
        }
    }
}
