//! The driver as a [`Model`].

use super::{Double, Half, Number, Perturbed, Precision, Single, plain};
use crate::interp::formula;
use crate::interp::judge::integer;
use crate::interp::model::{Model, Pick};
use crate::interp::program::Scalar;
use crate::interp::program::op::FloatOp;
use crate::interp::scalar::convert;
use crate::texture::{Format, Known};
use lobe_codegen::accuracy::{Accuracy, LERP, Operation};
use lobe_codegen::intrinsics::Intrinsic;
use naga::BinaryOperator;

impl<P: Precision> Model for Perturbed<P> {
    const SHADOW: bool = false;
    const ALL_WIDTHS: bool = true;
    type F = Number;
    type W = u64;
    type B = bool;

    type Half = Perturbed<Half>;
    type Double = Perturbed<Double>;
    fn half(&self) -> Perturbed<Half> {
        self.of()
    }
    fn double(&self) -> Perturbed<Double> {
        self.of()
    }

    fn float(&self, value: f32, _: f64) -> Number {
        plain(value.into())
    }
    fn ranged(&self, value: f32, known: Known) -> Number {
        let middle = f64::midpoint(known.low, known.high);
        let drawn = P::nearest(middle + self.share() * (known.high - middle));
        let fits = (known.low..=known.high).contains(&drawn);
        plain(self.flush(if fits { drawn } else { value.into() }))
    }
    /// Integers are one code each.
    fn texel(&self, format: Format, numbers: [u64; 4]) -> u128 {
        format.encode_either(numbers, || self.coin())
    }
    fn converted(&self, a: Number, from: Scalar) -> Number {
        let x = match from {
            Scalar::F16 => self.half().operand(a),
            Scalar::F64 => self.double().operand(a),
            _ => self.of::<Single>().operand(a),
        };
        let is_wider = from.bytes() < P::SCALAR.bytes();
        plain(if is_wider { self.flush(x) } else { self.rounded(x) })
    }
    fn unpromised(&self, a: Number) -> Number {
        a
    }
    fn value(&self, a: Number) -> f32 {
        a.value as f32
    }
    fn exact(&self, a: Number) -> f64 {
        a.value
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
        convert::truncated(a.value, P::DIGITS, to)
    }
    fn to_float(&self, a: u64, from: Scalar) -> Number {
        let exact = integer::number(a, from);
        plain(if exact as f64 as i128 == exact { self.either(exact as f64) } else { P::of_integer(exact) })
    }
    fn bits(&self, a: Number) -> u64 {
        P::bits(a.value)
    }
    fn float_of_bits(&self, a: u64) -> Number {
        plain(P::of_bits(a))
    }

    fn add(&self, a: Number, b: Number) -> Number {
        self.sum(a, b)
    }
    fn sub(&self, a: Number, b: Number) -> Number {
        self.add(a, self.neg(b))
    }
    fn mul(&self, a: Number, b: Number) -> Number {
        let product = self.operand(a) * self.operand(b);
        Number { product: Some(product), ..plain(self.rounded(product)) }
    }
    fn square(&self, a: Number) -> Number {
        let x = self.operand(a);
        Number { product: Some(x * x), ..plain(self.rounded(x * x)) }
    }
    fn div(&self, a: Number, b: Number) -> Number {
        let divide = self.classes(Operation::Infix(BinaryOperator::Divide));
        let divisor = self.operand(b);
        self.inexact(self.class(divide), divisor, self.operand(a) / divisor)
    }
    fn rem(&self, a: Number, b: Number) -> Number {
        self.sub(a, self.mul(b, self.trunc(self.div(a, b))))
    }
    fn neg(&self, a: Number) -> Number {
        Number {
            value: -a.value,
            product: a.product.map(|p| -p),
            terms: a.terms.map(|terms| terms.map(|t| -t)),
        }
    }
    fn abs(&self, a: Number) -> Number {
        self.exactly(a, f64::abs)
    }
    fn min(&self, a: Number, b: Number) -> Number {
        plain(P::strict(FloatOp::Min, [self.operand(a), self.operand(b), 0.0]))
    }
    fn max(&self, a: Number, b: Number) -> Number {
        plain(P::strict(FloatOp::Max, [self.operand(a), self.operand(b), 0.0]))
    }
    fn sign(&self, a: Number) -> Number {
        plain(P::strict(FloatOp::Sign, [self.operand(a), 0.0, 0.0]))
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
        if x >= P::MIN_NORMAL || x < 0.0 {
            return match self.class(self.builtin(Intrinsic::Sqrt)) {
                Accuracy::Inherited(_) => self.div(plain(1.0), self.inverse_sqrt(plain(x))),
                class => self.inexact(class, x, x.sqrt()),
            };
        }
        plain(self.flush(if self.coin() { 0.0 } else { P::nearest(x.sqrt()) }))
    }
    fn inverse_sqrt(&self, a: Number) -> Number {
        self.elementary(Intrinsic::InverseSqrt, a, |x| 1.0 / x.sqrt())
    }
    fn exp(&self, a: Number) -> Number {
        self.composed(Intrinsic::Exp, a, libm::exp, formula::exp)
    }
    fn exp2(&self, a: Number) -> Number {
        self.elementary(Intrinsic::Exp2, a, libm::exp2)
    }
    fn log(&self, a: Number) -> Number {
        self.composed(Intrinsic::Log, a, libm::log, formula::log)
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
        self.inexact(self.class(self.builtin(Intrinsic::Atan2)), 0.0, angle)
    }
    fn asin(&self, x: Number) -> Number {
        self.composed(Intrinsic::Asin, x, libm::asin, formula::asin)
    }
    fn acos(&self, x: Number) -> Number {
        self.composed(Intrinsic::Acos, x, libm::acos, formula::acos)
    }
    fn mix(&self, x: Number, y: Number, t: Number) -> Number {
        match self.class(self.builtin(Intrinsic::Mix)) {
            Accuracy::Inherited(LERP) => formula::lerp(self, x, y, t),
            _ => formula::mix(self, x, y, t),
        }
    }
    fn tanh(&self, x: Number) -> Number {
        self.composed(Intrinsic::Tanh, x, libm::tanh, formula::tanh)
    }
}
