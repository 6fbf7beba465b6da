//! Hexadecimal floats, which lose nothing and show the bits: `0x1.8p3` is 12.

/// `value` as a C99 hexadecimal float, without trailing zeros.
#[must_use]
pub fn format_hex(value: f32) -> String {
    if value.is_subnormal() {
        // As the hardware has it, with the exponent of the smallest normal number.
        return digits(value.is_sign_negative(), 0, u64::from(value.to_bits() & 0x007f_ffff) << 29, -126);
    }
    format_hex_f64(value.into())
}

/// The same of an `f64`.
#[must_use]
pub fn format_hex_f64(value: f64) -> String {
    let is_negative = value.is_sign_negative();
    if value.is_nan() {
        return "nan".to_owned();
    }
    if value.is_infinite() {
        return if is_negative { "-inf".to_owned() } else { "inf".to_owned() };
    }
    let bits = value.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    match (exponent, fraction) {
        (0, 0) => digits(is_negative, 0, 0, 0),
        (0, _) => digits(is_negative, 0, fraction, -1022),
        _ => digits(is_negative, 1, fraction, exponent - 1023),
    }
}

/// `fraction` counts 2^-52.
fn digits(is_negative: bool, lead: u8, fraction: u64, power: i32) -> String {
    let sign = if is_negative { "-" } else { "" };
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{lead}{point}{digits}p{power}")
}

/// Reads what [`format_hex`] writes, and any other C99 hexadecimal float.
///
/// `None` when `text` is none. Digits beyond what an `f64` holds are refused rather than rounded twice.
#[must_use]
pub fn parse_hex(text: &str) -> Option<f64> {
    let (negative, rest) = match text.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let magnitude = match rest {
        "nan" => f64::NAN,
        "inf" => f64::INFINITY,
        _ => finite(rest)?,
    };
    Some(if negative { -magnitude } else { magnitude })
}

fn finite(text: &str) -> Option<f64> {
    let text = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X"))?;
    let (mantissa, power) = text.split_once(['p', 'P']).unwrap_or((text, "0"));
    let power: i32 = power.parse().ok()?;
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let digits = digits.trim_start_matches('0');
    if whole.len() + fraction.len() == 0 || digits.len() > 13 || power.abs() > 2000 {
        return None;
    }
    let bits = if digits.is_empty() { 0 } else { u64::from_str_radix(digits, 16).ok()? };
    let power = power - 4 * i32::try_from(fraction.len()).ok()?;
    // Two steps keep the factors finite; the product is exact but for f64 subnormals.
    let half = power / 2;
    Some(bits as f64 * 2f64.powi(half) * 2f64.powi(power - half))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_float_comes_back() {
        let bits = [0, 1, 0x0040_0000, 0x0080_0000, 0x3f80_0000, 0x3f80_0001, 0x7f7f_ffff, 0x7f80_0000];
        for bits in bits.into_iter().flat_map(|b| [b, b | 0x8000_0000]) {
            let value = f32::from_bits(bits);
            let text = format_hex(value);
            assert_eq!(parse_hex(&text).map(|v| (v as f32).to_bits()), Some(bits), "{text}");
        }
        assert!(parse_hex(&format_hex(f32::NAN)).is_some_and(f64::is_nan));
    }

    #[test]
    fn the_spelling_is_that_of_c() {
        assert_eq!(format_hex(12.0), "0x1.8p3");
        assert_eq!(format_hex(-0.0), "-0x0p0");
        assert_eq!(format_hex(f32::from_bits(1)), "0x0.000002p-126");
        assert_eq!(format_hex_f64(0.1), "0x1.999999999999ap-4");
        assert_eq!(format_hex_f64(f64::from_bits(1)), "0x0.0000000000001p-1022");
        assert_eq!(parse_hex("0x.8"), Some(0.5));
        assert_eq!(parse_hex("0xffp-4"), Some(15.9375));
    }

    #[test]
    fn what_is_no_hexadecimal_float_is_refused() {
        for text in
            ["", "1.5", "0x", "0x.", "0xg", "0x1p", "0x1p1.5", "0x1p99999", "infinite", "0x123456789abcdef"]
        {
            assert_eq!(parse_hex(text), None, "{text}");
        }
    }
}
