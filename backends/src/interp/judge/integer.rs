//! Integers of any width, as bits: a second hand beside `fast::ops::integer`, for one number at a time.

use super::super::program::Scalar;
use super::super::program::op::{Comparison, IntOp};

/// Bits of a type.
fn width(scalar: Scalar) -> u32 {
    8 * scalar.bytes()
}

/// The lower bits, as registers hold them.
fn wrap(scalar: Scalar, number: i128) -> u64 {
    match scalar {
        Scalar::I16 => u64::from(i32::from(number as i16) as u32),
        Scalar::U16 => u64::from(number as u16),
        _ if scalar.wide() => number as u64,
        _ => u64::from(number as u32),
    }
}

/// The number that bits mean.
pub(in super::super) fn number(bits: u64, scalar: Scalar) -> i128 {
    let above = 128 - width(scalar);
    if scalar.signed() { (i128::from(bits) << above) >> above } else { i128::from(bits) }
}

/// The f32 nearest to an integer.
pub(in super::super) fn rounded(bits: u64, from: Scalar) -> f32 {
    number(bits, from) as f32
}

/// A float as an integer: towards zero, at most the largest f32 that the type holds, NaN as zero.
pub(in super::super) fn truncated(x: f32, to: Scalar) -> u64 {
    truncated_exact(x.into(), to)
}

/// The same of an exact number.
pub(in super::super) fn truncated_exact(x: f64, to: Scalar) -> u64 {
    let (low, high) = limits(to);
    // WGSL and the drivers stop at an f32; what lies between it and the largest integer is out of reach.
    let bits = i128::BITS - high.leading_zeros();
    let beyond = (1_i128 << bits.saturating_sub(f32::MANTISSA_DIGITS)) - 1;
    wrap(to, (x as i128).clamp(low, high - beyond))
}

fn limits(scalar: Scalar) -> (i128, i128) {
    let values = 1_i128 << width(scalar);
    if scalar.signed() { (-values / 2, values / 2 - 1) } else { (0, values - 1) }
}

/// What a conversion between integers keeps.
pub(super) fn converted(bits: u64, from: Scalar, to: Scalar) -> u64 {
    wrap(to, number(bits, from))
}

/// A comparison.
pub(super) fn compare(scalar: Scalar, comparison: Comparison, a: u64, b: u64) -> bool {
    let (a, b) = (number(a, scalar), number(b, scalar));
    match comparison {
        Comparison::Equal => a == b,
        Comparison::NotEqual => a != b,
        Comparison::Less => a < b,
        Comparison::LessEqual => a <= b,
    }
}

/// Whether a quotient is defined.
pub(super) fn divides(scalar: Scalar, a: i128, b: i128) -> bool {
    b != 0 && !(scalar.signed() && a == limits(scalar).0 && b == -1)
}

/// An operation; operands that it does not have are zero.
pub(super) fn apply(scalar: Scalar, op: IntOp, words: [u64; 4]) -> u64 {
    let [a, b, c, _] = words.map(|w| number(w, scalar));
    let raw = words[0] & (u64::MAX >> (64 - width(scalar)));
    let width = width(scalar);
    let defined = divides(scalar, a, b);
    let shift = words[1] as u32 % width;
    let result = match op {
        IntOp::Add => a + b,
        IntOp::Sub => a - b,
        IntOp::Mul => a.wrapping_mul(b),
        IntOp::Div => {
            if defined {
                a / b
            } else {
                a
            }
        }
        IntOp::Rem => {
            if defined {
                a % b
            } else {
                0
            }
        }
        IntOp::Neg => -a,
        IntOp::Not => !a,
        IntOp::And => a & b,
        IntOp::Or => a | b,
        IntOp::Xor => a ^ b,
        IntOp::Shl => a << shift,
        IntOp::Shr => a >> shift,
        IntOp::Abs => a.abs(),
        IntOp::Sign => a.signum(),
        IntOp::Min => a.min(b),
        IntOp::Max => a.max(b),
        IntOp::Clamp => a.max(b).min(c),
        IntOp::CountOneBits => raw.count_ones().into(),
        IntOp::CountLeadingZeros => (raw.leading_zeros() + width - 64).into(),
        IntOp::CountTrailingZeros => raw.trailing_zeros().min(width).into(),
        IntOp::ReverseBits => (raw.reverse_bits() >> (64 - width)).into(),
        IntOp::FirstLeadingBit => {
            first_bit(wrap(scalar, if a < 0 { !a } else { a }), |x| 63 - x.leading_zeros())
        }
        IntOp::FirstTrailingBit => first_bit(raw, u64::trailing_zeros),
        IntOp::ExtractBits => extract(scalar, a, words[1], words[2]),
        IntOp::InsertBits => insert(width, words),
    };
    wrap(scalar, result)
}

/// -1 where no bit is set.
fn first_bit(bits: u64, place: impl Fn(u64) -> u32) -> i128 {
    if bits == 0 { -1 } else { place(bits).into() }
}

/// Where a range of bits begins and how long it is, both cut to the width.
fn range(width: u32, at: u64, count: u64) -> (u32, u32) {
    let at = at.min(width.into()) as u32;
    (at, count.min((width - at).into()) as u32)
}

fn extract(scalar: Scalar, a: i128, at: u64, count: u64) -> i128 {
    let (at, count) = range(width(scalar), at, count);
    if count == 0 {
        return 0;
    }
    let above = 128 - count;
    let field = (a >> at) << above;
    if scalar.signed() { field >> above } else { (field as u128 >> above) as i128 }
}

fn insert(width: u32, [a, bits, at, count]: [u64; 4]) -> i128 {
    let (at, count) = range(width, at, count);
    let field = ((1_i128 << count) - 1) << at;
    (i128::from(a) & !field) | ((i128::from(bits) << at) & field)
}
