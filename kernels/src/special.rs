//! Special functions of one variable that shading languages lack.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Higham02, Tokuyoshi22};
use lobe_codegen::prelude::*;

/// `(e^x - 1) / x`, and 1 at 0.
///
/// Source: the definition. For `|x| < 1` the Taylor series `1 + x/2! + x²/3! + ..` to the ninth power,
/// otherwise the quotient as it stands.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `x` | argument | -1e7 ..= 80 | 1 |
///
/// Returns the quotient, above 0; it increases with `x`.
///
/// Numerics: the series needs no function of the driver, where the quotient would cancel. The usual
/// way out, [`expm1_over_x_higham`], needs a logarithm that is accurate near 1, which no shading
/// language promises. Truncation error 4e-8 of the result at most, at `x = -1`. Above 88.7 it overflows.
///
/// ```
/// assert_eq!(lobe_kernels::special::expm1_over_x(0.0), 1.0);
/// ```
#[kernel(
    family = "special",
    cite = "definition; series",
    domain(x = -1e7..=80.0),
    budget((2e-6 + 3e-7 * max(x, 0.0)) * result),
    truth = exact_expm1_over_x,
    measured
)]
pub fn expm1_over_x(x: f32) -> f32 {
    if abs(x) < 1.0 {
        // The coefficients are 1/2!, 1/3!, .., 1/10!.
        let c6 = 1.0 / 5040.0 + x * (1.0 / 40320.0 + x * (1.0 / 362880.0 + x * (1.0 / 3628800.0)));
        return 1.0
            + x * (1.0 / 2.0
                + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0 + x * (1.0 / 720.0 + x * c6)))));
    }
    // Of magnitudes, whose signs are equal; the floor holds for a driver that got here with |x| just below 1.
    abs(exp(x) - 1.0) / max(abs(x), 1.0)
}

fn exact_expm1_over_x(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.exp_m1() / x }
}

/// Derivative of [`expm1_over_x`].
///
/// `f'(x) = (e^x - f(x)) / x`, `f(x) = (e^x - 1) / x`; 1/2 at 0.
/// Source: the definition. For `|x| < 1` the Taylor series, otherwise the quotient as it stands.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `x` | argument | -1e7 ..= 80 | 1 |
///
/// Returns the derivative, above 0; it increases with `x`.
///
/// Numerics: the difference cancels towards 0, hence the series; its truncation error is 9e-8 of the result at
/// most, at `x = -1`.
#[kernel(
    family = "special",
    cite = "definition; series",
    domain(x = -1e7..=80.0),
    budget((5e-6 + 3e-7 * max(x, 0.0)) * result),
    truth = exact_expm1_over_x_slope,
    measured
)]
pub fn expm1_over_x_slope(x: f32) -> f32 {
    if abs(x) < 1.0 {
        // The coefficients are n/(n + 1)!, n = 1, 2, .., 10.
        let c6 = 6.0 / 5040.0
            + x * (7.0 / 40320.0 + x * (8.0 / 362880.0 + x * (9.0 / 3628800.0 + x * (10.0 / 39916800.0))));
        return 1.0 / 2.0
            + x * (2.0 / 6.0 + x * (3.0 / 24.0 + x * (4.0 / 120.0 + x * (5.0 / 720.0 + x * c6))));
    }
    // Of magnitudes, as in `expm1_over_x`.
    abs(exp(x) - expm1_over_x(x)) / max(abs(x), 1.0)
}

fn exact_expm1_over_x_slope(x: f64) -> f64 {
    if x.abs() >= 1.0 {
        return (x.exp() - exact_expm1_over_x(x)) / x;
    }
    // Σ n x^(n - 1) / (n + 1)!
    let mut term = 0.5;
    let mut sum = 0.0;
    for n in 1..=25_u32 {
        let n = f64::from(n);
        sum += n * term;
        term *= x / (n + 2.0);
    }
    sum
}

/// `(e^x - 1) / x` with cancellation of rounding errors, as printed.
///
/// Source: [Higham02] section 1.14.1, [Tokuyoshi22] supplement listing 4.
///
/// Arguments, domain and result as of [`expm1_over_x`].
///
/// Numerics: `(u - 1) / log(u)`, `u = e^x`, is accurate because the errors of both cancel, if `log` is
/// accurate near 1. WGSL and Vulkan allow `log` an absolute error of 2^-21 on 0.5 ..= 2.
#[kernel(
    family = "special",
    cite = "[Tokuyoshi22] supplement listing 4",
    domain(x = -1e7..=80.0),
    budget((2e-6 + 3e-7 * max(x, 0.0)) * result),
    variant_of = expm1_over_x,
    not_robust = "it needs a logarithm that is accurate near 1, and the languages allow an absolute error of 2^-21 there",
    measured
)]
pub fn expm1_over_x_higham(x: f32) -> f32 {
    let u = exp(x);
    if u == 1.0 {
        return 1.0;
    }
    let y = u - 1.0;
    if abs(x) < 1.0 {
        return y / log(u);
    }
    y / x
}

/// The error function, `2/√π ∫₀ˣ exp(-t²) dt`.
///
/// Source: [Tokuyoshi22] supplement listing 5: an odd polynomial for `|x| <= 1`, one minus a power of 2
/// of a polynomial up to 4, the sign beyond.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `x` | argument | any | 1 |
///
/// Returns the value, in -1 ..= 1; odd and increasing.
///
/// Numerics: the approximation errs by 1.2e-7 at most, by 1.8e-7 of the value near 0. The sign is chosen
/// by a comparison, where the listing moves bits.
#[kernel(
    family = "special",
    cite = "[Tokuyoshi22] supplement listing 5",
    domain(x = -1e6..=1e6),
    budget(6e-7 * abs(result) + 1e-37),
    truth = exact_erf,
    measured
)]
pub fn erf(x: f32) -> f32 {
    let a = abs(x);
    if a >= 4.0 {
        return select(-1.0, 1.0, x > 0.0);
    }
    if a > 1.0 {
        let exponent = (((((2.58907676e-5 * a - 5.64874616e-4) * a + 5.66795561e-3) * a - 3.51759829e-2)
            * a
            + 1.54329389e-1)
            * a
            + 9.15674746e-1)
            * a
            + 1.628459513;
        let y = 1.0 - exp2(-(exponent * a));
        return select(-y, y, x > 0.0);
    }
    let x2 = x * x;
    (((((-5.58853149e-4 * x2 + 4.90735564e-3) * x2 - 2.67030653e-2) * x2 + 1.12799220e-1) * x2
        - 3.76123011e-1)
        * x2
        + 1.128379121)
        * x
}

fn exact_erf(x: f64) -> f64 {
    libm::erf(x)
}
