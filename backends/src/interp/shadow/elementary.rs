//! Elementary functions: f64 at the ends of the interval, widened by the accuracy class.

use super::round::{above, absolute, below, largest_ulp, ulp};
use super::slope::{self, only};
use super::tape::Slope;
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

/// The own error of a result, as [`widen`] has it; `None` where it is not of one size.
fn own(accuracy: Accuracy, argument: (f64, f64), result: Float) -> Option<f64> {
    let size = argument.0.abs().max(argument.1.abs());
    let ulps = |n: f64| largest_ulp(n, (result.low, result.high));
    match accuracy {
        Accuracy::Exact | Accuracy::Correct => Some(ulps(1.0)),
        Accuracy::Ulp(n) => Some(ulps(n)),
        Accuracy::UlpScaled { base, slope } => Some(ulps(base + slope * size)),
        Accuracy::UlpOrAbsolute { ulp: n, absolute: error, from, to } => {
            let apart = argument.1 < from || argument.0 > to;
            let within = argument.0 >= from && argument.1 <= to;
            Some(match (apart, within) {
                (true, _) => ulps(n),
                (_, true) => above(error),
                (false, false) => ulps(n).max(above(error)),
            })
        }
        Accuracy::AbsoluteOn { absolute: error, .. } => Some(above(error)),
        Accuracy::Inherited(_) | Accuracy::InheritedOrAbsolute(..) => None,
    }
}

