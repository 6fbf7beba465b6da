//! The shadow lane: beside each f32 the real value, and how far a legal driver's result may be from it.
//!
//! A [`Real`] promises `|r - exact| <= bound` for the result `r` of any implementation that keeps the
//! accuracy rules of `lobe_codegen::intrinsics`: it may round either way, contract a product and a sum,
//! and flush subnormals.
//! Contraction needs no case of its own: the bound is around the exact value, and a fused operation
//! leaves out a rounding that the bound already permits.
//! Flushing does: a result that may be subnormal may become 0, which adds 2^-126; since every float is
//! the result of an operation, a literal or an input, that covers operands as well, once inputs and
//! literals are treated alike.
//!
//! Propagation is rigorous, not of first order: each rule bounds the image of the whole interval.
//! [`arithmetic`] has the operators, [`function`] the built-in functions, [`discrete`] what jumps.

mod arithmetic;
mod discrete;
mod function;

use super::model::{Comparison, F1, F2, F3, Model};
use lobe_codegen::def::Truth;

/// 2^-126, the smallest normal f32.
const TINY: f64 = 1.1754943508222875e-38;
/// 2^-149, the smallest subnormal f32.
const SUBNORMAL: f64 = 1.401298464324817e-45;
/// One ULP relative to the value: 2^-23.
const ULP: f64 = 1.1920928955078125e-7;
/// What f64 arithmetic itself may add, relative: a few of its roundings.
const HAIR: f64 = 1e-15;

/// A float of the shadow lane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Real {
    /// The strict f32 result.
    pub(super) value: f32,
    /// The real number.
    pub(super) exact: f64,
    /// Distance of a legal result from `exact`; infinite when there is no promise.
    pub(super) bound: f64,
}

impl Real {
    /// An input or literal: `value` in f32, `exact` in truth.
    fn given(value: f32, exact: f64) -> Self {
        Self { value, exact, bound: (f64::from(value) - exact).abs() }.flushed()
    }

    /// Lowest and highest legal result.
    fn ends(self) -> (f64, f64) {
        (self.exact - self.bound, self.exact + self.bound)
    }

    /// Largest magnitude of a legal result.
    fn magnitude(self) -> f64 {
        self.exact.abs() + self.bound
    }

    /// Permits a result that may be subnormal to be flushed to zero, and refuses one that may overflow.
    fn flushed(mut self) -> Self {
        let magnitude = self.magnitude();
        if !(magnitude <= f64::from(f32::MAX)) || !self.value.is_finite() {
            self.bound = f64::INFINITY;
        } else if self.exact.abs() - self.bound < TINY && magnitude > 0.0 {
            self.bound += magnitude.min(TINY);
        }
        self
    }

    /// The result of an operation: `exact`, with `spread` from the operands' bounds, and a rounding of
    /// so many ULP of the largest legal magnitude.
    fn rounded(value: f32, exact: f64, spread: f64, ulps: f64) -> Self {
        let magnitude = exact.abs() + spread;
        // Below the normal numbers one ULP is the smallest subnormal.
        let bound = spread + ulps * (magnitude * ULP).max(SUBNORMAL) + magnitude * HAIR;
        Self { value, exact, bound: if bound.is_nan() { f64::INFINITY } else { bound } }.flushed()
    }

    /// As [`Real::rounded`] with an absolute error.
    fn within(value: f32, exact: f64, spread: f64, absolute: f64) -> Self {
        let bound = spread + absolute + exact.abs() * HAIR;
        Self { value, exact, bound: if bound.is_nan() { f64::INFINITY } else { bound } }.flushed()
    }

    /// A result that nothing is promised about.
    fn unknown(value: f32, exact: f64) -> Self {
        Self { value, exact, bound: f64::INFINITY }
    }

    /// Whether the legal results are just `exact`, so that what is decided by it is decided.
    fn is_certain(self) -> bool {
        self.bound == 0.0
    }
}

/// An integer of the shadow lane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Word {
    /// On the f32 path.
    pub(super) value: u32,
    /// On the exact path.
    pub(super) exact: u32,
    /// Whether every legal driver has this value.
    pub(super) known: bool,
}

/// A boolean of the shadow lane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Decision {
    /// On the f32 path.
    pub(super) value: bool,
    /// On the exact path.
    pub(super) exact: bool,
    /// Whether a legal driver may decide either way.
    pub(super) ambiguous: bool,
}

/// The shadow lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shadow;

impl Model for Shadow {
    type F = Real;
    type W = Word;
    type B = Decision;

