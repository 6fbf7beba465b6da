//! The shadow lane as a [`Model`].

use super::slope::{only, rounded, rounded_product};
use super::sum::Terms;
use super::tape::Slope;
use super::{Float, Shadow, Truth, Word, boolean, collect, elementary, interval, pieces, slope, sum};
use crate::interp::formula;
use crate::interp::model::{Model, Pick};
use crate::interp::precision::{Double, Half, Precision};
use crate::interp::program::Scalar;
use crate::interp::program::op::FloatOp;
use crate::texture::Known;
use naga::SubgroupOperation;

/// Operations that put their results on the tape themselves, or whose results are sources there.
macro_rules! forward {
    (
        $($piece:ident($($a:ident)*)),* of pieces: source;
        $($name:ident($($arg:ident)*)),* of elementary;
    ) => {
        $(fn $piece(&self, $($a: Float),*) -> Float {
            self.source(pieces::$piece::<P>($($a),*))
        })*
        $(fn $name(&self, $($arg: Float),*) -> Float {
            elementary::$name(self, $($arg),*)
        })*
    };
}

/// What a formula gives, with the strict value of the operation that stands for it.
fn formed<P: Precision>(op: FloatOp, args: [Float; 3], formula: Float) -> Float {
    Float { value: P::strict(op, args.map(|a| a.value)), ..formula }
}

impl<P: Precision> Model for Shadow<P> {
    const SHADOW: bool = true;
    const ALL_WIDTHS: bool = true;
    type F = Float;
    type W = Word;
    type B = Truth;

    type Half = Shadow<Half>;
    type Double = Shadow<Double>;
    fn half(&self) -> Shadow<Half> {
        self.of(self.promises.half)
    }
    fn double(&self) -> Shadow<Double> {
        self.of(self.promises.double)
    }

    fn float(&self, value: f32, exact: f64) -> Float {
        self.number(value.into(), exact)
    }
    fn ranged(&self, value: f32, known: Known) -> Float {
        let x = f64::from(value);
        self.source(Float::closed::<P>(x, known.exact, known.low.min(x), known.high.max(x)))
    }
    fn range(&self, a: Float) -> Known {
        let Float { exact, low, high, .. } = self.tightened(a);
        Known { exact, low, high }
    }
    fn converted(&self, a: Float, from: Scalar) -> Float {
        self.reformatted(a, from)
    }
    fn unpromised(&self, a: Float) -> Float {
        Float::unbounded(a.value, a.exact)
    }
    /// A driver may have rounded a formula's constant either way.
    fn constant(&self, exact: f64) -> Float {
        self.source(Float::closed::<P>(P::nearest(exact), exact, P::down(exact), P::up(exact)))
    }
    fn value(&self, a: Float) -> f32 {
        a.value as f32
    }
    fn exact(&self, a: Float) -> f64 {
        a.exact
    }
    fn with_truth(&self, a: Float, truth: f64) -> Float {
        if a.bounded() {
            let told = Float::closed::<P>(a.value, truth, a.low, a.high);
            self.link(told, (truth - a.exact).abs(), only(a, Slope::ONE))
        } else {
            Float::unbounded(a.value, truth)
        }
    }
    fn collected(&self, op: SubgroupOperation, all: &[Float], strict: Float) -> Float {
        self.source(collect::collected::<P>(op, all, strict.value))
    }
    fn join_f(&self, a: Float, b: Float, pick: Pick) -> Float {
        let value = if pick.value { a.value } else { b.value };
        let exact = if pick.exact { a.exact } else { b.exact };
        let terms = sum::either(a, b);
        self.part(Float { value, exact, low: a.low.min(b.low), high: a.high.max(b.high), terms, ..a })
    }

