//! Products of lobes, and pairs of lobes before a light.

use super::{decades, frame, integrate};
use crate::support::{check, close, rotation, unit};
use lobe_codegen::glam::Vec3;
use lobe_kernels::asg::{Asg, asg_sg_product_integral};
use lobe_kernels::sg::{Sg, sg_eval, sg_sg_product_integral};
use lobe_kernels::vsgl::{
    asg_sg_sg_product_integral, vpl_radiance, vsgl_pair_radiance, vsgl_pair_radiance_diffuse, vsl_cone,
    vsl_radiance, vsl_window,
};
use proptest::prelude::*;

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
