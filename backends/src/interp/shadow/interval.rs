//! The four operations and the remainder, on intervals.
//!
//! Ends are computed in f64 and rounded outwards to numbers of the format, which is as far as a correctly rounded result can
//! be; an end that f64 itself had to round is first moved outwards by one f64 step.

use super::promise::Quotient;
use super::round::ulp;
use super::{Float, Place};
use crate::interp::precision::Precision;
use crate::interp::program::op::FloatOp;

/// The sum of two ends and the direction in which the true one lies.
fn sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let b_part = s - a;
    (s, (a - (s - b_part)) + (b - b_part))
}

fn sum_down<P: Precision>(a: f64, b: f64) -> f64 {
    let (s, rest) = sum(a, b);
    P::down(if rest < 0.0 { s.next_down() } else { s })
}

fn sum_up<P: Precision>(a: f64, b: f64) -> f64 {
    -sum_down::<P>(-a, -b)
}

/// The strict result of an operation.
fn strict<P: Precision>(op: FloatOp, a: Float, b: Float) -> f64 {
    P::strict(op, [a.value, b.value, 0.0])
}

pub(super) fn add<P: Precision>(a: Float, b: Float) -> Float {
    let (low, high) = (sum_down::<P>(a.low, b.low), sum_up::<P>(a.high, b.high));
    Float::closed::<P>(strict::<P>(FloatOp::Add, a, b), a.exact + b.exact, low, high)
}

pub(super) fn neg(a: Float) -> Float {
    Float {
        value: -a.value,
        exact: -a.exact,
        low: -a.high,
        high: -a.low,
        place: Place::NONE,
        terms: a.terms.negated(),
    }
}

pub(super) fn sub<P: Precision>(a: Float, b: Float) -> Float {
    Float { value: strict::<P>(FloatOp::Sub, a, b), ..add::<P>(a, neg(b)) }
}

/// Whether a number is an f32, so that products of two such are exact in f64.
fn single(x: f64) -> bool {
    f64::from(x as f32) == x
}

fn extremes(values: [f64; 4]) -> (f64, f64) {
    (values.into_iter().fold(f64::INFINITY, f64::min), values.into_iter().fold(f64::NEG_INFINITY, f64::max))
}

/// The product's interval, from that of the exact products.
fn product<P: Precision>(value: f64, exact: f64, (low, high): (f64, f64), precise: bool) -> Float {
    if precise {
        return Float::closed::<P>(value, exact, P::down(low), P::up(high));
    }
    // Nothing but a zero factor gives zero here: f64 has room below the products of f32 numbers.
    let low = if low == 0.0 { low } else { low.next_down() };
    let high = if high == 0.0 { high } else { high.next_up() };
    Float::closed::<P>(value, exact, P::down(low), P::up(high))
}

/// Zeros among the ends of a product that may be numbers for which f64 has no room, as those which they may be.
fn with_room<P: Precision>(a: Float, b: Float, (low, high): (f64, f64)) -> (f64, f64) {
    if !P::IS_WIDE || a.is_zero() || b.is_zero() {
        return (low, high);
    }
    let like = (a.low >= 0.0 && b.low >= 0.0) || (a.high <= 0.0 && b.high <= 0.0);
    let unlike = (a.low >= 0.0 && b.high <= 0.0) || (a.high <= 0.0 && b.low >= 0.0);
    (
        if low == 0.0 && !like { -P::MIN_NORMAL } else { low },
        if high == 0.0 && !unlike { P::MIN_NORMAL } else { high },
    )
}

pub(super) fn mul<P: Precision>(a: Float, b: Float) -> Float {
    let (value, exact) = (strict::<P>(FloatOp::Mul, a, b), a.exact * b.exact);
    if !a.bounded() || !b.bounded() {
        return Float::unbounded(value, exact);
    }
    let ends = extremes([a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high]);
    let precise = single(a.low) && single(a.high) && single(b.low) && single(b.high);
    product::<P>(value, exact, with_room::<P>(a, b, ends), precise)
}

/// `a * a`, both factors being the same number.
pub(super) fn square<P: Precision>(a: Float) -> Float {
    let (value, exact) = (strict::<P>(FloatOp::Mul, a, a), a.exact * a.exact);
    if !a.bounded() {
        return Float::unbounded(value, exact);
    }
    let (low, high) = (a.low * a.low, a.high * a.high);
    let least = if a.low <= 0.0 && a.high >= 0.0 { 0.0 } else { low.min(high) };
    let is_lost = P::IS_WIDE && low.max(high) == 0.0 && !a.is_zero();
    let most = if is_lost { P::MIN_NORMAL } else { low.max(high) };
    product::<P>(value, exact, (least, most), single(a.low) && single(a.high))
}

pub(super) fn div<P: Precision>(a: Float, b: Float, promise: Quotient) -> Float {
    let (value, exact) = (strict::<P>(FloatOp::Div, a, b), a.exact / b.exact);
    let smallest = b.low.max(-b.high);
    let largest = b.high.max(-b.low);
    if !(a.bounded() && smallest >= promise.from && largest <= promise.to) {
        return Float::unbounded(value, exact);
    }
    let quotients = extremes([a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high]);
    let (low, high) = ulp::<P>(promise.ulps, quotients);
    Float::closed::<P>(value, exact, low, high)
}
