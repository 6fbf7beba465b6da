//! What an operation's rounding adds to the interval of its exact results.

use super::MIN_NORMAL;

/// One ULP, relative.
pub(super) const ULP: f64 = 1.0 / (1 << 23) as f64;

/// Spacing of the subnormal numbers.
pub(super) const TINY: f64 = 1.401298464324817e-45;

/// More than the relative error of an f64 function.
const HAIR: f64 = 1.0 / (1_u64 << 50) as f64;

/// The largest f32 that is not above `x`.
pub(super) fn down(x: f64) -> f64 {
    let nearest = x as f32;
    f64::from(if f64::from(nearest) > x { nearest.next_down() } else { nearest })
}

/// The smallest f32 that is not below `x`.
pub(super) fn up(x: f64) -> f64 {
    -down(-x)
}

/// `x` and the hair by which an f64 function may be above.
pub(super) fn below(x: f64) -> f64 {
    x - x.abs() * HAIR
}

/// `x` and the hair by which an f64 function may be below.
pub(super) fn above(x: f64) -> f64 {
    x + x.abs() * HAIR
}

/// Widens by `n` ULP; the sign of results stays.
pub(super) fn ulp(n: f64, (low, high): (f64, f64)) -> (f64, f64) {
    let margin =
        |x: f64| (n * ULP + HAIR) * x.abs() + if x.abs() < 2.0 * MIN_NORMAL { n * TINY } else { 0.0 };
    let wide = (low - margin(low), high + margin(high));
    (if low >= 0.0 { wide.0.max(0.0) } else { wide.0 }, if high <= 0.0 { wide.1.min(0.0) } else { wide.1 })
}

/// The most that `n` ULP are anywhere from `low` to `high`.
pub(super) fn largest_ulp(n: f64, (low, high): (f64, f64)) -> f64 {
    (n * ULP + HAIR) * low.abs().max(high.abs()) + n * TINY
}

/// Widens by an absolute error.
pub(super) fn absolute(error: f64, (low, high): (f64, f64)) -> (f64, f64) {
    (below(low - error), above(high + error))
}
