//! What an operation's rounding adds to the interval of its exact results.

use crate::interp::precision::Precision;

/// More than the relative error of an f64 function.
const HAIR: f64 = 1.0 / (1_u64 << 50) as f64;

/// `x` and the hair by which an f64 function may be above.
pub(super) fn below(x: f64) -> f64 {
    x - x.abs() * HAIR
}

/// `x` and the hair by which an f64 function may be below.
pub(super) fn above(x: f64) -> f64 {
    x + x.abs() * HAIR
}

/// Widens by `n` ULP; the sign of results stays.
pub(super) fn ulp<P: Precision>(n: f64, (low, high): (f64, f64)) -> (f64, f64) {
    let margin = |x: f64| {
        (n * P::ULP + HAIR) * x.abs() + if x.abs() < 2.0 * P::MIN_NORMAL { n * P::TINY } else { 0.0 }
    };
    let wide = (low - margin(low), high + margin(high));
    (if low >= 0.0 { wide.0.max(0.0) } else { wide.0 }, if high <= 0.0 { wide.1.min(0.0) } else { wide.1 })
}

/// The most that `n` ULP are anywhere from `low` to `high`.
pub(super) fn largest_ulp<P: Precision>(n: f64, (low, high): (f64, f64)) -> f64 {
    (n * P::ULP + HAIR) * low.abs().max(high.abs()) + n * P::TINY
}

/// Widens by an absolute error.
pub(super) fn absolute(error: f64, (low, high): (f64, f64)) -> (f64, f64) {
    (below(low - error), above(high + error))
}
