//! Properties of the reflectance models, their lobes and their sampling: quadrature, identities, limits.
//!
//! Each test draws its cases from a seed that it prints; `LOBE_SEED=n` repeats a run.

use lobe_codegen::glam::{DVec3, Mat3, Quat, Vec2, Vec3};
use lobe_kernels::asg::asg_eval;
use lobe_kernels::brdf::Material;
use lobe_kernels::brdf::fresnel::{fresnel_schlick, fresnel_schlick_between};
use lobe_kernels::brdf::lobe::{asg_ndf, asg_ndf_warp, sg_ndf, sg_ndf_warp};
use lobe_kernels::brdf::model::{
    lambert_brdf, microfacet_brdf, microfacet_m, microfacet_reflectance, surface_brdf, surface_brdf_cosine,
    surface_transfer,
};
use lobe_kernels::brdf::ndf::{beckmann_ndf, ggx_ndf, ggx_ndf_between, ggx_ndf_cosine, ggx_ndf_paper};
use lobe_kernels::brdf::sampling::{
    circle_of_turn, cosine_hemisphere_pdf, cosine_sample_hemisphere, frame_to_local, frame_to_world,
    ggx_half_vector_pdf, ggx_sample_half_vector, ggx_sample_visible_normal, ggx_visible_normal_pdf, mirror,
    orthonormal_frame,
};
use lobe_kernels::brdf::visibility::{smith_g1, smith_g2, smith_visibility};
use lobe_kernels::sg::sg_eval;
use lobe_tests::domain::Rng;
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use std::f64::consts::{PI, TAU};

fn seed() -> u64 {
    let seed: u64 = match std::env::var("LOBE_SEED").ok().and_then(|s| s.parse().ok()) {
        Some(seed) => seed,
        None => std::time::SystemTime::UNIX_EPOCH.elapsed().map_or(7, |t| t.as_nanos() as u64),
    };
    println!("seed {seed} (repeat with LOBE_SEED={seed})");
    seed
}

/// Runs `test` on values of `strategy`, 256 of them, from a printed seed.
fn check<S: Strategy>(strategy: S, test: impl Fn(S::Value) -> Result<(), TestCaseError>) {
    let seed = seed();
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let config = ProptestConfig { failure_persistence: None, ..ProptestConfig::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &bytes));
    if let Err(error) = runner.run(&strategy, test) {
        panic!("seed {seed}: {error}");
    }
}

fn close(a: f32, b: f64, tolerance: f64, what: &str) -> Result<(), TestCaseError> {
    prop_assert!((f64::from(a) - b).abs() <= tolerance, "{what}: {a} against {b}, tolerance {tolerance:e}");
    Ok(())
}

fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance, "{what}: {a} against {b}, tolerance {tolerance:e}");
}

fn direction(z: f64, phi: f64) -> Vec3 {
    let r = (1.0 - z * z).max(0.0).sqrt();
    DVec3::new(r * phi.cos(), r * phi.sin(), z).normalize().as_vec3()
}

fn unit() -> impl Strategy<Value = Vec3> {
    (-1.0..=1.0_f64, 0.0..TAU).prop_map(|(z, phi)| direction(z, phi))
}

/// Above the horizon of `z`, down to 1e-3 from it.
fn upper() -> impl Strategy<Value = Vec3> {
    (1e-3..=1.0_f64, 0.0..TAU).prop_map(|(z, phi)| direction(z, phi))
}

fn alpha() -> impl Strategy<Value = f32> {
    (0.02_f32.ln()..0.0).prop_map(f32::exp)
}

fn colour() -> impl Strategy<Value = Vec3> {
    (0.0..=1.0_f32, 0.0..=1.0_f32, 0.0..=1.0_f32).prop_map(|(r, g, b)| Vec3::new(r, g, b))
}

fn material() -> impl Strategy<Value = Material> {
    (colour(), colour(), 0.0..=1.0_f32, alpha()).prop_map(|(diffuse_albedo, f0, f90, alpha)| Material {
        diffuse_albedo,
        f0,
        f90,
        alpha,
    })
}

fn rotation() -> impl Strategy<Value = Mat3> {
    (unit(), 0.0..6.0_f32).prop_map(|(axis, angle)| Mat3::from_quat(Quat::from_axis_angle(axis, angle)))
}

fn uniform_pair() -> impl Strategy<Value = Vec2> {
    (0.0..0.9999_f32, 0.0..0.9999_f32).prop_map(|(x, y)| Vec2::new(x, y))
}

