//! Independent integrals, in f64: what the kernels' closed forms are drawn against.

/// Largest argument of the substitution: beyond it the weights are below 1e-17.
const REACH: f64 = 3.2;
/// Steps of the substitution to each side: nine digits along a line, seven over an area.
const STEPS: i32 = 48;

/// `∫ f` over `low ..= high`, by the double exponential rule: ends may have roots or poles of a derivative.
pub fn integral(low: f64, high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    if low >= high {
        return 0.0;
    }
    let half = 0.5 * (high - low);
    let middle = 0.5 * (high + low);
    let step = REACH / f64::from(STEPS);
    let node = |i: i32| {
        let u = f64::from(i) * step;
        let inner = std::f64::consts::FRAC_PI_2 * libm::sinh(u);
        let cosine = libm::cosh(inner);
        let weight = std::f64::consts::FRAC_PI_2 * libm::cosh(u) / (cosine * cosine);
        weight * f((middle + half * libm::tanh(inner)).clamp(low, high))
    };
    step * half * (-STEPS..=STEPS).map(node).sum::<f64>()
}

/// Integral of `exp(k (w·v - 1))` over the hemisphere around `n`, `c = v·n`.
///
/// Rings around `v` are circles of which the hemisphere holds an arc of known length.
pub fn hemisphere(c: f64, k: f64) -> f64 {
    let sine = (1.0 - c * c).max(0.0).sqrt();
    let arc = |z: f64| {
        let reach = sine * (1.0 - z * z).max(0.0).sqrt();
        2.0 * libm::acos((-z * c / reach.max(1e-300)).clamp(-1.0, 1.0))
    };
    // Rings that lie wholly inside or outside end where the plane meets them.
    let lowest = (1.0 - 45.0 / k.max(1e-9)).max(-1.0);
    let cuts = [lowest, (-sine).max(lowest), sine.max(lowest), 1.0];
    cuts.windows(2).map(|cut| integral(cut[0], cut[1], |z| arc(z) * libm::exp(k * (z - 1.0)))).sum()
}

/// Integral over the sphere of `max(w·z, 0) exp(-lambda x² - mu y²) exp(nu (w·p - 1))`.
///
/// In the plane of `x` and `y` the cosine cancels the projection's Jacobian.
pub fn anisotropic(lambda: f64, mu: f64, nu: f64, p: [f64; 3]) -> f64 {
    // Along one tangent the integrand falls off at least as `exp(-(bandwidth + nu/2) (x - centre)²)`.
    let window = |bandwidth: f64, tilt: f64, edge: f64| {
        let together = bandwidth + 0.5 * nu;
        let (centre, reach) = (0.5 * nu * tilt / together, (36.0 / together).sqrt());
        ((-edge).max(centre - reach), edge.min(centre + reach))
    };
    let (low, high) = window(lambda, p[0], 1.0);
    integral(low, high, |x| {
        let (low, high) = window(mu, p[1], (1.0 - x * x).max(0.0).sqrt());
        integral(low, high, |y| {
            let z = (1.0 - x * x - y * y).max(0.0).sqrt();
            let dot = x * p[0] + y * p[1] + z * p[2];
            libm::exp(-lambda * x * x - mu * y * y + nu * (dot - 1.0))
        })
    })
}

/// The place in `low ..= high` where `f`, which has one minimum there, is least.
pub fn minimum(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let mut inner = [high - golden * (high - low), low + golden * (high - low)];
    let mut values = inner.map(&f);
    while high - low > 1e-7 * high.abs() {
        let at = usize::from(values[0] > values[1]);
        if at == 0 {
            high = inner[1];
            inner = [high - golden * (high - low), inner[0]];
            values = [f(inner[0]), values[0]];
        } else {
            low = inner[0];
            inner = [inner[1], low + golden * (high - low)];
            values = [values[1], f(inner[1])];
        }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    #[track_caller]
    fn assert_within(tolerance: f64, found: f64, wanted: f64) {
        assert!((found / wanted - 1.0).abs() < tolerance, "{found} for {wanted}");
    }

    #[track_caller]
    fn assert_close(found: f64, wanted: f64) {
        assert_within(1e-9, found, wanted);
    }

    #[test]
    fn integrals_with_singular_ends_are_found() {
        assert_close(integral(-1.0, 1.0, |x| (1.0 - x * x).sqrt()), 0.5 * PI);
        assert_close(integral(0.0, 2.0, f64::exp), 2f64.exp_m1());
        assert_eq!(integral(1.0, 1.0, |_| 1.0), 0.0);
    }

    #[test]
    fn hemispheres_of_a_lobe_have_closed_forms_above_below_and_across() {
        for k in [1e-3_f64, 0.5, 6.3, 80.0, 1e4, 1e6] {
            let upper = -TAU * (-k).exp_m1() / k;
            assert_close(hemisphere(1.0, k), upper);
            assert_close(hemisphere(0.0, k), -TAU * (-2.0 * k).exp_m1() / (2.0 * k));
            let whole = -TAU * (-2.0 * k).exp_m1() / k;
            assert!((hemisphere(0.6, k) + hemisphere(-0.6, k) - whole).abs() < 1e-9 * whole);
        }
    }

    #[test]
    fn an_isotropic_product_on_the_axis_has_a_closed_form() {
        // With t = 1 - w·z: 2π ∫ (1 - t) exp(-b t (2 - t) - nu t) dt over 0..=1.
        for (b, nu) in [(1.0_f64, 10.0_f64), (30.0, 50.0), (500.0, 2.0), (1000.0, 1000.0)] {
            let wanted = TAU
                * integral(0.0, 1.0_f64.min(90.0 / (b + nu)), |t| {
                    (1.0 - t) * (-b * t * (2.0 - t) - nu * t).exp()
                });
            assert_within(1e-7, anisotropic(b, b, nu, [0.0, 0.0, 1.0]), wanted);
        }
        // Without the isotropic lobe: π (1 - e^-b)/b.
        assert_within(1e-7, anisotropic(4.0, 4.0, 1e-12, [0.0, 0.0, 1.0]), -PI * (-4_f64).exp_m1() / 4.0);
    }

    #[test]
    fn a_minimum_is_found() {
        assert!((minimum(0.1, 9.0, |x| (x - 2.5).powi(2)) - 2.5).abs() < 1e-6);
    }
}
