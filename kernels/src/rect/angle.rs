//! Angles and logarithms without the built-in functions of the shading languages, which may be off by 4096 ULP.

use crate::constants::HALF_PI;
use lobe_codegen::prelude::*;

/// Angle of a vector of the first quadrant, `atan2(y, x)`.
///
/// Source: the definition; `atan(t)/t` as a polynomial in `t²`, our own fit for `0 <= t <= 1`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `y` | second coordinate | 0 ..= 1e18 | 1 |
/// | `x` | first coordinate | 1e-6 ..= 1e18 | 1 |
///
/// Returns the angle in rad, in 0 ..= π/2.
///
/// Numerics: the built-in function may err by 4096 ULP. The fit errs by 2.4e-9 of the angle at most.
#[kernel(
    family = "rect",
    cite = "definition; polynomial",
    domain(y = 0.0..=1e18, x = 1e-6..=1e18),
    budget(1.5e-6 * result + 1e-30),
    truth = exact_arctangent,
    measured
)]
pub fn arctangent(y: f32, x: f32) -> f32 {
    let t = min(y, x) / max(max(y, x), 1e-30);
    let u = t * t;
    let high = 5.7552094228e-2 + u * (-3.0804589204e-2 + u * (1.0726939744e-2 - u * 1.7539291779e-3));
    let middle = -1.4261933078e-1 + u * (1.0942030517e-1 + u * (-8.3773150052e-2 + u * high));
    let angle = t * (9.9999999763e-1 + u * (-3.3333283642e-1 + u * (1.9998266039e-1 + u * middle)));
    select(angle, HALF_PI - angle, y > x)
}

fn exact_arctangent(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// Angle between two unit vectors over its sine, for angles up to a right one.
///
/// `θ/sin θ`; our own fit in the depth `1 - cos θ`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `depth` | `1 - cos θ` | 0 ..= 1 | 1 |
///
/// Returns the ratio, in 1 ..= π/2; it increases with `depth`.
///
/// Numerics: the fit errs by 1.2e-8 of the ratio at most.
#[kernel(
    family = "rect",
    cite = "definition; polynomial",
    domain(depth = 0.0..=1.0),
    budget(1e-6 * result),
    truth = exact_angle_over_sine,
    measured
)]
pub fn angle_over_sine(depth: f32) -> f32 {
    let u = depth;
    let high = -3.5150903776e-2 + u * (5.2578715020e-2 + u * (-3.3457406443e-2 + u * 1.1357370054e-2));
    let middle = 5.8037704288e-2 + u * (1.9848690236e-2 + u * (3.0985678717e-2 + u * high));
    9.9999998850e-1 + u * (3.3333558841e-1 + u * (1.3326088372e-1 + u * middle))
}

fn exact_angle_over_sine(depth: f64) -> f64 {
    if depth <= 0.0 {
        return 1.0;
    }
    let half = (0.5 * depth).sqrt();
    2.0 * half.min(1.0).asin() / (depth * (2.0 - depth)).sqrt()
}

/// Area between a chord and its arc of the unit circle, up to a quarter of the circle.
///
/// `(φ - sin φ)/2`, `φ` being the angle of the arc; our own fit in the chord's square `4 sin²(φ/2)`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `chord_squared` | the chord's length, squared | 0 ..= 2 | 1 |
///
/// Returns the area, in 0 ..= (π - 2)/4.
///
/// Numerics: the difference cancels for short arcs, hence a polynomial that has the cube of the chord for a factor.
/// It errs by 5.6e-9 of the area at most.
#[kernel(
    family = "rect",
    cite = "definition; polynomial",
    domain(chord_squared = 0.0..=2.0),
    budget(2e-6 * result + 1e-30),
    truth = exact_circle_segment,
    measured
)]
pub fn circle_segment(chord_squared: f32) -> f32 {
    let q = chord_squared;
    let high = -2.5667685002e-6 + q * (6.3260461501e-6 + q * (-2.0250092241e-6 + q * 4.4700347735e-7));
    let middle = 8.3751574895e-4 + q * (1.3338330127e-4 + q * (2.9695937693e-5 + q * high));
    q * sqrt(q) * (8.3333333799e-2 + q * (6.2499637476e-3 + q * middle))
}

fn exact_circle_segment(chord_squared: f64) -> f64 {
    let angle = 2.0 * (0.5 * chord_squared.max(0.0).sqrt()).min(1.0).asin();
    if angle > 0.5 {
        return 0.5 * (angle - angle.sin());
    }
    // The Taylor series of (φ - sin φ)/2.
    let mut term = angle * angle * angle / 12.0;
    let mut sum = 0.0;
    for n in 1..12_u32 {
        sum += term;
        let n = f64::from(2 * n);
        term *= -angle * angle / ((n + 2.0) * (n + 3.0));
    }
    sum
}

/// `log(1 + x) / x`, and 1 at 0.
///
/// Source: the definition; for `x < 1` the series of the inverse hyperbolic tangent,
/// `log(1 + x) = 2 artanh(x/(2 + x))`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `x` | argument | 0 ..= 1e18 | 1 |
///
/// Returns the quotient, in 0 ..= 1; it decreases with `x`.
///
/// Numerics: `1 + x` loses `x`, and the languages allow the logarithm an absolute error of 2^-21 near 1. The series
/// is cut where it errs by 2e-8.
#[kernel(
    family = "rect",
    cite = "definition; series",
    domain(x = 0.0..=1e18),
    budget(2e-6 * result),
    truth = exact_log1p_over_x,
    measured
)]
pub fn log1p_over_x(x: f32) -> f32 {
    if x < 1.0 {
        let whole = 2.0 + x;
        let y = x / whole;
        let y2 = y * y;
        let high = 1.0 / 9.0 + y2 * (1.0 / 11.0 + y2 * (1.0 / 13.0 + y2 * (1.0 / 15.0)));
        return 2.0 / whole * (1.0 + y2 * (1.0 / 3.0 + y2 * (1.0 / 5.0 + y2 * (1.0 / 7.0 + y2 * high))));
    }
    log(1.0 + x) / max(x, 0.5)
}

fn exact_log1p_over_x(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.ln_1p() / x }
}
