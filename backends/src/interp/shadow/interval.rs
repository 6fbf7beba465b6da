//! The four operations and the remainder, on intervals.
//!
//! Ends are computed in f64 and rounded outwards to f32, which is as far as a correctly rounded result can
//! be; an end that f64 itself had to round is first moved outwards by one f64 step.

use super::promise::Quotient;
use super::round::{down, ulp, up};
use super::{Float, Place};

/// The sum of two ends and the direction in which the true one lies.
fn sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let b_part = s - a;
    (s, (a - (s - b_part)) + (b - b_part))
}

fn sum_down(a: f64, b: f64) -> f64 {
    let (s, rest) = sum(a, b);
    down(if rest < 0.0 { s.next_down() } else { s })
}

fn sum_up(a: f64, b: f64) -> f64 {
    -sum_down(-a, -b)
}

pub(super) fn add(a: Float, b: Float) -> Float {
    Float::closed(a.value + b.value, a.exact + b.exact, sum_down(a.low, b.low), sum_up(a.high, b.high))
}

pub(super) fn neg(a: Float) -> Float {
    Float { value: -a.value, exact: -a.exact, low: -a.high, high: -a.low, place: Place::NONE }
}

pub(super) fn sub(a: Float, b: Float) -> Float {
    let difference = add(a, neg(b));
    Float { value: a.value - b.value, ..difference }
}

/// Whether a number is an f32, so that products of two such are exact in f64.
fn single(x: f64) -> bool {
    f64::from(x as f32) == x
}

fn extremes(values: [f64; 4]) -> (f64, f64) {
    (values.into_iter().fold(f64::INFINITY, f64::min), values.into_iter().fold(f64::NEG_INFINITY, f64::max))
}

/// The product's interval, from that of the exact products.
fn product(value: f32, exact: f64, (low, high): (f64, f64), precise: bool) -> Float {
    if precise {
        return Float::closed(value, exact, down(low), up(high));
    }
    // Nothing but a zero factor gives zero here: f64 has room below the products of f32 numbers.
    let low = if low == 0.0 { low } else { low.next_down() };
    let high = if high == 0.0 { high } else { high.next_up() };
    Float::closed(value, exact, down(low), up(high))
}

pub(super) fn mul(a: Float, b: Float) -> Float {
    let (value, exact) = (a.value * b.value, a.exact * b.exact);
    if !a.bounded() || !b.bounded() {
        return Float::unbounded(value, exact);
    }
    let ends = extremes([a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high]);
    let precise = single(a.low) && single(a.high) && single(b.low) && single(b.high);
    product(value, exact, ends, precise)
}

/// `a * a`, both factors being the same number.
pub(super) fn square(a: Float) -> Float {
    let (value, exact) = (a.value * a.value, a.exact * a.exact);
    if !a.bounded() {
        return Float::unbounded(value, exact);
    }
    let (low, high) = (a.low * a.low, a.high * a.high);
    let least = if a.low <= 0.0 && a.high >= 0.0 { 0.0 } else { low.min(high) };
    product(value, exact, (least, low.max(high)), single(a.low) && single(a.high))
}

pub(super) fn div(a: Float, b: Float, promise: Quotient) -> Float {
    let (value, exact) = (a.value / b.value, a.exact / b.exact);
    let smallest = b.low.max(-b.high);
    let largest = b.high.max(-b.low);
    if !(a.bounded() && smallest >= promise.from && largest <= promise.to) {
        return Float::unbounded(value, exact);
    }
    let quotients = extremes([a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high]);
    let (low, high) = ulp(promise.ulps, quotients);
    Float::closed(value, exact, low, high)
}