    fn word(&self, value: u64) -> Word {
        Word { value, exact: value, known: true }
    }
    fn word_value(&self, a: Word) -> u64 {
        a.value
    }
    fn word_exact(&self, a: Word) -> u64 {
        a.exact
    }
    fn known(&self, a: Word) -> bool {
        a.known
    }
    fn word_parts(&self, value: u64, exact: u64) -> Word {
        Word { value, exact, known: value == exact }
    }
    fn forget(&self, a: Word) -> Word {
        Word { known: false, ..a }
    }
    fn map_w(&self, a: Word, f: impl Fn(u64) -> u64) -> Word {
        Word { value: f(a.value), exact: f(a.exact), known: a.known }
    }
    fn zip_w(&self, a: Word, b: Word, f: impl Fn(u64, u64) -> u64) -> Word {
        Word { value: f(a.value, b.value), exact: f(a.exact, b.exact), known: a.known && b.known }
    }
    fn join_w(&self, a: Word, b: Word, pick: Pick) -> Word {
        Word {
            value: if pick.value { a.value } else { b.value },
            exact: if pick.exact { a.exact } else { b.exact },
            known: a.known && b.known && a.value == b.value,
        }
    }

    fn boolean(&self, value: bool) -> Truth {
        Truth::sure(value)
    }
    fn decision(&self, a: Truth) -> bool {
        a.value
    }
    fn decision_exact(&self, a: Truth) -> bool {
        a.exact
    }
    fn ambiguous(&self, a: Truth) -> bool {
        a.ambiguous
    }
    fn join_b(&self, a: Truth, b: Truth, pick: Pick) -> Truth {
        Truth {
            value: if pick.value { a.value } else { b.value },
            exact: if pick.exact { a.exact } else { b.exact },
            ambiguous: a.ambiguous || b.ambiguous || a.value != b.value,
        }
    }
    fn not(&self, a: Truth) -> Truth {
        a.not()
    }
    fn and(&self, a: Truth, b: Truth) -> Truth {
        a.and(b)
    }
    fn xor(&self, a: Truth, b: Truth) -> Truth {
        a.xor(b)
    }

    fn compare_w(&self, a: Word, b: Word, f: impl Fn(u64, u64) -> bool) -> Truth {
        Truth { value: f(a.value, b.value), exact: f(a.exact, b.exact), ambiguous: !(a.known && b.known) }
    }
    fn less(&self, a: Float, b: Float) -> Truth {
        self.decided(a, b, boolean::less)
    }
    fn less_equal(&self, a: Float, b: Float) -> Truth {
        self.decided(a, b, boolean::less_equal)
    }
    fn equal(&self, a: Float, b: Float) -> Truth {
        self.decided(a, b, boolean::equal)
    }
    fn settled(&self, a: Float) -> Float {
        if a.is_wide() { self.tightened(a) } else { a }
    }
    fn is_nan(&self, a: Float) -> Truth {
        Truth { value: a.value.is_nan(), exact: a.exact.is_nan(), ambiguous: !a.bounded() }
    }
    fn is_inf(&self, a: Float) -> Truth {
        Truth { value: a.value.is_infinite(), exact: a.exact.is_infinite(), ambiguous: !a.bounded() }
    }

    fn to_word(&self, a: Float, to: Scalar) -> Word {
        self.truncated(a, to)
    }
    fn to_float(&self, a: Word, from: Scalar) -> Float {
        self.of_integer(a, from)
    }
    fn bits(&self, a: Float) -> Word {
        // Zero has two signs, and a driver may have either.
        Word { value: P::bits(a.value), exact: P::bits(a.exact), known: a.is_point() && (a.low != 0.0) }
    }
    fn float_of_bits(&self, a: Word) -> Float {
        let (value, exact) = (P::of_bits(a.value), P::of_bits(a.exact));
        if a.known { self.number(value, exact) } else { Float::unbounded(value, exact) }
    }
    fn nonnegative(&self, a: Float) -> Float {
        let cut = Float {
            exact: a.exact.max(0.0),
            low: if a.bounded() { a.low.max(0.0) } else { a.low },
            terms: Terms::ONE,
            ..a
        };
        self.link(cut, 0.0, only(a, if a.low >= 0.0 { Slope::ONE } else { Slope::PARTLY }))
    }

