//! Built-in functions: each spreads its argument's bound, and adds what its accuracy class permits.
//!
//! The classes are those of `lobe_codegen::intrinsics::TABLE`; a test compares the constants here with
//! the table.

use super::super::model::F1;
use super::arithmetic::{add, divide, multiply, negate, subtract};
use super::{Real, TINY, discrete};
use lobe_codegen::math::scalar;
use std::f64::consts::PI;

/// Absolute error of `sin` and `cos` on -π ..= π: 2^-11.
pub(super) const SIN_ABSOLUTE: f64 = 0.00048828125;
/// Absolute error of `log` and `log2` on 0.5 ..= 2: 2^-21.
pub(super) const LOG_ABSOLUTE: f64 = 4.76837158203125e-7;
/// ULP of `log` and `log2` elsewhere.
pub(super) const LOG_ULP: f64 = 3.0;
/// ULP of `exp` and `exp2` at 0, and for each unit of the argument.
pub(super) const EXP_ULP: (f64, f64) = (3.0, 2.0);
/// ULP of `inverse_sqrt`.
pub(super) const INVERSE_SQRT_ULP: f64 = 2.0;
/// ULP of `atan` and `atan2`.
pub(super) const ATAN_ULP: f64 = 4096.0;
/// Absolute error that `asin` and `acos` may have at least.
pub(super) const ASIN_ABSOLUTE: f64 = 6.81e-5;
/// Absolute error that `tanh` may have at least.
pub(super) const TANH_ABSOLUTE: f64 = 1e-5;

pub(super) fn f1(op: F1) -> fn(Real) -> Real {
    match op {
        F1::Negate => negate,
        F1::Abs => discrete::abs,
        F1::Saturate => discrete::saturate,
        F1::Sign => discrete::sign,
        F1::Ceil => discrete::ceil,
        F1::Floor => discrete::floor,
        F1::Round => discrete::round,
        F1::Trunc => discrete::trunc,
        F1::Fract => discrete::fract,
        F1::Sqrt => sqrt,
        F1::InverseSqrt => inverse_sqrt,
        F1::Exp => |x| exponential(x, scalar::exp(x.value), f64::exp),
        F1::Exp2 => |x| exponential(x, scalar::exp2(x.value), f64::exp2),
        F1::Log => |x| logarithm(x, scalar::log(x.value), f64::ln),
        F1::Log2 => |x| logarithm(x, scalar::log2(x.value), f64::log2),
        F1::Sin => |x| wave(x, scalar::sin(x.value), f64::sin),
        F1::Cos => |x| wave(x, scalar::cos(x.value), f64::cos),
        F1::Tan => |x| Real { value: scalar::tan(x.value), ..divide(f1(F1::Sin)(x), f1(F1::Cos)(x)) },
        F1::Asin => asin,
        F1::Acos => acos,
        F1::Atan => |x| Real::rounded(scalar::atan(x.value), x.exact.atan(), spread(x, f64::atan), ATAN_ULP),
        F1::Sinh => |x| hyperbolic(x, scalar::sinh(x.value), subtract),
        F1::Cosh => |x| hyperbolic(x, scalar::cosh(x.value), add),
        F1::Tanh => tanh,
        F1::Asinh => |x| area(x, scalar::asinh(x.value), add(multiply(x, x), one())),
        F1::Acosh => |x| area(x, scalar::acosh(x.value), subtract(multiply(x, x), one())),
        F1::Atanh => atanh,
        F1::Degrees => |x| scaled(x, scalar::degrees(x.value), 57.295779513082322865),
        F1::Radians => |x| scaled(x, scalar::radians(x.value), 0.017453292519943295474),
    }
}

fn one() -> Real {
    Real::given(1.0, 1.0)
}

fn half() -> Real {
    Real::given(0.5, 0.5)
}

/// How far a monotone function's value at the ends is from that at `exact`.
fn spread(x: Real, f: fn(f64) -> f64) -> f64 {
    let (low, high) = x.ends();
    let middle = f(x.exact);
    let spread = (f(high) - middle).abs().max((f(low) - middle).abs());
    if x.bound.is_infinite() || spread.is_nan() { f64::INFINITY } else { spread }
}

fn exponential(x: Real, value: f32, f: fn(f64) -> f64) -> Real {
    let ulps = EXP_ULP.0 + EXP_ULP.1 * x.magnitude();
    Real::rounded(value, f(x.exact), spread(x, f), ulps)
}

fn logarithm(x: Real, value: f32, f: fn(f64) -> f64) -> Real {
    let (low, high) = x.ends();
    if low < TINY {
        return Real::unknown(value, f(x.exact));
    }
    let spread = spread(x, f);
    let near_one = Real::within(value, f(x.exact), spread, LOG_ABSOLUTE);
    let elsewhere = Real::rounded(value, f(x.exact), spread, LOG_ULP);
    match (low >= 0.5 && high <= 2.0, high < 0.5 || low > 2.0) {
        (true, _) => near_one,
        (_, true) => elsewhere,
        _ => Real { bound: near_one.bound.max(elsewhere.bound), ..near_one },
    }
}

fn wave(x: Real, value: f32, f: fn(f64) -> f64) -> Real {
    let exact = f(x.exact);
    if !(x.magnitude() <= PI) {
        return Real::unknown(value, exact);
    }
    Real::within(value, exact, x.bound, SIN_ABSOLUTE)
}

fn inverse_sqrt(x: Real) -> Real {
    let f = |x: f64| 1.0 / x.sqrt();
    let value = scalar::inverse_sqrt(x.value);
    if x.exact - x.bound < TINY {
        return Real::unknown(value, f(x.exact));
    }
    Real::rounded(value, f(x.exact), spread(x, f), INVERSE_SQRT_ULP)
}

