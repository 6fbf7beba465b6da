//! A driver drawn by chance: every operation errs as far as its accuracy class permits.
//!
//! This is the adversary of the shadow lane: what it returns must lie within the bounds, whatever the seed.
//! It rounds either way, errs by whole ULPs, takes absolute errors, flushes subnormal numbers, and fuses
//! products into the sums that follow them.

use super::judge::integer;
use super::model::{Model, Pick};
use super::program::Scalar;
use lobe_codegen::accuracy::{self, Accuracy, LERP, Operation, Rounding, Subnormal};
use lobe_codegen::intrinsics::Intrinsic;
use naga::BinaryOperator;
use std::cell::Cell;

/// The model; it draws from a generator of its own.
#[derive(Debug)]
pub(super) struct Perturbed {
    accuracy: &'static accuracy::Model,
    state: Cell<u64>,
}

/// A number and, when it is a product, that product before it was rounded.
#[derive(Debug, Clone, Copy)]
pub(super) struct Number {
    value: f32,
    product: Option<f64>,
}

const ULP: f64 = 1.0 / (1 << 23) as f64;

fn plain(value: f32) -> Number {
    Number { value, product: None }
}

impl Perturbed {
    /// The driver of a part of the work, so that parts err differently; it errs as `accuracy` permits.
    pub(super) fn nth(accuracy: &'static accuracy::Model, seed: u64, part: usize) -> Self {
        let seed = seed ^ (part as u64).wrapping_mul(0x5851_f42d_4c95_7f2d);
        Self { accuracy, state: Cell::new(seed) }
    }

