//! Operators and conversions on single columns.

use super::error::{Internal, Result};
use super::expr::{f2, map, zip};
use super::model::{Comparison, F2, Model};
use super::value::Column;
use naga::{BinaryOperator, ScalarKind};

/// `a op b`; `signed` says how integers are read.
pub(super) fn binary<M: Model>(
    op: BinaryOperator,
    a: &Column<M>,
    b: &Column<M>,
    signed: bool,
) -> Result<Column<M>> {
    match a {
        Column::F(_) => float(op, a, b),
        Column::W(_) => word(op, a, b, signed),
        Column::B(_) => boolean(op, a, b),
    }
}

fn float<M: Model>(op: BinaryOperator, a: &Column<M>, b: &Column<M>) -> Result<Column<M>> {
    match op {
        BinaryOperator::Add => f2(F2::Add, a, b),
        BinaryOperator::Subtract => f2(F2::Subtract, a, b),
        BinaryOperator::Multiply => f2(F2::Multiply, a, b),
        BinaryOperator::Divide => f2(F2::Divide, a, b),
        BinaryOperator::Modulo => f2(F2::Remainder, a, b),
        BinaryOperator::Equal
        | BinaryOperator::NotEqual
        | BinaryOperator::Less
        | BinaryOperator::LessEqual
        | BinaryOperator::Greater
        | BinaryOperator::GreaterEqual => {
            let op = comparison(op).ok_or(Internal::Kind)?;
            Ok(Column::B(zip(a.floats()?, b.floats()?, |x, y| M::compare(op, x, y))))
        }
        BinaryOperator::And
        | BinaryOperator::ExclusiveOr
        | BinaryOperator::InclusiveOr
        | BinaryOperator::LogicalAnd
        | BinaryOperator::LogicalOr
        | BinaryOperator::ShiftLeft
        | BinaryOperator::ShiftRight => Err(Internal::Kind.into()),
    }
}

fn comparison(op: BinaryOperator) -> Option<Comparison> {
    Some(match op {
        BinaryOperator::Equal => Comparison::Equal,
        BinaryOperator::NotEqual => Comparison::NotEqual,
        BinaryOperator::Less => Comparison::Less,
        BinaryOperator::LessEqual => Comparison::LessEqual,
        BinaryOperator::Greater => Comparison::Greater,
        BinaryOperator::GreaterEqual => Comparison::GreaterEqual,
        BinaryOperator::Add
        | BinaryOperator::Subtract
        | BinaryOperator::Multiply
        | BinaryOperator::Divide
        | BinaryOperator::Modulo
        | BinaryOperator::And
        | BinaryOperator::ExclusiveOr
        | BinaryOperator::InclusiveOr
        | BinaryOperator::LogicalAnd
        | BinaryOperator::LogicalOr
        | BinaryOperator::ShiftLeft
        | BinaryOperator::ShiftRight => return None,
    })
}

/// Integers wrap; a quotient by zero is the dividend, a remainder by zero is 0, and so WGSL has it for the
/// one quotient that overflows; shifts count modulo 32.
fn word<M: Model>(op: BinaryOperator, a: &Column<M>, b: &Column<M>, signed: bool) -> Result<Column<M>> {
    let (x, y) = (a.words()?, b.words()?);
    if let Some(op) = comparison(op) {
        let holds = |a: u32, b: u32| if signed { op.holds(a as i32, b as i32) } else { op.holds(a, b) };
        return Ok(Column::B(zip(x, y, |x, y| M::test(x, y, holds))));
    }
    let f: fn(u32, u32) -> u32 = match op {
        BinaryOperator::Add => u32::wrapping_add,
        BinaryOperator::Subtract => u32::wrapping_sub,
        BinaryOperator::Multiply => u32::wrapping_mul,
        BinaryOperator::Divide if signed => |a, b| {
            let (a, b) = (a as i32, b as i32);
            (if b == 0 { a } else { a.wrapping_div(b) }) as u32
        },
        BinaryOperator::Divide => |a, b| a.checked_div(b).unwrap_or(a),
        BinaryOperator::Modulo if signed => |a, b| {
            let (a, b) = (a as i32, b as i32);
            (if b == 0 { 0 } else { a.wrapping_rem(b) }) as u32
        },
        BinaryOperator::Modulo => |a, b| a.checked_rem(b).unwrap_or(0),
        BinaryOperator::And => |a, b| a & b,
        BinaryOperator::ExclusiveOr => |a, b| a ^ b,
        BinaryOperator::InclusiveOr => |a, b| a | b,
        BinaryOperator::ShiftLeft => |a, b| a << (b & 31),
        BinaryOperator::ShiftRight if signed => |a, b| ((a as i32) >> (b & 31)) as u32,
        BinaryOperator::ShiftRight => |a, b| a >> (b & 31),
        BinaryOperator::Equal
        | BinaryOperator::NotEqual
        | BinaryOperator::Less
        | BinaryOperator::LessEqual
        | BinaryOperator::Greater
        | BinaryOperator::GreaterEqual
        | BinaryOperator::LogicalAnd
        | BinaryOperator::LogicalOr => return Err(Internal::Kind.into()),
    };
    Ok(Column::W(zip(x, y, |x, y| M::w2(x, y, f))))
}