impl Shadow {
    /// Puts the result of a function of one number on the tape.
    fn follow(&self, a: Float, result: Float, slope: fn(Float) -> Slope, accuracy: Accuracy) -> Float {
        if !result.bounded() {
            return result;
        }
        let error = if a.is_point() { Some(result.bound()) } else { own(accuracy, (a.low, a.high), result) };
        match error {
            Some(error) => self.link(result, error, only(a, slope(a))),
            None => self.source(result),
        }
    }
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

pub(super) fn exp(m: &Shadow, a: Float) -> Float {
    let result = monotone(a, scalar::exp, libm::exp, f64::NEG_INFINITY, Intrinsic::Exp);
    m.follow(a, result, slope::exp, Intrinsic::Exp.row().accuracy)
}

pub(super) fn exp2(m: &Shadow, a: Float) -> Float {
    let result = monotone(a, scalar::exp2, libm::exp2, f64::NEG_INFINITY, Intrinsic::Exp2);
    m.follow(a, result, slope::exp2, Intrinsic::Exp2.row().accuracy)
}

pub(super) fn log(m: &Shadow, a: Float) -> Float {
    let a = if a.low < MIN_NORMAL { m.tightened(a) } else { a };
    let result = monotone(a, scalar::log, libm::log, MIN_NORMAL, Intrinsic::Log);
    m.follow(a, result, slope::log, Intrinsic::Log.row().accuracy)
}

pub(super) fn log2(m: &Shadow, a: Float) -> Float {
    let a = if a.low < MIN_NORMAL { m.tightened(a) } else { a };
    let result = monotone(a, scalar::log2, libm::log2, MIN_NORMAL, Intrinsic::Log2);
    m.follow(a, result, slope::log2, Intrinsic::Log2.row().accuracy)
}

pub(super) fn atan(m: &Shadow, a: Float) -> Float {
    let result = monotone(a, scalar::atan, libm::atan, f64::NEG_INFINITY, Intrinsic::Atan);
    m.follow(a, result, slope::atan, Intrinsic::Atan.row().accuracy)
}

pub(super) fn inverse_sqrt(m: &Shadow, a: Float) -> Float {
    let a = if a.low < MIN_NORMAL { m.tightened(a) } else { a };
    let result = monotone(a, scalar::inverse_sqrt, |x| 1.0 / x.sqrt(), MIN_NORMAL, Intrinsic::InverseSqrt);
    m.follow(a, result, slope::inverse_sqrt, Intrinsic::InverseSqrt.row().accuracy)
}

/// `1 / inverse_sqrt(x)`; see the readings in the module's documentation.
pub(super) fn sqrt(m: &Shadow, a: Float) -> Float {
    let a = if a.low < MIN_NORMAL { m.tightened(a) } else { a };
    let (value, exact) = (scalar::sqrt(a.value), a.exact.sqrt());
    if !(a.bounded() && a.low >= 0.0) {
        return Float::unbounded(value, exact);
    }
    // (1 + 2u)(1 + 2.5u) < 1 + 4.5001u
    const ULPS: f64 = 4.5001;
    let (low, high) = ulp(ULPS, ends(a, f64::sqrt));
    if a.low < MIN_NORMAL {
        return m.source(Float::closed(value, exact, 0.0, high));
    }
    m.follow(a, Float::closed(value, exact, low, high), slope::sqrt, Accuracy::Ulp(ULPS))
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

pub(super) fn sin(m: &Shadow, a: Float) -> Float {
    let result = wave(a, scalar::sin, libm::sin, &[(-PI / 2.0, -1.0), (PI / 2.0, 1.0)], Intrinsic::Sin);
    m.follow(a, result, slope::sin, Intrinsic::Sin.row().accuracy)
}

pub(super) fn cos(m: &Shadow, a: Float) -> Float {
    let result = wave(a, scalar::cos, libm::cos, &[(-PI, -1.0), (0.0, 1.0), (PI, -1.0)], Intrinsic::Cos);
    m.follow(a, result, slope::cos, Intrinsic::Cos.row().accuracy)
}

/// Seen from the origin, the box of arguments spans angles; where it meets the cut, all of them.
pub(super) fn atan2(m: &Shadow, y: Float, x: Float) -> Float {
    let (value, exact) = (scalar::atan2(y.value, x.value), libm::atan2(y.exact, x.exact));
    let origin = x.low <= 0.0 && x.high >= 0.0 && y.low <= 0.0 && y.high >= 0.0;
    if !y.bounded() || !x.bounded() || origin {
        return Float::unbounded(value, exact);
    }
    let cut = x.low < 0.0 && y.low <= 0.0 && y.high >= 0.0;
    let results = if cut {
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
    let accuracy = Intrinsic::Atan2.row().accuracy;
    let result = match widen(accuracy, (0.0, 0.0), results) {
        Some((low, high)) => Float::closed(value, exact, low, high),
        None => Float::unbounded(value, exact),
    };
    match own(accuracy, (0.0, 0.0), result) {
        Some(error) if !cut => m.link(result, error, slope::atan2(y, x)),
        _ => m.source(result),
    }
}

impl Shadow {
    /// The interval of `formula`; value and exact value of their own.
    pub(super) fn inherit(&self, formula: Float, value: f32, exact: f64) -> Float {
        if formula.bounded() {
            let result = Float::closed(value, exact, formula.low, formula.high);
            self.link(result, (exact - formula.exact).abs(), only(formula, Slope::ONE))
        } else {
            Float::unbounded(value, exact)
        }
    }
}

/// The worse of the formula and of an absolute error; `f` rises or falls all along `from ..= to`.
fn inherited_or_absolute(
    m: &Shadow,
    a: Float,
    formula: Float,
    native: fn(f32) -> f32,
    f: fn(f64) -> f64,
    intrinsic: Intrinsic,
) -> Float {
    let inherited = m.inherit(formula, native(a.value), f(a.exact));
    match intrinsic.row().accuracy {
        Accuracy::InheritedOrAbsolute(_, error) if inherited.bounded() => {
            let (low, high) = absolute(error, ends(a, f));
            let (low, high) = (low.min(inherited.low), high.max(inherited.high));
            m.source(Float::closed(inherited.value, inherited.exact, low, high))
        }
        _ => inherited,
    }
}

pub(super) fn asin(m: &Shadow, a: Float) -> Float {
    inherited_or_absolute(m, a, formula::asin(m, a), scalar::asin, libm::asin, Intrinsic::Asin)
}

pub(super) fn acos(m: &Shadow, a: Float) -> Float {
    inherited_or_absolute(m, a, formula::acos(m, a), scalar::acos, libm::acos, Intrinsic::Acos)
}

pub(super) fn tanh(m: &Shadow, a: Float) -> Float {
    inherited_or_absolute(m, a, formula::tanh(m, a), scalar::tanh, libm::tanh, Intrinsic::Tanh)
}

pub(super) fn tan(m: &Shadow, a: Float) -> Float {
    m.inherit(formula::tan(m, a), scalar::tan(a.value), libm::tan(a.exact))
}

pub(super) fn sinh(m: &Shadow, a: Float) -> Float {
    m.inherit(formula::sinh(m, a), scalar::sinh(a.value), libm::sinh(a.exact))
}

pub(super) fn cosh(m: &Shadow, a: Float) -> Float {
    m.inherit(formula::cosh(m, a), scalar::cosh(a.value), libm::cosh(a.exact))
}

pub(super) fn asinh(m: &Shadow, a: Float) -> Float {
    m.inherit(formula::asinh(m, a), scalar::asinh(a.value), libm::asinh(a.exact))
}

pub(super) fn acosh(m: &Shadow, a: Float) -> Float {
    m.inherit(formula::acosh(m, a), scalar::acosh(a.value), libm::acosh(a.exact))
}

pub(super) fn atanh(m: &Shadow, a: Float) -> Float {
    m.inherit(formula::atanh(m, a), scalar::atanh(a.value), libm::atanh(a.exact))
}

pub(super) fn pow(m: &Shadow, x: Float, y: Float) -> Float {
    let exact = if x.exact < 0.0 { f64::NAN } else { libm::pow(x.exact, y.exact) };
    m.inherit(formula::pow(m, x, y), scalar::pow(x.value, y.value), exact)
}