    /// SplitMix64.
    fn draw(&self) -> u64 {
        self.state.set(self.state.get().wrapping_add(0x9e37_79b9_7f4a_7c15));
        let mut z = self.state.get();
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn coin(&self) -> bool {
        self.draw() & 1 == 1
    }

    /// -1 ..= 1, the ends often.
    fn share(&self) -> f64 {
        match self.draw() % 4 {
            0 => -1.0,
            1 => 1.0,
            _ => (self.draw() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0,
        }
    }

    fn flush(&self, x: f32) -> f32 {
        let always = self.accuracy.rules.subnormal.0 == Subnormal::Flushed;
        if x.is_subnormal() && (always || self.coin()) { 0.0_f32.copysign(x) } else { x }
    }

    fn operand(&self, a: Number) -> f64 {
        self.flush(a.value).into()
    }

    /// One of the two floats that enclose `x`.
    fn either(&self, x: f64) -> f32 {
        let nearest = x as f32;
        let other = if f64::from(nearest) < x {
            nearest.next_up()
        } else if f64::from(nearest) > x {
            nearest.next_down()
        } else {
            nearest
        };
        self.flush(if self.coin() { nearest } else { other })
    }

    /// `x`, correctly rounded.
    fn rounded(&self, x: f64) -> f32 {
        match self.accuracy.rules.rounding.0 {
            Rounding::Either => self.either(x),
            Rounding::Nearest => self.flush(x as f32),
        }
    }

    /// One of the classes that a result may be of.
    fn class(&self, classes: &[Accuracy]) -> Accuracy {
        match classes {
            [] => Accuracy::Nothing,
            [class] => *class,
            classes => classes[(self.draw() % classes.len() as u64) as usize],
        }
    }

    /// A float not further than `error` from `x`.
    fn within(&self, x: f64, error: f64) -> Number {
        let wanted = (x + self.share() * error) as f32;
        let fits = (f64::from(wanted) - x).abs() <= error && (f64::from(wanted) >= 0.0) == (x >= 0.0);
        plain(self.flush(if fits { wanted } else { x as f32 }))
    }

    fn ulps(&self, n: f64, x: f64) -> Number {
        if x == 0.0 {
            return plain(x as f32);
        }
        self.within(x, n * (ULP * x.abs()).max(1.401298464324817e-45))
    }

    /// A result within a class that is a number, at argument `a`.
    fn inexact(&self, class: Accuracy, a: f64, result: f64) -> Number {
        match class {
            Accuracy::Exact | Accuracy::Correct => plain(self.rounded(result)),
            Accuracy::Ulp(n) | Accuracy::UlpWhere { ulp: n, .. } => self.ulps(n, result),
            Accuracy::UlpScaled { base, slope } => self.ulps(base + slope * a.abs(), result),
            Accuracy::UlpOrAbsolute { ulp, absolute, from, to } => {
                if (from..=to).contains(&a) {
                    self.off(result, absolute)
                } else {
                    self.ulps(ulp, result)
                }
            }
            Accuracy::Absolute(error) | Accuracy::AbsoluteOn { absolute: error, .. } => {
                self.off(result, error)
            }
            Accuracy::Inherited(_) => plain(result as f32),
            Accuracy::Nothing => self.off(result, 1.0 + result.abs()),
        }
    }

    fn off(&self, x: f64, error: f64) -> Number {
        let wanted = (x + self.share() * error) as f32;
        plain(self.flush(if (f64::from(wanted) - x).abs() <= error { wanted } else { x as f32 }))
    }

    /// What an addition takes for a product: its float, or all of it.
    fn summand(&self, a: Number) -> f64 {
        match a.product {
            Some(product) if self.coin() => product,
            Some(_) | None => self.operand(a),
        }
    }

    fn exactly(&self, a: Number, f: fn(f64) -> f64) -> Number {
        plain(self.flush(f(self.operand(a)) as f32))
    }

    fn elementary(&self, intrinsic: Intrinsic, a: Number, f: fn(f64) -> f64) -> Number {
        let x = self.operand(a);
        self.inexact(self.class(self.accuracy.builtin(intrinsic)), x, f(x))
    }

    /// The same where the class may be a formula.
    fn composed(
        &self,
        intrinsic: Intrinsic,
        a: Number,
        f: fn(f64) -> f64,
        formula: fn(&Self, Number) -> Number,
    ) -> Number {
        match self.class(self.accuracy.builtin(intrinsic)) {
            Accuracy::Inherited(_) => formula(self, a),
            class => {
                let x = self.operand(a);
                self.inexact(class, x, f(x))
            }
        }
    }
}

impl Model for Perturbed {
    const SHADOW: bool = false;
    type F = Number;
    type W = u64;
    type B = bool;

    fn float(&self, value: f32, _: f64) -> Number {
        plain(value)
    }
    fn value(&self, a: Number) -> f32 {
        a.value
    }
    fn exact(&self, a: Number) -> f64 {
        a.value.into()
    }
    fn with_truth(&self, a: Number, _: f64) -> Number {
        a
    }
    fn join_f(&self, a: Number, b: Number, pick: Pick) -> Number {
        if pick.value { a } else { b }
    }

    fn word(&self, value: u64) -> u64 {
        value
    }
    fn word_value(&self, a: u64) -> u64 {
        a
    }
    fn word_exact(&self, a: u64) -> u64 {
        a
    }
    fn known(&self, _: u64) -> bool {
        true
    }
    fn word_parts(&self, value: u64, _: u64) -> u64 {
        value
    }
    fn forget(&self, a: u64) -> u64 {
        a
    }
    fn map_w(&self, a: u64, f: impl Fn(u64) -> u64) -> u64 {
        f(a)
    }
    fn zip_w(&self, a: u64, b: u64, f: impl Fn(u64, u64) -> u64) -> u64 {
        f(a, b)
    }
    fn join_w(&self, a: u64, b: u64, pick: Pick) -> u64 {
        if pick.value { a } else { b }
    }

    fn boolean(&self, value: bool) -> bool {
        value
    }
    fn decision(&self, a: bool) -> bool {
        a
    }
    fn decision_exact(&self, a: bool) -> bool {
        a
    }
    fn ambiguous(&self, _: bool) -> bool {
        false
    }
    fn join_b(&self, a: bool, b: bool, pick: Pick) -> bool {
        if pick.value { a } else { b }
    }
    fn not(&self, a: bool) -> bool {
        !a
    }
    fn and(&self, a: bool, b: bool) -> bool {
        a && b
    }
    fn xor(&self, a: bool, b: bool) -> bool {
        a != b
    }

    fn compare_w(&self, a: u64, b: u64, f: impl Fn(u64, u64) -> bool) -> bool {
        f(a, b)
    }
    fn less(&self, a: Number, b: Number) -> bool {
        self.operand(a) < self.operand(b)
    }
    fn less_equal(&self, a: Number, b: Number) -> bool {
        self.operand(a) <= self.operand(b)
    }
    fn equal(&self, a: Number, b: Number) -> bool {
        self.operand(a) == self.operand(b)
    }
    fn is_nan(&self, a: Number) -> bool {
        a.value.is_nan()
    }
    fn is_inf(&self, a: Number) -> bool {
        a.value.is_infinite()
    }

    fn to_word(&self, a: Number, to: Scalar) -> u64 {
        integer::truncated(a.value, to)
    }
    fn to_float(&self, a: u64, from: Scalar) -> Number {
        let exact = integer::number(a, from);
        plain(if exact as f64 as i128 == exact {
            self.either(exact as f64)
        } else {
            integer::rounded(a, from)
        })
    }
    fn bits(&self, a: Number) -> u64 {
        a.value.to_bits().into()
    }
    fn float_of_bits(&self, a: u64) -> Number {
        plain(f32::from_bits(a as u32))
    }

    fn add(&self, a: Number, b: Number) -> Number {
        // A fused operation takes one product whole, not two.
        let (x, y) =
            if self.coin() { (self.summand(a), self.operand(b)) } else { (self.operand(a), self.summand(b)) };
        plain(self.rounded(x + y))
    }
    fn sub(&self, a: Number, b: Number) -> Number {
        self.add(a, self.neg(b))
    }
    fn mul(&self, a: Number, b: Number) -> Number {
        let product = self.operand(a) * self.operand(b);
        Number { value: self.rounded(product), product: Some(product) }
    }
    fn square(&self, a: Number) -> Number {
        let x = self.operand(a);
        Number { value: self.rounded(x * x), product: Some(x * x) }
    }
    fn div(&self, a: Number, b: Number) -> Number {
        let divide = self.accuracy.row(Operation::Infix(BinaryOperator::Divide)).f32;
        let divisor = self.operand(b);
        self.inexact(self.class(divide), divisor, self.operand(a) / divisor)
    }
    fn rem(&self, a: Number, b: Number) -> Number {
        self.sub(a, self.mul(b, self.trunc(self.div(a, b))))
    }
    fn neg(&self, a: Number) -> Number {
        Number { value: -a.value, product: a.product.map(|p| -p) }
    }
    fn abs(&self, a: Number) -> Number {
        self.exactly(a, f64::abs)
    }
    fn min(&self, a: Number, b: Number) -> Number {
        let (a, b) = (self.flush(a.value), self.flush(b.value));
        plain(lobe_codegen::math::scalar::min(a, b))
    }
    fn max(&self, a: Number, b: Number) -> Number {
        let (a, b) = (self.flush(a.value), self.flush(b.value));
        plain(lobe_codegen::math::scalar::max(a, b))
    }
    fn sign(&self, a: Number) -> Number {
        plain(lobe_codegen::math::scalar::sign(self.flush(a.value)))
    }
    fn ceil(&self, a: Number) -> Number {
        self.exactly(a, f64::ceil)
    }
    fn floor(&self, a: Number) -> Number {
        self.exactly(a, f64::floor)
    }
    fn round(&self, a: Number) -> Number {
        self.exactly(a, f64::round_ties_even)
    }
    fn trunc(&self, a: Number) -> Number {
        self.exactly(a, f64::trunc)
    }
    fn fract(&self, a: Number) -> Number {
        let x = self.operand(a);
        plain(self.rounded(x - x.floor()))
    }
    fn step(&self, edge: Number, x: Number) -> Number {
        plain(if self.less_equal(edge, x) { 1.0 } else { 0.0 })
    }
    fn sqrt(&self, a: Number) -> Number {
        let x = self.operand(a);
        if x >= f64::from(f32::MIN_POSITIVE) || x < 0.0 {
            return match self.class(self.accuracy.builtin(Intrinsic::Sqrt)) {
                Accuracy::Inherited(_) => self.div(plain(1.0), self.inverse_sqrt(plain(x as f32))),
                class => self.inexact(class, x, x.sqrt()),
            };
        }
        plain(self.flush(if self.coin() { 0.0 } else { x.sqrt() as f32 }))
    }
    fn inverse_sqrt(&self, a: Number) -> Number {
        self.elementary(Intrinsic::InverseSqrt, a, |x| 1.0 / x.sqrt())
    }
    fn exp(&self, a: Number) -> Number {
        self.composed(Intrinsic::Exp, a, libm::exp, super::formula::exp)
    }
    fn exp2(&self, a: Number) -> Number {
        self.elementary(Intrinsic::Exp2, a, libm::exp2)
    }
    fn log(&self, a: Number) -> Number {
        self.composed(Intrinsic::Log, a, libm::log, super::formula::log)
    }
    fn log2(&self, a: Number) -> Number {
        self.elementary(Intrinsic::Log2, a, libm::log2)
    }
    fn sin(&self, a: Number) -> Number {
        self.elementary(Intrinsic::Sin, a, libm::sin)
    }
    fn cos(&self, a: Number) -> Number {
        self.elementary(Intrinsic::Cos, a, libm::cos)
    }
    fn atan(&self, a: Number) -> Number {
        self.elementary(Intrinsic::Atan, a, libm::atan)
    }
    fn atan2(&self, y: Number, x: Number) -> Number {
        let angle = libm::atan2(self.operand(y), self.operand(x));
        self.inexact(self.class(self.accuracy.builtin(Intrinsic::Atan2)), 0.0, angle)
    }
    fn asin(&self, x: Number) -> Number {
        self.composed(Intrinsic::Asin, x, libm::asin, super::formula::asin)
    }
    fn acos(&self, x: Number) -> Number {
        self.composed(Intrinsic::Acos, x, libm::acos, super::formula::acos)
    }
    fn mix(&self, x: Number, y: Number, t: Number) -> Number {
        match self.class(self.accuracy.builtin(Intrinsic::Mix)) {
            Accuracy::Inherited(LERP) => super::formula::lerp(self, x, y, t),
            _ => super::formula::mix(self, x, y, t),
        }
    }
    fn tanh(&self, x: Number) -> Number {
        self.composed(Intrinsic::Tanh, x, libm::tanh, super::formula::tanh)
    }
}