/// `∫ f(θ) sin θ dθ dφ` over the upper hemisphere for what is flat about `z`, fine near it: midpoint rule in `s`,
/// `tan θ = width s/(1 - s)`.
fn about_z(width: f64, f: impl Fn(Vec3) -> f64) -> f64 {
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
fn about(axis: Vec3, width: f64, f: impl Fn(Vec3) -> f64) -> f64 {
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

#[test]
fn distributions_of_normals_are_normalised() {
    for alpha in [0.02_f32, 0.05, 0.1, 0.3, 0.6, 1.0] {
        let width = f64::from(alpha);
        let ggx = about_z(width, |h| f64::from(ggx_ndf(Vec3::Z, h, alpha)) * f64::from(h.z));
        near(ggx, 1.0, 1e-5, "GGX");
        let beckmann = about_z(width, |h| f64::from(beckmann_ndf(Vec3::Z, h, alpha)) * f64::from(h.z));
        near(beckmann, 1.0, 1e-5, "Beckmann");
    }
}

#[test]
fn the_lobe_of_a_distribution_normalises_another_integral() {
    // [alpha, ∫ G cos]
    for (alpha, projected) in [(0.1_f32, 0.9950), (0.3, 0.955), (0.5, 0.875), (1.0, 0.57)] {
        let sg = sg_ndf(Vec3::Z, alpha);
        let width = f64::from(alpha);
        let value = |h: Vec3| f64::from(sg_eval(h, sg));
        near(about_z(width, |h| value(h) * f64::from(h.z)), projected, 2.5e-3, "with the cosine");
        let whole = 1.0 - (-4.0 / (width * width)).exp();
        let upper = 1.0 - (-2.0 / (width * width)).exp();
        near(about_z(width, value), upper, 1e-4, "upper hemisphere");
        near(f64::from(sg_eval(Vec3::Z, sg)) * TAU * width * width / 2.0 * whole, whole, 1e-5, "sphere");
    }
}

#[test]
fn the_lobe_of_a_distribution_has_its_peak_and_not_its_tail() {
    let alpha = 0.1_f32;
    for (at, ratio) in [(0.0, 1.0), (0.5, 1.21), (1.0, 1.45), (1.5, 1.09), (2.0, 0.45), (3.0, 0.012)] {
        let h = direction((at * f64::from(alpha)).cos(), 1.0);
        let found = f64::from(sg_eval(h, sg_ndf(Vec3::Z, alpha)) / ggx_ndf(Vec3::Z, h, alpha));
        near(found, ratio, 0.015, "SG/GGX");
    }
}

#[test]
fn stable_forms_are_the_printed_ones() {
    check((1e-3..=1.0_f32, 0.0..=1.0_f32, unit(), unit()), |(alpha, cosine, n, h)| {
        let (a, c) = (f64::from(alpha), f64::from(cosine));
        let printed = |c: f64, a: f64| a * a / (PI * (1.0 - (1.0 - a * a) * c * c).powi(2));
        close(ggx_ndf_cosine(cosine, alpha), printed(c, a), 3e-6 * printed(c, a), "by the cosine")?;
        let coarse = 1e-6 / (a * a) * printed(c, a);
        close(ggx_ndf_paper(cosine, alpha), printed(c, a), 3e-6 * printed(c, a) + coarse, "as printed")?;
        let (m, k) = (n.as_dvec3().normalize(), h.as_dvec3().normalize());
        let c = m.dot(k).abs();
        prop_assume!(c < 0.99);
        close(ggx_ndf(n, h, alpha), printed(c, a), 2e-5 * printed(c, a), "by vectors")?;
        let tangent = (1.0 - c * c) / (c * c);
        let beckmann = (-tangent / (a * a)).exp() / (PI * a * a * c.powi(4));
        let scale = 1e-5 + 1e-5 * tangent / (a * a);
        prop_assume!(c > 1e-2);
        close(beckmann_ndf(n, h, alpha), beckmann, scale * beckmann + 1e-18, "Beckmann")
    });
}

#[test]
fn the_distribution_between_directions_is_that_at_their_half_vector() {
    check((upper(), upper(), alpha()), |(l, v, alpha)| {
        let h = (l.as_dvec3() + v.as_dvec3()).normalize();
        let c = h.z;
        let a = f64::from(alpha);
        let truth = a * a / (PI * ((1.0 - c) * (1.0 + c) + a * a * c * c).powi(2));
        close(ggx_ndf_between(Vec3::Z, l, v, alpha), truth, (1e-5 + 2e-6 / a) * truth, "D(h)")?;
        let f0 = Vec3::new(0.04, 0.5, 0.9);
        let cosine = h.dot(v.as_dvec3()) as f32;
        let (one, other) = (fresnel_schlick_between(f0, 0.8, l, v), fresnel_schlick(f0, 0.8, cosine));
        prop_assert!((one - other).abs().max_element() < 3e-6, "{one} {other}");
        Ok(())
    });
}

#[test]
fn fresnel_lies_between_its_ends() {
    check((colour(), 0.0..=1.0_f32, -1.0..=1.0_f32), |(f0, f90, c)| {
        let f = fresnel_schlick(f0, f90, c);
        let (low, high) = (f0.min(Vec3::splat(f90)), f0.max(Vec3::splat(f90)));
        prop_assert!(f.cmpge(low - 1e-6).all() && f.cmple(high + 1e-6).all(), "{f}");
        prop_assert_eq!(fresnel_schlick(f0, f90, 1.0), f0);
        prop_assert_eq!(fresnel_schlick(f0, f90, 0.0), Vec3::splat(f90));
        Ok(())
    });
}

#[test]
fn masking_is_consistent() {
    check((1e-3..=1.0_f32, 1e-3..=1.0_f32, alpha()), |(l, v, alpha)| {
        let (g1, g2) = (smith_g1(v, alpha), smith_g2(l, v, alpha));
        prop_assert!(g2 <= g1.min(smith_g1(l, alpha)) * 1.000_01 && g2 >= g1 * smith_g1(l, alpha) * 0.999_99);
        let tangent = ((1.0 - f64::from(v)) * (1.0 + f64::from(v))).sqrt() / f64::from(v);
        let truth = 2.0 / (1.0 + (1.0 + (f64::from(alpha) * tangent).powi(2)).sqrt());
        close(g1, truth, 3e-6 * truth, "G1")?;
        let from_v = 4.0 * f64::from(l) * f64::from(v) * f64::from(smith_visibility(l, v, alpha));
        close(g2, from_v, 5e-6 * from_v, "G2 = 4 (n·l)(n·v) V")?;
        prop_assert!(smith_g1(1.0, alpha) > 0.999_999 && smith_g1(-0.5, alpha) < 1e-10);
        prop_assert!(
            smith_visibility(0.0, v, alpha).is_finite() && smith_visibility(0.0, 0.0, alpha) <= 5.1e5
        );
        Ok(())
    });
}

/// Visible normals' distribution is normalised: `∫ G1 D (v·h)⁺ dh = n·v`.
#[test]
fn masking_conserves_the_projected_area() {
    for alpha in [0.1_f32, 0.4, 1.0] {
        for cosine in [1.0, 0.6, 0.2] {
            let view = direction(cosine, 0.7);
            let seen = about(Vec3::Z, f64::from(alpha), |h| {
                f64::from(ggx_ndf(Vec3::Z, h, alpha)) * f64::from(h.dot(view)).max(0.0)
            });
            near(f64::from(smith_g1(view.z, alpha)) * seen, cosine, 2e-3 * cosine, "projected area");
        }
    }
}

#[test]
fn reflectance_is_reciprocal_and_one_sided() {
    check((material(), unit(), unit(), unit()), |(material, n, l, v)| {
        prop_assert_eq!(surface_brdf(material, n, l, v), surface_brdf(material, n, v, l));
        prop_assert_eq!(surface_transfer(material, n, l, v), surface_transfer(material, n, v, l));
        let is_seen = n.dot(l) > 1e-6 && n.dot(v) > 1e-6;
        let value = surface_brdf(material, n, l, v);
        prop_assert!(value.min_element() >= 0.0 && value.is_finite());
        prop_assert!(
            is_seen || n.dot(l).abs() < 1e-6 || n.dot(v).abs() < 1e-6 || value == Vec3::ZERO,
            "{value}"
        );
        Ok(())
    });
}

#[test]
fn the_parts_make_the_whole() {
    check((material(), upper(), upper()), |(m, l, v)| {
        let whole = surface_brdf(m, Vec3::Z, l, v);
        let parts = lambert_brdf(m.diffuse_albedo) + microfacet_brdf(m.f0, m.f90, m.alpha, Vec3::Z, l, v);
        let scale = parts.max_element() * (1e-5 + 1e-6 / m.alpha);
        prop_assert!((whole - parts).abs().max_element() <= scale);
        let d = ggx_ndf_between(Vec3::Z, l, v, m.alpha);
        let factor = microfacet_m(m.f0, m.f90, m.alpha, Vec3::Z, l, v);
        prop_assert!(
            (factor * d - (parts - lambert_brdf(m.diffuse_albedo))).abs().max_element()
                <= 1e-5 * parts.max_element()
        );
        let (nl, nv) = (l.z, v.z);
        let transfer = surface_transfer(m, Vec3::Z, l, v);
        let cosine = surface_brdf_cosine(m, Vec3::Z, l, v);
        prop_assert!((transfer - whole * nl * nv).abs().max_element() <= 2e-5 * transfer.max_element());
        prop_assert!((cosine - whole * nl).abs().max_element() <= 2e-5 * cosine.max_element());
        let flat = microfacet_reflectance(m.f0, m.f90, m.alpha, Vec3::Z, l, v);
        let wanted = factor * nl / (std::f32::consts::PI * m.alpha * m.alpha);
        prop_assert!((flat - wanted).abs().max_element() <= 2e-5 * wanted.max_element(), "{flat} {wanted}");
        Ok(())
    });
}

#[test]
fn reflectance_is_invariant_under_rotation() {
    check((material(), upper(), upper(), rotation()), |(m, l, v, turn)| {
        prop_assume!(l.z > 0.01 && v.z > 0.01);
        let turned = |d: Vec3| (turn * d).normalize();
        let before = surface_brdf(m, Vec3::Z, l, v);
        let after = surface_brdf(m, turned(Vec3::Z), turned(l), turned(v));
        let scale = before.max_element() * (1e-4 + 4e-6 / m.alpha);
        prop_assert!((before - after).abs().max_element() <= scale, "{before} {after}");
        Ok(())
    });
}

/// Share of the light that comes back of facets that reflect all: what is missing bounced more than once.
#[test]
fn one_bounce_loses_what_it_is_known_to_lose() {
    // By quadrature in f64 of the printed formulas on a grid of 2000 x 2000.
    let albedos: [(f32, [(f64, f64); 3]); 3] = [
        // 1 - ln 2 at normal incidence.
        (1.0, [(1.0, 0.306_853), (0.7, 0.378_888), (0.1, 0.760_211)]),
        (0.5, [(1.0, 0.687_848), (0.7, 0.682_954), (0.1, 0.860_105)]),
        (0.3, [(1.0, 0.877_358), (0.7, 0.844_531), (0.1, 0.888_804)]),
    ];
    for (alpha, rows) in albedos {
        for (cosine, albedo) in rows {
            let view = direction(cosine, 0.2);
            let found = about(Vec3::Z, 1.0, |l| {
                f64::from(microfacet_brdf(Vec3::ONE, 1.0, alpha, Vec3::Z, l, view).x) * f64::from(l.z)
            });
            near(found, albedo, 2e-3, "albedo of GGX facets");
            assert!(found <= 1.0);
        }
    }
}

#[test]
fn a_surface_of_any_width_reflects_no_more_than_it_receives() {
    let seed = seed();
    let mut rng = Rng::new(seed, "energy");
    for _ in 0..40 {
        let alpha = (0.02_f64.ln() * rng.unit()).exp() as f32;
        let view = direction(rng.range(1e-3, 1.0), 0.0);
        let mut sum = 0.0;
        let n = 4000;
        for _ in 0..n {
            let h = ggx_sample_visible_normal(view, alpha, pair(&mut rng));
            let light = mirror(view, h);
            let value = f64::from(surface_brdf_cosine(WHITE_METAL.with(alpha), Vec3::Z, light, view).x);
            let pdf = f64::from(ggx_visible_normal_pdf(alpha, Vec3::Z, light, view));
            if light.z > 0.0 {
                assert!(value / pdf <= 1.01, "seed {seed}: weight {} at {alpha}", value / pdf);
                sum += value / pdf / f64::from(n);
            }
        }
        // At a width of 1 and normal incidence, where most is lost, 0.31 comes back.
        assert!(sum <= 1.001 && sum > 0.28, "seed {seed}: {sum} for {alpha}, {view}");
    }
}

struct Metal;
const WHITE_METAL: Metal = Metal;
impl Metal {
    fn with(self, alpha: f32) -> Material {
        Material { diffuse_albedo: Vec3::ZERO, f0: Vec3::ONE, f90: 1.0, alpha }
    }
}

#[test]
fn warps_have_their_stated_distance_to_the_reflected_distribution() {
    // [alpha, view in degrees, that of the isotropic lobe, that of the anisotropic one]; none: not stated.
    let rows = [
        (0.05_f32, 0.0, Some(0.001), 0.003),
        (0.05, 30.0, Some(0.09), 0.005),
        (0.05, 60.0, Some(0.43), 0.037),
        (0.05, 75.0, Some(0.80), 0.10),
        (0.3, 0.0, None, 0.07),
        (0.3, 30.0, None, 0.07),
        (0.3, 60.0, None, 0.17),
        (0.3, 75.0, None, 0.34),
    ];
    for (alpha, degrees, isotropic, anisotropic) in rows {
        let view = direction(f64::to_radians(degrees).cos(), 0.4);
        let ndf = sg_ndf(Vec3::Z, alpha);
        let truth = |l: Vec3| f64::from(sg_eval((l + view).normalize(), ndf));
        let (sg, asg) = (sg_ndf_warp(Vec3::Z, view, alpha), asg_ndf_warp(Vec3::Z, view, alpha));
        let gap = |lobe: &dyn Fn(Vec3) -> f64| {
            let width = 2.0 * f64::from(alpha);
            about(sg.axis, width, |l| (lobe(l) - truth(l)).abs()) / about(sg.axis, width, truth)
        };
        let found = (gap(&|l| f64::from(sg_eval(l, sg))), gap(&|l| f64::from(asg_eval(l, asg))));
        println!("alpha {alpha}, {degrees}°: {found:?}");
        if let Some(stated) = isotropic {
            near(found.0, stated, 0.05 * stated + 0.006, "isotropic");
        }
        near(found.1, anisotropic, 0.1 * anisotropic + 0.006, "anisotropic");
    }
}

#[test]
fn warps_hold_the_energy_and_are_frames() {
    check((unit(), unit(), 1e-3..=1.0_f32), |(n, v, alpha)| {
        let asg = asg_ndf_warp(n, v, alpha);
        let frame = [asg.x.length(), asg.y.length(), asg.z.length()];
        prop_assert!(frame.iter().all(|l| (l - 1.0).abs() < 3e-6), "{frame:?}");
        let skew = [asg.x.dot(asg.y), asg.y.dot(asg.z), asg.z.dot(asg.x), asg.x.dot(n)];
        prop_assert!(skew.iter().all(|c| c.abs() < 3e-6), "{skew:?}");
        prop_assert!((asg.z - sg_ndf_warp(n, v, alpha).axis).length() < 1e-6);
        let cosine = f64::from(n.dot(v)).abs();
        prop_assume!(cosine > 1e-2);
        // The isotropic lobe's sharpness is twice the geometric mean of the bandwidths.
        let mean = 2.0 * f64::from(asg.lambda).sqrt() * f64::from(asg.mu).sqrt();
        close(sg_ndf_warp(n, v, alpha).sharpness, mean, 1e-4 * mean, "equal energy")?;
        Ok(())
    });
}

#[test]
fn a_view_along_the_normal_gives_an_isotropic_warp() {
    check((unit(), 1e-3..=1.0_f32), |(n, alpha)| {
        let asg = asg_ndf_warp(n, n, alpha);
        prop_assert!((asg.lambda / asg.mu - 1.0).abs() < 2e-6);
        prop_assert!(
            (asg.x.length() - 1.0).abs() < 1e-6 && asg.x.dot(n).abs() < 1e-6 && asg.y.dot(n).abs() < 1e-6
        );
        prop_assert!((asg.z - n).length() < 1e-6);
        let flat = asg_ndf(n, asg.x, alpha, alpha);
        close(flat.lambda, 4.0 * f64::from(asg.mu), 4e-6 * f64::from(flat.lambda), "half angles")?;
        let grazing = asg_ndf_warp(n, asg.x, alpha);
        prop_assert!(grazing.lambda.is_finite() && grazing.x.is_finite());
        Ok(())
    });
}

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

/// Two uniform numbers, as kernels make them.
fn pair(rng: &mut Rng) -> Vec2 {
    let mut one = || (rng.bits() >> 40) as f32 / 16_777_216.0;
    Vec2::new(one(), one())
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
