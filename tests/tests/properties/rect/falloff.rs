//! The falloff, its fit and the energy.

use crate::support::{check, close};
use lobe_kernels::rect::attenuation::{
    rect_attenuation, rect_falloff, rect_falloff_fit, rect_falloff_paper, rect_psi_paper,
};
use lobe_kernels::rect::energy::rect_energy;
use std::f64::consts::{FRAC_PI_2, PI};

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
