//! Elementary functions: f64 at the ends of the interval, widened by the accuracy class.

use super::promise::{is_number, own, widen};
use super::round::{above, below, ulp};
use super::slope::{self, only};
use super::tape::Slope;
use super::{Float, MIN_NORMAL, Shadow};
use crate::interp::formula;
use lobe_codegen::accuracy::Accuracy;
use lobe_codegen::intrinsics::Intrinsic;
use lobe_codegen::math::scalar;
use std::f64::consts::PI;

impl Shadow {
    /// Puts the result of a function of one number on the tape.
    fn follow(&self, a: Float, result: Float, slope: fn(Float) -> Slope, classes: &[Accuracy]) -> Float {
        if !result.bounded() {
            return result;
        }
        let error = if a.is_point() { Some(result.bound()) } else { own(classes, (a.low, a.high), result) };
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
fn monotone(a: Float, native: fn(f32) -> f32, f: fn(f64) -> f64, from: f64, classes: &[Accuracy]) -> Float {
    let (value, exact) = (native(a.value), f(a.exact));
    let inside = a.bounded() && a.low >= from;
    match inside.then(|| widen(classes, (a.low, a.high), ends(a, f))).flatten() {
        Some((low, high)) => Float::closed(value, exact, low, high),
        None => Float::unbounded(value, exact),
    }
}

pub(super) fn exp(m: &Shadow, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Exp);
    m.composed(
        classes,
        |m| formula::exp(m, a),
        |m| {
            let result = monotone(a, scalar::exp, libm::exp, f64::NEG_INFINITY, classes);
            m.follow(a, result, slope::exp, classes)
        },
    )
}

pub(super) fn exp2(m: &Shadow, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Exp2);
    let result = monotone(a, scalar::exp2, libm::exp2, f64::NEG_INFINITY, classes);
    m.follow(a, result, slope::exp2, classes)
}

pub(super) fn log(m: &Shadow, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Log);
    m.composed(
        classes,
        |m| formula::log(m, a),
        |m| {
            let a = if a.low < MIN_NORMAL { m.tightened(a) } else { a };
            let result = monotone(a, scalar::log, libm::log, MIN_NORMAL, classes);
            m.follow(a, result, slope::log, classes)
        },
    )
}

pub(super) fn log2(m: &Shadow, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Log2);
    let a = if a.low < MIN_NORMAL { m.tightened(a) } else { a };
    let result = monotone(a, scalar::log2, libm::log2, MIN_NORMAL, classes);
    m.follow(a, result, slope::log2, classes)
}

pub(super) fn atan(m: &Shadow, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Atan);
    let result = monotone(a, scalar::atan, libm::atan, f64::NEG_INFINITY, classes);
    m.follow(a, result, slope::atan, classes)
}

pub(super) fn inverse_sqrt(m: &Shadow, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::InverseSqrt);
    let a = if a.low < MIN_NORMAL { m.tightened(a) } else { a };
    let result = monotone(a, scalar::inverse_sqrt, |x| 1.0 / x.sqrt(), MIN_NORMAL, classes);
    m.follow(a, result, slope::inverse_sqrt, classes)
}

/// `1 / inverse_sqrt(x)`; see the readings in the module's documentation.
pub(super) fn sqrt(m: &Shadow, a: Float) -> Float {
    let a = if a.low < MIN_NORMAL { m.tightened(a) } else { a };
    let (value, exact) = (scalar::sqrt(a.value), a.exact.sqrt());
    if !(a.bounded() && a.low >= 0.0) {
        return Float::unbounded(value, exact);
    }
    let ulps = m.promise.root;
    let (low, high) = ulp(ulps, ends(a, f64::sqrt));
    if a.low < MIN_NORMAL {
        return m.source(Float::closed(value, exact, 0.0, high));
    }
    m.follow(a, Float::closed(value, exact, low, high), slope::sqrt, &[Accuracy::Ulp(ulps)])
}

/// Sine and cosine: their extremes within the interval are those of the ends and of the turning points, of which `top` is
/// one where the function is 1.
fn wave(a: Float, native: fn(f32) -> f32, f: fn(f64) -> f64, top: f64, classes: &[Accuracy]) -> Float {
    let (value, exact) = (native(a.value), f(a.exact));
    if !a.bounded() {
        return Float::unbounded(value, exact);
    }
    let mut results = ends(a, f);
    let meets = |turn: f64| ((a.low - turn) / (2.0 * PI)).ceil() <= ((a.high - turn) / (2.0 * PI)).floor();
    if meets(top) {
        results.1 = results.1.max(1.0);
    }
    if meets(top + PI) {
        results.0 = results.0.min(-1.0);
    }
    match widen(classes, (a.low, a.high), results) {
        Some((low, high)) => Float::closed(value, exact, low, high),
        None => Float::unbounded(value, exact),
    }
}

