//! The row at which something is worst, kept so that it can be run again.

use crate::value::{Floats, args_json};
use lobe_codegen::def::FunctionDef;
use serde_json::Value;

/// A row, replayable with `lobe eval`.
#[derive(Clone, Debug, serde::Serialize, serde::Deserialize)]
pub struct Worst {
    /// The arguments, floats in hexadecimal.
    pub args: Value,
    /// The scalar of the result; empty for a result of one scalar.
    pub leaf: String,
    /// The value found.
    #[serde(with = "float")]
    pub found: f64,
    /// The value wanted.
    #[serde(with = "float")]
    pub wanted: f64,
    /// The permitted distance.
    #[serde(with = "float")]
    pub permitted: f64,
    /// The command that runs it again, where that is not `lobe eval`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub again: Option<String>,
}

/// Collects the extremes over rows.
#[derive(Clone, Debug, Default)]
pub struct Extreme {
    /// Largest share of the permitted.
    pub share: f64,
    /// Largest absolute error.
    pub absolute: f64,
    /// Largest relative error, where the wanted value is a normal f32.
    pub relative: f64,
    /// Largest error in ULP, likewise.
    pub ulp: f64,
    /// Row of the largest share.
    pub worst: Option<Worst>,
}

/// One comparison.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// The value found.
    pub found: f64,
    /// The value wanted.
    pub wanted: f64,
    /// Its distance.
    pub error: f64,
    /// The permitted distance.
    pub permitted: f64,
}

impl Sample {
    /// The error as a share of what is permitted: 0 for none, infinite for one where none is.
    #[must_use]
    pub fn share(&self) -> f64 {
        if self.error == 0.0 {
            0.0
        } else if self.error.is_nan() || self.permitted.is_nan() {
            f64::INFINITY
        } else {
            self.error / self.permitted.max(0.0)
        }
    }
}

impl Extreme {
    /// Takes a comparison, and returns whether the error is permitted; `worst` describes its row.
    pub fn take(&mut self, sample: Sample, worst: impl FnOnce() -> Worst) -> bool {
        let share = sample.share();
        self.absolute = self.absolute.max(sample.error);
        if sample.wanted.abs() >= f64::from(f32::MIN_POSITIVE) {
            self.relative = self.relative.max(sample.error / sample.wanted.abs());
            self.ulp = self.ulp.max(sample.error / ulp(sample.wanted));
        }
        if share > self.share || self.worst.is_none() {
            self.share = self.share.max(share);
            self.worst = Some(worst());
        }
        share <= 1.0
    }
}

impl Worst {
    /// The row `words` of `kernel`'s arguments, with what was compared there at scalar `leaf` of the result.
    #[must_use]
    pub fn at(kernel: &FunctionDef, words: &[u32], leaf: &str, sample: Sample) -> Self {
        Self {
            args: args_json(kernel, words, Floats::Hex),
            leaf: leaf.to_owned(),
            found: sample.found,
            wanted: sample.wanted,
            permitted: sample.permitted,
            again: None,
        }
    }
}

/// The distance between the f32 values around `value`.
#[must_use]
pub fn ulp(value: f64) -> f64 {
    let magnitude = value.abs().clamp(f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX));
    let exponent = (magnitude.to_bits() >> 52) as i32 - 1023;
    2f64.powi(exponent - 23)
}

/// JSON has no infinities and no NaN: they are written as strings.
pub(crate) mod float {
    use serde::de::Error;
    use serde::{Deserialize, Deserializer, Serializer};

    /// A float as JSON has it.
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Written {
        Number(f64),
        Word(String),
    }

    pub(crate) fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        if value.is_finite() {
            serializer.serialize_f64(*value)
        } else {
            serializer.serialize_str(&value.to_string().to_lowercase())
        }
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        match Written::deserialize(deserializer)? {
            Written::Number(value) => Ok(value),
            Written::Word(word) => {
                word.parse().map_err(|_| D::Error::custom(format!("`{word}` is no float")))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ulp_is_that_of_f32() {
        assert_eq!(ulp(1.0), f64::from(f32::EPSILON));
        assert_eq!(ulp(0.0), f64::from(f32::from_bits(1)));
        assert_eq!(ulp(-3.9), 2.0 * f64::from(f32::EPSILON));
    }

    #[test]
    fn no_error_is_always_permitted_and_nan_never() {
        let sample = |error, permitted| Sample { found: 0.0, wanted: 0.0, error, permitted }.share();
        assert_eq!(sample(0.0, 0.0), 0.0);
        assert_eq!(sample(1e-300, 0.0), f64::INFINITY);
        assert_eq!(sample(f64::NAN, 1.0), f64::INFINITY);
        assert_eq!(sample(1.0, f64::NAN), f64::INFINITY);
        assert_eq!(sample(1.0, -1.0), f64::INFINITY);
        assert_eq!(sample(1.0, 2.0), 0.5);
    }
}