    fn float(value: f32, exact: f64) -> Real {
        Real::given(value, exact)
    }
    fn word(value: u32) -> Word {
        Word { value, exact: value, known: true }
    }
    fn bool(value: bool) -> Decision {
        Decision { value, exact: value, ambiguous: false }
    }
    fn float_value(x: Real) -> f32 {
        x.value
    }
    fn word_value(x: Word) -> u32 {
        x.value
    }
    fn bool_value(x: Decision) -> bool {
        x.value
    }
    fn is_known(x: Word) -> bool {
        x.known
    }
    fn is_ambiguous(x: Decision) -> bool {
        x.ambiguous
    }
    fn f1(op: F1) -> fn(Real) -> Real {
        function::f1(op)
    }
    fn f2(op: F2) -> fn(Real, Real) -> Real {
        match op {
            F2::Add => arithmetic::add,
            F2::Subtract => arithmetic::subtract,
            F2::Multiply => arithmetic::multiply,
            F2::Divide => arithmetic::divide,
            F2::Remainder => discrete::remainder,
            F2::Min => discrete::min,
            F2::Max => discrete::max,
            F2::Step => discrete::step,
            F2::Pow => function::pow,
            F2::Atan2 => function::atan2,
        }
    }
    fn f3(op: F3) -> fn(Real, Real, Real) -> Real {
        match op {
            F3::Clamp => discrete::clamp,
            F3::Fma => arithmetic::fma,
            F3::Mix => arithmetic::mix,
            F3::SmoothStep => function::smoothstep,
        }
    }
    fn compare(op: Comparison, a: Real, b: Real) -> Decision {
        discrete::compare(op, a, b)
    }
    fn w1(x: Word, f: impl Fn(u32) -> u32) -> Word {
        Word { value: f(x.value), exact: f(x.exact), known: x.known }
    }
    fn w2(x: Word, y: Word, f: impl Fn(u32, u32) -> u32) -> Word {
        Word { value: f(x.value, y.value), exact: f(x.exact, y.exact), known: x.known && y.known }
    }
    fn test(x: Word, y: Word, f: impl Fn(u32, u32) -> bool) -> Decision {
        let ambiguous = !(x.known && y.known);
        Decision { value: f(x.value, y.value), exact: f(x.exact, y.exact), ambiguous }
    }
    fn not(x: Decision) -> Decision {
        Decision { value: !x.value, exact: !x.exact, ..x }
    }
    fn and(x: Decision, y: Decision) -> Decision {
        // A certain `false` decides.
        let decided = |d: Decision| !d.ambiguous && !d.exact;
        let ambiguous = !decided(x) && !decided(y) && (x.ambiguous || y.ambiguous);
        Decision { value: x.value && y.value, exact: x.exact && y.exact, ambiguous }
    }
    fn to_bits(x: Real) -> Word {
        Word { value: x.value.to_bits(), exact: (x.exact as f32).to_bits(), known: x.is_certain() }
    }
    fn from_bits(x: Word) -> Real {
        let (value, exact) = (f32::from_bits(x.value), f64::from(f32::from_bits(x.exact)));
        if x.known { Real::given(value, exact) } else { Real::unknown(value, exact) }
    }
    fn to_word(x: Real, f: fn(f64) -> u32) -> Word {
        let (low, high) = x.ends();
        let known = x.bound.is_finite() && f(low) == f(high);
        Word { value: f(x.value.into()), exact: f(x.exact), known }
    }
    fn to_float(x: Word, f: fn(u32) -> f64) -> Real {
        let value = f(x.value) as f32;
        // An integer beyond 2^24 is rounded, to either side.
        let exact = f(x.exact);
        match (x.known, f64::from(value) == exact) {
            (true, true) => Real::given(value, exact),
            (true, false) => Real::rounded(value, exact, 0.0, 1.0),
            (false, _) => Real::unknown(value, exact),
        }
    }
    fn bool_to_word(x: Decision) -> Word {
        Word { value: x.value.into(), exact: x.exact.into(), known: !x.ambiguous }
    }
    fn select_float(condition: Decision, accept: Real, reject: Real) -> Real {
        let value = if condition.value { accept.value } else { reject.value };
        let (this, other) = if condition.exact { (accept, reject) } else { (reject, accept) };
        let mut bound = this.bound;
        if condition.ambiguous {
            let reach = (other.exact - this.exact).abs() + other.bound;
            // `max` would pass over the NaN of a side that has no value, as 0/0.
            bound = if reach.is_nan() { f64::INFINITY } else { bound.max(reach) };
        }
        Real { value, exact: this.exact, bound: if bound.is_nan() { f64::INFINITY } else { bound } }
    }
    fn select_word(condition: Decision, accept: Word, reject: Word) -> Word {
        let value = if condition.value { accept.value } else { reject.value };
        let this = if condition.exact { accept } else { reject };
        let same = accept.known && reject.known && accept.exact == reject.exact;
        Word { value, exact: this.exact, known: if condition.ambiguous { same } else { this.known } }
    }
    fn select_bool(condition: Decision, accept: Decision, reject: Decision) -> Decision {
        let value = if condition.value { accept.value } else { reject.value };
        let this = if condition.exact { accept } else { reject };
        let differ = accept.ambiguous || reject.ambiguous || accept.exact != reject.exact;
        Decision {
            value,
            exact: this.exact,
            ambiguous: if condition.ambiguous { differ } else { this.ambiguous },
        }
    }
    fn with_truth(result: Real, truth: Truth, arguments: &[Real]) -> Real {
        let truth = match (truth, arguments) {
            (Truth::Unary(f), [x]) => f(x.exact),
            (Truth::Binary(f), [x, y]) => f(x.exact, y.exact),
            (Truth::Unary(_) | Truth::Binary(_), _) => return result,
        };
        let bound = result.bound + (result.exact - truth).abs();
        Real { exact: truth, bound: if bound.is_nan() { f64::INFINITY } else { bound }, ..result }
    }
}
