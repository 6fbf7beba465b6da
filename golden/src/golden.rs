//! The true picture with its permitted error, and what it says of others.

use crate::verdict::{Pixels, Verdict, Worst};

/// Pixels of a golden, at most.
pub(crate) const MOST_PIXELS: usize = 1 << 20;

/// A true picture and its permitted error: RGB, row by row from the top.
///
/// The truth is rounded to f32; the permitted error has that rounding in it, so that it is the one around the f32.
/// Where nothing is promised it is infinite.
#[derive(Debug, Clone, PartialEq)]
pub struct Golden {
    size: [u32; 2],
    truth: Vec<f32>,
    permitted: Vec<f32>,
    /// Pixels of which a channel has no bound.
    unbounded: usize,
}

/// Why there is no golden of these numbers, or a picture cannot be judged by it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GoldenError {
    /// The picture has another size than the golden.
    #[error("the picture is {} x {} with {values} values, the golden {} x {}: render it in the golden's size", found[0], found[1], expected[0], expected[1])]
    Size {
        /// Columns and rows of the golden.
        expected: [u32; 2],
        /// Of the picture.
        found: [u32; 2],
        /// Values of the picture.
        values: usize,
    },
    /// The numbers do not make a golden.
    #[error("{} x {} pixels need {expected} values each, but there are {truth} true ones and {permitted} permitted errors", size[0], size[1])]
    Count {
        /// Columns and rows.
        size: [u32; 2],
        /// Values that they need.
        expected: usize,
        /// True values.
        truth: usize,
        /// Permitted errors.
        permitted: usize,
    },
    /// No pixels, so that everything would pass, or too many.
    #[error("a golden has 1 to {MOST_PIXELS} pixels, not {} x {}", size[0], size[1])]
    Pixels {
        /// Columns and rows.
        size: [u32; 2],
    },
    /// A true value is none, or a permitted error is.
    #[error(
        "value {at} is {truth} within {permitted}: a true value is finite, a permitted error not negative"
    )]
    Value {
        /// Which one.
        at: usize,
        /// The true value, as text.
        truth: String,
        /// The permitted error.
        permitted: String,
    },
}

impl Golden {
    /// The golden of true values and the permitted distances from them, three for each pixel. A value that is not finite
    /// has no bound, and counts as 0.
    ///
    /// # Errors
    /// When there are not three for each pixel, or a bounded value's permitted error is NaN or negative.
    pub fn new(size: [u32; 2], truth: &[f64], permitted: &[f64]) -> Result<Self, GoldenError> {
        let pairs = truth.iter().zip(permitted);
        let rounded = pairs.map(|(truth, permitted)| match rounded(*truth) {
            Some(near) => (near, up(permitted + (f64::from(near) - truth).abs())),
            None => (0.0, f32::INFINITY),
        });
        let (near, around): (Vec<f32>, Vec<f32>) = rounded.unzip();
        if truth.len() != permitted.len() {
            let expected = values(size).unwrap_or_default();
            return Err(GoldenError::Count {
                size,
                expected,
                truth: truth.len(),
                permitted: permitted.len(),
            });
        }
        Self::of_floats(size, near, around)
    }

    /// The golden of what [`Golden::truth`] and [`Golden::permitted`] return.
    ///
    /// # Errors
    /// When there are not three for each pixel, or a value or its permitted error is none.
    pub fn of_floats(size: [u32; 2], truth: Vec<f32>, permitted: Vec<f32>) -> Result<Self, GoldenError> {
        let expected = values(size).ok_or(GoldenError::Pixels { size })?;
        if truth.len() != expected || permitted.len() != expected {
            return Err(GoldenError::Count {
                size,
                expected,
                truth: truth.len(),
                permitted: permitted.len(),
            });
        }
        // Written so that NaN is none.
        let is_sound = |(truth, permitted): (&f32, &f32)| truth.is_finite() && *permitted >= 0.0;
        if let Some(at) = truth.iter().zip(&permitted).position(|pair| !is_sound(pair)) {
            let [truth, permitted] = [truth[at], permitted[at]].map(|value| value.to_string());
            return Err(GoldenError::Value { at, truth, permitted });
        }
        let unbounded = permitted.as_chunks::<3>().0.iter().filter(|p| p.contains(&f32::INFINITY)).count();
        Ok(Self { size, truth, permitted, unbounded })
    }

    /// Columns and rows.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The true values, nearest f32.
    #[must_use]
    pub fn truth(&self) -> &[f32] {
        &self.truth
    }

    /// The permitted distance from them.
    #[must_use]
    pub fn permitted(&self) -> &[f32] {
        &self.permitted
    }

    /// Pixels of which a channel has no bound.
    #[must_use]
    pub fn unbounded(&self) -> usize {
        self.unbounded
    }

