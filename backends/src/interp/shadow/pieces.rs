//! Functions that return one of their operands, or a whole number: exact, but for the choice.

use super::Float;
use crate::interp::precision::Precision;
use crate::interp::program::op::FloatOp as O;

/// The strict result of an operation on one number.
fn one<P: Precision>(op: O, a: Float) -> f64 {
    P::strict(op, [a.value, 0.0, 0.0])
}

/// The same on two.
fn two<P: Precision>(op: O, a: Float, b: Float) -> f64 {
    P::strict(op, [a.value, b.value, 0.0])
}

/// `f` is not decreasing.
fn monotone<P: Precision>(a: Float, op: O, f: fn(f64) -> f64) -> Float {
    let (value, exact) = (one::<P>(op, a), f(a.exact));
    if a.bounded() {
        Float::closed::<P>(value, exact, f(a.low), f(a.high))
    } else {
        Float::unbounded(value, exact)
    }
}

fn sign_of(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

pub(super) fn floor<P: Precision>(a: Float) -> Float {
    monotone::<P>(a, O::Floor, f64::floor)
}

pub(super) fn ceil<P: Precision>(a: Float) -> Float {
    monotone::<P>(a, O::Ceil, f64::ceil)
}

pub(super) fn trunc<P: Precision>(a: Float) -> Float {
    monotone::<P>(a, O::Trunc, f64::trunc)
}

pub(super) fn round<P: Precision>(a: Float) -> Float {
    monotone::<P>(a, O::Round, f64::round_ties_even)
}

pub(super) fn sign<P: Precision>(a: Float) -> Float {
    monotone::<P>(a, O::Sign, sign_of)
}

/// `a - floor(a)`, correctly rounded, so up to and including 1.
pub(super) fn fract<P: Precision>(a: Float) -> Float {
    let (value, exact) = (one::<P>(O::Fract, a), a.exact - a.exact.floor());
    if !a.bounded() {
        return Float::unbounded(value, exact);
    }
    if a.low.floor() == a.high.floor() {
        let floor = a.low.floor();
        // The difference may need more bits than f64 has, but only near the ends of `0 ..= 1`.
        return Float::closed::<P>(
            value,
            exact,
            P::down((a.low - floor).next_down()).max(0.0),
            P::up((a.high - floor).next_up()).min(1.0),
        );
    }
    Float::closed::<P>(value, exact, 0.0, 1.0)
}

pub(super) fn abs<P: Precision>(a: Float) -> Float {
    let (value, exact) = (one::<P>(O::Abs, a), a.exact.abs());
    if !a.bounded() {
        return Float::unbounded(value, exact);
    }
    let low = if a.low <= 0.0 && a.high >= 0.0 { 0.0 } else { a.low.abs().min(a.high.abs()) };
    Float::closed::<P>(value, exact, low, a.low.abs().max(a.high.abs()))
}

pub(super) fn min<P: Precision>(a: Float, b: Float) -> Float {
    let (value, exact) = (two::<P>(O::Min, a, b), a.exact.min(b.exact));
    if a.bounded() && b.bounded() {
        Float::closed::<P>(value, exact, a.low.min(b.low), a.high.min(b.high))
    } else {
        Float::unbounded(value, exact)
    }
}

pub(super) fn max<P: Precision>(a: Float, b: Float) -> Float {
    let (value, exact) = (two::<P>(O::Max, a, b), a.exact.max(b.exact));
    if a.bounded() && b.bounded() {
        Float::closed::<P>(value, exact, a.low.max(b.low), a.high.max(b.high))
    } else {
        Float::unbounded(value, exact)
    }
}

pub(super) fn step<P: Precision>(edge: Float, x: Float) -> Float {
    let number = |holds: bool| if holds { 1.0 } else { 0.0 };
    let (value, exact) = (two::<P>(O::Step, edge, x), number(edge.exact <= x.exact));
    if edge.bounded() && x.bounded() {
        Float::closed::<P>(value, exact, number(edge.high <= x.low), number(edge.low <= x.high))
    } else {
        Float::unbounded(value, exact)
    }
}
