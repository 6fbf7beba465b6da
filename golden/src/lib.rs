//! Images judged against a true value with a per-pixel permitted error.
//!
//! A golden image here is not what some driver once drew: it is the f64 value of the picture, and beside
//! it, for each value, how far a legal driver's result may lie from it.
//! So one golden serves every route, and changes only when the mathematics does.
//!
//! This crate knows no shaders: it takes numbers.
//!
//! ```
//! use lobe_golden::{Golden, judge};
//!
//! // Two pixels of one channel, the second in a shadow whose edge rounding may move.
//! let golden = Golden { stride: 2, truth: vec![0.25, 0.5], permitted: vec![1e-6, 0.1] };
//! let verdict = judge(&golden, &[0.250_000_5, 0.58])?;
//! assert!(verdict.passes());
//! assert_eq!(verdict.worst.place, 1);
//! # Ok::<(), lobe_golden::GoldenError>(())
//! ```

/// The true picture and its permitted error.
#[derive(Debug, Clone, PartialEq)]
pub struct Golden {
    /// Values a row: width times channels.
    pub stride: usize,
    /// True values, row by row.
    pub truth: Vec<f64>,
    /// Permitted distance from the truth, one for each value.
    pub permitted: Vec<f64>,
}

/// Why a picture cannot be judged.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GoldenError {
    /// The picture has another size than the golden.
    #[error("the picture has {found} values, the golden {expected}: render it in the golden's size")]
    Size {
        /// Values of the golden.
        expected: usize,
        /// Values of the picture.
        found: usize,
    },
    /// The golden itself is not whole.
    #[error(
        "the golden has {truth} true values and {permitted} permitted errors: it is damaged, write it anew"
    )]
    Damaged {
        /// True values.
        truth: usize,
        /// Permitted errors.
        permitted: usize,
    },
    /// The golden has no values, so that everything would pass.
    #[error("the golden is empty: it cannot judge anything")]
    Empty,
}

/// How a picture stands against its golden.
#[derive(Debug, Clone, PartialEq)]
pub struct Verdict {
    /// Values outside their permitted error.
    pub outside: usize,
    /// The value that uses the largest share of its permitted error.
    pub worst: Worst,
}

/// A value of a picture and how it stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Worst {
    /// Row of the picture.
    pub row: usize,
    /// Place in the row: column times channels plus channel.
    pub place: usize,
    /// Its distance from the truth over the permitted one; infinite for NaN, or where none is permitted.
    pub share: f64,
}

impl Verdict {
    /// Whether every value is within its permitted error.
    pub fn passes(&self) -> bool {
        self.outside == 0
    }
}

/// Judges a picture.
///
/// # Errors
/// When sizes differ or the golden is empty: a comparison that cannot be made never passes.
///
/// ```
/// use lobe_golden::{Golden, judge};
///
/// let golden = Golden { stride: 2, truth: vec![0.5, 1.0], permitted: vec![1e-3, 0.0] };
/// assert!(judge(&golden, &[0.5004, 1.0])?.passes());
/// assert!(!judge(&golden, &[0.502, 1.0])?.passes());
/// # Ok::<(), lobe_golden::GoldenError>(())
/// ```
pub fn judge(golden: &Golden, picture: &[f32]) -> Result<Verdict, GoldenError> {
    let (truth, permitted) = (golden.truth.len(), golden.permitted.len());
    if truth != permitted {
        return Err(GoldenError::Damaged { truth, permitted });
    }
    if truth == 0 || golden.stride == 0 {
        return Err(GoldenError::Empty);
    }
    if picture.len() != truth {
        return Err(GoldenError::Size { expected: truth, found: picture.len() });
    }
    let shares = golden.truth.iter().zip(&golden.permitted).zip(picture).map(|((t, p), v)| share(*t, *p, *v));
    let mut verdict = Verdict { outside: 0, worst: Worst { row: 0, place: 0, share: 0.0 } };
    for (i, share) in shares.enumerate() {
        verdict.outside += usize::from(share > 1.0);
        if share > verdict.worst.share {
            verdict.worst = Worst { row: i / golden.stride, place: i % golden.stride, share };
        }
    }
    Ok(verdict)
}

/// Distance from the truth over the permitted one.
fn share(truth: f64, permitted: f64, value: f32) -> f64 {
    let distance = (f64::from(value) - truth).abs();
    if distance == 0.0 {
        return 0.0;
    }
    let share = distance / permitted;
    if share.is_nan() { f64::INFINITY } else { share }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn golden() -> Golden {
        Golden { stride: 2, truth: vec![0.0, 1.0, 2.0, 3.0], permitted: vec![0.0, 0.1, 0.1, 0.5] }
    }

    #[test]
    fn the_worst_value_is_named() {
        let verdict = judge(&golden(), &[0.0, 1.05, 2.09, 3.1]).unwrap();
        assert!(verdict.passes());
        assert_eq!((verdict.worst.row, verdict.worst.place), (1, 0));
    }

    #[test]
    fn what_no_error_is_permitted_for_must_be_met() {
        assert!(!judge(&golden(), &[1e-30, 1.0, 2.0, 3.0]).unwrap().passes());
    }

    #[test]
    fn nan_never_passes() {
        assert_eq!(judge(&golden(), &[0.0, f32::NAN, 2.0, 3.0]).unwrap().outside, 1);
    }

    #[test]
    fn a_comparison_that_cannot_be_made_is_an_error() {
        assert_eq!(judge(&golden(), &[0.0]), Err(GoldenError::Size { expected: 4, found: 1 }));
        let empty = Golden { stride: 1, truth: vec![], permitted: vec![] };
        assert_eq!(judge(&empty, &[]), Err(GoldenError::Empty));
        let damaged = Golden { permitted: vec![], ..golden() };
        assert!(matches!(judge(&damaged, &[0.0; 4]), Err(GoldenError::Damaged { .. })));
    }
}
