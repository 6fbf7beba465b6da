//! Elementary functions: f64 at the ends of the interval, widened by the accuracy class.

use super::promise::{is_number, own, widen};
use super::round::{above, below, ulp};
use super::slope::{self, only};
use super::tape::Slope;
use super::{Float, Shadow, sum};
use crate::interp::formula;
use crate::interp::precision::Precision;
use crate::interp::program::op::FloatOp as O;
use lobe_codegen::accuracy::Accuracy;
use lobe_codegen::intrinsics::Intrinsic;
use std::f64::consts::PI;

impl<P: Precision> Shadow<P> {
    /// Puts the result of a function of one number on the tape.
    fn follow(&self, a: Float, result: Float, slope: fn(Float) -> Slope, classes: &[Accuracy]) -> Float {
        if !result.bounded() {
            return result;
        }
        let error =
            if a.is_point() { Some(result.bound()) } else { own::<P>(classes, (a.low, a.high), result) };
        match error {
            Some(error) => self.link(result, error, only(a, slope(a))),
            None => self.source(result),
        }
    }
}

/// The strict result of an operation.
fn one<P: Precision>(op: O, a: Float) -> f64 {
    P::strict(op, [a.value, 0.0, 0.0])
}

/// `f` at the ends, in order, with the hair that f64 may be off.
fn ends(a: Float, f: fn(f64) -> f64) -> (f64, f64) {
    let (x, y) = (f(a.low), f(a.high));
    (below(x.min(y)), above(x.max(y)))
}

/// A function that rises or falls all along `from <= x`.
fn monotone<P: Precision>(a: Float, op: O, f: fn(f64) -> f64, from: f64, classes: &[Accuracy]) -> Float {
    let (value, exact) = (one::<P>(op, a), f(a.exact));
    let inside = a.bounded() && a.low >= from;
    match inside.then(|| widen::<P>(classes, (a.low, a.high), ends(a, f))).flatten() {
        Some((low, high)) => Float::closed::<P>(value, exact, low, high),
        None => Float::unbounded(value, exact),
    }
}

pub(super) fn exp<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Exp);
    m.composed(
        classes,
        |m| formula::exp(m, a),
        |m| {
            let result = monotone::<P>(a, O::Exp, libm::exp, f64::NEG_INFINITY, classes);
            m.follow(a, result, slope::exp, classes)
        },
    )
}

pub(super) fn exp2<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Exp2);
    let result = monotone::<P>(a, O::Exp2, libm::exp2, f64::NEG_INFINITY, classes);
    m.follow(a, result, slope::exp2, classes)
}

pub(super) fn log<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Log);
    m.composed(
        classes,
        |m| formula::log(m, a),
        |m| {
            let a = if a.low < P::MIN_NORMAL { m.tightened(a) } else { a };
            let result = monotone::<P>(a, O::Log, libm::log, P::MIN_NORMAL, classes);
            m.follow(a, result, slope::log, classes)
        },
    )
}

pub(super) fn log2<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Log2);
    let a = if a.low < P::MIN_NORMAL { m.tightened(a) } else { a };
    let result = monotone::<P>(a, O::Log2, libm::log2, P::MIN_NORMAL, classes);
    m.follow(a, result, slope::log2, classes)
}

pub(super) fn atan<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Atan);
    let result = monotone::<P>(a, O::Atan, libm::atan, f64::NEG_INFINITY, classes);
    m.follow(a, result, slope::atan, classes)
}

pub(super) fn inverse_sqrt<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::InverseSqrt);
    let a = if a.low < P::MIN_NORMAL { m.tightened(a) } else { a };
    let result = monotone::<P>(a, O::InverseSqrt, |x| 1.0 / x.sqrt(), P::MIN_NORMAL, classes);
    m.follow(a, result, slope::inverse_sqrt, classes)
}

/// `1 / inverse_sqrt(x)`; see the readings in the module's documentation.
pub(super) fn sqrt<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    let a = if a.low < P::MIN_NORMAL { m.tightened(a) } else { a };
    let (value, exact) = (one::<P>(O::Sqrt, a), a.exact.sqrt());
    if !(a.bounded() && a.low >= 0.0) {
        return Float::unbounded(value, exact);
    }
    let ulps = m.promise.root;
    let (low, high) = ulp::<P>(ulps, ends(a, f64::sqrt));
    if a.low < P::MIN_NORMAL {
        return m.source(Float::closed::<P>(value, exact, 0.0, high));
    }
    m.follow(a, Float::closed::<P>(value, exact, low, high), slope::sqrt, &[Accuracy::Ulp(ulps)])
}

/// Sine and cosine: their extremes within the interval are those of the ends and of the turning points, of which `top` is
/// one where the function is 1.
fn wave<P: Precision>(a: Float, op: O, f: fn(f64) -> f64, top: f64, classes: &[Accuracy]) -> Float {
    let (value, exact) = (one::<P>(op, a), f(a.exact));
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
    match widen::<P>(classes, (a.low, a.high), results) {
        Some((low, high)) => Float::closed::<P>(value, exact, low, high),
        None => Float::unbounded(value, exact),
    }
}

