//! Logarithms.

use super::polynomial;

/// `x = (1 + f) 2^e`, `1 + f` from the root of 1/2 to that of 2.
struct Split {
    f: f32,
    e: f32,
}

#[inline(always)]
fn split(x: f32) -> Split {
    const ROOT_HALF: u32 = 0x3f35_04f3;
    let tiny = x < f32::MIN_POSITIVE;
    let scaled = if tiny { x * 8_388_608.0 } else { x };
    let bits = scaled.to_bits().wrapping_sub(ROOT_HALF) as i32 >> 23;
    let mantissa = f32::from_bits(scaled.to_bits().wrapping_sub((bits << 23) as u32));
    let e = bits as f32 - if tiny { 23.0 } else { 0.0 };
    Split { f: mantissa - 1.0, e }
}

/// `log(1 + f) = f - f²/2 + f³ p`: the last two terms.
#[inline(always)]
fn rest(f: f32) -> (f32, f32) {
    let p = polynomial(
        f,
        [
            0.333_333_3,
            -0.250_008_23,
            0.200_012_28,
            -0.166_233_51,
            0.142_017_4,
            -0.131_602_29,
            0.127_617_37,
            -0.076_345_757,
        ],
    );
    let square = f * f;
    (0.5 * square, f * square * p)
}

/// The result for positive numbers; minus infinity at 0, NaN below, infinity of infinity, NaN of NaN.
#[inline(always)]
fn of_positive(x: f32, result: f32) -> f32 {
    let result = if x == 0.0 { f32::NEG_INFINITY } else { result };
    let result = if x < 0.0 { f32::NAN } else { result };
    if x.is_nan() || x == f32::INFINITY { x } else { result }
}

/// Natural logarithm: the exponent's part, and a polynomial of degree 10 in the mantissa. At most 0.87 ULP.
#[inline(always)]
pub fn log(x: f32) -> f32 {
    let Split { f, e } = split(x);
    let (half_square, cube) = rest(f);
    let low = cube + e * -2.121_944_4e-4 - half_square;
    of_positive(x, (f + low) + e * 0.693_359_375)
}

/// Logarithm of base 2: as the natural one, times a conversion in two parts. At most 0.92 ULP.
#[inline(always)]
pub fn log2(x: f32) -> f32 {
    const HIGH: f32 = 1.442_871_1; // 12 bits
    const LOW: f32 = -1.760_528_5e-4;
    let Split { f, e } = split(x);
    let (half_square, cube) = rest(f);
    // 12 bits of f - f²/2, so that its product with the upper part is exact; what they lack.
    let upper = f32::from_bits((f - half_square).to_bits() & 0xffff_f000);
    let lower = ((f - upper) - half_square) + cube;
    let low = (upper + lower) * LOW + lower * HIGH;
    of_positive(x, low + upper * HIGH + e)
}
