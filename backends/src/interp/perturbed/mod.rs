//! A driver drawn by chance: every operation errs as far as its accuracy class permits.
//!
//! This is the adversary of the shadow lane: what it returns must lie within the bounds, whatever the seed.
//! It rounds either way, errs by whole ULPs, takes absolute errors, flushes subnormal numbers, and fuses
//! products into the sums that follow them.

mod model;

use super::precision::{Double, Half, Precision, Single};
use super::program::Scalar;
use lobe_codegen::accuracy::{self, Accuracy, Operation, Rounding, Subnormal, Width};
use lobe_codegen::intrinsics::Intrinsic;
use std::cell::Cell;
use std::marker::PhantomData;
use std::rc::Rc;

/// The model for floats of a format; it draws from a generator of its own, the same for all formats.
#[derive(Debug)]
pub(super) struct Perturbed<P = Single> {
    accuracy: &'static accuracy::Model,
    state: Rc<Cell<u64>>,
    format: PhantomData<P>,
}

/// A number, and what it is to a sum that takes it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Number {
    value: f64,
    /// A product before it was rounded.
    product: Option<f64>,
    /// The two terms of a sum.
    terms: Option<[f64; 2]>,
}

fn plain(value: f64) -> Number {
    Number { value, product: None, terms: None }
}

impl Perturbed {
    /// The driver of a part of the work, so that parts err differently; it errs as `accuracy` permits.
    pub(super) fn nth(accuracy: &'static accuracy::Model, seed: u64, part: usize) -> Self {
        let seed = seed ^ (part as u64).wrapping_mul(0x5851_f42d_4c95_7f2d);
        Self { accuracy, state: Rc::new(Cell::new(seed)), format: PhantomData }
    }
}

impl<P: Precision> Perturbed<P> {
    /// The same driver, for floats of another format.
    fn of<Q>(&self) -> Perturbed<Q> {
        Perturbed { accuracy: self.accuracy, state: self.state.clone(), format: PhantomData }
    }

    /// The classes of an operation.
    fn classes(&self, operation: Operation) -> &'static [Accuracy] {
        let width = match P::SCALAR {
            Scalar::F16 => Width::Half,
            Scalar::F64 => Width::Double,
            _ => Width::Single,
        };
        self.accuracy.classes_of(operation, width)
    }

    fn builtin(&self, intrinsic: Intrinsic) -> &'static [Accuracy] {
        self.classes(Operation::Builtin(intrinsic))
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

    fn flush(&self, x: f64) -> f64 {
        let always = self.accuracy.rules.subnormal.0 == Subnormal::Flushed;
        let is_subnormal = x != 0.0 && x.abs() < P::MIN_NORMAL;
        if is_subnormal && (always || self.coin()) { 0.0_f64.copysign(x) } else { x }
    }

    fn operand(&self, a: Number) -> f64 {
        self.flush(a.value)
    }

    /// One of the two floats that enclose `x`.
    fn either(&self, x: f64) -> f64 {
        self.flush(if self.coin() { P::down(x) } else { P::up(x) })
    }

    /// `x`, correctly rounded.
    fn rounded(&self, x: f64) -> f64 {
        match self.accuracy.rules.rounding.0 {
            Rounding::Either => self.either(x),
            Rounding::Nearest => self.flush(P::nearest(x)),
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
        let wanted = P::nearest(x + self.share() * error);
        let fits = (wanted - x).abs() <= error && (wanted >= 0.0) == (x >= 0.0);
        plain(self.flush(if fits { wanted } else { P::nearest(x) }))
    }

    fn ulps(&self, n: f64, x: f64) -> Number {
        if x == 0.0 {
            return plain(x);
        }
        self.within(x, n * (P::ULP * x.abs()).max(P::TINY))
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
            Accuracy::Inherited(_) => plain(P::nearest(result)),
            Accuracy::Nothing => self.off(result, 1.0 + result.abs()),
        }
    }

    fn off(&self, x: f64, error: f64) -> Number {
        let wanted = P::nearest(x + self.share() * error);
        plain(self.flush(if (wanted - x).abs() <= error { wanted } else { P::nearest(x) }))
    }

    /// What an addition takes for a product: its float, or all of it.
    fn summand(&self, a: Number) -> f64 {
        match a.product {
            Some(product) if self.coin() => product,
            Some(_) | None => self.operand(a),
        }
    }

    /// `a + b`, perhaps with the terms of one of them in another order.
    fn sum(&self, a: Number, b: Number) -> Number {
        let reorders = self.accuracy.rules.reassociation.0 && self.coin();
        match (a.terms, b.terms) {
            (Some(terms), _) if reorders => self.reordered(terms, b),
            (_, Some(terms)) if reorders => self.reordered(terms, a),
            _ => self.added(a, b),
        }
    }

    /// `(p + q) + b` as `p + (q + b)`, or with the roles of `p` and `q` changed.
    fn reordered(&self, [p, q]: [f64; 2], b: Number) -> Number {
        let (first, second) = if self.coin() { (p, q) } else { (q, p) };
        self.added(plain(first), self.added(plain(second), b))
    }

    fn added(&self, a: Number, b: Number) -> Number {
        // A fused operation takes one product whole, not two.
        let (x, y) =
            if self.coin() { (self.summand(a), self.operand(b)) } else { (self.operand(a), self.summand(b)) };
        Number { terms: Some([a.value, b.value]), ..plain(self.rounded(x + y)) }
    }

    fn exactly(&self, a: Number, f: fn(f64) -> f64) -> Number {
        plain(self.flush(f(self.operand(a))))
    }

    fn elementary(&self, intrinsic: Intrinsic, a: Number, f: fn(f64) -> f64) -> Number {
        let x = self.operand(a);
        self.inexact(self.class(self.builtin(intrinsic)), x, f(x))
    }

    /// The same where the class may be a formula.
    fn composed(
        &self,
        intrinsic: Intrinsic,
        a: Number,
        f: fn(f64) -> f64,
        formula: fn(&Self, Number) -> Number,
    ) -> Number {
        match self.class(self.builtin(intrinsic)) {
            Accuracy::Inherited(_) => formula(self, a),
            class => {
                let x = self.operand(a);
                self.inexact(class, x, f(x))
            }
        }
    }
}
