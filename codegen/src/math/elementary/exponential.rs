//! Exponential functions.

use super::abreast::{each, pairs, polynomial};

/// Adding this rounds to an integer, which then stands in the lowest bits.
const ROUND: f32 = 12_582_912.0; // 1.5 * 2^23

/// Upper and lower part of ln 2; the upper one has few enough bits for exact products.
const LN_2_HIGH: f32 = 0.693_359_375;
const LN_2_LOW: f32 = -2.121_944_4e-4;

/// `mantissa` times 2 to the power that stands in the lowest bits of `rounded`.
#[inline(always)]
fn scaled(mantissa: f32, rounded: f32) -> f32 {
    f32::from_bits(mantissa.to_bits().wrapping_add(rounded.to_bits() << 23))
}

/// Arguments whose results are normal numbers.
struct Normal {
    least: f32,
    most: f32,
}

const EXP: Normal = Normal { least: -87.336_54, most: 88.722_83 };
const EXP2: Normal = Normal { least: -126.0, most: f32::MAX_EXP as f32 - 7.629_394_5e-6 };

impl Normal {
    /// Zero instead of a result below the normal numbers.
    #[inline(always)]
    fn flushed(&self, x: f32, result: f32) -> f32 {
        if x < self.least { 0.0 } else { result }
    }

    /// The result where it is a normal number, infinity above, zero below; NaN of NaN.
    #[inline(always)]
    fn of_any(&self, x: f32, result: f32) -> f32 {
        let result = self.flushed(x, result);
        if x <= self.most { result } else { x + f32::INFINITY }
    }
}

/// The same functions where they are finite: same results for arguments that the function before takes, without the way
/// for others.
pub mod finite {
    use super::{EXP, EXP2, pairs};

    /// Whether [`exp`] takes this argument.
    #[inline(always)]
    pub fn has_exp(x: f32) -> bool {
        x <= EXP.most
    }

    /// See [`exp`](super::exp).
    #[inline(always)]
    pub fn exp<const K: usize>(x: [f32; K]) -> [f32; K] {
        pairs(x, super::exp_normal(x), |x, normal| EXP.flushed(x, normal))
    }

    /// Whether [`exp2`] takes this argument.
    #[inline(always)]
    pub fn has_exp2(x: f32) -> bool {
        x <= EXP2.most
    }

    /// See [`exp2`](super::exp2).
    #[inline(always)]
    pub fn exp2<const K: usize>(x: [f32; K]) -> [f32; K] {
        pairs(x, super::exp2_normal(x), |x, normal| EXP2.flushed(x, normal))
    }
}

/// Several numbers abreast: the same results, sooner.
pub mod several {
    use super::{EXP, EXP2, pairs};

    /// See [`exp`](super::exp).
    #[inline(always)]
    pub fn exp<const K: usize>(x: [f32; K]) -> [f32; K] {
        pairs(x, super::exp_normal(x), |x, normal| EXP.of_any(x, normal))
    }

    /// See [`exp2`](super::exp2).
    #[inline(always)]
    pub fn exp2<const K: usize>(x: [f32; K]) -> [f32; K] {
        pairs(x, super::exp2_normal(x), |x, normal| EXP2.of_any(x, normal))
    }
}

/// `e^x`: the power of two next to it times a polynomial of degree 6 in the rest. At most 0.99 ULP; results
/// below the smallest normal number are 0.
#[inline(always)]
pub fn exp(x: f32) -> f32 {
    let [result] = several::exp([x]);
    result
}

#[inline(always)]
fn exp_normal<const K: usize>(x: [f32; K]) -> [f32; K] {
    let rounded = each(x, |x| x * std::f32::consts::LOG2_E + ROUND);
    let n = each(rounded, |rounded| rounded - ROUND);
    let high = pairs(x, n, |x, n| x - n * LN_2_HIGH);
    let r = pairs(high, n, |high, n| high - n * LN_2_LOW);
    let p = polynomial(r, [0.499_999_94, 0.166_665_21, 0.041_668_39, 0.008_368_717, 0.001_381_459_8]);
    let mantissa = pairs(r, p, |r, p| (r * r) * p + r + 1.0);
    pairs(mantissa, rounded, scaled)
}

/// `2^x`: the power of two next to it times a polynomial of degree 6 in the rest. At most 0.73 ULP; results
/// below the smallest normal number are 0.
#[inline(always)]
pub fn exp2(x: f32) -> f32 {
    let [result] = several::exp2([x]);
    result
}

#[inline(always)]
fn exp2_normal<const K: usize>(x: [f32; K]) -> [f32; K] {
    let rounded = each(x, |x| x + ROUND);
    let r = pairs(x, rounded, |x, rounded| x - (rounded - ROUND));
    let p = polynomial(
        r,
        [0.193_147_2, 0.240_226_48, 0.055_503_324, 0.009_618_441, 0.001_339_886_5, 1.535_249_9e-4],
    );
    let mantissa = pairs(r, p, |r, p| {
        // 1 + r/2 as a rounded sum and what it lacks.
        let half = 0.5 * r;
        let high = 1.0 + half;
        let low = half - (high - 1.0);
        high + (low + r * p)
    });
    pairs(mantissa, rounded, scaled)
}
