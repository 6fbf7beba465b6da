//! The shadow lane: beside each float its exact value and all values that permitted drivers may have.
//!
//! A float is `{ value, exact, low, high }`: what strict arithmetic gives, what the formula gives in real numbers
//! (f64), and an interval.
//! **Claim:** whatever implementation evaluates the function while it keeps the accuracy rules of
//! a model of [`lobe_codegen::accuracy`], its number lies in `low ..= high`; so `max(high - exact, exact - low)`
//! bounds its error.
//! The claim holds for arguments and is kept by every operation: the interval of the result holds the exact
//! result of every choice of operands from their intervals ([`interval`]), widened by the operation's
//! accuracy class ([`promise`], [`round`]).
//! Since each operation allows for all operands, second-order terms are no matter; since the interval holds
//! the exact result of operands that were not rounded before, contraction to fused multiply-add is covered.
//!
//! Intervals alone forget which numbers share an error; the [`tape`] remembers, and bounds what depends on
//! them by how the errors meet.
//! The bound of a result is the smaller of both; on the way, wide intervals are cut to what the tape leaves, and
//! a comparison that intervals leave open is asked of the difference.
//!
//! An interval rather than a radius, because kernels guard their domains: after `max(x, 0)` nothing is
//! negative, and only an interval says so to the root that follows.
//!
//! One model serves one [format](super::precision); those of the formats share a tape, so what is converted keeps what
//! it shares.
//!
//! Readings of the rules that the specifications leave open:
//!
//! - A result that is correctly rounded lies between the floats that enclose it, so what is representable is
//!   exact: counters and powers of two carry no error.
//! - Flushing: whenever an interval holds subnormal numbers it is extended to zero.
//! - The terms of a sum may be added in any order ([`sum`]), whether the shader names partial sums or not. Products of more
//!   than two factors are taken in the order in which they stand: another errs by as much, unless it leaves the range.
//! - A number that is used twice is one number, so `x * x` is not negative, and `x - x` is zero; but a product may be
//!   fused into one sum and rounded in another, and a subnormal number flushed in one place and kept in another.
//! - Errors in ULP do not change the sign of a result, and an ULP of zero is zero.
//! - `sqrt` is `1 / inverse_sqrt(x)`, which at zero would be `1 / inf`, which no rule bounds; we let arguments
//!   that reach below the normal numbers give results in `0 ..= sqrt(high)`, widened.
//! - `atan2` keeps its promise wherever the angle is known; read to the letter, WGSL makes none on the axes, so none of
//!   `acos(0)`.
//! - `normalize` is `x / length(x)`, which is looser than the `x * inverse_sqrt(dot(x, x))` of Vulkan.
//! - `sin` and `cos` keep their promise up to the f32 that is nearest to an end of the range.
//! - Doubles are promised the precision of singles, so their results are rounded to 24 digits, and what has no more is
//!   exact. What moves a double, or returns it (`abs`, `min`, `floor`, ..), keeps all its digits.
//! - Once a number has no bound (overflow, a pole, a domain left), nothing computed from it has one, not even
//!   `clamp` of it: it may be NaN.

mod boolean;
mod collect;
mod convert;
mod elementary;
mod interval;
mod model;
mod pieces;
mod promise;
mod round;
mod slope;
mod sum;
mod tape;

use promise::Promise;
pub(super) use promise::Promises;

use super::precision::{Precision, Single};
use std::cell::RefCell;
use std::marker::PhantomData;
use std::rc::Rc;
use sum::{Sum, Terms};
use tape::{Kind, Place, Slope, Tape};

/// The model for floats of a format: what it remembers of a batch, and what drivers promise.
#[derive(Debug)]
pub(super) struct Shadow<P = Single> {
    /// That of all formats.
    tape: Rc<RefCell<Tape>>,
    promises: Promises,
    promise: Promise,
    format: PhantomData<P>,
}

impl Shadow {
    /// A model of drivers that keep their promises.
    pub(super) fn new(promises: Promises) -> Self {
        Self::with_tape(promises, Tape::default())
    }

