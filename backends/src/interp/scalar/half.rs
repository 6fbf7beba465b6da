//! Floats of 16 bits, held as f32.

/// Largest finite number.
pub(crate) const MAX: f32 = 65504.0;

/// The nearest number of 16 bits, ties to even; infinite from 65520 on.
#[inline(always)]
pub(crate) fn round(x: f32) -> f32 {
    let magnitude = x.abs();
    let bits = magnitude.to_bits();
    // 13 bits go: half of the last one that stays, less one in favour of an even neighbour.
    let normal = f32::from_bits(bits.wrapping_add(0xfff + ((bits >> 13) & 1)) & !0x1fff);
    // Below 2^-14 numbers lie 2^-24 apart, as f32 do from 0.5 on.
    let small = (magnitude + 0.5) - 0.5;
    let rounded = if magnitude < 6.103_515_6e-5 { small } else { normal };
    let finite = if rounded > MAX { f32::INFINITY } else { rounded };
    if x.is_nan() { x } else { finite.copysign(x) }
}

/// The nearest number of 16 bits of an f64, rounded once.
#[inline(always)]
pub(crate) fn round_f64(x: f64) -> f32 {
    let near = x as f32;
    let back = f64::from(near);
    // To odd first: an inexact f32 whose last bit is set can be no tie.
    let odd = if back == x || x.is_nan() || near.to_bits() & 1 == 1 {
        near
    } else if (back < x) == (x > 0.0) {
        f32::from_bits(near.to_bits() + 1)
    } else {
        f32::from_bits(near.to_bits().saturating_sub(1))
    };
    round(odd)
}

/// `x * y + z`, rounded once.
#[inline(always)]
pub(crate) fn fma(x: f32, y: f32, z: f32) -> f32 {
    let product = f64::from(x) * f64::from(y);
    let z = f64::from(z);
    let sum = product + z;
    // What the sum lost; the product is exact.
    let part = sum - product;
    let lost = (product - (sum - part)) + (z - part);
    let odd = if lost == 0.0 || !lost.is_finite() || sum.to_bits() & 1 == 1 {
        sum
    } else if (lost > 0.0) == (sum > 0.0) {
        f64::from_bits(sum.to_bits() + 1)
    } else {
        f64::from_bits(sum.to_bits() - 1)
    };
    round_f64(odd)
}

/// The 16 bits of a number that they can hold.
#[inline(always)]
pub(crate) fn to_bits(x: f32) -> u16 {
    let sign = (x.to_bits() >> 16) & 0x8000;
    let magnitude = x.abs();
    let bits = if x.is_nan() {
        0x7e00
    } else if magnitude > MAX {
        0x7c00
    } else if magnitude < 6.103_515_6e-5 {
        (magnitude * 16_777_216.0) as u32
    } else {
        (magnitude.to_bits() >> 13) - (112 << 10)
    };
    (sign | bits) as u16
}

/// The number of 16 bits.
#[inline(always)]
pub(crate) fn from_bits(bits: u16) -> f32 {
    let (sign, rest) = (u32::from(bits & 0x8000) << 16, u32::from(bits & 0x7fff));
    let finite = f32::from_bits(rest << 13) * f32::from_bits(0x7780_0000);
    let magnitude = if rest >= 0x7c00 { f32::from_bits((rest << 13) | 0x7f80_0000) } else { finite };
    f32::from_bits(magnitude.to_bits() | sign)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::half::f16;

    #[test]
    fn all_numbers_of_16_bits_come_back() {
        for bits in 0..=u16::MAX {
            let (ours, theirs) = (from_bits(bits), f16::from_bits(bits));
            if theirs.is_nan() {
                assert!(ours.is_nan() && round(ours).is_nan() && from_bits(to_bits(ours)).is_nan());
            } else {
                assert_eq!(ours.to_bits(), f32::from(theirs).to_bits(), "{bits:#x}");
                assert_eq!((to_bits(ours), round(ours).to_bits()), (bits, ours.to_bits()), "{bits:#x}");
            }
        }
    }

    /// Between all neighbours: the middle goes to the even one, what is beside it to the nearer one.
    #[test]
    fn rounding_is_to_nearest_even() {
        for bits in 0..0x7c00_u16 {
            let (low, high) = (f64::from(from_bits(bits)), f64::from(from_bits(bits + 1)));
            let high = if high.is_finite() { high } else { 65536.0 };
            let middle = f64::midpoint(low, high);
            let even = from_bits(bits + (bits & 1));
            let low = from_bits(bits);
            let high = from_bits(bits + 1);
            assert_eq!(round(middle as f32), even, "{bits:#x}");
            assert_eq!(round((middle as f32).next_down()), low, "{bits:#x}");
            assert_eq!(round((middle as f32).next_up()), high, "{bits:#x}");
            for (x, wanted) in [(middle, even), (middle.next_down(), low), (middle.next_up(), high)] {
                assert_eq!(round_f64(x), wanted, "{x:e}");
                assert_eq!(round_f64(-x), -wanted, "{x:e}");
            }
        }
    }

    #[test]
    fn a_product_and_a_sum_are_rounded_once() {
        // 1 + 2^-11 is a tie that the smallest number decides.
        let (one, tie, least) = (1.0, 2.0_f32.powi(-11), 2.0_f32.powi(-24));
        assert_eq!(fma(tie, one, one), 1.0);
        assert_eq!(fma(least, 1.0, 0.0), least);
        // 2048 + 1 is a tie between 2048 and 2050; a product of 2^-26 decides it.
        let up = fma(1.0 + 2.0_f32.powi(-10), 1.0 + 2.0_f32.powi(-10), 2048.0);
        assert_eq!(up, 2050.0);
        // 65504 * 65504 with 2^-24 added and taken away lies where f64 no longer tells.
        assert_eq!(fma(256.0, 8.0, least), 2048.0);
        assert_eq!(fma(4096.0, 0.500_122_1, least), round(4096.0 * 0.500_122_1));
        assert!(fma(f32::INFINITY, 0.0, 1.0).is_nan());
        assert_eq!(fma(f32::INFINITY, 1.0, 1.0), f32::INFINITY);
    }
}
