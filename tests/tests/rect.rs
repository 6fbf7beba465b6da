//! Properties of the glossy rectangle: the falloff and its fit, the disk's energy and area, the shading and what it is
//! worth against the integral, the form factor.
//!
//! Each random test draws its cases from a seed that it prints; `LOBE_SEED=n` repeats a run.

use lobe_codegen::emit::{Options, Target, emit};
use lobe_codegen::glam::{DVec3, Mat3, Quat};
use lobe_codegen::prelude::*;
use lobe_kernels::asg::asg_integral_paper;
use lobe_kernels::rect::attenuation::{
    rect_attenuation, rect_falloff, rect_falloff_fit, rect_falloff_paper, rect_psi_paper,
};
use lobe_kernels::rect::chain::{rect_shade_light, rect_shade_light_paper};
use lobe_kernels::rect::diffuse::{rect_diffuse_glossy, rect_form_factor};
use lobe_kernels::rect::disk::{
    rect_coverage, rect_coverage_bounds, rect_coverage_paper, rect_disk_area, rect_disk_bounds,
    rect_disk_radius,
};
use lobe_kernels::rect::energy::{rect_energy, rect_energy_ggx};
use lobe_kernels::rect::light::{
    rect_asg_from_disk, rect_bandwidth_paper, rect_bandwidth_slope, rect_disk_frame,
};
use lobe_kernels::rect::peak::rect_specular_peak;
use lobe_kernels::rect::reflection::{DistantLight, Reflection, rect_reflection};
use lobe_kernels::rect::shade::rect_shade;
use lobe_kernels::rect::{GlossyReceiver, Rectangle};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use std::f64::consts::{FRAC_PI_2, PI};

