//! Integers of 16, 32 and 64 bits: wrapping, total.

use super::super::program::op::IntOp;

/// An integer as registers hold it: 16 bits in 32, extended by sign or zeros.
pub(crate) trait Integer: Copy + 'static {
    /// What a register holds.
    type Held: Copy + 'static;
    /// Of one operand.
    fn one(op: IntOp, a: Self::Held) -> Self::Held;
    /// Of two operands.
    fn two(op: IntOp, a: Self::Held, b: Self::Held) -> Self::Held;
    /// By so many bits; the lower ones of the count matter.
    fn shift(op: IntOp, a: Self::Held, by: u32) -> Self::Held;
    /// `min(max(a, low), high)`
    fn clamp(a: Self::Held, low: Self::Held, high: Self::Held) -> Self::Held;
    /// `count` bits from `at` on, both clamped to the number, extended by sign or zeros.
    fn extract(a: Self::Held, at: u32, count: u32) -> Self::Held;
    /// `a` with `count` bits from `at` on replaced by the lowest of `bits`.
    fn insert(a: Self::Held, bits: Self::Held, at: u32, count: u32) -> Self::Held;
}

macro_rules! integers {
    ($($ty:ident $unsigned:ident $held:ident $signed:literal;)*) => {
        $(impl Integer for $ty {
            type Held = $held;
            #[inline(always)]
            fn one(op: IntOp, a: $held) -> $held {
                let a = a as $ty;
                let negative = $signed && a >> ($ty::BITS - 1) & 1 == 1;
                let unsigned = a as $unsigned;
                (match op {
                    IntOp::Neg => a.wrapping_neg(),
                    IntOp::Not => !a,
                    IntOp::Abs if negative => a.wrapping_neg(),
                    IntOp::Sign if negative => !0,
                    IntOp::Sign => $ty::from(a != 0),
                    IntOp::CountOneBits => a.count_ones() as $ty,
                    IntOp::CountLeadingZeros => a.leading_zeros() as $ty,
                    IntOp::CountTrailingZeros => a.trailing_zeros() as $ty,
                    IntOp::ReverseBits => a.reverse_bits(),
                    IntOp::FirstLeadingBit => {
                        let bits = if negative { !unsigned } else { unsigned };
                        ($unsigned::BITS - 1).wrapping_sub(bits.leading_zeros()) as i32 as $ty
                    }
                    IntOp::FirstTrailingBit if a == 0 => !0,
                    IntOp::FirstTrailingBit => a.trailing_zeros() as $ty,
                    _ => a,
                }) as $held
            }
            #[inline(always)]
            fn two(op: IntOp, a: $held, b: $held) -> $held {
                let (a, b) = (a as $ty, b as $ty);
                (match op {
                    IntOp::Add => a.wrapping_add(b),
                    IntOp::Sub => a.wrapping_sub(b),
                    IntOp::Mul => a.wrapping_mul(b),
                    IntOp::Div => a.checked_div(b).unwrap_or(a),
                    IntOp::Rem => a.checked_rem(b).unwrap_or(0),
                    IntOp::And => a & b,
                    IntOp::Or => a | b,
                    IntOp::Xor => a ^ b,
                    IntOp::Min => a.min(b),
                    IntOp::Max => a.max(b),
                    _ => a,
                }) as $held
            }
            #[inline(always)]
            fn shift(op: IntOp, a: $held, by: u32) -> $held {
                let a = a as $ty;
                (match op {
                    IntOp::Shl => a.wrapping_shl(by),
                    _ => a.wrapping_shr(by),
                }) as $held
            }
            #[inline(always)]
            fn clamp(a: $held, low: $held, high: $held) -> $held {
                a.max(low).min(high)
            }
            #[inline(always)]
            fn extract(a: $held, at: u32, count: u32) -> $held {
                let at = at.min($ty::BITS);
                let count = count.min($ty::BITS - at);
                if count == 0 {
                    return 0;
                }
                let up = (a as $ty) << ($ty::BITS - count - at);
                (up >> ($ty::BITS - count)) as $held
            }
            #[inline(always)]
            fn insert(a: $held, bits: $held, at: u32, count: u32) -> $held {
                let at = at.min($ty::BITS);
                let count = count.min($ty::BITS - at);
                if count == 0 {
                    return a;
                }
                let mask = ($unsigned::MAX >> ($ty::BITS - count)) << at;
                let (a, bits) = (a as $unsigned, bits as $unsigned);
                ((a & !mask) | (bits << at & mask)) as $ty as $held
            }
        })*
    };
}

integers! {
    i16 u16 i32 true;
    u16 u16 u32 false;
    i32 u32 i32 true;
    u32 u32 u32 false;
    i64 u64 i64 true;
    u64 u64 u64 false;
}
