//! What results owe to the errors made on the way to them.
//!
//! An interval forgets that two numbers share an error, so whatever cancels later (a Newton step, a sum of
//! neighbours, a determinant) looks far worse than it is.
//! The tape remembers: for each operation `z = f(x, y)`, with exact values marked 0,
//!
//! ```text
//! z - z0 = (slope in x) (x - x0) + (slope in y) (y - y0) + own error
//! ```
//!
//! where a slope is an interval of *difference quotients*: all that `(f(x, y) - f(x0, y)) / (x - x0)` can be
//! while the operands stay in their intervals. This is an equation, not a first-order approximation; what is
//! of second order sits in the widths of the slopes.
//! Followed back from a result to everything that errs, in interval arithmetic, it says by how much the result
//! can be off in all: the sum over the operations of (largest slope of the result in it) x (its own error).
//! Slopes along different ways to the same operation add up before their largest value is taken, so
//! what cancels cancels.

use super::Float;
use crate::interp::precision::Precision;
use std::cell::RefCell;

thread_local! {
    /// The memory of a tape that is done with, for the next one of this thread.
    static SPARE: RefCell<Option<(Vec<Step>, Sweep)>> = const { RefCell::new(None) };
}

/// An interval of difference quotients.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slope {
    low: f64,
    high: f64,
}

impl Slope {
    pub(super) const ZERO: Self = Self::exactly(0.0);
    pub(super) const ONE: Self = Self::exactly(1.0);
    pub(super) const MINUS_ONE: Self = Self::exactly(-1.0);
    /// Of a choice that may or may not follow the operand.
    pub(super) const PARTLY: Self = Self { low: 0.0, high: 1.0 };

    pub(super) const fn exactly(slope: f64) -> Self {
        Self { low: slope, high: slope }
    }

    /// All from one end to the other.
    pub(super) fn between(a: f64, b: f64) -> Self {
        Self { low: a.min(b), high: a.max(b) }
    }

    pub(super) fn times(self, factor: f64) -> Self {
        Self::between(self.low * factor, self.high * factor)
    }

    /// Wider by this share of the ends.
    pub(super) fn wider(self, share: f64) -> Self {
        Self { low: self.low - self.low.abs() * share, high: self.high + self.high.abs() * share }
    }

    /// Largest magnitude.
    fn size(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    fn is_finite(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }

    pub(super) fn is_zero(self) -> bool {
        self.low == 0.0 && self.high == 0.0
    }

    pub(super) fn product(self, b: Self) -> Self {
        let (p, q, r, s) = (self.low * b.low, self.low * b.high, self.high * b.low, self.high * b.high);
        Self { low: p.min(q).min(r.min(s)), high: p.max(q).max(r.max(s)) }
    }

    /// Adds, outwards by more than f64 rounds.
    fn add(&mut self, b: Self) {
        self.low += b.low - (self.low.abs() + b.low.abs()) * f64::EPSILON;
        self.high += b.high + (self.high.abs() + b.high.abs()) * f64::EPSILON;
    }
}

/// A number's place on the tape.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Place(u32);

impl Place {
    /// Not there: all that is known of the number's error is its interval.
    pub(super) const NONE: Self = Self(u32::MAX);

    fn index(self) -> Option<usize> {
        (self != Self::NONE).then_some(self.0 as usize)
    }
}

/// An operation: what its result owes to two operands, and its own error.
#[derive(Debug, Clone, Copy)]
struct Step {
    operands: [Place; 2],
    slopes: [Slope; 2],
    /// The operation's own error.
    rounding: f64,
    /// What it owes to operands that are not on the tape.
    owed: f64,
    kind: Kind,
}

/// What a number is to the sums that take it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Itself, the same in all of them.
    Whole,
    /// A product or a sum. A product may be fused into one sum and rounded in another, and the terms of a sum may be
    /// those of a greater one, so a sum takes it before it is rounded, and answers for that itself.
    Part,
}

/// Operations of a batch, in order. When it is full, what follows is known by intervals alone.
#[derive(Debug)]
pub(super) struct Tape {
    steps: Vec<Step>,
    capacity: usize,
    sweep: Sweep,
}

impl Default for Tape {
    fn default() -> Self {
        Self::with_capacity(1 << 20) // 64 MiB
    }
}

/// More than the sums of a sweep may be off by rounding in f64.
const HAIR: f64 = 1.0 + 1e-9;

impl Tape {
    /// An empty tape for so many steps.
    pub(super) fn with_capacity(capacity: usize) -> Self {
        let (steps, sweep) = SPARE.take().unwrap_or_default();
        Self { steps, capacity, sweep }
    }

    /// `result`, of which nothing is remembered but its interval; still, it is one number wherever it is used.
    pub(super) fn source<P: Precision>(&mut self, result: Float) -> Float {
        self.unrelated::<P>(result, Kind::Whole)
    }

    /// The same of a number that is a part of sums, perhaps.
    pub(super) fn unrelated<P: Precision>(&mut self, result: Float, kind: Kind) -> Float {
        if !result.bounded() || result.bound() == 0.0 {
            return Float { place: Place::NONE, ..result };
        }
        let bound = result.bound() + if result.may_flush::<P>() { P::MIN_NORMAL } else { 0.0 };
        let (operands, slopes) = ([Place::NONE; 2], [Slope::ZERO; 2]);
        let step = Step { operands, slopes, rounding: 0.0, owed: bound, kind };
        self.push(step, result)
    }

