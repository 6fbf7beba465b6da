//! One scalar in a buffer: of any width, as JSON, as text, and how far from another.

use crate::value::{format_hex, format_hex_f64, parse_hex};
use half::f16;
use naga::{Scalar, ScalarKind};
use serde_json::{Number, Value};

/// Bits of a scalar, in the low end.
fn bits(bytes: &[u8]) -> u64 {
    let mut wide = [0; 8];
    wide.iter_mut().zip(bytes).for_each(|(to, from)| *to = *from);
    u64::from_le_bytes(wide)
}

/// Whether a scalar is a float.
#[must_use]
pub fn is_float(scalar: Scalar) -> bool {
    scalar.kind == ScalarKind::Float
}

/// The value of a float.
#[must_use]
pub fn float(width: u8, bytes: &[u8]) -> f64 {
    let bits = bits(bytes);
    match width {
        2 => f16::from_bits(bits as u16).to_f64(),
        4 => f32::from_bits(bits as u32).into(),
        _ => f64::from_bits(bits),
    }
}

/// The bytes of a float that is rounded to its width.
#[must_use]
pub fn float_bytes(width: u8, value: f64) -> Vec<u8> {
    match width {
        2 => f16::from_f64(value).to_le_bytes().to_vec(),
        4 => (value as f32).to_le_bytes().to_vec(),
        _ => value.to_le_bytes().to_vec(),
    }
}

/// The value of an integer, or of a boolean.
#[must_use]
pub fn integer(scalar: Scalar, bytes: &[u8]) -> i128 {
    let (bits, unused) = (bits(bytes), 64 - 8 * u32::from(scalar.width.clamp(1, 8)));
    match scalar.kind {
        ScalarKind::Sint => ((bits << unused) as i64 >> unused).into(),
        _ => bits.into(),
    }
}

/// Floats between `a` and `b`, counting one of them; the distance that ULPs are counted in.
#[must_use]
pub fn ulps(width: u8, a: &[u8], b: &[u8]) -> u64 {
    // Negative floats run downwards, so that neighbours are neighbours across zero.
    let place = |bytes: &[u8]| {
        let (bits, sign) = (i128::from(bits(bytes)), 1 << (8 * u32::from(width) - 1));
        if bits >= sign { sign - bits } else { bits }
    };
    (place(a) - place(b)).unsigned_abs() as u64
}

/// A scalar as text: floats in hexadecimal, which loses nothing.
#[must_use]
pub fn text(scalar: Scalar, bytes: &[u8]) -> String {
    match (scalar.kind, scalar.width) {
        (ScalarKind::Float, 8) => format_hex_f64(float(8, bytes)),
        (ScalarKind::Float, width) => format_hex(float(width, bytes) as f32),
        _ => integer(scalar, bytes).to_string(),
    }
}

/// A scalar as JSON: floats in the shortest form that reads back the same; NaN and infinities are strings.
#[must_use]
pub fn to_json(scalar: Scalar, bytes: &[u8]) -> Value {
    if !is_float(scalar) {
        let value = integer(scalar, bytes);
        return i64::try_from(value).map_or_else(|_| Value::from(value as u64), Value::from);
    }
    let value = float(scalar.width, bytes);
    let shortest = if scalar.width == 8 { format!("{value:e}") } else { format!("{:e}", value as f32) };
    match shortest.parse().ok().and_then(Number::from_f64) {
        Some(number) => Value::Number(number),
        None => Value::String(text(scalar, bytes)),
    }
}

/// The bytes of the scalar that `value` states; `None` if it is not one of this kind.
#[must_use]
pub fn from_json(scalar: Scalar, value: &Value) -> Option<Vec<u8>> {
    let width = usize::from(scalar.width);
    if is_float(scalar) {
        let float = match value {
            Value::Number(number) => number.as_f64()?,
            Value::String(text) => parse_hex(&text.to_ascii_lowercase())?,
            Value::Null | Value::Bool(_) | Value::Array(_) | Value::Object(_) => return None,
        };
        return Some(float_bytes(scalar.width, float));
    }
    let integer = match value {
        Value::Bool(value) => i128::from(*value),
        Value::Number(number) => {
            number.as_i64().map(i128::from).or_else(|| number.as_u64().map(i128::from))?
        }
        Value::Null | Value::String(_) | Value::Array(_) | Value::Object(_) => return None,
    };
    let bits = 8 * u32::from(scalar.width);
    let (least, most) = match scalar.kind {
        ScalarKind::Sint => (-(1_i128 << (bits - 1)), (1 << (bits - 1)) - 1),
        _ => (0, (1 << bits) - 1),
    };
    (least..=most).contains(&integer).then(|| integer.to_le_bytes()[..width].to_vec())
}

/// What JSON a scalar may be.
#[must_use]
pub fn wanted(scalar: Scalar) -> String {
    let bits = 8 * u32::from(scalar.width);
    match scalar.kind {
        ScalarKind::Float => "a number (or a string as \"0x1.8p3\", \"nan\", \"inf\")".to_owned(),
        ScalarKind::Sint => format!("an integer of {bits} bits"),
        _ => format!("a non-negative integer of {bits} bits"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scalars_come_back_from_json_as_they_went() {
        let scalars =
            [Scalar::F32, Scalar::F16, Scalar::F64, Scalar::I32, Scalar::U32, Scalar::I64, Scalar::U64];
        for scalar in scalars {
            for bits in
                [0_u64, 1, 0x3c00, 0x7bff, 0x7c00, 0x3f80_0001, u64::MAX, 1 << 63, 0x7ff0_0000_0000_0000]
            {
                let bytes = bits.to_le_bytes()[..usize::from(scalar.width)].to_vec();
                let json = to_json(scalar, &bytes);
                let back = from_json(scalar, &json).unwrap_or_else(|| panic!("{scalar:?} {json}"));
                let is_nan = is_float(scalar) && float(scalar.width, &bytes).is_nan();
                assert!(back == bytes || is_nan && float(scalar.width, &back).is_nan(), "{scalar:?} {json}");
            }
        }
    }

    #[test]
    fn integers_that_do_not_fit_are_refused() {
        for (scalar, json) in [
            (Scalar::U32, Value::from(-1)),
            (Scalar::U32, Value::from(1_u64 << 32)),
            (Scalar::I32, Value::from(1_u64 << 31)),
            (Scalar::I32, Value::from(0.5)),
            (Scalar::F32, Value::from("one")),
        ] {
            assert_eq!(from_json(scalar, &json), None, "{json}");
        }
    }

    #[test]
    fn ulps_count_across_zero() {
        let of = |a: f32, b: f32| ulps(4, &a.to_le_bytes(), &b.to_le_bytes());
        assert_eq!(of(1.0, 1.0), 0);
        assert_eq!(of(1.0, 1.0_f32.next_up()), 1);
        assert_eq!(of(0.0, -0.0), 0);
        assert_eq!(of(f32::from_bits(1), -f32::from_bits(1)), 2);
        assert_eq!(ulps(8, &1_f64.to_le_bytes(), &2_f64.to_le_bytes()), 1 << 52);
    }
}
