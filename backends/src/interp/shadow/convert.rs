//! Conversions between formats, and from integers and to them.

use super::slope::{only, rounded};
use super::tape::Slope;
use super::{Float, Shadow, Word};
use crate::interp::judge::integer;
use crate::interp::precision::{Double, Half, Precision, Single};
use crate::interp::program::Scalar;
use crate::interp::scalar::convert;

/// The smallest normal number of a format.
fn least(scalar: Scalar) -> f64 {
    match scalar {
        Scalar::F16 => Half::MIN_NORMAL,
        Scalar::F64 => Double::MIN_NORMAL,
        _ => Single::MIN_NORMAL,
    }
}

/// An f64 that is not above an integer and one that is not below it; `near` is the nearest.
fn around(whole: i128, near: f64) -> (f64, f64) {
    if near as i128 == whole { (near, near) } else { (near.next_down(), near.next_up()) }
}

impl<P: Precision> Shadow<P> {
    /// A float of another format.
    pub(super) fn reformatted(&self, a: Float, from: Scalar) -> Float {
        let value = P::held(a.value);
        if !a.bounded() {
            return Float::unbounded(value, a.exact);
        }
        // A number that is subnormal there may be flushed on its way.
        let flushed = if a.is_below(least(from)) { least(from) } else { 0.0 };
        if from.bytes() < P::SCALAR.bytes() {
            let wider = Float::closed::<P>(value, a.exact, a.low, a.high);
            return self.link(wider, flushed, only(a, Slope::ONE));
        }
        let narrower = Float::closed::<P>(value, a.exact, P::down(a.low), P::up(a.high));
        self.link(narrower, rounded::<P>(narrower, [a, a]) + flushed, only(a, Slope::ONE))
    }

    /// The integer nearest to a float, towards zero.
    pub(super) fn truncated(&self, a: Float, to: Scalar) -> Word {
        let number = |x: f64| convert::truncated(x, P::DIGITS, to);
        let known = a.bounded() && number(a.low) == number(a.high);
        Word { value: number(a.value), exact: number(a.exact), known }
    }

    /// The float that an integer is.
    pub(super) fn of_integer(&self, a: Word, from: Scalar) -> Float {
        let whole = integer::number(a.exact, from);
        let (value, exact) = (P::of_integer(integer::number(a.value, from)), whole as f64);
        if a.known {
            let (low, high) = around(whole, exact);
            self.source(Float::closed::<P>(value, exact, P::down(low), P::up(high)))
        } else {
            Float::unbounded(value, exact)
        }
    }
}
