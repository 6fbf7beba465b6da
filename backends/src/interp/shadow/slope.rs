//! How much each operation's result follows its operands: difference quotients against the exact values.

use super::Float;
use super::round::largest_ulp;
use super::tape::Slope;
use crate::interp::precision::Precision;
use std::f64::consts::LN_2;

/// More than the relative error of a derivative.
const HAIR: f64 = 1.0 / (1_u64 << 46) as f64;

/// An operand with the slope in it.
pub(super) type Link = (Float, Slope);

/// Of a function of one operand.
pub(super) fn only(a: Float, slope: Slope) -> [Link; 2] {
    [(a, slope), (a, Slope::ZERO)]
}

/// `x y - x0 y0 = y (x - x0) + x0 (y - y0)`, or the same with the roles changed, whichever is narrower.
pub(super) fn mul(x: Float, y: Float) -> [Link; 2] {
    let spread = |a: Float| (a.high - a.low) / a.low.abs().max(a.high.abs());
    if spread(x) < spread(y) {
        [(x, Slope::exactly(y.exact)), (y, Slope::between(x.low, x.high))]
    } else {
        [(x, Slope::between(y.low, y.high)), (y, Slope::exactly(x.exact))]
    }
}

/// `x x - x0 x0 = (x + x0) (x - x0)`
pub(super) fn square(x: Float) -> [Link; 2] {
    only(x, Slope::between(x.low + x.exact, x.high + x.exact))
}

/// `x / y - z0 = (x - x0) / y - z0 (y - y0) / y`; the divisor has one sign.
pub(super) fn div(x: Float, y: Float, quotient: f64) -> [Link; 2] {
    let reciprocal = Slope::between(1.0 / y.low, 1.0 / y.high);
    [(x, reciprocal), (y, reciprocal.times(-quotient))]
}

pub(super) fn abs(a: Float) -> [Link; 2] {
    let slope = if a.low >= 0.0 {
        Slope::ONE
    } else if a.high <= 0.0 {
        Slope::MINUS_ONE
    } else {
        Slope::between(-1.0, 1.0)
    };
    only(a, slope)
}

/// Of `min`; where the order is sure, one operand alone counts.
pub(super) fn min(a: Float, b: Float) -> [Link; 2] {
    if a.high <= b.low {
        only(a, Slope::ONE)
    } else if b.high <= a.low {
        only(b, Slope::ONE)
    } else {
        [(a, Slope::PARTLY), (b, Slope::PARTLY)]
    }
}

pub(super) fn max(a: Float, b: Float) -> [Link; 2] {
    if a.high <= b.low {
        only(b, Slope::ONE)
    } else if b.high <= a.low {
        only(a, Slope::ONE)
    } else {
        [(a, Slope::PARTLY), (b, Slope::PARTLY)]
    }
}

/// `sqrt(x) - sqrt(x0) = (x - x0) / (sqrt(x) + sqrt(x0))`
pub(super) fn sqrt(a: Float) -> Slope {
    let root = a.exact.max(0.0).sqrt();
    Slope::between(1.0 / (a.high.sqrt() + root), 1.0 / (a.low.max(0.0).sqrt() + root))
}

/// Between the derivatives at the ends, which rise or fall all along.
fn monotone(a: Float, derivative: fn(f64) -> f64) -> Slope {
    Slope::between(derivative(a.low), derivative(a.high)).wider(HAIR)
}

pub(super) fn inverse_sqrt(a: Float) -> Slope {
    monotone(a, |x| -0.5 / (x * x.sqrt()))
}

pub(super) fn exp(a: Float) -> Slope {
    monotone(a, libm::exp)
}

pub(super) fn exp2(a: Float) -> Slope {
    monotone(a, libm::exp2).times(LN_2)
}

pub(super) fn log(a: Float) -> Slope {
    monotone(a, |x| 1.0 / x)
}

pub(super) fn log2(a: Float) -> Slope {
    monotone(a, |x| 1.0 / x).times(1.0 / LN_2)
}

pub(super) fn atan(a: Float) -> Slope {
    let flattest = a.low.abs().max(a.high.abs());
    let steepest = if a.low <= 0.0 && a.high >= 0.0 { 0.0 } else { a.low.abs().min(a.high.abs()) };
    let derivative = |x: f64| 1.0 / (1.0 + x * x);
    Slope::between(derivative(flattest), derivative(steepest))
}

/// Sine and cosine: the derivative moves by no more than the operand does.
fn wave(a: Float, derivative: f64) -> Slope {
    let reach = (a.high - a.exact).max(a.exact - a.low);
    Slope::between((derivative - reach).max(-1.0), (derivative + reach).min(1.0))
}

pub(super) fn sin(a: Float) -> Slope {
    wave(a, libm::cos(a.exact))
}

pub(super) fn cos(a: Float) -> Slope {
    wave(a, -libm::sin(a.exact))
}

/// Over a box without the origin and without the cut: `x / r^2` in `y`, `-y / r^2` in `x`.
pub(super) fn atan2(y: Float, x: Float) -> [Link; 2] {
    let nearest = |a: Float| if a.low <= 0.0 && a.high >= 0.0 { 0.0 } else { a.low.abs().min(a.high.abs()) };
    let farthest = |a: Float| a.low.abs().max(a.high.abs());
    let square = |a: f64, b: f64| a * a + b * b;
    let inverse =
        Slope::between(1.0 / square(nearest(x), nearest(y)), 1.0 / square(farthest(x), farthest(y)));
    let along = |a: Float| Slope::between(a.low, a.high).product(inverse);
    [(y, along(x)), (x, along(y).times(-1.0))]
}

/// Whether all drivers have this one number, and it is the exact one.
fn known(a: Float) -> bool {
    a.is_point()
}

/// Own error of a correctly rounded result, either way.
pub(super) fn rounded<P: Precision>(result: Float, operands: [Float; 2]) -> f64 {
    if operands.into_iter().all(known) {
        return result.bound();
    }
    spacing::<P>(result.low.abs().max(result.high.abs()))
}

/// Own error of a product: a power of two shifts, where all digits are promised.
pub(super) fn rounded_product<P: Precision>(result: Float, [a, b]: [Float; 2]) -> f64 {
    let shift = |x: Float| known(x) && (x.low.to_bits() & ((1 << 52) - 1)) == 0;
    if !P::IS_WIDE && (shift(a) || shift(b)) { 0.0 } else { rounded::<P>(result, [a, b]) }
}

/// Own error of a quotient; see [`super::interval::div`].
pub(super) fn divided<P: Precision>(result: Float, operands: [Float; 2], ulps: f64) -> f64 {
    if operands.into_iter().all(known) {
        result.bound()
    } else {
        largest_ulp::<P>(ulps, (result.low, result.high))
    }
}

/// Distance of neighbouring floats below `size`.
fn spacing<P: Precision>(size: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    let power = f64::from_bits(size.next_down().to_bits() & EXPONENT);
    power.max(P::MIN_NORMAL) * P::ULP
}