    /// Judges a picture.
    ///
    /// # Errors
    /// When sizes differ: a comparison that cannot be made never passes.
    pub fn judge(&self, size: [u32; 2], picture: &[f32]) -> Result<Verdict, GoldenError> {
        if size != self.size || picture.len() != self.truth.len() {
            return Err(GoldenError::Size { expected: self.size, found: size, values: picture.len() });
        }
        if is_equal(picture, &self.truth) {
            return Ok(self.verdict_of_equal());
        }
        let mut verdict = Verdict { pixels: Pixels::default(), worst: None, shares: [0.0; 4] };
        let mut shares = Vec::with_capacity(picture.len() / 3);
        for (at, found) in picture.as_chunks::<3>().0.iter().enumerate() {
            shares.extend(self.take(at, found, &mut verdict));
        }
        verdict.shares = quantiles(shares);
        Ok(verdict)
    }

    /// Judges a pixel; returns the largest share of its permitted errors, if it has them all.
    fn take(&self, at: usize, found: &[f32; 3], verdict: &mut Verdict) -> Option<f64> {
        let mut most: f64 = 0.0;
        let (mut is_bounded, mut is_equal) = (true, true);
        for (channel, found) in found.iter().enumerate() {
            let (truth, permitted) = (self.truth[3 * at + channel], self.permitted[3 * at + channel]);
            is_equal &= truth.to_bits() == found.to_bits();
            if permitted == f32::INFINITY {
                is_bounded = false;
                continue;
            }
            let share = share(truth, permitted, *found);
            most = most.max(share);
            if verdict.worst.is_none_or(|worst| share > worst.share) {
                let (x, y) = (at % self.size[0] as usize, at / self.size[0] as usize);
                verdict.worst = Some(Worst { x, y, channel, found: *found, truth, permitted, share });
            }
        }
        let pixels = &mut verdict.pixels;
        pixels.equal += usize::from(is_equal);
        *match (most <= 1.0, is_bounded) {
            (false, _) => &mut pixels.outside,
            (true, false) => &mut pixels.indeterminate,
            (true, true) => &mut pixels.inside,
        } += 1;
        is_bounded.then_some(most)
    }

    fn verdict_of_equal(&self) -> Verdict {
        let equal = self.truth.len() / 3;
        let pixels =
            Pixels { inside: equal - self.unbounded, outside: 0, indeterminate: self.unbounded, equal };
        let first = self.permitted.iter().position(|permitted| *permitted < f32::INFINITY);
        let worst = first.map(|at| {
            let (pixel, channel) = (at / 3, at % 3);
            let (x, y) = (pixel % self.size[0] as usize, pixel / self.size[0] as usize);
            let truth = self.truth[at];
            Worst { x, y, channel, found: truth, truth, permitted: self.permitted[at], share: 0.0 }
        });
        Verdict { pixels, worst, shares: [0.0; 4] }
    }

    /// How many f32 numbers each true value is from that of `other`, of the same size: how many differ, the furthest, and how
    /// many are beyond what `self` permits.
    ///
    /// # Errors
    /// When sizes differ.
    pub fn distance(&self, other: &Self) -> Result<Distance, GoldenError> {
        if self.size != other.size {
            let values = other.truth.len();
            return Err(GoldenError::Size { expected: self.size, found: other.size, values });
        }
        let mut distance = Distance::default();
        for ((ours, theirs), permitted) in self.truth.iter().zip(&other.truth).zip(&self.permitted) {
            distance.differing += usize::from(ours.to_bits() != theirs.to_bits());
            distance.furthest = distance.furthest.max(ordinal(*ours).abs_diff(ordinal(*theirs)));
            distance.beyond += usize::from(share(*ours, *permitted, *theirs) > 1.0);
        }
        Ok(distance)
    }
}

/// How far two truths are from each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Distance {
    /// Values that differ.
    pub differing: usize,
    /// The f32 numbers between the two that are furthest from each other.
    pub furthest: u32,
    /// Values that differ by more than is permitted.
    pub beyond: usize,
}

/// The place of a float among all.
fn ordinal(x: f32) -> i32 {
    let bits = x.to_bits() as i32;
    if bits < 0 { i32::MIN.wrapping_sub(bits) } else { bits }
}

/// Three for each pixel, if these are of a golden's number.
fn values(size: [u32; 2]) -> Option<usize> {
    let pixels = (size[0] as usize).checked_mul(size[1] as usize)?;
    (1..=MOST_PIXELS).contains(&pixels).then_some(3 * pixels)
}

/// The nearest f32, if there is one.
fn rounded(x: f64) -> Option<f32> {
    let near = x as f32;
    near.is_finite().then_some(near)
}

/// The least f32 that is not below.
fn up(x: f64) -> f32 {
    let near = x as f32;
    if f64::from(near) < x { near.next_up() } else { near }
}

/// Bit for bit; written so that it becomes vector instructions.
fn is_equal(a: &[f32], b: &[f32]) -> bool {
    let differs =
        |a: &[f32], b: &[f32]| a.iter().zip(b).fold(0, |all, (a, b)| all | (a.to_bits() ^ b.to_bits())) != 0;
    a.chunks(1024).zip(b.chunks(1024)).all(|(a, b)| !differs(a, b))
}

