//! Spherical Gaussians, over the sphere and a hemisphere.

use super::support::{check, close, integrate, lobe, rotation, sharpness, unit};
use lobe_codegen::glam::{DVec3, Vec3};
use lobe_kernels::hsg::{clamped_cosine, hsg_cosine_product_integral, hsg_integral, hsg_upper_integral};
use lobe_kernels::sg::{
    Sg, sg_eval, sg_integral, sg_product, sg_sg_product_integral, sg_sg_product_integral_iwasaki,
};
use lobe_kernels::special::{erf, expm1_over_x, expm1_over_x_slope};
use proptest::prelude::*;

#[test]
fn integral_is_that_of_quadrature() {
    check((unit(), sharpness()), |(axis, k)| {
        let truth = integrate(axis, k, |_| 1.0);
        close(sg_integral(k), truth, 2e-5 * truth, "sphere")
    });
}

#[test]
fn product_is_the_product_of_values() {
    check((lobe(), lobe(), unit()), |(a, b, dir)| {
        let product = sg_product(a, b);
        prop_assume!((product.axis.length() - 1.0).abs() < 1e-3);
        let apart = f64::from(sg_eval(dir, a)) * f64::from(sg_eval(dir, b));
        // The lobes' own exponents carry errors that their sharpness multiplies.
        let tolerance = 1e-5 + 3e-6 * f64::from(a.sharpness + b.sharpness);
        close(sg_eval(dir, product), apart, tolerance * (apart + 1e-30) + 1e-30, "product")
    });
}

#[test]
fn product_integral_is_that_of_quadrature() {
    check((lobe(), lobe()), |(a, b)| {
        let (wide, sharp) = if a.sharpness < b.sharpness { (a, b) } else { (b, a) };
        let other = |w: DVec3| {
            (f64::from(wide.log_amplitude)
                + f64::from(sharp.log_amplitude)
                + f64::from(wide.sharpness) * (w.dot(wide.axis.as_dvec3().normalize()) - 1.0))
                .exp()
        };
        let truth = integrate(sharp.axis, sharp.sharpness, other);
        let peak =
            f64::from(sg_integral(sharp.sharpness)) * f64::from(a.log_amplitude + b.log_amplitude).exp();
        close(sg_sg_product_integral(a, b), truth, 1e-3 * truth + 1e-5 * peak, "product integral")
    });
}

#[test]
fn product_integral_is_symmetric() {
    check((lobe(), lobe()), |(a, b)| {
        let (ab, ba) = (sg_sg_product_integral(a, b), sg_sg_product_integral(b, a));
        // Errors of the exponent count absolutely, so relative ones grow with it, as in the kernel's budget.
        let exponent = f64::from(sg_product(a, b).log_amplitude).abs();
        close(ab, ba.into(), (1e-5 + 1e-6 * exponent) * f64::from(ba) + 1e-35, "swapped lobes")
    });
}

#[test]
fn iwasaki_approaches_the_exact_integral_for_one_sharp_lobe() {
    check((unit(), unit(), 1e3..1e5_f32), |(v, w, k)| {
        let a = Sg { axis: v, sharpness: k, log_amplitude: 0.0 };
        let b = Sg { axis: w, sharpness: 2.0, log_amplitude: 0.0 };
        let exact = f64::from(sg_sg_product_integral(a, b));
        close(sg_sg_product_integral_iwasaki(a, b), exact, 5e-3 * exact, "[Iwasaki12]")
    });
}

#[test]
fn integrals_are_invariant_under_rotation() {
    check((lobe(), lobe(), rotation()), |(a, b, turn)| {
        let turned = |s: Sg| Sg { axis: (turn * s.axis).normalize(), ..s };
        let before = f64::from(sg_sg_product_integral(a, b));
        let spread =
            1e-6 * f64::from(a.sharpness.min(b.sharpness)) * f64::from((a.axis - b.axis).length()).max(1e-3);
        let after = sg_sg_product_integral(turned(a), turned(b));
        close(after, before, (1e-5 + 4.0 * spread) * before + 1e-30, "product integral")?;
        let c = hsg_cosine_product_integral(a, b.axis);
        let turned_c = hsg_cosine_product_integral(turned(a), turned(b).axis);
        let scale = f64::from(hsg_upper_integral(a.sharpness)) * f64::from(a.log_amplitude).exp();
        close(turned_c, c.into(), (1e-5 + 3e-7 * f64::from(a.sharpness).sqrt()) * scale, "against the cosine")
    });
}

#[test]
fn hemispherical_integral_is_within_its_stated_error_of_quadrature() {
    check((unit(), unit(), sharpness()), |(axis, normal, k)| {
        let n = normal.as_dvec3().normalize();
        let truth = integrate(axis, k, |w| f64::from(u8::from(w.dot(n) > 0.0)));
        let whole = f64::from(sg_integral(k));
        close(hsg_integral(axis.dot(normal), k), truth, 4.94e-3 * whole + 5e-3 * whole, "hemisphere")
    });
}