pub(super) fn sin<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Sin);
    let result = wave::<P>(a, O::Sin, libm::sin, PI / 2.0, classes);
    m.follow(a, result, slope::sin, classes)
}

pub(super) fn cos<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    let classes = m.promise.classes(Intrinsic::Cos);
    let result = wave::<P>(a, O::Cos, libm::cos, 0.0, classes);
    m.follow(a, result, slope::cos, classes)
}

/// Seen from the origin, the box of arguments spans angles; where it meets the cut, all of them.
pub(super) fn atan2<P: Precision>(m: &Shadow<P>, y: Float, x: Float) -> Float {
    let (value, exact) = (P::strict(O::Atan2, [y.value, x.value, 0.0]), libm::atan2(y.exact, x.exact));
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
    let result = match widen::<P>(classes, (0.0, 0.0), results) {
        Some((low, high)) => Float::closed::<P>(value, exact, low, high),
        None => Float::unbounded(value, exact),
    };
    match own::<P>(classes, (0.0, 0.0), result) {
        Some(error) if !cut => m.link(result, error, slope::atan2(y, x)),
        _ => m.source(result),
    }
}

impl<P: Precision> Shadow<P> {
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
        let hull = Float::closed::<P>(a.value, a.exact, a.low.min(b.low), a.high.max(b.high));
        self.part(Float { terms: sum::either(a, b), ..hull })
    }

    /// The same where the model promises the function `intrinsic` at all.
    fn inherited(&self, intrinsic: Intrinsic, formula: Float, value: f64, exact: f64) -> Float {
        if self.promise.has(intrinsic) {
            self.inherit(formula, value, exact)
        } else {
            Float::unbounded(value, exact)
        }
    }

    /// The interval of `formula`; value and exact value of their own.
    pub(super) fn inherit(&self, formula: Float, value: f64, exact: f64) -> Float {
        if formula.bounded() {
            let result = Float::closed::<P>(value, exact, formula.low, formula.high);
            self.link(result, (exact - formula.exact).abs(), only(formula, Slope::ONE))
        } else {
            Float::unbounded(value, exact)
        }
    }
}

/// The worse of the formula and of an absolute error; `f` rises or falls all along `from ..= to`.
fn inherited_or_absolute<P: Precision>(
    m: &Shadow<P>,
    a: Float,
    formula: Float,
    op: O,
    f: fn(f64) -> f64,
    intrinsic: Intrinsic,
) -> Float {
    let inherited = m.inherited(intrinsic, formula, one::<P>(op, a), f(a.exact));
    let classes = m.promise.classes(intrinsic);
    if !(inherited.bounded() && classes.iter().any(is_number)) {
        return inherited;
    }
    match widen::<P>(classes, (a.low, a.high), ends(a, f)) {
        Some((low, high)) => {
            let (low, high) = (low.min(inherited.low), high.max(inherited.high));
            m.source(Float::closed::<P>(inherited.value, inherited.exact, low, high))
        }
        None => Float::unbounded(inherited.value, inherited.exact),
    }
}

pub(super) fn asin<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    inherited_or_absolute(m, a, formula::asin(m, a), O::Asin, libm::asin, Intrinsic::Asin)
}

pub(super) fn acos<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    inherited_or_absolute(m, a, formula::acos(m, a), O::Acos, libm::acos, Intrinsic::Acos)
}

pub(super) fn tanh<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    inherited_or_absolute(m, a, formula::tanh(m, a), O::Tanh, libm::tanh, Intrinsic::Tanh)
}

pub(super) fn tan<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    m.inherited(Intrinsic::Tan, formula::tan(m, a), one::<P>(O::Tan, a), libm::tan(a.exact))
}

pub(super) fn sinh<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    m.inherited(Intrinsic::Sinh, formula::sinh(m, a), one::<P>(O::Sinh, a), libm::sinh(a.exact))
}

pub(super) fn cosh<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    m.inherited(Intrinsic::Cosh, formula::cosh(m, a), one::<P>(O::Cosh, a), libm::cosh(a.exact))
}

pub(super) fn asinh<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    m.inherited(Intrinsic::Asinh, formula::asinh(m, a), one::<P>(O::Asinh, a), libm::asinh(a.exact))
}

pub(super) fn acosh<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    m.inherited(Intrinsic::Acosh, formula::acosh(m, a), one::<P>(O::Acosh, a), libm::acosh(a.exact))
}

pub(super) fn atanh<P: Precision>(m: &Shadow<P>, a: Float) -> Float {
    m.inherited(Intrinsic::Atanh, formula::atanh(m, a), one::<P>(O::Atanh, a), libm::atanh(a.exact))
}

pub(super) fn pow<P: Precision>(m: &Shadow<P>, x: Float, y: Float) -> Float {
    let exact = if x.exact < 0.0 { f64::NAN } else { libm::pow(x.exact, y.exact) };
    m.inherited(Intrinsic::Pow, formula::pow(m, x, y), P::strict(O::Pow, [x.value, y.value, 0.0]), exact)
}
