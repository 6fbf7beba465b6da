//! Exponential and logarithm in f64, as accurate as f32 results ask for: about 2^-32.
//!
//! What is built on them has an error little above half an ULP, the last rounding's. No argument is checked:
//! callers bound them, and NaN goes through where a function says so.

use super::polynomial;

/// Adding this rounds to an integer, which then stands in the lowest bits.
pub(super) const ROUND: f64 = 6_755_399_441_055_744.0; // 1.5 * 2^52

/// 2 to the power that stands in the lowest bits of `rounded`.
#[inline(always)]
fn power_of_2(rounded: f64) -> f64 {
    f64::from_bits((rounded.to_bits() << 52).wrapping_add(1.0_f64.to_bits()))
}

/// `2^x` for -1000 <= x <= 1000; NaN of NaN.
#[inline(always)]
pub(super) fn exp2(x: f64) -> f64 {
    let rounded = x + ROUND;
    let r = x - (rounded - ROUND);
    let p = polynomial(
        r,
        [
            0.693_147_180_706_373_3,
            0.240_226_510_665_512_5,
            0.055_504_103_608_808_45,
            0.009_618_038_119_952_392,
            0.001_333_393_806_146_492_2,
            1.546_676_354_204_659e-4,
            1.519_566_887_689_861e-5,
        ],
    );
    power_of_2(rounded) * (1.0 + r * p)
}

/// `e^x - 1` for -700 <= x <= 700, near 0 too; NaN of NaN.
#[inline(always)]
pub(super) fn exp_minus_1(x: f64) -> f64 {
    let rounded = x * std::f64::consts::LOG2_E + ROUND;
    let r = x - (rounded - ROUND) * std::f64::consts::LN_2;
    let p = polynomial(
        r,
        [
            1.000_000_000_031_265_7,
            0.500_000_004_680_476_7,
            0.166_666_662_496_370_13,
            0.041_666_353_939_758_56,
            0.008_333_402_778_521_905,
            0.001_394_103_894_520_970_4,
            1.984_135_681_007_656e-4,
        ],
    );
    let power = power_of_2(rounded);
    power * (r * p) + (power - 1.0)
}

/// Logarithm of base 2 of a positive normal number, near 1 too.
#[inline(always)]
pub(super) fn log2(x: f64) -> f64 {
    const ROOT_HALF: u64 = 0x3fe6_a09e_667f_3bcd;
    const ONE: u64 = 1023 << 52;
    // x = (1 + f) 2^e; the biased exponent becomes the lowest bits of a number near 2^52.
    let biased = x.to_bits().wrapping_sub(ROOT_HALF).wrapping_add(ONE) >> 52;
    let e = f64::from_bits(biased | 0x4330_0000_0000_0000) - (4_503_599_627_370_496.0 + 1023.0);
    let mantissa = f64::from_bits(x.to_bits().wrapping_sub(biased << 52).wrapping_add(ONE));
    let s = (mantissa - 1.0) / (mantissa + 1.0);
    let p = polynomial(
        s * s,
        [
            2.885_390_081_790_140_6,
            0.961_796_673_284_350_3,
            0.577_083_594_452_137_4,
            0.411_672_218_294_417_47,
            0.340_738_355_105_096_5,
        ],
    );
    s * p + e
}

/// `log(1 + x)` for -1 < x < infinity, near 0 too; NaN of NaN.
#[inline(always)]
pub(super) fn log_1_plus(x: f64) -> f64 {
    let sum = 1.0 + x;
    // What the sum lacks.
    let rest = x - (sum - 1.0);
    log2(sum) * std::f64::consts::LN_2 + rest / sum
}
