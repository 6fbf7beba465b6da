//! Elementary functions: f64 at the ends of the interval, widened by the accuracy class.

use super::round::{above, absolute, below, ulp};
use super::{Float, MIN_NORMAL, Shadow};
use crate::interp::formula;
use lobe_codegen::intrinsics::{Accuracy, Intrinsic};
use lobe_codegen::math::scalar;
use std::f64::consts::PI;

/// Widens the exact results for arguments of `low ..= high`.
fn widen(accuracy: Accuracy, argument: (f64, f64), results: (f64, f64)) -> Option<(f64, f64)> {
    let size = argument.0.abs().max(argument.1.abs());
    Some(match accuracy {
        Accuracy::Exact | Accuracy::Correct => ulp(1.0, results),
        Accuracy::Ulp(n) => ulp(n, results),
        Accuracy::UlpScaled { base, slope } => ulp(base + slope * size, results),
        Accuracy::UlpOrAbsolute { ulp: n, absolute: error, from, to } => {
            let apart = argument.1 < from || argument.0 > to;
            let within = argument.0 >= from && argument.1 <= to;
            let (a, b) = (absolute(error, results), ulp(n, results));
            match (apart, within) {
                (true, _) => b,
                (_, true) => a,
                (false, false) => (a.0.min(b.0), a.1.max(b.1)),
            }
        }
        Accuracy::AbsoluteOn { absolute: error, from, to } => {
            // The f32 nearest to an end is taken for it.
            let (from, to) = (from.min(f64::from(from as f32)), to.max(f64::from(to as f32)));
            if argument.0 < from || argument.1 > to {
                return None;
            }
            absolute(error, results)
        }
        Accuracy::Inherited(_) | Accuracy::InheritedOrAbsolute(..) => return None,
    })
}

/// `f` at the ends, in order, with the hair that f64 may be off.
fn ends(a: Float, f: fn(f64) -> f64) -> (f64, f64) {
    let (x, y) = (f(a.low), f(a.high));
    (below(x.min(y)), above(x.max(y)))
}

/// A function that rises or falls all along `from <= x`.
fn monotone(a: Float, native: fn(f32) -> f32, f: fn(f64) -> f64, from: f64, intrinsic: Intrinsic) -> Float {
    let (value, exact) = (native(a.value), f(a.exact));
    let inside = a.bounded() && a.low >= from;
    match inside.then(|| widen(intrinsic.row().accuracy, (a.low, a.high), ends(a, f))).flatten() {
        Some((low, high)) => Float::closed(value, exact, low, high),
        None => Float::unbounded(value, exact),
    }
}

pub(super) fn exp(a: Float) -> Float {
    monotone(a, scalar::exp, libm::exp, f64::NEG_INFINITY, Intrinsic::Exp)
}

pub(super) fn exp2(a: Float) -> Float {
    monotone(a, scalar::exp2, libm::exp2, f64::NEG_INFINITY, Intrinsic::Exp2)
}

pub(super) fn log(a: Float) -> Float {
    monotone(a, scalar::log, libm::log, MIN_NORMAL, Intrinsic::Log)
}

pub(super) fn log2(a: Float) -> Float {
    monotone(a, scalar::log2, libm::log2, MIN_NORMAL, Intrinsic::Log2)
}

pub(super) fn atan(a: Float) -> Float {
    monotone(a, scalar::atan, libm::atan, f64::NEG_INFINITY, Intrinsic::Atan)
}

pub(super) fn inverse_sqrt(a: Float) -> Float {
    monotone(a, scalar::inverse_sqrt, |x| 1.0 / x.sqrt(), MIN_NORMAL, Intrinsic::InverseSqrt)
}

/// `1 / inverse_sqrt(x)`; see the readings in the module's documentation.
pub(super) fn sqrt(a: Float) -> Float {
    let (value, exact) = (scalar::sqrt(a.value), a.exact.sqrt());
    if !(a.bounded() && a.low >= 0.0) {
        return Float::unbounded(value, exact);
    }
    // (1 + 2u)(1 + 2.5u) < 1 + 4.5001u
    let (low, high) = ulp(4.5001, ends(a, f64::sqrt));
    let low = if a.low < MIN_NORMAL { 0.0 } else { low };
    Float::closed(value, exact, low, high)
}

/// Sine and cosine: their extremes within the interval are those of the ends and of the turning points.
fn wave(
    a: Float,
    native: fn(f32) -> f32,
    f: fn(f64) -> f64,
    turns: &[(f64, f64)],
    intrinsic: Intrinsic,
) -> Float {
    let (value, exact) = (native(a.value), f(a.exact));
    if !a.bounded() {
        return Float::unbounded(value, exact);
    }
    let mut results = ends(a, f);
    for (_, extreme) in turns.iter().filter(|(at, _)| a.low <= *at && *at <= a.high) {
        results = (results.0.min(*extreme), results.1.max(*extreme));
    }
    match widen(intrinsic.row().accuracy, (a.low, a.high), results) {
        Some((low, high)) => Float::closed(value, exact, low, high),
        None => Float::unbounded(value, exact),
    }
}

