//! The whole reflectance and its parts: symmetries, energy.

use super::{about, material, near, pair, upper};
use crate::support::{check, direction, rotation, seed, unit};
use lobe_codegen::glam::Vec3;
use lobe_kernels::brdf::Material;
use lobe_kernels::brdf::model::{
    lambert_brdf, microfacet_brdf, microfacet_m, microfacet_reflectance, surface_brdf, surface_brdf_cosine,
    surface_transfer,
};
use lobe_kernels::brdf::ndf::ggx_ndf_between;
use lobe_kernels::brdf::sampling::{ggx_sample_visible_normal, ggx_visible_normal_pdf, mirror};
use lobe_tests::domain::Rng;
use proptest::prelude::*;

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
