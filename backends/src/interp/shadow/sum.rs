//! Sums: drivers may take the terms of a sum in any order.
//!
//! With terms `t1 .. tn`, whatever the order, each of the `n - 1` additions rounds a partial sum. The last of these is
//! the sum `S` itself; the others are at most `P`, the larger one of what the positive terms add up to and what the
//! negative ones do. So the error is at most
//!
//! ```text
//! u (|S| + (n - 2) P)
//! ```
//!
//! and that of the products among the terms, which may have been rounded or fused.
//! A sum of sums has the terms of both. What an addition adds to the errors of its operands, if these have `n` and `m`
//! terms, partial sums up to `P` and `Q`, is at most `u (m P + n Q)`: such errors added up are never less than the above.

use super::Float;
use super::slope::rounded;
use crate::interp::precision::Precision;

/// The terms of a number that is a sum; any other has one term, itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Terms {
    /// How many.
    count: u32,
    /// What those that may be positive add up to at most, where they are more than one.
    positive: f32,
    /// The same of those that may be negative.
    negative: f32,
    /// The roundings of those that are products.
    roundings: f32,
    /// All are multiples of 2 to this power, for every driver.
    quantum: i32,
}

/// Of a number that is not the same for every driver.
const NO_QUANTUM: i32 = i32::MIN;

impl Terms {
    pub(super) const ONE: Self =
        Self { count: 1, positive: 0.0, negative: 0.0, roundings: 0.0, quantum: NO_QUANTUM };

    /// Those of a number's opposite.
    pub(super) fn negated(self) -> Self {
        Self { positive: self.negative, negative: self.positive, ..self }
    }

    fn and(self, b: Self) -> Self {
        Self {
            count: self.count.saturating_add(b.count),
            positive: total(self.positive, b.positive),
            negative: total(self.negative, b.negative),
            roundings: total(self.roundings, b.roundings),
            quantum: self.quantum.min(b.quantum),
        }
    }

    /// The largest partial sum.
    fn partial(self) -> f64 {
        self.positive.max(self.negative).into()
    }

    /// Whether each partial sum is a number of the format, so that none is rounded or flushed.
    fn are_exact<P: Precision>(self) -> bool {
        if self.quantum == NO_QUANTUM {
            return false;
        }
        let unit = power_of_two(self.quantum);
        unit >= P::MIN_NORMAL && self.partial() * P::ULP <= unit
    }
}

/// A sum of two numbers.
pub(super) struct Sum {
    /// The number.
    pub(super) result: Float,
    /// Its error, that of its terms left out.
    pub(super) rounding: f64,
    /// Its terms.
    pub(super) terms: Terms,
}

/// More than a rounded partial sum, of which the terms have errors of their own.
const HAIR: f64 = 1.0 + 1e-6;

impl Sum {
    /// Of two operands, each with its own rounding; `plain` is the interval of the sum if it is taken as it stands.
    pub(super) fn of<P: Precision>(operands: [(Float, f64); 2], plain: Float, reorders: bool) -> Self {
        let [(a, rounding_a), (b, rounding_b)] = operands;
        if is_nothing::<P>(a) || is_nothing::<P>(b) {
            let terms = if is_nothing::<P>(a) { b.terms } else { a.terms };
            return Self { result: plain, rounding: rounding_a + rounding_b, terms };
        }
        let rounded = rounded::<P>(plain, [a, b]);
        if !reorders {
            return Self { result: plain, rounding: rounded + rounding_a + rounding_b, terms: Terms::ONE };
        }
        let (of_a, of_b) = (terms(a, rounding_a), terms(b, rounding_b));
        let terms = of_a.and(of_b);
        if terms.are_exact::<P>() {
            return Self { result: plain, rounding: 0.0, terms };
        }
        if terms.count == 2 {
            return Self { result: plain, rounding: rounded + f64::from(terms.roundings), terms };
        }
        let others = f64::from(terms.count - 2);
        let last = plain.low.abs().max(plain.high.abs());
        let flushed = 2.0 * f64::from(terms.count) * P::MIN_NORMAL;
        let rounding =
            (last + others * terms.partial()) * P::ULP * HAIR + f64::from(terms.roundings) + flushed;
        Self { result: widened::<P>(plain, (of_a, of_b), flushed), rounding, terms }
    }
}

/// Whether adding it changes nothing; a sum that is zero still has its terms, and doubles have more digits than promised.
fn is_nothing<P: Precision>(x: Float) -> bool {
    !P::IS_WIDE && x.is_zero() && x.terms.count == 1
}

/// What a number is to a sum.
fn terms(x: Float, rounding: f64) -> Terms {
    if x.terms.count > 1 {
        return x.terms;
    }
    Terms {
        count: 1,
        positive: above(x.high),
        negative: above(-x.low),
        roundings: above(rounding),
        quantum: if x.is_point() { lowest_bit(x.low) } else { NO_QUANTUM },
    }
}

/// The interval of a sum whose terms may be reordered. Numbers of one sign have sums of that sign.
fn widened<P: Precision>(plain: Float, (a, b): (Terms, Terms), flushed: f64) -> Float {
    let sizes = a.partial() * f64::from(b.count) + b.partial() * f64::from(a.count);
    let margin = sizes * P::ULP * HAIR + flushed;
    if !plain.bounded() || sizes > f64::from(f32::MAX).min(P::MAX) {
        return Float::unbounded(plain.value, plain.exact);
    }
    let terms = a.and(b);
    let low = (plain.low - margin).max(if terms.negative == 0.0 { 0.0 } else { f64::NEG_INFINITY });
    let high = (plain.high + margin).min(if terms.positive == 0.0 { 0.0 } else { f64::INFINITY });
    Float::closed::<P>(plain.value, plain.exact, low, high)
}

/// The terms of a number that is one of two.
pub(super) fn either(a: Float, b: Float) -> Terms {
    if a.terms.count == 1 && b.terms.count == 1 {
        return Terms::ONE;
    }
    let (a, b) = (terms(a, 0.0), terms(b, 0.0));
    Terms {
        count: a.count.max(b.count),
        positive: a.positive.max(b.positive),
        negative: a.negative.max(b.negative),
        roundings: a.roundings.max(b.roundings),
        quantum: a.quantum.min(b.quantum),
    }
}

/// 2 to this power, 0 below the normal numbers.
fn power_of_two(power: i32) -> f64 {
    match power {
        -1022..=1023 => f64::from_bits(((power + 1023) as u64) << (f64::MANTISSA_DIGITS - 1)),
        1024.. => f64::INFINITY,
        _ => 0.0,
    }
}

/// The power of the largest power of two of which `x` is a multiple.
fn lowest_bit(x: f64) -> i32 {
    const DIGITS: u32 = f64::MANTISSA_DIGITS - 1;
    if x == 0.0 {
        return i32::MAX;
    }
    let (power, digits) = ((x.to_bits() >> DIGITS) as i32 & 0x7ff, x.to_bits() | (1 << DIGITS));
    power - 1023 - DIGITS as i32 + digits.trailing_zeros() as i32
}

/// A float that is not below `x`, and not negative.
fn above(x: f64) -> f32 {
    if x > 0.0 { (x as f32).next_up() } else { 0.0 }
}

/// A float that is not below the sum of two that are not negative.
fn total(a: f32, b: f32) -> f32 {
    above(f64::from(a) + f64::from(b))
}
