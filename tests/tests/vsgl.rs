//! Properties of virtual spherical lights and spherical-Gaussian lights.

mod random;

use lobe_codegen::glam::{DVec3, Vec3};
use lobe_kernels::asg::{Asg, asg_sg_product_integral};
use lobe_kernels::filter::{moments_empty, moments_merge, moments_of_lobe, moments_of_position};
use lobe_kernels::sg::{Sg, sg_eval, sg_integral, sg_sg_product_integral};
use lobe_kernels::vsgl::{
    Vsgl, asg_sg_sg_product_integral, brsm_pdf, brsm_weight, vpl_radiance, vpl_transfer, vsgl_diffuse,
    vsgl_diffuse_paper, vsgl_from_moments, vsgl_from_moments_paper, vsgl_incoming, vsgl_light,
    vsgl_pair_radiance, vsgl_pair_radiance_diffuse, vsgl_reduce_bias, vsgl_smoothness, vsgl_specular,
    vsgl_specular_axis, vsgl_transfer_sharpness, vsl_cone, vsl_mip_level, vsl_radiance, vsl_radius,
    vsl_window,
};
use proptest::prelude::*;
use random::{check, close, rotation, unit};
use std::f64::consts::{PI, TAU};

fn decades(low: f32, high: f32) -> impl Strategy<Value = f32> {
    (low..high).prop_map(|e| 10.0_f32.powf(e))
}

fn light() -> impl Strategy<Value = Vsgl> {
    let variance = prop_oneof![1 => Just(0.0), 9 => decades(-6.0, 2.0)];
    (unit(), decades(-1.0, 1.0), variance, unit(), decades(-3.0, 4.0), decades(-2.0, 2.0)).prop_map(
        |(dir, dist, variance, axis, sharpness, intensity)| Vsgl {
            mean: dist * dir,
            variance,
            axis,
            sharpness,
            intensity,
        },
    )
}

fn frame(z: Vec3, lambda: f32, mu: f32) -> Asg {
    let (x, y) = z.any_orthonormal_pair();
    Asg { z, x, y, lambda, mu, amplitude: 1.0 }
}

/// `∫ f dw` by the midpoint rule in polar coordinates about `axis`, to the angle where `1 - cos` is `depth`.
fn integrate(axis: Vec3, depth: f64, f: impl Fn(DVec3) -> f64) -> f64 {
    let (axis, n, m) = (axis.as_dvec3().normalize(), 800, 128);
    let (x, y) = axis.any_orthonormal_pair();
    let ring = |i: i32| {
        let s = (f64::from(i) + 0.5) / f64::from(n);
        let down = depth * s * s;
        let (c, r) = (1.0 - down, (down * (2.0 - down)).max(0.0).sqrt());
        let along = |j: i32| {
            let phi = TAU * (f64::from(j) + 0.5) / f64::from(m);
            f(axis * c + (x * phi.cos() + y * phi.sin()) * r)
        };
        (0..m).map(along).sum::<f64>() * TAU / f64::from(m) * depth * 2.0 * s / f64::from(n)
    };
    (0..n).map(ring).sum()
}

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
fn anisotropic_product_is_close_on_the_axis() {
    // Bandwidths up to a ratio of 30, which the quadrature resolves.
    check((unit(), decades(1.0, 4.0), decades(0.0, 1.5), decades(0.0, 5.0)), |(z, lambda, ratio, k)| {
        let mu = lambda * ratio;
        let asg = frame(z, lambda, mu);
        let sg = Sg { axis: z, sharpness: k, log_amplitude: 0.0 };
        let [z, x, y] = [asg.z, asg.x, asg.y].map(|v| v.as_dvec3().normalize());
        let narrowest = f64::from(lambda.min(mu) + 0.5 * k);
        let truth = integrate(asg.z, (40.0 / narrowest).min(1.0), |w| {
            let exponent = f64::from(lambda) * w.dot(x).powi(2) + f64::from(mu) * w.dot(y).powi(2);
            w.dot(z).max(0.0) * (f64::from(k) * (w.dot(z) - 1.0) - exponent).exp()
        });
        let permitted = if lambda.min(mu) < 50.0 { 1.3e-2 } else { 3e-3 };
        close(asg_sg_product_integral(asg, sg), truth, permitted * truth, "on the axis")
    });
}