    /// The same, but it forgets: its bounds are those of the intervals.
    pub(super) fn forgetful(promises: Promises) -> Self {
        Self::with_tape(promises, Tape::with_capacity(0))
    }

    fn with_tape(promises: Promises, tape: Tape) -> Self {
        let promise = promises.single;
        Self { tape: Rc::new(RefCell::new(tape)), promises, promise, format: PhantomData }
    }
}

impl<P> Shadow<P> {
    /// The same model, for floats of another format.
    fn of<Q>(&self, promise: Promise) -> Shadow<Q> {
        Shadow { tape: self.tape.clone(), promises: self.promises, promise, format: PhantomData }
    }
}

/// A float; see the module's documentation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Float {
    pub(super) value: f64,
    pub(super) exact: f64,
    pub(super) low: f64,
    pub(super) high: f64,
    place: Place,
    terms: Terms,
}

/// An integer.
#[derive(Debug, Clone, Copy)]
pub(super) struct Word {
    /// On the strict path.
    pub(super) value: u64,
    /// On the exact path.
    pub(super) exact: u64,
    /// Whether every permitted driver has the same value.
    pub(super) known: bool,
}

/// A decision.
#[derive(Debug, Clone, Copy)]
pub(super) struct Truth {
    /// By the strict numbers.
    pub(super) value: bool,
    /// By the exact numbers.
    pub(super) exact: bool,
    /// Whether permitted drivers may decide otherwise.
    pub(super) ambiguous: bool,
}

impl Float {
    /// A number of which nothing is promised.
    pub(super) fn unbounded(value: f64, exact: f64) -> Self {
        Self {
            value,
            exact,
            low: f64::NEG_INFINITY,
            high: f64::INFINITY,
            place: Place::NONE,
            terms: Terms::ONE,
        }
    }

    /// Closes the interval under flushing and gives up what may overflow.
    pub(super) fn closed<P: Precision>(value: f64, exact: f64, low: f64, high: f64) -> Self {
        let (mut low, mut high) = (
            if low > 0.0 && low < P::MIN_NORMAL { 0.0 } else { low },
            if high < 0.0 && high > -P::MIN_NORMAL { 0.0 } else { high },
        );
        if P::IS_WIDE {
            low = if low < 0.0 { low.min(-P::MIN_NORMAL) } else { low };
            high = if high > 0.0 { high.max(P::MIN_NORMAL) } else { high };
        }
        // Written so that NaN anywhere gives up, too.
        if low >= -P::MAX && high <= P::MAX && exact.abs() <= P::MAX {
            Self {
                value,
                exact,
                low: low.min(exact),
                high: high.max(exact),
                place: Place::NONE,
                terms: Terms::ONE,
            }
        } else {
            Self::unbounded(value, exact)
        }
    }

    /// Whether anything is promised.
    pub(super) fn bounded(self) -> bool {
        self.low.is_finite()
    }

    /// Whether all drivers have this one number.
    pub(super) fn is_point(self) -> bool {
        self.low == self.high
    }

    /// Whether the tape has it.
    fn is_placed(self) -> bool {
        self.place != Place::NONE
    }

    /// Whether a driver may have zero in place of this number.
    fn may_flush<P: Precision>(self) -> bool {
        self.is_below(P::MIN_NORMAL)
    }

    /// Whether it may be nearer to zero than that, and not be zero.
    fn is_below(self, least: f64) -> bool {
        self.low < least && self.high > -least && !self.is_zero()
    }

    /// Whether all drivers have zero.
    fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    /// Whether so little is known that another look may pay.
    fn is_wide(self) -> bool {
        const SHARE: f64 = 1.0 / (1 << 14) as f64;
        self.bounded() && self.high - self.low > SHARE * self.high.abs().max(self.low.abs())
    }

    /// Largest possible distance from the exact value; infinite when nothing is promised.
    pub(super) fn bound(self) -> f64 {
        if self.bounded() { (self.high - self.exact).max(self.exact - self.low) } else { f64::INFINITY }
    }
}

impl<P: Precision> Shadow<P> {
    /// A float that is `value` by strict arithmetic and `exact` in truth.
    fn number(&self, value: f64, exact: f64) -> Float {
        if value.is_finite() {
            self.source(Float::closed::<P>(value, exact, value.min(exact), value.max(exact)))
        } else {
            Float::unbounded(value, exact)
        }
    }

