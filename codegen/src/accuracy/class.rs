//! The classes of accuracy.

use std::fmt;

/// The smallest normal `f32`, `2^-126`, and the smallest normal `f16`, `2^-14`.
pub(super) const MIN_NORMAL: f64 = f32::MIN_POSITIVE as f64;
pub(super) const MIN_NORMAL_16: f64 = 1.0 / 16384.0;
/// `2^126` and `2^14`: the reciprocals of larger numbers are subnormal.
pub(super) const MAX_DIVISOR: f64 = 1.0 / MIN_NORMAL;
pub(super) const MAX_DIVISOR_16: f64 = 1.0 / MIN_NORMAL_16;
pub(super) const TWO_TO_MINUS_7: f64 = 1.0 / 128.0;
pub(super) const TWO_TO_MINUS_11: f64 = 1.0 / 2048.0;
pub(super) const TWO_TO_MINUS_21: f64 = 1.0 / 2_097_152.0;

/// The other formula of `mix`.
pub const LERP: &str = "x + z * (y - x)";

/// How far a driver's result may lie from the exact one.
///
/// One ULP is taken as `2^-23` of the result's magnitude (`2^-10` in `f16`), which no representable value exceeds.
/// Beside its class, every float operation may flush subnormal operands and results to zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// The result is representable, and that one is returned.
    Exact,
    /// One of the two floats that enclose the exact result.
    Correct,
    /// So many ULP.
    Ulp(f64),
    /// `base + slope·|x|` ULP, `x` being the argument.
    UlpScaled {
        /// At 0.
        base: f64,
        /// Growth.
        slope: f64,
    },
    /// So many ULP while the magnitude of the second argument of the formula lies in `from..=to`, no promise elsewhere.
    UlpWhere {
        /// Within the range.
        ulp: f64,
        /// Begin of the range.
        from: f64,
        /// End of the range.
        to: f64,
    },
    /// An absolute error for arguments in `from..=to`, so many ULP elsewhere.
    UlpOrAbsolute {
        /// Elsewhere.
        ulp: f64,
        /// Within the range.
        absolute: f64,
        /// Begin of the range.
        from: f64,
        /// End of the range.
        to: f64,
    },
    /// An absolute error.
    Absolute(f64),
    /// An absolute error for arguments in `from..=to`, no promise elsewhere.
    AbsoluteOn {
        /// Within the range.
        absolute: f64,
        /// Begin of the range.
        from: f64,
        /// End of the range.
        to: f64,
    },
    /// As accurate as this formula of other operations.
    Inherited(&'static str),
    /// The specification promises nothing.
    Nothing,
}

impl Accuracy {
    /// Whether whoever keeps `other` keeps this one; `false` where that is not known.
    pub fn covers(self, other: Self) -> bool {
        use Accuracy::{
            Absolute, AbsoluteOn, Correct, Exact, Nothing, Ulp, UlpOrAbsolute, UlpScaled, UlpWhere,
        };
        if self == other || self == Nothing || other == Exact {
            return true;
        }
        match (self, other) {
            (Ulp(a) | UlpScaled { base: a, .. } | UlpWhere { ulp: a, .. }, Correct) => a >= 1.0,
            (Ulp(a) | UlpScaled { base: a, .. } | UlpWhere { ulp: a, .. }, Ulp(b)) => a >= b,
            (UlpScaled { base: a, slope: m }, UlpScaled { base: b, slope: n }) => a >= b && m >= n,
            (UlpWhere { ulp: a, from, to }, UlpWhere { ulp: b, from: low, to: high }) => {
                a >= b && low <= from && to <= high
            }
            (
                UlpOrAbsolute { ulp: a, absolute: d, from, to },
                UlpOrAbsolute { ulp: b, absolute: e, from: low, to: high },
            ) => a >= b && d >= e && low == from && to == high,
            (Absolute(a) | AbsoluteOn { absolute: a, .. }, Absolute(b)) => a >= b,
            (AbsoluteOn { absolute: a, from, to }, AbsoluteOn { absolute: b, from: low, to: high }) => {
                a >= b && low <= from && to <= high
            }
            _ => false,
        }
    }
}

impl fmt::Display for Accuracy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact => f.write_str("exact"),
            Self::Correct => f.write_str("correctly rounded"),
            Self::Ulp(n) => write!(f, "{n} ULP"),
            Self::UlpScaled { base, slope } => write!(f, "{base} + {slope} |x| ULP"),
            Self::UlpWhere { ulp, from, to } => {
                write!(f, "{ulp} ULP for a second argument of {from:e} ..= {to:e}")
            }
            Self::UlpOrAbsolute { ulp, absolute, from, to } => {
                write!(f, "absolute {absolute:e} on {from} ..= {to}, {ulp} ULP elsewhere")
            }
            Self::Absolute(error) => write!(f, "absolute {error:e}"),
            Self::AbsoluteOn { absolute, from, to } => {
                write!(f, "absolute {absolute:e} on {from} ..= {to}")
            }
            Self::Inherited(formula) => write!(f, "as {formula}"),
            Self::Nothing => f.write_str("no promise"),
        }
    }
}