    /// `result` of an operation on two operands, with the error of its own rounding.
    pub(super) fn record<P: Precision>(
        &mut self,
        result: Float,
        mut rounding: f64,
        operands: [(Float, Slope); 2],
        kind: Kind,
    ) -> Float {
        if !result.bounded() || result.bound() == 0.0 {
            return Float { place: Place::NONE, ..result };
        }
        if result.may_flush::<P>() {
            rounding += P::MIN_NORMAL;
        }
        let mut owed = 0.0;
        for (operand, slope) in operands {
            if operand.may_flush::<P>() {
                rounding += slope.size() * P::MIN_NORMAL; // here, and perhaps nowhere else
            }
            if operand.place == Place::NONE && !slope.is_zero() && operand.bound() > 0.0 {
                owed += slope.size() * operand.bound();
            }
        }
        let [(a, in_a), (b, in_b)] = operands;
        if !((rounding + owed).is_finite() && in_a.is_finite() && in_b.is_finite()) {
            return self.unrelated::<P>(result, kind);
        }
        self.push(Step { operands: [a.place, b.place], slopes: [in_a, in_b], rounding, owed, kind }, result)
    }

    /// The number as a sum takes it, and its rounding, which the sum answers for.
    pub(super) fn summand(&mut self, number: Float) -> (Float, f64) {
        match self.step(number) {
            Some(step) if step.kind == Kind::Part && step.rounding > 0.0 => {
                (self.push(Step { rounding: 0.0, ..step }, number), step.rounding)
            }
            Some(_) | None => (number, 0.0),
        }
    }

    /// Puts the opposite of a number on the tape; that of a part is one.
    pub(super) fn negative<P: Precision>(&mut self, number: Float, result: Float) -> Float {
        match self.step(number) {
            Some(step) if step.kind == Kind::Part => {
                self.push(Step { slopes: step.slopes.map(|s| s.times(-1.0)), ..step }, result)
            }
            Some(_) | None => self.record::<P>(
                result,
                0.0,
                [(number, Slope::MINUS_ONE), (number, Slope::ZERO)],
                Kind::Whole,
            ),
        }
    }

    fn step(&self, number: Float) -> Option<Step> {
        number.place.index().map(|index| self.steps[index])
    }

    /// Puts `number` on the tape as `step` says; where that is full, it is known by its interval alone.
    fn push(&mut self, step: Step, number: Float) -> Float {
        let place = Place(self.steps.len() as u32);
        if self.steps.len() >= self.capacity {
            return Float { place: Place::NONE, ..number };
        }
        self.steps.push(step);
        Float { place, ..number }
    }

    /// How far `number` may be from its exact value, by all that led to it; infinite where that says nothing.
    pub(super) fn bound(&mut self, number: Float) -> f64 {
        let Some(top) = number.place.index() else {
            return f64::INFINITY;
        };
        let mut sum = 0.0;
        self.sweep.begin(top);
        while let Some((index, slope)) = self.sweep.next() {
            if !slope.is_finite() {
                sum = f64::INFINITY;
                continue;
            }
            let step = &self.steps[index];
            sum += slope.size() * (step.rounding + step.owed);
            for (operand, along) in step.operands.iter().zip(step.slopes) {
                if let Some(from) = operand.index()
                    && !along.is_zero()
                {
                    self.sweep.add(from, slope.product(along));
                }
            }
        }
        sum * HAIR
    }
}

impl Drop for Tape {
    fn drop(&mut self) {
        self.steps.clear();
        SPARE.set(Some((std::mem::take(&mut self.steps), std::mem::take(&mut self.sweep))));
    }
}

/// A walk back along the tape: the slopes of one number in the steps that it depends on, latest step first.
#[derive(Debug, Default)]
struct Sweep {
    slopes: Vec<Slope>,
    /// A bit for each step that waits.
    waiting: Vec<u64>,
    /// The word of `waiting` that is being emptied.
    word: usize,
}

impl Sweep {
    fn begin(&mut self, top: usize) {
        if self.slopes.len() <= top {
            self.slopes.resize(top + 1, Slope::ZERO);
            self.waiting.resize(top / 64 + 1, 0);
        }
        self.word = top / 64;
        self.add(top, Slope::ONE);
    }

    fn add(&mut self, index: usize, slope: Slope) {
        self.slopes[index].add(slope);
        self.waiting[index / 64] |= 1 << (index % 64);
    }

    /// Takes the latest step that waits.
    fn next(&mut self) -> Option<(usize, Slope)> {
        while self.waiting[self.word] == 0 {
            self.word = self.word.checked_sub(1)?;
        }
        let bit = 63 - self.waiting[self.word].leading_zeros() as usize;
        self.waiting[self.word] &= !(1 << bit);
        let index = self.word * 64 + bit;
        Some((index, std::mem::replace(&mut self.slopes[index], Slope::ZERO)))
    }
}
