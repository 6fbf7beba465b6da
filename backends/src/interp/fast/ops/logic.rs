//! Comparisons, booleans and selects. A boolean is all ones or zero, so that choosing is a matter of bits.

use super::super::super::program::Scalar;
use super::super::super::program::op::{Comparison, LogicOp};
use super::super::Isa;
use super::super::control::JumpWhere;
use super::super::shape::{Ask, Exec, Found, exec, one, three, two, two_alike, two_commuting};
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
    EqualWide(a: u64, b: u64) -> u32 = mask(a == b);
    NotEqualWide(a: u64, b: u64) -> u32 = mask(a != b);
    LessU64(a: u64, b: u64) -> u32 = mask(a < b);
    LessEqualU64(a: u64, b: u64) -> u32 = mask(a <= b);
    LessI64(a: i64, b: i64) -> u32 = mask(a < b);
    LessEqualI64(a: i64, b: i64) -> u32 = mask(a <= b);
    EqualF64(a: f64, b: f64) -> u32 = mask(a == b);
    NotEqualF64(a: f64, b: f64) -> u32 = mask(a != b);
    LessF64(a: f64, b: f64) -> u32 = mask(a < b);
    LessEqualF64(a: f64, b: f64) -> u32 = mask(a <= b);
    IsNanF64(a: f64) -> u32 = mask(a.is_nan());
    IsInfF64(a: f64) -> u32 = mask(a.is_infinite());
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

/// The form of a comparison.
pub(super) fn compare<const N: usize>(scalar: Scalar, comparison: Comparison, ask: Ask) -> Found<N> {
    use Comparison as C;
    use Scalar as S;
    match (scalar, comparison) {
        (S::F32 | S::F16, C::Equal) => two_commuting::<EqualF, N>(ask),
        (S::F32 | S::F16, C::NotEqual) => two_commuting::<NotEqualF, N>(ask),
        (S::F32 | S::F16, C::Less) => two::<LessF, N>(ask),
        (S::F32 | S::F16, C::LessEqual) => two::<LessEqualF, N>(ask),
        (S::I16 | S::U16 | S::I32 | S::U32 | S::Bool, C::Equal) => two_commuting::<EqualU, N>(ask),
        (S::I16 | S::U16 | S::I32 | S::U32 | S::Bool, C::NotEqual) => two_commuting::<NotEqualU, N>(ask),
        (S::I16 | S::I32, C::Less) => two::<LessI, N>(ask),
        (S::I16 | S::I32, C::LessEqual) => two::<LessEqualI, N>(ask),
        (S::U16 | S::U32 | S::Bool, C::Less) => two::<LessU, N>(ask),
        (S::U16 | S::U32 | S::Bool, C::LessEqual) => two::<LessEqualU, N>(ask),
        (S::I64 | S::U64, C::Equal) => two_alike::<EqualWide, N>(ask),
        (S::I64 | S::U64, C::NotEqual) => two_alike::<NotEqualWide, N>(ask),
        (S::I64, C::Less) => two_alike::<LessI64, N>(ask),
        (S::I64, C::LessEqual) => two_alike::<LessEqualI64, N>(ask),
        (S::U64, C::Less) => two_alike::<LessU64, N>(ask),
        (S::U64, C::LessEqual) => two_alike::<LessEqualU64, N>(ask),
        (S::F64, C::Equal) => two_alike::<EqualF64, N>(ask),
        (S::F64, C::NotEqual) => two_alike::<NotEqualF64, N>(ask),
        (S::F64, C::Less) => two_alike::<LessF64, N>(ask),
        (S::F64, C::LessEqual) => two_alike::<LessEqualF64, N>(ask),
    }
}

/// The step that jumps where a comparison of cells is `WHEN`, if there is one.
pub(in super::super) fn jump<const WHEN: bool, const N: usize>(
    scalar: Scalar,
    comparison: Comparison,
) -> Option<Exec<N>> {
    use Comparison as C;
    use Scalar as S;
    let run = match (scalar, comparison) {
        (S::F32, C::Equal) => exec::<JumpWhere<EqualF, WHEN>, N>,
        (S::F32, C::NotEqual) => exec::<JumpWhere<NotEqualF, WHEN>, N>,
        (S::F32, C::Less) => exec::<JumpWhere<LessF, WHEN>, N>,
        (S::F32, C::LessEqual) => exec::<JumpWhere<LessEqualF, WHEN>, N>,
        (S::I32 | S::U32, C::Equal) => exec::<JumpWhere<EqualU, WHEN>, N>,
        (S::I32 | S::U32, C::NotEqual) => exec::<JumpWhere<NotEqualU, WHEN>, N>,
        (S::I32, C::Less) => exec::<JumpWhere<LessI, WHEN>, N>,
        (S::I32, C::LessEqual) => exec::<JumpWhere<LessEqualI, WHEN>, N>,
        (S::U32, C::Less) => exec::<JumpWhere<LessU, WHEN>, N>,
        (S::U32, C::LessEqual) => exec::<JumpWhere<LessEqualU, WHEN>, N>,
        (S::Bool | S::I16 | S::U16 | S::F16 | S::I64 | S::U64 | S::F64, _) => return None,
    };
    Some(run(Isa::Portable))
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

/// Of a float.
pub(super) fn is_nan<const N: usize>(scalar: Scalar, ask: Ask) -> Found<N> {
    if scalar.wide() { one::<IsNanF64, N>(ask) } else { one::<IsNan, N>(ask) }
}

/// Of a float.
pub(super) fn is_inf<const N: usize>(scalar: Scalar, ask: Ask) -> Found<N> {
    if scalar.wide() { one::<IsInfF64, N>(ask) } else { one::<IsInf, N>(ask) }
}

pub(super) fn select<const N: usize>(scalar: Scalar, ask: Ask) -> Found<N> {
    if scalar.wide() { three::<SelectWide, N>(ask) } else { three::<Select, N>(ask) }
}
