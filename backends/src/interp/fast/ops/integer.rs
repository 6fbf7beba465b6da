//! Integers: wrapping, total; bit operations are those of the native functions.

use super::super::super::program::Scalar;
use super::super::super::program::op::IntOp;
use super::super::shape::{Ask, Fn4, Found, four_alike, one, three_alike, two, two_alike, two_commuting};
use super::{functions, sized};
use lobe_codegen::math;

functions! {
    Add(a: u32, b: u32) -> u32 = a.wrapping_add(b);
    Sub(a: u32, b: u32) -> u32 = a.wrapping_sub(b);
    Mul(a: u32, b: u32) -> u32 = a.wrapping_mul(b);
    DivU(a: u32, b: u32) -> u32 = a.checked_div(b).unwrap_or(a);
    DivI(a: i32, b: i32) -> i32 = a.checked_div(b).unwrap_or(a);
    RemU(a: u32, b: u32) -> u32 = a.checked_rem(b).unwrap_or(0);
    RemI(a: i32, b: i32) -> i32 = a.checked_rem(b).unwrap_or(0);
    Neg(a: u32) -> u32 = a.wrapping_neg();
    Not(a: u32) -> u32 = !a;
    And(a: u32, b: u32) -> u32 = a & b;
    Or(a: u32, b: u32) -> u32 = a | b;
    Xor(a: u32, b: u32) -> u32 = a ^ b;
    Shl(a: u32, b: u32) -> u32 = a.wrapping_shl(b);
    ShrU(a: u32, b: u32) -> u32 = a.wrapping_shr(b);
    ShrI(a: i32, b: u32) -> i32 = a.wrapping_shr(b);
    AbsI(a: i32) -> i32 = a.wrapping_abs();
    SignI(a: i32) -> i32 = a.signum();
    MinU(a: u32, b: u32) -> u32 = a.min(b);
    MinI(a: i32, b: i32) -> i32 = a.min(b);
    MaxU(a: u32, b: u32) -> u32 = a.max(b);
    MaxI(a: i32, b: i32) -> i32 = a.max(b);
    ClampU(a: u32, low: u32, high: u32) -> u32 = a.max(low).min(high);
    ClampI(a: i32, low: i32, high: i32) -> i32 = a.max(low).min(high);
    CountOnes(a: u32) -> u32 = a.count_ones();
    LeadingZeros(a: u32) -> u32 = a.leading_zeros();
    TrailingZeros(a: u32) -> u32 = a.trailing_zeros();
    Reverse(a: u32) -> u32 = a.reverse_bits();
    FirstLeadingU(a: u32) -> u32 = math::first_leading_bit(a);
    FirstLeadingI(a: i32) -> i32 = math::first_leading_bit(a);
    FirstTrailing(a: u32) -> u32 = math::first_trailing_bit(a);
    ExtractU(a: u32, at: u32, n: u32) -> u32 = math::extract_bits(a, at, n);
    ExtractI(a: i32, at: u32, n: u32) -> i32 = math::extract_bits(a, at, n);
}

struct Insert;
impl Fn4 for Insert {
    type A = u32;
    type C = u32;
    #[inline(always)]
    fn eval(a: u32, bits: u32, at: u32, n: u32) -> u32 {
        math::insert_bits(a, bits, at, n)
    }
}

/// The form of an operation.
pub(super) fn find<const N: usize>(scalar: Scalar, op: IntOp, ask: Ask) -> Option<Found<N>> {
    match scalar {
        Scalar::I32 => Some(signed(op, ask)),
        Scalar::U32 => Some(unsigned(op, ask)),
        Scalar::I16 => Some(sized::find::<i16, N>(op, ask)),
        Scalar::U16 => Some(sized::find::<u16, N>(op, ask)),
        Scalar::I64 => Some(sized::find::<i64, N>(op, ask)),
        Scalar::U64 => Some(sized::find::<u64, N>(op, ask)),
        Scalar::Bool | Scalar::F32 | Scalar::F16 | Scalar::F64 => None,
    }
}

/// Those that depend on the sign.
fn signed<const N: usize>(op: IntOp, ask: Ask) -> Found<N> {
    match op {
        IntOp::Div => two_alike::<DivI, N>(ask),
        IntOp::Rem => two_alike::<RemI, N>(ask),
        IntOp::Shr => two::<ShrI, N>(ask),
        IntOp::Abs => one::<AbsI, N>(ask),
        IntOp::Sign => one::<SignI, N>(ask),
        IntOp::Min => two_commuting::<MinI, N>(ask),
        IntOp::Max => two_commuting::<MaxI, N>(ask),
        IntOp::Clamp => three_alike::<ClampI, N>(ask),
        IntOp::FirstLeadingBit => one::<FirstLeadingI, N>(ask),
        IntOp::ExtractBits => three_alike::<ExtractI, N>(ask),
        IntOp::Add
        | IntOp::Sub
        | IntOp::Mul
        | IntOp::Neg
        | IntOp::Not
        | IntOp::And
        | IntOp::Or
        | IntOp::Xor
        | IntOp::Shl
        | IntOp::CountOneBits
        | IntOp::CountLeadingZeros
        | IntOp::CountTrailingZeros
        | IntOp::ReverseBits
        | IntOp::FirstTrailingBit
        | IntOp::InsertBits => unsigned(op, ask),
    }
}

fn unsigned<const N: usize>(op: IntOp, ask: Ask) -> Found<N> {
    match op {
        IntOp::Add => two_commuting::<Add, N>(ask),
        IntOp::Sub => two::<Sub, N>(ask),
        IntOp::Mul => two_commuting::<Mul, N>(ask),
        IntOp::Div => two_alike::<DivU, N>(ask),
        IntOp::Rem => two_alike::<RemU, N>(ask),
        IntOp::Neg => one::<Neg, N>(ask),
        IntOp::Not => one::<Not, N>(ask),
        IntOp::And => two_commuting::<And, N>(ask),
        IntOp::Or => two_commuting::<Or, N>(ask),
        IntOp::Xor => two_commuting::<Xor, N>(ask),
        IntOp::Shl => two::<Shl, N>(ask),
        IntOp::Shr => two::<ShrU, N>(ask),
        IntOp::Abs | IntOp::Sign => one::<SignI, N>(ask),
        IntOp::Min => two_commuting::<MinU, N>(ask),
        IntOp::Max => two_commuting::<MaxU, N>(ask),
        IntOp::Clamp => three_alike::<ClampU, N>(ask),
        IntOp::CountOneBits => one::<CountOnes, N>(ask),
        IntOp::CountLeadingZeros => one::<LeadingZeros, N>(ask),
        IntOp::CountTrailingZeros => one::<TrailingZeros, N>(ask),
        IntOp::ReverseBits => one::<Reverse, N>(ask),
        IntOp::FirstLeadingBit => one::<FirstLeadingU, N>(ask),
        IntOp::FirstTrailingBit => one::<FirstTrailing, N>(ask),
        IntOp::ExtractBits => three_alike::<ExtractU, N>(ask),
        IntOp::InsertBits => four_alike::<Insert, N>(ask),
    }
}