#[test]
fn cosine_integral_is_within_its_stated_error_of_quadrature() {
    check((lobe(), unit()), |(sg, normal)| {
        let n = normal.as_dvec3().normalize();
        let amplitude = f64::from(sg.log_amplitude).exp();
        let truth = amplitude * integrate(sg.axis, sg.sharpness, |w| w.dot(n).max(0.0));
        let upper = f64::from(hsg_upper_integral(sg.sharpness)) * amplitude;
        // Beside the closed form's error, that of the quadrature at the horizon.
        close(hsg_cosine_product_integral(sg, normal), truth, 3.7e-3 * upper + 2e-4 * upper, "cosine")
    });
}

#[test]
fn both_hemispheres_make_the_sphere() {
    check((-1.0..=1.0_f32, sharpness()), |(c, k)| {
        let both = f64::from(hsg_integral(c, k)) + f64::from(hsg_integral(-c, k));
        let upper = f64::from(hsg_upper_integral(k));
        close(sg_integral(k), both, 1e-5 * upper, "upper and lower")
    });
}

#[test]
fn nothing_is_negative_or_nan() {
    check((lobe(), lobe(), unit()), |(a, b, n)| {
        let values = [
            sg_eval(n, a),
            sg_integral(a.sharpness),
            sg_sg_product_integral(a, b),
            sg_sg_product_integral_iwasaki(a, b),
            hsg_integral(a.axis.dot(n), a.sharpness),
            hsg_cosine_product_integral(a, n),
            clamped_cosine(a.axis.dot(n)),
        ];
        prop_assert!(values.iter().all(|v| *v >= 0.0), "{values:?}");
        Ok(())
    });
}

#[test]
fn limits_at_sharpness_zero() {
    check((unit(), unit()), |(v, n)| {
        let constant = Sg { axis: v, sharpness: 0.0, log_amplitude: 0.0 };
        close(sg_eval(n, constant), 1.0, 1e-6, "value")?;
        close(sg_integral(0.0), 4.0 * std::f64::consts::PI, 1e-5, "sphere")?;
        close(hsg_integral(v.dot(n), 0.0), 2.0 * std::f64::consts::PI, 1e-5, "hemisphere")?;
        close(hsg_cosine_product_integral(constant, n), std::f64::consts::PI, 1e-5, "cosine")?;
        let product = sg_product(constant, Sg { axis: n, ..constant });
        prop_assert!(product.sharpness == 0.0 && product.log_amplitude == 0.0 && product.axis.is_finite());
        Ok(())
    });
}

#[test]
fn limits_at_infinite_sharpness() {
    check((unit(), unit(), 4.0..6.0_f32), |(v, n, e)| {
        let k = 10.0_f32.powf(e);
        let sg = Sg { axis: v, sharpness: k, log_amplitude: 0.0 };
        let cosine = f64::from(v.dot(n));
        prop_assume!(cosine.abs() > 0.1);
        // A sharp lobe is a point light of power 2π/k.
        let power = 2.0 * std::f64::consts::PI / f64::from(k);
        close(sg_integral(k), power, 1e-5 * power, "sphere")?;
        close(hsg_cosine_product_integral(sg, n), power * cosine.max(0.0), 3e-4 * power, "cosine")
    });
}

#[test]
fn opposite_lobes_cancel_without_nan() {
    check((unit(), sharpness()), |(v, k)| {
        let a = Sg { axis: v, sharpness: k, log_amplitude: 0.0 };
        let product = sg_product(a, Sg { axis: -v, ..a });
        prop_assert!(product.axis.is_finite() && product.sharpness.is_finite(), "{product:?}");
        let total = 4.0 * std::f64::consts::PI * (-2.0 * f64::from(k)).exp();
        close(
            sg_sg_product_integral(a, Sg { axis: -v, ..a }),
            total,
            (1e-4 + 1e-5 * f64::from(k)) * total + 1e-30,
            "integral",
        )
    });
}

#[test]
fn special_functions_are_monotone_and_match_f64() {
    check((-20.0..20.0_f32, 0.0..1.0_f32), |(x, step)| {
        let slack = 1.0 + 4e-6;
        prop_assert!(expm1_over_x(x) <= expm1_over_x(x + step) * slack);
        prop_assert!(expm1_over_x_slope(x) <= expm1_over_x_slope(x + step) * slack);
        prop_assert!(erf(x) <= erf(x + step) + 3e-7);
        prop_assert!(erf(-x) == -erf(x));
        let truth = if x == 0.0 { 1.0 } else { f64::from(x).exp_m1() / f64::from(x) };
        close(expm1_over_x(x), truth, 1e-6 * truth, "expm1_over_x")
    });
}

#[test]
fn extreme_sharpness_is_finite() {
    for k in [f32::MIN_POSITIVE, 1e-40, 1e9, 1e18, 1e30, f32::MAX] {
        let sg = Sg { axis: Vec3::Z, sharpness: k, log_amplitude: 0.0 };
        let other = Sg { axis: Vec3::X, ..sg };
        assert!(sg_integral(k).is_finite() && hsg_integral(0.3, k).is_finite(), "{k:e}");
        assert!(hsg_cosine_product_integral(sg, Vec3::Z).is_finite(), "{k:e}");
        assert!(sg_eval(Vec3::X, sg).is_finite() && sg_sg_product_integral(sg, other).is_finite(), "{k:e}");
    }
}
