//! Distributions of normals and their lobe, Fresnel, masking.

use super::{about, about_z, alpha, colour, near, upper};
use crate::support::{check, close, direction, unit};
use lobe_codegen::glam::Vec3;
use lobe_kernels::brdf::fresnel::{fresnel_schlick, fresnel_schlick_between};
use lobe_kernels::brdf::lobe::sg_ndf;
use lobe_kernels::brdf::ndf::{beckmann_ndf, ggx_ndf, ggx_ndf_between, ggx_ndf_cosine, ggx_ndf_paper};
use lobe_kernels::brdf::visibility::{smith_g1, smith_g2, smith_visibility};
use lobe_kernels::sg::sg_eval;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

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