fn boolean<M: Model>(op: BinaryOperator, a: &Column<M>, b: &Column<M>) -> Result<Column<M>> {
    let or = |x, y| M::not(M::and(M::not(x), M::not(y)));
    let differ = |x, y| M::and(or(x, y), M::not(M::and(x, y)));
    let (x, y) = (a.bools()?, b.bools()?);
    Ok(Column::B(match op {
        BinaryOperator::And | BinaryOperator::LogicalAnd => zip(x, y, M::and),
        BinaryOperator::InclusiveOr | BinaryOperator::LogicalOr => zip(x, y, or),
        BinaryOperator::NotEqual | BinaryOperator::ExclusiveOr => zip(x, y, differ),
        BinaryOperator::Equal => zip(x, y, |x, y| M::not(differ(x, y))),
        BinaryOperator::Add
        | BinaryOperator::Subtract
        | BinaryOperator::Multiply
        | BinaryOperator::Divide
        | BinaryOperator::Modulo
        | BinaryOperator::Less
        | BinaryOperator::LessEqual
        | BinaryOperator::Greater
        | BinaryOperator::GreaterEqual
        | BinaryOperator::ShiftLeft
        | BinaryOperator::ShiftRight => return Err(Internal::Kind.into()),
    }))
}

/// Conversion of values, or (`convert` false) of bits.
pub(super) fn cast<M: Model>(
    column: &Column<M>,
    from: ScalarKind,
    to: ScalarKind,
    convert: bool,
) -> Result<Column<M>> {
    let zero = M::word(0);
    Ok(match (column, to) {
        (Column::F(x), ScalarKind::Float) => Column::F(x.clone()),
        (Column::F(x), ScalarKind::Sint | ScalarKind::Uint) if !convert => Column::W(map(x, M::to_bits)),
        (Column::F(x), ScalarKind::Sint) => Column::W(map(x, |x| M::to_word(x, |v| v as i32 as u32))),
        (Column::F(x), ScalarKind::Uint) => Column::W(map(x, |x| M::to_word(x, |v| v as u32))),
        (Column::F(x), ScalarKind::Bool) => {
            Column::B(map(x, |x| M::compare(Comparison::NotEqual, x, M::float(0.0, 0.0))))
        }
        (Column::W(x), ScalarKind::Sint | ScalarKind::Uint) => Column::W(x.clone()),
        (Column::W(x), ScalarKind::Float) if !convert => Column::F(map(x, M::from_bits)),
        (Column::W(x), ScalarKind::Float) if from == ScalarKind::Sint => {
            Column::F(map(x, |x| M::to_float(x, |v| f64::from(v as i32))))
        }
        (Column::W(x), ScalarKind::Float) => Column::F(map(x, |x| M::to_float(x, f64::from))),
        (Column::W(x), ScalarKind::Bool) => Column::B(map(x, |x| M::test(x, zero, |a, b| a != b))),
        (Column::B(x), ScalarKind::Bool) => Column::B(x.clone()),
        (Column::B(x), ScalarKind::Sint | ScalarKind::Uint) => Column::W(map(x, M::bool_to_word)),
        (Column::B(x), ScalarKind::Float) => {
            Column::F(map(x, |x| M::to_float(M::bool_to_word(x), f64::from)))
        }
        (_, ScalarKind::AbstractInt | ScalarKind::AbstractFloat) => return Err(Internal::Type.into()),
    })
}