#[test]
fn triple_product_of_an_isotropic_lobe_is_that_of_three_isotropic_ones() {
    check((unit(), unit(), unit(), decades(3.0, 5.0)), |(z, v, l, k)| {
        // Axes a fraction of the lobes' widths apart.
        let near = |d: Vec3| (z + 0.3 / k.sqrt() * d).normalize();
        let sg = |axis: Vec3| Sg { axis, sharpness: k, log_amplitude: 0.0 };
        let (v, l) = (sg(near(v)), sg(near(l)));
        let product = lobe_kernels::sg::sg_product(v, l);
        let wanted = f64::from(sg_sg_product_integral(product, sg(z)));
        let found = asg_sg_sg_product_integral(frame(z, 0.5 * k, 0.5 * k), v, l);
        close(found, wanted, 5e-3 * wanted, "isotropic")
    });
}

#[test]
fn triple_product_does_not_depend_on_the_order_of_the_isotropic_lobes_nor_on_rotation() {
    let lobe = || (unit(), decades(-1.0, 4.0));
    check((unit(), decades(0.0, 3.0), lobe(), lobe(), rotation()), |(z, lambda, v, l, turn)| {
        let sg = |(axis, sharpness)| Sg { axis, sharpness, log_amplitude: 0.0 };
        let (asg, v, l) = (frame(z, lambda, 10.0), sg(v), sg(l));
        let value = f64::from(asg_sg_sg_product_integral(asg, v, l));
        let smaller = f64::from(v.sharpness.min(l.sharpness));
        let spread = 1e-5 + 2e-6 * (smaller + f64::from(lambda));
        close(asg_sg_sg_product_integral(asg, l, v), value, spread * value + 1e-12, "order")?;
        let turned = |s: Sg| Sg { axis: (turn * s.axis).normalize(), ..s };
        let asg = Asg { z: turn * asg.z, x: turn * asg.x, y: turn * asg.y, ..asg };
        let found = asg_sg_sg_product_integral(asg, turned(v), turned(l));
        close(found, value, 4.0 * spread * value + 1e-9, "rotation")
    });
}

#[test]
fn a_pair_of_lobes_converges_to_its_value_for_a_point_light() {
    check((unit(), unit(), 1.0..1e3_f32, 1.0..1e3_f32, 0.5..2.0_f32), |(z, tilt, lambda, k, d)| {
        let dir = (z + 0.3 / lambda.max(k).sqrt() * tilt).normalize();
        let asg = frame(z, lambda, 2.0 * lambda);
        let lobe = Sg { axis: z, sharpness: k, log_amplitude: 0.5 };
        let value = lobe_kernels::asg::asg_eval(dir, asg) * sg_eval(dir, lobe);
        let wanted = f64::from(vpl_radiance(0.7 * value, d));
        let found = vsgl_pair_radiance(asg, lobe, dir, d, 1e-4 * d, 0.7);
        close(found, wanted, 1e-3 * wanted, "small light")?;
        let reduced = vsl_radiance(0.7 * value, d, 1e-4 * d);
        close(found, reduced.into(), 1e-3 * wanted, "smooth lobes")
    });
}