    /// Puts `result` of an operation on the tape, with its own error and what it owes to its operands.
    fn link(&self, result: Float, own: f64, operands: [slope::Link; 2]) -> Float {
        self.link_as(Kind::Whole, result, own, operands)
    }

    fn link_as(&self, kind: Kind, result: Float, own: f64, operands: [slope::Link; 2]) -> Float {
        if !self.promise.holds {
            return Float::unbounded(result.value, result.exact);
        }
        let number = self.tape.borrow_mut().record::<P>(result, own, operands, kind);
        // Of one operand the interval knows as much as the tape.
        let meet = operands.iter().all(|(operand, slope)| operand.is_placed() && !slope.is_zero());
        if meet && number.is_wide() { self.tightened(number) } else { number }
    }

    /// The same for a product.
    fn link_product(&self, result: Float, own: f64, operands: [slope::Link; 2]) -> Float {
        self.link_as(Kind::Part, result, own, operands)
    }

    /// `plain` is the sum of `a` and `b` taken as it stands, or their difference if `sign` is -1.
    fn sum(&self, plain: Float, a: Float, b: Float, sign: Slope) -> Float {
        let ([(a, part_a), (b, part_b)], reorders) = (self.summands(a, b), self.promise.reassociation);
        let signed = if sign == Slope::ONE { b } else { interval::neg(b) };
        let sum = Sum::of::<P>([(a, part_a), (signed, part_b)], plain, reorders);
        let kind = if reorders { Kind::Part } else { Kind::Whole };
        let linked = self.link_as(kind, sum.result, sum.rounding, [(a, Slope::ONE), (b, sign)]);
        Float { terms: sum.terms, ..linked }
    }

    /// The operands of a sum as it takes them, each with its own rounding.
    fn summands(&self, a: Float, b: Float) -> [(Float, f64); 2] {
        let mut tape = self.tape.borrow_mut();
        [tape.summand(a), tape.summand(b)]
    }

    /// Puts a number on the tape whose error is known by its interval alone.
    fn source(&self, result: Float) -> Float {
        if !self.promise.holds {
            return Float::unbounded(result.value, result.exact);
        }
        self.tape.borrow_mut().source::<P>(result)
    }

    /// The same of a number that may go into sums unrounded.
    fn part(&self, result: Float) -> Float {
        if !self.promise.holds {
            return Float::unbounded(result.value, result.exact);
        }
        self.tape.borrow_mut().unrelated::<P>(result, Kind::Part)
    }

    /// The largest distance of a number from its exact value.
    pub(super) fn bound(&self, a: Float) -> f64 {
        a.bound().min(self.tape.borrow_mut().bound(a))
    }

    /// The same number where there is no tape.
    pub(super) fn detached(&self, a: Float) -> Float {
        Float { place: Place::NONE, ..self.tightened(a) }
    }

    /// The same number, in the interval that the tape leaves it.
    fn tightened(&self, a: Float) -> Float {
        let bound = self.tape.borrow_mut().bound(a);
        if !bound.is_finite() {
            return a;
        }
        let hair = (a.exact.abs() + bound) * (2.0 * f64::EPSILON);
        let (low, high) = (a.exact - bound - hair, a.exact + bound + hair);
        Float { low: a.low.max(low), high: a.high.min(high), ..a }
    }

    /// A comparison that the intervals leave open may be closed by what the tape knows of the difference.
    fn decided(&self, a: Float, b: Float, compare: fn(Float, Float) -> Truth) -> Truth {
        let first = compare(a, b);
        if !(first.ambiguous && a.bounded() && b.bounded()) {
            return first;
        }
        let zero = Float::closed::<P>(0.0, 0.0, 0.0, 0.0);
        let difference = interval::sub::<P>(a, b);
        let known = self.tightened(self.link(difference, 0.0, [(a, Slope::ONE), (b, Slope::MINUS_ONE)]));
        Truth { ambiguous: compare(known, zero).ambiguous, ..first }
    }
}