/// `1 / inverse_sqrt(x)`. At 0 the formula is 1/∞, for which the rules promise nothing, though every
/// driver returns 0: read here as any value between 0 and the root of the largest legal argument.
fn sqrt(x: Real) -> Real {
    let value = scalar::sqrt(x.value);
    let exact = x.exact.sqrt();
    let (low, high) = x.ends();
    if low < -TINY || !high.is_finite() {
        // An argument that may be negative by more than what is flushed has no root.
        return Real::unknown(value, exact);
    }
    if low < TINY {
        let top = high.max(TINY).sqrt() * (1.0 + 8.0 * super::ULP);
        return if x.is_certain() && x.exact == 0.0 {
            Real { value, exact, bound: 0.0 }
        } else {
            Real { value, exact: if exact.is_nan() { 0.0 } else { exact }, bound: top }
        };
    }
    Real { value, exact, ..divide(one(), inverse_sqrt(x)) }
}

fn tanh(x: Real) -> Real {
    let value = scalar::tanh(x.value);
    let by_formula = divide(f1(F1::Sinh)(x), f1(F1::Cosh)(x));
    let absolute = Real::within(value, x.exact.tanh(), spread(x, f64::tanh), TANH_ABSOLUTE);
    // The worse of both; where the formula overflows, the absolute error is all that is meant.
    let bound =
        if by_formula.bound.is_finite() { by_formula.bound.max(absolute.bound) } else { absolute.bound };
    Real { bound, ..absolute }
}

fn hyperbolic(x: Real, value: f32, join: fn(Real, Real) -> Real) -> Real {
    let exp = f1(F1::Exp);
    Real { value, ..multiply(join(exp(x), exp(negate(x))), half()) }
}

/// `log(x + sqrt(square))`
fn area(x: Real, value: f32, square: Real) -> Real {
    Real { value, ..f1(F1::Log)(add(x, sqrt(square))) }
}

fn atanh(x: Real) -> Real {
    let quotient = divide(add(one(), x), subtract(one(), x));
    Real { value: scalar::atanh(x.value), ..multiply(f1(F1::Log)(quotient), half()) }
}

/// `sqrt(1 - x²)` for `|x| <= 1`; beyond, a legal argument by a rounding only, the root is taken as 0.
fn cofactor(x: Real) -> Real {
    let square = subtract(one(), multiply(x, x));
    let (low, _) = square.ends();
    if low < TINY {
        let top = square.magnitude().sqrt();
        return Real { value: 0.0, exact: square.exact.max(0.0).sqrt(), bound: top };
    }
    sqrt(square)
}

fn asin(x: Real) -> Real {
    inverse_wave(x, scalar::asin(x.value), f64::asin, atan2(x, cofactor(x)))
}

fn acos(x: Real) -> Real {
    inverse_wave(x, scalar::acos(x.value), f64::acos, atan2(cofactor(x), x))
}

fn inverse_wave(x: Real, value: f32, f: fn(f64) -> f64, by_formula: Real) -> Real {
    let (low, high) = x.ends();
    if !(low >= -1.0 && high <= 1.0) {
        return Real::unknown(value, f(x.exact));
    }
    let absolute = Real::within(value, f(x.exact), spread(x, f), ASIN_ABSOLUTE);
    // Where the formula's root may vanish its own bound says nothing; the absolute error holds there.
    let bound =
        if by_formula.bound.is_finite() { by_formula.bound.max(absolute.bound) } else { absolute.bound };
    Real { bound, ..absolute }
}

fn scaled(x: Real, value: f32, factor: f64) -> Real {
    Real { value, ..multiply(x, Real::given(factor as f32, factor)) }
}

/// `exp2(y log2(x))`
pub(super) fn pow(x: Real, y: Real) -> Real {
    let value = scalar::pow(x.value, y.value);
    Real { value, ..f1(F1::Exp2)(multiply(y, f1(F1::Log2)(x))) }
}

/// Angle of a point; none is promised where the point may be the origin, or cross the cut.
pub(super) fn atan2(y: Real, x: Real) -> Real {
    let value = scalar::atan2(y.value, x.value);
    let exact = y.exact.atan2(x.exact);
    let ((x0, x1), (y0, y1)) = (x.ends(), y.ends());
    let crosses_cut = x0 <= 0.0 && y0 <= 0.0 && y1 >= 0.0 && !(y.is_certain() && y.exact != 0.0);
    if crosses_cut || !(x.bound.is_finite() && y.bound.is_finite()) {
        return Real::unknown(value, exact);
    }
    // Over a box that does not meet the cut the angle is extreme at a corner.
    let spread = [(y0, x0), (y0, x1), (y1, x0), (y1, x1)]
        .iter()
        .map(|&(y, x)| (y.atan2(x) - exact).abs())
        .fold(0.0, f64::max);
    Real::rounded(value, exact, spread, ATAN_ULP)
}

/// `t t (3 - 2 t)`, `t = clamp((x - low) / (high - low), 0, 1)`
pub(super) fn smoothstep(low: Real, high: Real, x: Real) -> Real {
    let value = scalar::smoothstep(low.value, high.value, x.value);
    let zero = Real::given(0.0, 0.0);
    let t = discrete::clamp(divide(subtract(x, low), subtract(high, low)), zero, one());
    let (two, three) = (Real::given(2.0, 2.0), Real::given(3.0, 3.0));
    Real { value, ..multiply(multiply(t, t), subtract(three, multiply(two, t))) }
}
