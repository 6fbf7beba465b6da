//! Operations that choose or jump.

use super::super::model::Comparison;
use super::{Decision, Real, arithmetic};
use lobe_codegen::math::scalar;

/// A comparison; it may come out either way where the legal results overlap.
pub(in super::super) fn compare(op: Comparison, a: Real, b: Real) -> Decision {
    let value = op.holds(a.value, b.value);
    let exact = op.holds(a.exact, b.exact);
    let certain = a.is_certain() && b.is_certain();
    let ((a0, a1), (b0, b1)) = (a.ends(), b.ends());
    let ambiguous = match op {
        _ if certain => false,
        // All of one below all of the other leaves no doubt; so says `!(.. < ..)` for NaN.
        Comparison::Less | Comparison::GreaterEqual => !(a1 < b0 || a0 >= b1),
        Comparison::LessEqual | Comparison::Greater => !(a1 <= b0 || a0 > b1),
        Comparison::Equal | Comparison::NotEqual => !(a1 < b0 || b1 < a0),
    };
    Decision { value, exact, ambiguous }
}

/// A function that does not decrease, and returns representable values.
fn monotone(x: Real, f32_of: fn(f32) -> f32, f64_of: fn(f64) -> f64) -> Real {
    let exact = f64_of(x.exact);
    let (low, high) = x.ends();
    let bound = (f64_of(high) - exact).max(exact - f64_of(low));
    let bound = if bound.is_nan() { f64::INFINITY } else { bound };
    Real { value: f32_of(x.value), exact, bound }
}

pub(super) fn abs(x: Real) -> Real {
    Real { value: x.value.abs(), exact: x.exact.abs(), ..x }
}

pub(super) fn floor(x: Real) -> Real {
    monotone(x, scalar::floor, f64::floor)
}

pub(super) fn ceil(x: Real) -> Real {
    monotone(x, scalar::ceil, f64::ceil)
}

pub(super) fn round(x: Real) -> Real {
    monotone(x, scalar::round, f64::round_ties_even)
}

pub(super) fn trunc(x: Real) -> Real {
    monotone(x, scalar::trunc, f64::trunc)
}

pub(super) fn sign(x: Real) -> Real {
    monotone(x, scalar::sign, |x| {
        if x > 0.0 {
            1.0
        } else if x < 0.0 {
            -1.0
        } else {
            x
        }
    })
}

pub(super) fn saturate(x: Real) -> Real {
    monotone(x, scalar::saturate, |x| x.clamp(0.0, 1.0))
}

/// `x - floor(x)`
pub(super) fn fract(x: Real) -> Real {
    Real { value: scalar::fract(x.value), ..arithmetic::subtract(x, floor(x)) }
}

pub(super) fn min(a: Real, b: Real) -> Real {
    choose(a, b, scalar::min(a.value, b.value), f64::min)
}

pub(super) fn max(a: Real, b: Real) -> Real {
    choose(a, b, scalar::max(a.value, b.value), f64::max)
}

/// The smaller or larger of two: its legal results lie between those of the ends.
fn choose(a: Real, b: Real, value: f32, f: fn(f64, f64) -> f64) -> Real {
    let exact = f(a.exact, b.exact);
    let ((a0, a1), (b0, b1)) = (a.ends(), b.ends());
    let bound = (f(a1, b1) - exact).max(exact - f(a0, b0));
    // Rust's min and max pass over NaN; a bound must not.
    let lost = bound.is_nan()
        || a.bound.is_infinite() && b.bound.is_infinite()
        || a.exact.is_nan()
        || b.exact.is_nan();
    Real { value, exact, bound: if lost { f64::INFINITY } else { bound } }
}

pub(super) fn clamp(x: Real, low: Real, high: Real) -> Real {
    min(max(x, low), high)
}

/// 1 if `edge <= x`, otherwise 0.
pub(super) fn step(edge: Real, x: Real) -> Real {
    let holds = compare(Comparison::LessEqual, edge, x);
    let of = |b: bool| if b { 1.0 } else { 0.0 };
    Real { value: of(holds.value) as f32, exact: of(holds.exact), bound: of(holds.ambiguous) }
}

/// `x - y trunc(x / y)`
pub(super) fn remainder(x: Real, y: Real) -> Real {
    let quotient = trunc(arithmetic::divide(x, y));
    let shadow = arithmetic::subtract(x, arithmetic::multiply(y, quotient));
    Real { value: x.value % y.value, exact: x.exact % y.exact, ..shadow }
}
