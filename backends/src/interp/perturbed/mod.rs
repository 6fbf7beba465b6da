//! A driver drawn by chance: every operation errs as far as its accuracy class permits.
//!
//! This is the adversary of the shadow lane: what it returns must lie within the bounds, whatever the seed.
//! It rounds either way, errs by whole ULPs, takes absolute errors, flushes subnormal numbers, and fuses
//! products into the sums that follow them.

mod model;

use lobe_codegen::accuracy::{self, Accuracy, Rounding, Subnormal};
use lobe_codegen::intrinsics::Intrinsic;
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