    fn add(&self, a: Float, b: Float) -> Float {
        self.sum(interval::add::<P>(a, b), a, b, Slope::ONE)
    }
    fn sub(&self, a: Float, b: Float) -> Float {
        self.sum(interval::sub::<P>(a, b), a, b, Slope::MINUS_ONE)
    }
    fn mul(&self, a: Float, b: Float) -> Float {
        let product = interval::mul::<P>(a, b);
        self.link_product(product, rounded_product::<P>(product, [a, b]), slope::mul(a, b))
    }
    fn square(&self, a: Float) -> Float {
        let square = interval::square::<P>(a);
        self.link_product(square, rounded::<P>(square, [a, a]), slope::square(a))
    }
    fn neg(&self, a: Float) -> Float {
        self.tape.borrow_mut().negative::<P>(a, interval::neg(a))
    }
    fn abs(&self, a: Float) -> Float {
        self.link(pieces::abs::<P>(a), 0.0, slope::abs(a))
    }
    fn min(&self, a: Float, b: Float) -> Float {
        self.link(pieces::min::<P>(a, b), 0.0, slope::min(a, b))
    }
    fn max(&self, a: Float, b: Float) -> Float {
        self.link(pieces::max::<P>(a, b), 0.0, slope::max(a, b))
    }
    /// `a - b * trunc(a / b)`
    fn rem(&self, a: Float, b: Float) -> Float {
        let (value, exact) = (P::strict(FloatOp::Rem, [a.value, b.value, 0.0]), a.exact % b.exact);
        if !self.promise.remainder {
            return Float::unbounded(value, exact);
        }
        let formula = self.sub(a, self.mul(b, self.trunc(self.div(a, b))));
        self.inherit(formula, value, exact)
    }
    fn fma(&self, x: Float, y: Float, z: Float) -> Float {
        formed::<P>(FloatOp::Fma, [x, y, z], self.add(self.mul(x, y), z))
    }
    fn div(&self, a: Float, b: Float) -> Float {
        let b = if b.low <= 0.0 && b.high >= 0.0 { self.tightened(b) } else { b };
        let promise = self.promise.quotient;
        let quotient = interval::div::<P>(a, b, promise);
        self.link(
            quotient,
            slope::divided::<P>(quotient, [a, b], promise.ulps),
            slope::div(a, b, quotient.exact),
        )
    }
    fn mix(&self, x: Float, y: Float, t: Float) -> Float {
        let mixed = formed::<P>(FloatOp::Mix, [x, y, t], formula::mix(self, x, y, t));
        if !self.promise.lerp {
            return mixed;
        }
        self.hull(mixed, formula::lerp(self, x, y, t))
    }
    fn smoothstep(&self, low: Float, high: Float, x: Float) -> Float {
        formed::<P>(FloatOp::SmoothStep, [low, high, x], formula::smoothstep(self, low, high, x))
    }
    fn degrees(&self, a: Float) -> Float {
        formed::<P>(FloatOp::Degrees, [a, a, a], formula::degrees(self, a))
    }
    fn radians(&self, a: Float) -> Float {
        formed::<P>(FloatOp::Radians, [a, a, a], formula::radians(self, a))
    }
    /// The magnitude, or a root of a square that may have left the range.
    fn length(&self, a: Float) -> Float {
        self.hull(self.abs(a), formula::length(self, a))
    }
    fn fract(&self, a: Float) -> Float {
        let part = pieces::fract::<P>(a);
        if a.low.floor() == a.high.floor() {
            self.link(part, rounded::<P>(part, [a, a]), only(a, Slope::ONE))
        } else {
            self.source(part)
        }
    }

    forward! {
        sign(a), ceil(a), floor(a), round(a), trunc(a), step(edge x) of pieces: source;
        sqrt(a), inverse_sqrt(a), exp(a), exp2(a), log(a), log2(a), pow(x y), sin(a), cos(a), tan(x), asin(x),
            acos(x), atan(a), atan2(y x), sinh(x), cosh(x), tanh(x), asinh(x), acosh(x), atanh(x) of elementary;
    }
}