#[test]
fn a_lobe_before_a_diffuse_receiver_is_its_mean_over_the_cone() {
    let lobe =
        (unit(), decades(-1.0, 4.0)).prop_map(|(axis, sharpness)| Sg { axis, sharpness, log_amplitude: 0.5 });
    check((unit(), lobe, 0.5..2.0_f32, 0.01..3.0_f32), |(dir, lobe, d, relative)| {
        let window = vsl_window(dir, d, relative * d);
        let mean = f64::from(sg_sg_product_integral(window, lobe))
            / f64::from(vsl_cone(d, relative * d).solid_angle);
        let wanted = 0.7 * mean * f64::from(vsl_cone(d, relative * d).density);
        let found = vsgl_pair_radiance_diffuse(lobe, dir, d, relative * d, 0.7);
        // Both exponents carry errors that grow with the sharpness.
        let slack = 1e-5 + 1e-6 * f64::from(lobe.sharpness.min(window.sharpness));
        close(found, wanted, slack * wanted + 1e-30, "mean over the cone")?;
        let constant = Sg { sharpness: 0.0, log_amplitude: 0.0, ..lobe };
        let smooth = f64::from(vsl_radiance(0.7, d, relative * d));
        close(
            vsgl_pair_radiance_diffuse(constant, dir, d, relative * d, 0.7),
            smooth,
            2e-2 * smooth,
            "constant",
        )
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

/// VPLs, each of power 1, on a disk at distance 1 above the origin that is tilted by 17.5 degrees; they emit as a
/// cosine.
struct Disk {
    normal: Vec3,
    positions: Vec<Vec3>,
}

impl Disk {
    fn new(radius: f32) -> Self {
        let n: u16 = 64;
        let normal = Vec3::new(-0.3, -0.1, -1.0).normalize();
        let (x, y) = normal.any_orthonormal_pair();
        let rings = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
        let positions = rings.map(|(i, j)| {
            let r = radius * ((f32::from(i) + 0.5) / f32::from(n)).sqrt();
            let phi = std::f32::consts::TAU * (f32::from(j) + 0.5 * f32::from(i % 2)) / f32::from(n);
            Vec3::Z + r * phi.cos() * x + r * phi.sin() * y
        });
        Self { normal, positions: positions.collect() }
    }

    /// The light that stands for it.
    fn light(&self, literal: bool) -> Vsgl {
        let reference = 2.0 / 3.0 * self.normal;
        let (mut places, mut lobes) = (moments_empty(), moments_empty());
        for position in &self.positions {
            places = moments_merge(places, moments_of_position(*position, 1.0, Vec3::Z));
            lobes = moments_merge(lobes, moments_of_lobe(self.normal, 2.0, 1.0, reference));
        }
        let make = if literal { vsgl_from_moments_paper } else { vsgl_from_moments };
        make(places, Vec3::Z, lobes, reference)
    }

    /// What the VPLs make the origin reflect by `lobe`, which includes the receiver's cosine.
    fn sum(&self, lobe: impl Fn(Vec3) -> f32) -> f64 {
        let each = self.positions.iter().map(|position| {
            let (d, dir) = (position.length(), position.normalize());
            // A cosine emitter: 1/π in power/sr along the normal.
            let emitter = std::f32::consts::FRAC_1_PI;
            let transfer = vpl_transfer(1.0, lobe(dir), emitter, 1.0, -dir.dot(self.normal));
            f64::from(vpl_radiance(transfer, d))
        });
        each.sum()
    }
}

/// Ratios of the light's to the VPLs' radiance: paper's diffuse, clamped cosine, specular.
fn ratios(radius: f32, literal: bool) -> [f64; 3] {
    let disk = Disk::new(radius);
    let light = disk.light(literal);
    let (origin, z) = (Vec3::ZERO, Vec3::Z);
    let cosine = |dir: Vec3| dir.z.max(0.0) * std::f32::consts::FRAC_1_PI;
    // Straight up, a lobe of alpha 0.3: bandwidth 1/(4 alpha²) both ways.
    let glossy = |dir: Vec3| dir.z.max(0.0) * (-(dir.x * dir.x + dir.y * dir.y) / 0.36).exp();
    let (diffuse, specular) = (disk.sum(cosine), disk.sum(glossy));
    [
        f64::from(vsgl_diffuse_paper(light, origin, z, 1.0)) / diffuse,
        f64::from(vsgl_diffuse(light, origin, z, 1.0)) / diffuse,
        f64::from(vsgl_specular(light, origin, z, z, 0.3, 1.0)) / specular,
    ]
}

#[test]
fn one_light_stands_for_4096_vpls() {
    // Radius over distance; ratios with half the trace for the variance, and with the trace as printed.
    let table = [
        (0.01, [0.973, 0.973, 0.973], [0.973, 0.973, 0.973]),
        (0.1, [0.972, 0.975, 0.977], [0.964, 0.968, 0.960]),
        (0.3, [0.965, 0.985, 1.004], [0.896, 0.930, 0.879]),
        (1.0, [0.957, 1.067, 1.227], [0.643, 0.731, 0.739]),
        (3.0, [1.003, 1.152, 1.428], [0.529, 0.607, 0.730]),
    ];
    for (radius, half, literal) in table {
        for (found, wanted) in [(ratios(radius, false), half), (ratios(radius, true), literal)] {
            for (f, w) in found.iter().zip(wanted) {
                assert!((f - w).abs() < 2e-3, "radius {radius}: {found:.4?} instead of {wanted:?}");
            }
        }
    }
}