pub(super) fn sin(a: Float) -> Float {
    wave(a, scalar::sin, libm::sin, &[(-PI / 2.0, -1.0), (PI / 2.0, 1.0)], Intrinsic::Sin)
}

pub(super) fn cos(a: Float) -> Float {
    wave(a, scalar::cos, libm::cos, &[(-PI, -1.0), (0.0, 1.0), (PI, -1.0)], Intrinsic::Cos)
}

/// Seen from the origin, the box of arguments spans angles; where it meets the cut, all of them.
pub(super) fn atan2(y: Float, x: Float) -> Float {
    let (value, exact) = (scalar::atan2(y.value, x.value), libm::atan2(y.exact, x.exact));
    let origin = x.low <= 0.0 && x.high >= 0.0 && y.low <= 0.0 && y.high >= 0.0;
    if !y.bounded() || !x.bounded() || origin {
        return Float::unbounded(value, exact);
    }
    let results = if x.low < 0.0 && y.low <= 0.0 && y.high >= 0.0 {
        (-PI, PI)
    } else {
        // No cut and no origin: the extreme angles are those of corners.
        let corner = |y, x| libm::atan2(y, x);
        let angles =
            [corner(y.low, x.low), corner(y.low, x.high), corner(y.high, x.low), corner(y.high, x.high)];
        (
            below(angles.into_iter().fold(f64::INFINITY, f64::min)),
            above(angles.into_iter().fold(f64::NEG_INFINITY, f64::max)),
        )
    };
    match widen(Intrinsic::Atan2.row().accuracy, (0.0, 0.0), results) {
        Some((low, high)) => Float::closed(value, exact, low, high),
        None => Float::unbounded(value, exact),
    }
}

/// The interval of `formula`; value and exact value of their own.
fn inherited(formula: Float, value: f32, exact: f64) -> Float {
    if formula.bounded() {
        Float::closed(value, exact, formula.low, formula.high)
    } else {
        Float::unbounded(value, exact)
    }
}

/// The worse of the formula and of an absolute error; `f` rises or falls all along `from ..= to`.
fn inherited_or_absolute(
    a: Float,
    formula: Float,
    native: fn(f32) -> f32,
    f: fn(f64) -> f64,
    intrinsic: Intrinsic,
) -> Float {
    let inherited = inherited(formula, native(a.value), f(a.exact));
    match intrinsic.row().accuracy {
        Accuracy::InheritedOrAbsolute(_, error) if inherited.bounded() => {
            let (low, high) = absolute(error, ends(a, f));
            Float::closed(inherited.value, inherited.exact, low.min(inherited.low), high.max(inherited.high))
        }
        _ => inherited,
    }
}

pub(super) fn asin(a: Float) -> Float {
    inherited_or_absolute(a, formula::asin(&Shadow, a), scalar::asin, libm::asin, Intrinsic::Asin)
}

pub(super) fn acos(a: Float) -> Float {
    inherited_or_absolute(a, formula::acos(&Shadow, a), scalar::acos, libm::acos, Intrinsic::Acos)
}

pub(super) fn tanh(a: Float) -> Float {
    inherited_or_absolute(a, formula::tanh(&Shadow, a), scalar::tanh, libm::tanh, Intrinsic::Tanh)
}

pub(super) fn tan(a: Float) -> Float {
    inherited(formula::tan(&Shadow, a), scalar::tan(a.value), libm::tan(a.exact))
}

pub(super) fn sinh(a: Float) -> Float {
    inherited(formula::sinh(&Shadow, a), scalar::sinh(a.value), libm::sinh(a.exact))
}

pub(super) fn cosh(a: Float) -> Float {
    inherited(formula::cosh(&Shadow, a), scalar::cosh(a.value), libm::cosh(a.exact))
}

pub(super) fn asinh(a: Float) -> Float {
    inherited(formula::asinh(&Shadow, a), scalar::asinh(a.value), libm::asinh(a.exact))
}

pub(super) fn acosh(a: Float) -> Float {
    inherited(formula::acosh(&Shadow, a), scalar::acosh(a.value), libm::acosh(a.exact))
}

pub(super) fn atanh(a: Float) -> Float {
    inherited(formula::atanh(&Shadow, a), scalar::atanh(a.value), libm::atanh(a.exact))
}

pub(super) fn pow(x: Float, y: Float) -> Float {
    let exact = if x.exact < 0.0 { f64::NAN } else { libm::pow(x.exact, y.exact) };
    inherited(formula::pow(&Shadow, x, y), scalar::pow(x.value, y.value), exact)
}