/// Runs `test` on values of `strategy`, 256 of them, from a printed seed.
fn check<S: Strategy>(strategy: S, test: impl Fn(S::Value) -> Result<(), TestCaseError>) {
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

fn unit() -> impl Strategy<Value = Vec3> {
    (-1.0..=1.0_f64, 0.0..std::f64::consts::TAU).prop_map(|(z, phi)| {
        let r = (1.0 - z * z).sqrt();
        DVec3::new(r * phi.cos(), r * phi.sin(), z).normalize().as_vec3()
    })
}

fn rotation() -> impl Strategy<Value = Mat3> {
    (unit(), 0.0..6.0_f32).prop_map(|(axis, angle)| Mat3::from_quat(Quat::from_axis_angle(axis, angle)))
}

/// A rectangle in the plane `z = 0`.
fn level(half_x: f32, half_y: f32) -> Rectangle {
    Rectangle { position: Vec3::ZERO, normal: Vec3::Z, tangent: Vec3::X, half_x, half_y }
}

/// A rectangle, a light on its side, a position on its side and a viewer on the position's: the scene of a shading.
type Scene = (Rectangle, f32, DistantLight, GlossyReceiver, f32);

fn scene() -> impl Strategy<Value = Scene> {
    let rectangle = (0.2..3.0_f32, 0.2..3.0_f32).prop_map(|(x, y)| level(x, y));
    let receiver = (-1.0..1.0_f32, -1.0..1.0_f32, 0.3..3.0_f32, 0.05..0.6_f32, 0.3..1.0_f32, 0.0..6.0_f32);
    let light = (0.05..1.3_f32, 0.0..6.0_f32).prop_map(|(sigma, phi)| DistantLight {
        direction: Vec3::new(sigma.sin() * phi.cos(), sigma.sin() * phi.sin(), sigma.cos()),
        irradiance: 1.0,
    });
    (rectangle, 0.05..0.7_f32, light, receiver, 0.05..0.8_f32).prop_map(
        |(rectangle, alpha, light, (x, y, z, own, tilt, phi), radius)| {
            // Towards the peak, and looked at from near the mirror direction.
            let to_peak = (light.direction - 2.0 * light.direction.z * Vec3::Z).normalize();
            let aside = to_peak.any_orthonormal_vector();
            let normal = (to_peak + tilt * 0.3 * aside).normalize();
            let mirror = 2.0 * to_peak.dot(normal) * normal - to_peak;
            let view = (mirror + 0.1 * phi.sin() * aside).normalize();
            let receiver =
                GlossyReceiver { position: Vec3::new(x, y, z), normal, view, alpha: own, reflectance: 1.0 };
            (rectangle, alpha, light, receiver, radius)
        },
    )
}

fn close(a: f32, b: f64, tolerance: f64, what: &str) -> Result<(), TestCaseError> {
    prop_assert!((f64::from(a) - b).abs() <= tolerance, "{what}: {a} against {b}, tolerance {tolerance:e}");
    Ok(())
}

/// Largest distance of two functions of the tangent over angles up to a right one.
fn farthest(f: impl Fn(f32) -> f32, g: impl Fn(f32) -> f32) -> f32 {
    let tangents = (0..=2000).map(|i| (FRAC_PI_2 * f64::from(i) / 2000.0).tan().min(1e7) as f32);
    tangents.map(|t| (f(t) - g(t)).abs()).fold(0.0, f32::max)
}

#[test]
fn the_fit_errs_as_figure_4_shows() {
    let pairs = [(PI / 6.0, 0.1, 0.120, 0.163), (0.4 * PI, 0.1, 0.196, 0.455)];
    let rough = [(PI / 6.0, 0.7, 0.630, 0.433), (0.4 * PI, 0.7, 0.951, 0.433)];
    for (sigma, alpha, to_paper, to_exact) in pairs.into_iter().chain(rough) {
        let fit = |t| rect_falloff_fit(t, sigma.cos() as f32, alpha);
        let paper = farthest(fit, |t| rect_falloff_paper(t, sigma.tan() as f32, alpha));
        let exact = farthest(fit, |t| rect_falloff(t, alpha));
        assert!((paper - to_paper).abs() < 1e-3, "σ {sigma}, m {alpha}: {paper} instead of {to_paper}");
        assert!((exact - to_exact).abs() < 1e-3, "σ {sigma}, m {alpha}: {exact} instead of {to_exact}");
    }
}

#[test]
fn the_fitted_exponent_passes_zero_where_the_text_says() {
    assert!(rect_attenuation(1.0, 0.6541).abs() < 1e-3);
    assert!((rect_attenuation((PI / 6.0).cos() as f32, 0.1) - 24.27).abs() < 0.01);
    assert!((rect_attenuation((0.4 * PI).cos() as f32, 0.7) + 0.491).abs() < 0.001);
}

#[test]
fn the_printed_angle_is_the_stable_one() {
    check((0.0..1.5_f64, 0.0..1.4_f64), |(theta, sigma)| {
        let secant = 1.0 / (sigma.cos() * sigma.cos());
        let printed = -0.5 * sigma + 0.5 * (secant * theta.tan() + sigma.tan()).atan();
        close(rect_psi_paper(theta.tan() as f32, sigma.tan() as f32), printed, 3e-7, "ψ")
    });
}

#[test]
fn the_falloff_is_that_of_the_distribution() {
    check((0.0..1.55_f64, 0.02..1.0_f64), |(theta, alpha)| {
        let (c, a2) = ((0.5 * theta).cos(), alpha * alpha);
        let exact = (a2 / (1.0 - (1.0 - a2) * c * c)).powi(2);
        // The argument, rounded to f32, is off by 6e-8.
        close(rect_falloff(theta.tan() as f32, alpha as f32), exact, 1e-5 * exact + 1e-7, "f")
    });
}

#[test]
fn the_energy_is_the_fits_integral_for_any_exponent() {
    check((-0.673..50.0_f64, 0.0..1.0_f64, 0.0..1.0_f64), |(k, t, tiny)| {
        for k in [k, 1e-6 * tiny, 0.0, -1e-6 * tiny] {
            // ∫ 2π e^(-k sin² θ) cos θ sin θ dθ = π ∫ e^(-k u) du.
            let exact: f64 = (0..2000).map(|i| (-k * t * (f64::from(i) + 0.5) / 2000.0).exp()).sum();
            let exact = 2.5 * PI * t * exact / 2000.0;
            close(rect_energy(1.0, 2.5, k as f32, t as f32), exact, 1e-4 * exact + 1e-12, "C")?;
        }
        Ok(())
    });
    assert_eq!(rect_energy(1.0, 1.0, 0.0, 0.5), rect_energy(1.0, 1.0, -1e-30, 0.5));
}

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

#[test]
fn shading_turns_and_grows_with_the_scene() {
    check(
        (scene(), rotation(), -2.0..2.0_f32),
        |((rectangle, alpha, light, receiver, radius), turn, size)| {
            let plain = rect_shade_light(rectangle, alpha, 1.0, light, receiver, radius);
            let size = 2.0_f32.powf(size);
            let turned = Rectangle {
                position: Vec3::new(1.0, -2.0, 3.0),
                normal: turn * rectangle.normal,
                tangent: turn * rectangle.tangent,
                half_x: size * rectangle.half_x,
                half_y: size * rectangle.half_y,
            };
            let light = DistantLight { direction: turn * light.direction, ..light };
            let receiver = GlossyReceiver {
                position: turned.position + size * (turn * receiver.position),
                normal: turn * receiver.normal,
                view: turn * receiver.view,
                ..receiver
            };
            let other = rect_shade_light(turned, alpha, 1.0, light, receiver, size * radius);
            let scale = plain.radiance.max(1e-3 * plain.amplitude);
            prop_assert!(
                (other.radiance - plain.radiance).abs() <= 3e-3 * scale,
                "{} became {}",
                plain.radiance,
                other.radiance
            );
            Ok(())
        },
    );
}

#[test]
fn nothing_shines_from_below() {
    check(scene(), |(rectangle, alpha, light, receiver, radius)| {
        let shade =
            |light, receiver| rect_shade_light(rectangle, alpha, 1.0, light, receiver, radius).radiance;
        let mirrored = |v: Vec3| Vec3::new(v.x, v.y, -v.z);
        let under = DistantLight { direction: mirrored(light.direction), ..light };
        let low = GlossyReceiver { position: mirrored(receiver.position), ..receiver };
        let behind = GlossyReceiver { view: -receiver.normal, ..receiver };
        let away = GlossyReceiver { normal: -receiver.normal, view: -receiver.view, ..receiver };
        prop_assert!(shade(light, receiver) >= 0.0);
        for (light, receiver) in [(under, receiver), (light, low), (light, behind), (light, away)] {
            prop_assert_eq!(shade(light, receiver), 0.0);
        }
        Ok(())
    });
}

#[test]
fn the_printed_form_lacks_the_factor_of_its_light() {
    check(scene(), |(rectangle, alpha, light, receiver, radius)| {
        let right = rect_shade_light(rectangle, alpha, 1.0, light, receiver, radius);
        let printed = rect_shade_light_paper(rectangle, alpha, 1.0, light, receiver, radius);
        let factor = PI * f64::from(alpha * alpha) * f64::from(printed.coverage / right.coverage.max(1e-9));
        if right.coverage > 0.0 {
            close(printed.energy / right.energy, factor, 1e-4 * factor, "energy")?;
        }
        prop_assert!(printed.coverage >= right.coverage);
        Ok(())
    });
}

/// Directions to the light, to the peak, of the normal and to the viewer, for an angle of incidence.
fn leaning(sigma: f64) -> (DVec3, DVec3, DVec3, DVec3) {
    let light = DVec3::new(sigma.sin(), 0.0, sigma.cos());
    let to_peak = DVec3::new(light.x, 0.0, -light.z);
    let normal = (PI / 6.0).cos() * to_peak - 0.5 * DVec3::new(sigma.cos(), 0.0, sigma.sin());
    (light, to_peak, normal, 2.0 * to_peak.dot(normal) * normal - to_peak)
}

/// Equation 3 by quadrature: a GGX rectangle of 4 by 4 around its peak, seen by a position at distance 1 of it whose
/// normal leans 30° from it, and which is looked at in the mirror direction; both BRDFs without their `M`. And
/// equation 13.
fn brute_force(sigma: f64, alpha: f64, own: f64) -> (f64, f64) {
    let (light, to_peak, normal, view) = leaning(sigma);
    let n = 800;
    let (mut shaded, mut energy) = (0.0, 0.0);
    // Cubic spacing: fine near the peak.
    let at = |i: i32| (2.0 * f64::from(i) + 1.0) / f64::from(n) - 1.0;
    let cell = |s: f64| 12.0 * s * s / f64::from(n);
    for i in 0..n {
        for j in 0..n {
            let way = DVec3::new(2.0 * at(i).powi(3), 2.0 * at(j).powi(3), 0.0) + to_peak;
            let dist = way.length();
            let w = way / dist;
            let solid = light.z / dist.powi(3) * cell(at(i)) * cell(at(j));
            let half = (light - w).normalize();
            let below = half.truncate().length_squared() + alpha * alpha * half.z * half.z;
            let from_rectangle = alpha * alpha / (PI * below * below) * light.z;
            let own_half = (w + view).normalize();
            let lobe = (2.0 / (own * own) * (own_half.dot(normal) - 1.0)).exp() / (PI * own * own);
            energy += from_rectangle * solid;
            shaded += from_rectangle * lobe * w.dot(normal).max(0.0) * solid;
        }
    }
    (shaded, energy)
}

#[test]
fn the_shading_is_as_far_from_the_integral_as_stated() {
    // σ in degrees, m of the rectangle, radiance and energy over the integral; the disk has four lobes.
    let stated = [
        (0.01, 0.05, 0.972, 0.868),
        (0.01, 0.1, 1.028, 0.891),
        (0.01, 0.3, 1.386, 1.036),
        (30.0, 0.05, 1.229, 1.107),
        (30.0, 0.1, 1.289, 1.129),
        (30.0, 0.3, 1.566, 1.224),
        (60.0, 0.1, 1.701, 1.549),
        (60.0, 0.3, 1.809, 1.479),
        (75.0, 0.1, 1.129, 1.032),
    ];
    for (sigma, alpha, of_radiance, of_energy) in stated {
        let sigma = f64::to_radians(sigma);
        let (radiance, energy) = brute_force(sigma, alpha, 0.15);
        let (light, to_peak, normal, view) = leaning(sigma);
        let receiver = GlossyReceiver {
            position: -to_peak.as_vec3(),
            normal: normal.as_vec3(),
            view: view.as_vec3(),
            alpha: 0.15,
            reflectance: 1.0,
        };
        let light = DistantLight { direction: light.as_vec3(), irradiance: 1.0 };
        let shade = rect_shade_light(level(2.0, 2.0), alpha as f32, 1.0, light, receiver, 4.0 * alpha as f32);
        let (a, b) = (f64::from(shade.radiance) / radiance, f64::from(shade.energy) / energy);
        assert!((a - of_radiance).abs() < 2e-3, "σ {sigma}, m {alpha}: radiance {a}");
        assert!((b - of_energy).abs() < 2e-3, "σ {sigma}, m {alpha}: energy {b}");
        let fitless =
            rect_energy_ggx(1.0, light.direction.z, light.direction.z, 4.0 * alpha as f32, alpha as f32);
        let c = f64::from(fitless) / energy;
        assert!((0.6..1.2).contains(&c), "σ {sigma}, m {alpha}: energy without a fit {c}");
    }
}

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

/// Gathers the light of all rectangles at each receiver: the reflections are made once a rectangle and light.
#[kernel(workgroup_size(64))]
pub fn gather_rectangles(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] rectangles: &[Rectangle],
    #[storage(0, 1)] reflections: &[Reflection],
    #[storage(0, 2)] receivers: &[GlossyReceiver],
    #[storage(0, 3)] alphas: &[f32],
    #[storage(0, 4)] radiances: &mut [f32],
) {
    let receiver = receivers[id.x as usize];
    let mut sum = 0.0;
    for i in 0..rectangles.len() {
        let rectangle = rectangles[i];
        let offset = receiver.position - rectangle.position;
        let dist = max(dot(offset, rectangle.normal), 0.0) / max(reflections[i].cos_sigma, 1e-3);
        let radius = rect_disk_radius(3.0, alphas[i], dist, rectangle.half_x, rectangle.half_y);
        sum += rect_shade(rectangle, reflections[i], receiver, max(radius, 1e-3)).radiance;
    }
    radiances[id.x as usize] = sum;
}

#[test]
fn rectangles_are_gathered_in_every_language() {
    let module =
        lobe_codegen::lower(&lobe_codegen::kernels![gather_rectangles]).unwrap_or_else(|e| panic!("{e}"));
    for target in Target::ALL {
        emit(&module, target, &Options::default()).unwrap_or_else(|e| panic!("{target}: {e}"));
    }
}

#[test]
fn lights_add() {
    check(scene(), |(rectangle, alpha, light, receiver, radius)| {
        let shade = |e| {
            let reflection =
                rect_reflection(rectangle.normal, alpha, 0.5, DistantLight { irradiance: e, ..light });
            rect_shade(rectangle, reflection, receiver, radius).radiance
        };
        close(shade(3.0), f64::from(shade(1.0) + shade(2.0)), 1e-5 * f64::from(shade(3.0)), "the sum")
    });
}