/// Distance from the truth over the permitted one.
fn share(truth: f32, permitted: f32, found: f32) -> f64 {
    let distance = (f64::from(found) - f64::from(truth)).abs();
    if distance == 0.0 {
        return 0.0;
    }
    let share = distance / f64::from(permitted);
    if share.is_nan() { f64::INFINITY } else { share }
}

/// What half, 99 %, 99.9 % and all stay within.
fn quantiles(mut shares: Vec<f64>) -> [f64; 4] {
    shares.sort_unstable_by(f64::total_cmp);
    [0.5, 0.99, 0.999, 1.0].map(|part| {
        let at = (part * shares.len() as f64).ceil() as usize;
        shares.get(at.saturating_sub(1)).copied().unwrap_or(0.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn golden() -> Golden {
        let permitted = [0.0, 0.1, 0.1, f64::INFINITY, 0.5, 0.5];
        Golden::new([2, 1], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], &permitted).unwrap()
    }

    #[test]
    fn the_worst_value_is_named() {
        let verdict = golden().judge([2, 1], &[0.0, 1.05, 2.09, 9.0, 4.4, 5.0]).unwrap();
        assert!(verdict.passes());
        let worst = verdict.worst.unwrap();
        assert_eq!((worst.x, worst.y, worst.channel), (0, 0, 2));
        assert_eq!(verdict.pixels, Pixels { inside: 1, outside: 0, indeterminate: 1, equal: 0 });
    }

    #[test]
    fn what_no_error_is_permitted_for_must_be_met() {
        let verdict = golden().judge([2, 1], &[1e-30, 1.0, 2.0, 3.0, 4.0, 5.0]).unwrap();
        assert_eq!((verdict.pixels.outside, verdict.pixels.equal), (1, 1));
    }

    #[test]
    fn nan_never_passes_where_there_is_a_bound() {
        let with = |at: usize| {
            let mut picture = golden().truth().to_vec();
            picture[at] = f32::NAN;
            golden().judge([2, 1], &picture).unwrap().pixels
        };
        assert_eq!(with(1).outside, 1);
        assert_eq!(with(4).outside, 1);
        assert_eq!((with(3).outside, with(3).indeterminate), (0, 1));
    }

    #[test]
    fn the_fast_way_says_what_the_slow_one_does() {
        let golden = golden();
        let equal = golden.judge([2, 1], golden.truth()).unwrap();
        assert_eq!(equal.pixels, Pixels { inside: 1, outside: 0, indeterminate: 1, equal: 2 });
        // 0 and -0 are equal numbers and other bits.
        let mut other = golden.truth().to_vec();
        other[0] = -0.0;
        let slow = golden.judge([2, 1], &other).unwrap();
        assert_eq!(Pixels { equal: 2, ..slow.pixels }, equal.pixels);
    }

    #[test]
    fn rounding_of_the_truth_is_permitted() {
        let golden = Golden::new([1, 1], &[0.1; 3], &[1e-12; 3]).unwrap();
        let permitted = f64::from(golden.permitted()[0]);
        let least = (f64::from(0.1_f32) - 0.1).abs() + 1e-12;
        assert!(permitted >= least && permitted < 1.000_001 * least);
    }

    #[test]
    fn a_comparison_that_cannot_be_made_is_an_error() {
        assert!(matches!(golden().judge([2, 1], &[0.0]), Err(GoldenError::Size { .. })));
        assert!(matches!(golden().judge([1, 2], golden().truth()), Err(GoldenError::Size { .. })));
        assert!(matches!(Golden::new([0, 1], &[], &[]), Err(GoldenError::Pixels { .. })));
        assert!(matches!(Golden::new([u32::MAX, u32::MAX], &[], &[]), Err(GoldenError::Pixels { .. })));
        assert!(matches!(Golden::new([1, 1], &[0.0; 3], &[0.0; 2]), Err(GoldenError::Count { .. })));
        assert!(matches!(Golden::new([1, 1], &[0.0; 3], &[-1.0; 3]), Err(GoldenError::Value { .. })));
        assert!(matches!(Golden::new([1, 1], &[0.0; 3], &[f64::NAN; 3]), Err(GoldenError::Value { .. })));
    }

    #[test]
    fn what_is_no_number_has_no_bound() {
        let golden = Golden::new([1, 1], &[f64::NAN, 1e300, 1.0], &[0.0; 3]).unwrap();
        assert_eq!((golden.unbounded(), golden.permitted()[0]), (1, f32::INFINITY));
        assert_eq!(golden.permitted()[1], f32::INFINITY);
    }

    #[test]
    fn truths_are_told_apart_to_the_last_bit() {
        let other = Golden::new([2, 1], &[0.0, 1.0 + 1.2e-7, 2.0, 3.0, 4.0, 5.6], &[0.0; 6]).unwrap();
        let distance = golden().distance(&other).unwrap();
        assert_eq!((distance.differing, distance.beyond), (2, 1));
        assert!(distance.furthest > 1_000_000);
        assert_eq!(golden().distance(&golden()).unwrap(), Distance::default());
        assert_eq!(ordinal(-0.0).abs_diff(ordinal(f32::from_bits(1))), 1);
    }
}