pub(super) fn sin(m: &Shadow, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Sin);
    let result = wave(a, scalar::sin, libm::sin, PI / 2.0, classes);
    m.follow(a, result, slope::sin, classes)
}

pub(super) fn cos(m: &Shadow, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Cos);
    let result = wave(a, scalar::cos, libm::cos, 0.0, classes);
    m.follow(a, result, slope::cos, classes)
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
    let classes = m.promise.classes(Intrinsic::Atan2);
    let result = match widen(classes, (0.0, 0.0), results) {
        Some((low, high)) => Float::closed(value, exact, low, high),
        None => Float::unbounded(value, exact),
    };
    match own(classes, (0.0, 0.0), result) {
        Some(error) if !cut => m.link(result, error, slope::atan2(y, x)),
        _ => m.source(result),
    }
}

impl Shadow {
    /// The worse of a formula and of what a function is `by_itself`, as far as the classes have either.
    fn composed(
        &self,
        classes: &[Accuracy],
        formula: impl FnOnce(&Self) -> Float,
        by_itself: impl FnOnce(&Self) -> Float,
    ) -> Float {
        let result = by_itself(self);
        if classes.iter().all(is_number) {
            return result;
        }
        let inherited = self.inherit(formula(self), result.value, result.exact);
        if !classes.iter().any(is_number) || !inherited.bounded() {
            return inherited;
        }
        self.hull(result, inherited)
    }

    /// Either of two numbers, of which the first has the value and the exact value.
    pub(super) fn hull(&self, a: Float, b: Float) -> Float {
        if !(a.bounded() && b.bounded()) {
            return Float::unbounded(a.value, a.exact);
        }
        self.source(Float::closed(a.value, a.exact, a.low.min(b.low), a.high.max(b.high)))
    }

    /// The same where the model promises the function `intrinsic` at all.
    fn inherited(&self, intrinsic: Intrinsic, formula: Float, value: f32, exact: f64) -> Float {
        if self.promise.holds(intrinsic) {
            self.inherit(formula, value, exact)
        } else {
            Float::unbounded(value, exact)
        }
    }

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
    let inherited = m.inherited(intrinsic, formula, native(a.value), f(a.exact));
    let classes = m.promise.classes(intrinsic);
    if !(inherited.bounded() && classes.iter().any(is_number)) {
        return inherited;
    }
    match widen(classes, (a.low, a.high), ends(a, f)) {
        Some((low, high)) => {
            let (low, high) = (low.min(inherited.low), high.max(inherited.high));
            m.source(Float::closed(inherited.value, inherited.exact, low, high))
        }
        None => Float::unbounded(inherited.value, inherited.exact),
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
    m.inherited(Intrinsic::Tan, formula::tan(m, a), scalar::tan(a.value), libm::tan(a.exact))
}

pub(super) fn sinh(m: &Shadow, a: Float) -> Float {
    m.inherited(Intrinsic::Sinh, formula::sinh(m, a), scalar::sinh(a.value), libm::sinh(a.exact))
}

pub(super) fn cosh(m: &Shadow, a: Float) -> Float {
    m.inherited(Intrinsic::Cosh, formula::cosh(m, a), scalar::cosh(a.value), libm::cosh(a.exact))
}

pub(super) fn asinh(m: &Shadow, a: Float) -> Float {
    m.inherited(Intrinsic::Asinh, formula::asinh(m, a), scalar::asinh(a.value), libm::asinh(a.exact))
}

pub(super) fn acosh(m: &Shadow, a: Float) -> Float {
    m.inherited(Intrinsic::Acosh, formula::acosh(m, a), scalar::acosh(a.value), libm::acosh(a.exact))
}

pub(super) fn atanh(m: &Shadow, a: Float) -> Float {
    m.inherited(Intrinsic::Atanh, formula::atanh(m, a), scalar::atanh(a.value), libm::atanh(a.exact))
}

pub(super) fn pow(m: &Shadow, x: Float, y: Float) -> Float {
    let exact = if x.exact < 0.0 { f64::NAN } else { libm::pow(x.exact, y.exact) };
    m.inherited(Intrinsic::Pow, formula::pow(m, x, y), scalar::pow(x.value, y.value), exact)
}
