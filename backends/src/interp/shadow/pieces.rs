//! Functions that return one of their operands, or a whole number: exact, but for the choice.

use super::Float;
use super::round::{down, up};
use lobe_codegen::math::scalar;

/// `f` is not decreasing.
fn monotone(a: Float, native: fn(f32) -> f32, f: fn(f64) -> f64) -> Float {
    let (value, exact) = (native(a.value), f(a.exact));
    if a.bounded() {
        Float::closed(value, exact, f(a.low), f(a.high))
    } else {
        Float::unbounded(value, exact)
    }
}

fn sign_of(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

pub(super) fn floor(a: Float) -> Float {
    monotone(a, scalar::floor, f64::floor)
}

pub(super) fn ceil(a: Float) -> Float {
    monotone(a, scalar::ceil, f64::ceil)
}

pub(super) fn trunc(a: Float) -> Float {
    monotone(a, scalar::trunc, f64::trunc)
}

pub(super) fn round(a: Float) -> Float {
    monotone(a, scalar::round, f64::round_ties_even)
}

pub(super) fn sign(a: Float) -> Float {
    monotone(a, scalar::sign, sign_of)
}

/// `a - floor(a)`, correctly rounded, so up to and including 1.
pub(super) fn fract(a: Float) -> Float {
    let (value, exact) = (scalar::fract(a.value), a.exact - a.exact.floor());
    if !a.bounded() {
        return Float::unbounded(value, exact);
    }
    if a.low.floor() == a.high.floor() {
        let floor = a.low.floor();
        // The difference may need more bits than f64 has, but only near the ends of `0 ..= 1`.
        return Float::closed(
            value,
            exact,
            down((a.low - floor).next_down()).max(0.0),
            up((a.high - floor).next_up()).min(1.0),
        );
    }
    Float::closed(value, exact, 0.0, 1.0)
}

pub(super) fn abs(a: Float) -> Float {
    let (value, exact) = (a.value.abs(), a.exact.abs());
    if !a.bounded() {
        return Float::unbounded(value, exact);
    }
    let low = if a.low <= 0.0 && a.high >= 0.0 { 0.0 } else { a.low.abs().min(a.high.abs()) };
    Float::closed(value, exact, low, a.low.abs().max(a.high.abs()))
}

pub(super) fn min(a: Float, b: Float) -> Float {
    let (value, exact) = (scalar::min(a.value, b.value), a.exact.min(b.exact));
    if a.bounded() && b.bounded() {
        Float::closed(value, exact, a.low.min(b.low), a.high.min(b.high))
    } else {
        Float::unbounded(value, exact)
    }
}

pub(super) fn max(a: Float, b: Float) -> Float {
    let (value, exact) = (scalar::max(a.value, b.value), a.exact.max(b.exact));
    if a.bounded() && b.bounded() {
        Float::closed(value, exact, a.low.max(b.low), a.high.max(b.high))
    } else {
        Float::unbounded(value, exact)
    }
}

pub(super) fn step(edge: Float, x: Float) -> Float {
    let number = |holds: bool| if holds { 1.0 } else { 0.0 };
    let (value, exact) = (scalar::step(edge.value, x.value), number(edge.exact <= x.exact));
    if edge.bounded() && x.bounded() {
        Float::closed(value, exact, number(edge.high <= x.low), number(edge.low <= x.high))
    } else {
        Float::unbounded(value, exact)
    }
}
