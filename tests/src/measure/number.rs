//! Numbers as the files write them. Only exact decimal arithmetic: the same on every machine.

/// Two significant digits, rounded up, so that "at most" is true.
pub(super) fn at_most(value: f64) -> String {
    if !value.is_finite() {
        return value.to_string();
    }
    let (digits, mut exponent) = decimal(value.abs());
    let beyond = digits.iter().skip(2).any(|d| *d != 0);
    let mut mantissa =
        u32::from(digits[0]) * 10 + u32::from(digits.get(1).copied().unwrap_or(0)) + u32::from(beyond);
    if mantissa == 100 {
        mantissa = 10;
        exponent += 1;
    }
    write(mantissa, exponent)
}

/// The digits and the exponent of the first one.
fn decimal(value: f64) -> (Vec<u8>, i32) {
    let text = format!("{value:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).map(|b| b - b'0').collect();
    (digits, exponent.parse().unwrap_or(0))
}

/// `mantissa / 10` times a power of ten.
fn write(mantissa: u32, exponent: i32) -> String {
    let (first, second) = (mantissa / 10, mantissa % 10);
    match exponent {
        0 if mantissa == 0 => "0".to_owned(),
        -2 | -1 => format!("0.{}{first}{second}", if exponent == -2 { "0" } else { "" }),
        0 => format!("{first}.{second}"),
        1..=3 => format!("{mantissa}{}", "0".repeat(exponent as usize - 1)),
        _ if second == 0 => format!("{first}e{exponent}"),
        _ => format!("{first}.{second}e{exponent}"),
    }
}

/// About the value: three significant digits.
pub(super) fn about(value: f64) -> String {
    let rounded: f64 = format!("{value:.2e}").parse().unwrap_or(value);
    match rounded.abs() {
        0.0 => "0".to_owned(),
        a if (1e-3..1e5).contains(&a) => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_at_most_is_rounded_up() {
        for (value, text) in [
            (0.0, "0"),
            (0.611, "0.62"),
            (0.61, "0.61"),
            (0.0101, "0.011"),
            (0.999, "1.0"),
            (1.0, "1.0"),
            (12.01, "13"),
            (995.0, "1000"),
            (8.4e7, "8.4e7"),
            (1.01e-9, "1.1e-9"),
            (2e-3, "2e-3"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(at_most(value), text);
        }
    }

    #[test]
    fn arguments_are_about() {
        for (value, text) in [(0.3, "0.3"), (6.2999, "6.3"), (1e6, "1e6"), (-0.70711, "-0.707"), (0.0, "0")] {
            assert_eq!(about(value), text);
        }
    }
}
