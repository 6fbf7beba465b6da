//! Comparisons, booleans and selects. A boolean is all ones or zero, so that choosing is a matter of bits.

use super::super::super::program::Scalar;
use super::super::super::program::op::{Comparison, LogicOp};
use super::super::shape::{Ask, Found, one, three, two, two_commuting};
use super::{functions, mask};

functions! {
    EqualF(a: f32, b: f32) -> u32 = mask(a == b);
    NotEqualF(a: f32, b: f32) -> u32 = mask(a != b);
    LessF(a: f32, b: f32) -> u32 = mask(a < b);
    LessEqualF(a: f32, b: f32) -> u32 = mask(a <= b);
    EqualU(a: u32, b: u32) -> u32 = mask(a == b);
    NotEqualU(a: u32, b: u32) -> u32 = mask(a != b);
    LessU(a: u32, b: u32) -> u32 = mask(a < b);
    LessEqualU(a: u32, b: u32) -> u32 = mask(a <= b);
    LessI(a: i32, b: i32) -> u32 = mask(a < b);
    LessEqualI(a: i32, b: i32) -> u32 = mask(a <= b);
    Not(a: u32) -> u32 = !a;
    And(a: u32, b: u32) -> u32 = a & b;
    AndNot(a: u32, b: u32) -> u32 = a & !b;
    Or(a: u32, b: u32) -> u32 = a | b;
    Xor(a: u32, b: u32) -> u32 = a ^ b;
    Same(a: u32, b: u32) -> u32 = !(a ^ b);
    IsNan(a: f32) -> u32 = mask(a.is_nan());
    IsInf(a: f32) -> u32 = mask(a.is_infinite());
    Select(c: u32, a: u32, b: u32) -> u32 = (c & a) | (!c & b);
    SelectWide(c: u32, a: u64, b: u64) -> u64 = {
        let c = i64::from(c as i32) as u64;
        (c & a) | (!c & b)
    };
}

/// The form of a comparison; none yet for 64 bits.
pub(super) fn compare<const N: usize>(scalar: Scalar, comparison: Comparison, ask: Ask) -> Option<Found<N>> {
    use Comparison as C;
    Some(match (scalar, comparison) {
        (Scalar::F32 | Scalar::F16, C::Equal) => two_commuting::<EqualF, N>(ask),
        (Scalar::F32 | Scalar::F16, C::NotEqual) => two_commuting::<NotEqualF, N>(ask),
        (Scalar::F32 | Scalar::F16, C::Less) => two::<LessF, N>(ask),
        (Scalar::F32 | Scalar::F16, C::LessEqual) => two::<LessEqualF, N>(ask),
        (Scalar::I32 | Scalar::U32 | Scalar::Bool, C::Equal) => two_commuting::<EqualU, N>(ask),
        (Scalar::I32 | Scalar::U32 | Scalar::Bool, C::NotEqual) => two_commuting::<NotEqualU, N>(ask),
        (Scalar::I32, C::Less) => two::<LessI, N>(ask),
        (Scalar::I32, C::LessEqual) => two::<LessEqualI, N>(ask),
        (Scalar::U32 | Scalar::Bool, C::Less) => two::<LessU, N>(ask),
        (Scalar::U32 | Scalar::Bool, C::LessEqual) => two::<LessEqualU, N>(ask),
        (Scalar::I64 | Scalar::U64 | Scalar::F64, _) => return None,
    })
}

pub(super) fn find<const N: usize>(op: LogicOp, ask: Ask) -> Found<N> {
    match op {
        LogicOp::Not => one::<Not, N>(ask),
        LogicOp::And => two_commuting::<And, N>(ask),
        LogicOp::AndNot => two::<AndNot, N>(ask),
        LogicOp::Or => two_commuting::<Or, N>(ask),
        LogicOp::Xor => two_commuting::<Xor, N>(ask),
        LogicOp::Same => two_commuting::<Same, N>(ask),
    }
}

pub(super) fn is_nan<const N: usize>(scalar: Scalar, ask: Ask) -> Option<Found<N>> {
    match scalar {
        Scalar::F32 | Scalar::F16 => Some(one::<IsNan, N>(ask)),
        Scalar::F64 | Scalar::Bool | Scalar::I32 | Scalar::U32 | Scalar::I64 | Scalar::U64 => None,
    }
}

pub(super) fn is_inf<const N: usize>(scalar: Scalar, ask: Ask) -> Option<Found<N>> {
    match scalar {
        Scalar::F32 | Scalar::F16 => Some(one::<IsInf, N>(ask)),
        Scalar::F64 | Scalar::Bool | Scalar::I32 | Scalar::U32 | Scalar::I64 | Scalar::U64 => None,
    }
}

pub(super) fn select<const N: usize>(scalar: Scalar, ask: Ask) -> Found<N> {
    if scalar.wide() { three::<SelectWide, N>(ask) } else { three::<Select, N>(ask) }
}
