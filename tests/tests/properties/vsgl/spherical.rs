//! Virtual spherical lights: the cone, the window, smoothness, sampling.

use super::decades;
use crate::support::{check, close};
use lobe_codegen::glam::Vec3;
use lobe_kernels::sg::sg_integral;
use lobe_kernels::vsgl::{
    brsm_pdf, brsm_weight, vpl_radiance, vpl_transfer, vsgl_reduce_bias, vsgl_smoothness,
    vsgl_transfer_sharpness, vsl_cone, vsl_mip_level, vsl_radiance, vsl_radius, vsl_window,
};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

#[test]
fn a_spherical_light_converges_to_a_point_light() {
    check((decades(-3.0, 4.0), 0.0..1e3_f32), |(d, transfer)| {
        let point = f64::from(vpl_radiance(transfer, d));
        for (relative, ratio) in [(0.0, 1.0), (1e-3, 1.0), (0.1, 0.9926), (0.5, 0.845), (1.0, 0.586)] {
            close(
                vsl_radiance(transfer, d, relative * d),
                ratio * point,
                5e-4 * point,
                "of the point light",
            )?;
        }
        let centre = f64::from(vsl_radiance(transfer, 0.0, d));
        close(2.0 * transfer / (d * d), centre, 1e-5 * centre, "at the centre")
    });
}

#[test]
fn transfer_is_cut_off_from_behind() {
    check((0.0..10.0_f32, -1.0..1.0_f32, -1.0..1.0_f32), |(flux, a, b)| {
        let wanted = f64::from(flux) * f64::from(a.max(0.0)) * f64::from(b.max(0.0)) * 6.0;
        close(vpl_transfer(flux, 2.0, 3.0, a, b), wanted, 1e-5 * wanted, "transfer")
    });
}

#[test]
fn the_cone_is_that_of_its_angle() {
    check((decades(-3.0, 4.0), decades(-3.0, 4.0)), |(d, r)| {
        let (d64, r64) = (f64::from(d), f64::from(r));
        let cone = vsl_cone(d, r);
        // 1 - cos = 2 sin²(θ/2), by the angle.
        let solid_angle = 2.0 * TAU * (0.5 * (r64 / d64).atan()).sin().powi(2);
        close(cone.solid_angle, solid_angle, 2e-6 * solid_angle, "solid angle")?;
        close(cone.density * r * r, solid_angle / PI, 3e-6 * solid_angle, "density")?;
        // The window's sharpness ends at 2^31.
        prop_assume!(r > 1e-4 * d);
        let window = vsl_window(Vec3::Z, d, r);
        let whole = f64::from(sg_integral(window.sharpness)) * f64::from(window.log_amplitude).exp();
        let wanted = solid_angle * (1.0 - (-8.0 * PI / solid_angle).exp());
        close(whole as f32, wanted, 1e-5 * wanted, "integral of the window")
    });
}

#[test]
fn smoothness_decides() {
    check((decades(0.0, 4.0), decades(0.0, 4.0), decades(-2.0, 1.0)), |(lambda, k, r)| {
        let sharpness = vsgl_transfer_sharpness(lambda, 1.0, k);
        prop_assert!(sharpness >= 2.0 * lambda && sharpness >= k);
        let ratio = vsgl_smoothness(sharpness, 1.0, r);
        let wanted = f64::from(sharpness) / f64::from(vsl_window(Vec3::Z, 1.0, r).sharpness);
        close(ratio, wanted, 1e-5 * wanted, "ratio of sharpnesses")?;
        prop_assert_eq!(vsgl_smoothness(sharpness, 1.0, 0.0), 0.0);
        let chosen = vsgl_reduce_bias(ratio, 1e-3, 1.0, 2.0);
        prop_assert_eq!(chosen, if ratio < 1e-3 { 1.0 } else { 2.0 });
        Ok(())
    });
}

#[test]
fn sampling_is_normalised() {
    check((prop::collection::vec(0.0..10.0_f32, 64), 1e-3..1.0_f32), |(estimates, share)| {
        let average = (estimates.iter().sum::<f32>() / 64.0).max(1e-3);
        let pdfs: Vec<f32> = estimates.iter().map(|e| brsm_pdf(*e, average, share)).collect();
        close(pdfs.iter().sum::<f32>() / 64.0, 1.0, 1e-4, "mean")?;
        // The expectation of the weights of N choices: each texel is chosen with probability p/64.
        let expected: f32 = pdfs.iter().map(|p| 16.0 * p / 64.0 * brsm_weight(*p, 16.0)).sum();
        close(expected, 1.0, 1e-4, "weights")?;
        for h_max in [0.0, 5.0, 8.0, 12.0_f32] {
            close(vsl_mip_level(h_max, 4.0_f32.powf(h_max), 1.0, 1.0), 0.0, 1e-5, "one texel a light")?;
            prop_assert_eq!(vsl_mip_level(h_max, 16.0, 4.0, 0.0), h_max);
        }
        Ok(())
    });
}

#[test]
fn radius_of_a_uniform_disk() {
    // Its trace is half the squared radius, its variance along an axis a quarter.
    check(decades(-3.0, 3.0), |r| close(vsl_radius(0.5 * r * r), r.into(), 1e-6 * f64::from(r), "radius"));
}
