//! Angles as quarter turns and a rest.

use super::double::ROUND;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// An angle of `quarters` quarter turns, of which the lowest two bits count, and `rest` radians, at most an eighth of a
/// turn.
#[derive(Clone, Copy)]
pub(super) struct Angle {
    pub(super) quarters: u64,
    pub(super) rest: f64,
}

/// Whether [`near`] reduces this angle.
#[inline(always)]
pub(super) fn is_near(x: f32) -> bool {
    x.abs() < 1_048_576.0 // 2^20
}

/// Reduces an angle of less than 2^20 quarter turns.
#[inline(always)]
pub(super) fn near(x: f32) -> Angle {
    // Pi / 2 in two parts; the product of the upper one, 33 bits, is exact.
    const HIGH: f64 = 1.570_796_326_734_125_6;
    const LOW: f64 = 6.077_100_506_506_192e-11;
    let x = f64::from(x);
    let rounded = x * FRAC_2_PI + ROUND;
    let n = rounded - ROUND;
    Angle { quarters: rounded.to_bits(), rest: (x - n * HIGH) - n * LOW }
}

/// 2 / pi, 24 bits each: a product with an f32 is exact.
const PARTS: [f64; 8] = {
    let bits = [
        0x00a2_f983_u32,
        0x006e_4e44,
        0x0015_29fc,
        0x0027_57d1,
        0x00f5_34dd,
        0x00c0_db62,
        0x0095_993c,
        0x0043_9041,
    ];
    let (mut parts, mut scale, mut at) = ([0.0; 8], 1.0, 0);
    while at < 8 {
        scale /= 16_777_216.0;
        parts[at] = bits[at] as f64 * scale;
        at += 1;
    }
    parts
};

/// Reduces any finite angle.
#[inline(always)]
pub(super) fn far(x: f32) -> Angle {
    /// Above this all numbers are whole turns, and adding it rounds to these.
    const TURNS: f64 = 18_014_398_509_481_984.0; // 2^54
    let magnitude = f64::from(x.abs());
    // Quarter turns by each part, without whole turns. These are exact.
    let mut quarters = [0.0; 8];
    let mut at = 0;
    while at < 8 {
        let product = magnitude * PARTS[at];
        let turns = (product + TURNS) - TURNS;
        quarters[at] = if product < TURNS { product - turns } else { 0.0 };
        at += 1;
    }
    let rounded = quarters.iter().rev().fold(0.0, |sum, q| sum + q) + ROUND;
    // From the largest part on: near a whole quarter the first sums are exact.
    let rest = quarters.iter().fold(ROUND - rounded, |sum, q| sum + q) * FRAC_PI_2;
    let (n, rest) =
        if x < 0.0 { (rounded.to_bits().wrapping_neg(), -rest) } else { (rounded.to_bits(), rest) };
    Angle { quarters: n, rest }
}
