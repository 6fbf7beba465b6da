//! Operations on literals become one literal here, in f32.
//!
//! Left to a compiler, `2.0 * 0.1` may be folded in f64; and a literal that no shading language can
//! write (infinity, NaN) is found here, at its Rust line.

use super::value::{Lit, Repr, Value};
use crate::def::{BinaryOp, Scalar, TypeDef, UnaryOp};

/// `op literal`.
pub(super) fn unary(op: UnaryOp, value: &Value) -> Option<Value> {
    let Repr::Literal(lit) = value.repr else { return None };
    Some(Value::literal(match (op, lit) {
        (UnaryOp::Negate, Lit::F32(v, exact)) => Lit::F32(-v, -exact),
        (UnaryOp::Negate, Lit::I32(v)) => Lit::I32(v.wrapping_neg()),
        (UnaryOp::Negate, Lit::Int(v)) => Lit::Int(-v),
        (UnaryOp::Not, Lit::Bool(v)) => Lit::Bool(!v),
        (UnaryOp::Not, Lit::U32(v)) => Lit::U32(!v),
        (UnaryOp::Not, Lit::I32(v)) => Lit::I32(!v),
        (UnaryOp::Not, Lit::Int(v)) => Lit::I32(!(v as i32)),
        (UnaryOp::Negate, Lit::U32(_) | Lit::Bool(_)) | (UnaryOp::Not, Lit::F32(..)) => return None,
    }))
}

/// `literal op literal`; `None` when one of them is none, or there is no such operation.
///
/// # Errors
/// When the outcome is no value of its type.
pub(super) fn binary(op: BinaryOp, l: &Value, r: &Value) -> Result<Option<Value>, String> {
    let (Repr::Literal(l), Repr::Literal(r)) = (l.repr, r.repr) else { return Ok(None) };
    if matches!(op, BinaryOp::ShiftLeft | BinaryOp::ShiftRight) {
        return shift(op, l, r);
    }
    let folded = match (l, r) {
        (Lit::F32(a, x), Lit::F32(b, y)) => float(op, (a, x), (b, y))?,
        (Lit::Bool(a), Lit::Bool(b)) => boolean(op, a, b),
        (Lit::Int(a), Lit::Int(b)) => integer(op, a, b, Lit::Int)?,
        (Lit::U32(a), Lit::U32(b)) => integer(op, a.into(), b.into(), |v| Lit::U32(v as u32))?,
        (Lit::I32(_) | Lit::Int(_), Lit::I32(_) | Lit::Int(_)) => {
            integer(op, l.as_i64(), r.as_i64(), |v| Lit::I32(v as i32))?
        }
        _ => None,
    };
    Ok(folded.map(Value::literal))
}

/// Each operand as the f32 and as the value that its decimals state; both are carried on.
fn float(op: BinaryOp, (a, x): (f32, f64), (b, y): (f32, f64)) -> Result<Option<Lit>, String> {
    let (value, exact, sign) = match op {
        BinaryOp::Add => (a + b, x + y, '+'),
        BinaryOp::Subtract => (a - b, x - y, '-'),
        BinaryOp::Multiply => (a * b, x * y, '*'),
        BinaryOp::Divide => (a / b, x / y, '/'),
        BinaryOp::Remainder => (a % b, x % y, '%'),
        _ => return compared_floats(op, (a, b), (x, y)),
    };
    if value.is_finite() {
        return Ok(Some(Lit::F32(value, exact)));
    }
    Err(format!("`{a:?} {sign} {b:?}` is {value} in f32, for which no shading language has a literal"))
}

/// Rust takes literals that nothing else decides as f64, so the outcome must not hang on that.
fn compared_floats(op: BinaryOp, (a, b): (f32, f32), (x, y): (f64, f64)) -> Result<Option<Lit>, String> {
    let outcome = compared(op, a.partial_cmp(&b));
    if outcome == compared(op, x.partial_cmp(&y)) {
        return Ok(outcome.map(Lit::Bool));
    }
    Err("this comparison of literals turns out differently in f32 and in f64: write its outcome".to_owned())
}

fn compared(op: BinaryOp, order: Option<std::cmp::Ordering>) -> Option<bool> {
    Some(match op {
        BinaryOp::Equal => order.is_some_and(|o| o.is_eq()),
        BinaryOp::NotEqual => order.is_none_or(|o| o.is_ne()),
        BinaryOp::Less => order.is_some_and(|o| o.is_lt()),
        BinaryOp::LessEqual => order.is_some_and(|o| o.is_le()),
        BinaryOp::Greater => order.is_some_and(|o| o.is_gt()),
        BinaryOp::GreaterEqual => order.is_some_and(|o| o.is_ge()),
        _ => return None,
    })
}

fn boolean(op: BinaryOp, a: bool, b: bool) -> Option<Lit> {
    let value = match op {
        BinaryOp::And | BinaryOp::LogicalAnd => a & b,
        BinaryOp::Or | BinaryOp::LogicalOr => a | b,
        BinaryOp::Xor => a ^ b,
        _ => compared(op, Some(a.cmp(&b)))?,
    };
    Some(Lit::Bool(value))
}

fn integer(op: BinaryOp, a: i64, b: i64, wrap: impl Fn(i64) -> Lit) -> Result<Option<Lit>, String> {
    if matches!(op, BinaryOp::Divide | BinaryOp::Remainder) && b == 0 {
        return Err(format!("{a} is divided by zero"));
    }
    let value = match op {
        BinaryOp::Add => a.wrapping_add(b),
        BinaryOp::Subtract => a.wrapping_sub(b),
        BinaryOp::Multiply => a.wrapping_mul(b),
        BinaryOp::Divide => a.wrapping_div(b),
        BinaryOp::Remainder => a.wrapping_rem(b),
        BinaryOp::And => a & b,
        BinaryOp::Or => a | b,
        BinaryOp::Xor => a ^ b,
        _ => return Ok(compared(op, Some(a.cmp(&b))).map(Lit::Bool)),
    };
    Ok(Some(wrap(value)))
}

fn shift(op: BinaryOp, l: Lit, r: Lit) -> Result<Option<Value>, String> {
    let bits = match r {
        Lit::Int(_) | Lit::I32(_) | Lit::U32(_) => r.as_i64(),
        Lit::F32(..) | Lit::Bool(_) => return Ok(None),
    };
    let Some(bits) = u32::try_from(bits).ok().filter(|bits| *bits < 32) else {
        return Err(format!("a 32-bit integer cannot be shifted by {bits} bits"));
    };
    let is_left = op == BinaryOp::ShiftLeft;
    Ok(Some(Value::literal(match l {
        Lit::Int(v) => Lit::Int(if is_left { v << bits } else { v >> bits }),
        Lit::I32(v) => Lit::I32(if is_left { v << bits } else { v >> bits }),
        Lit::U32(v) => Lit::U32(if is_left { v << bits } else { v >> bits }),
        Lit::F32(..) | Lit::Bool(_) => return Ok(None),
    })))
}

/// `literal as ty`, as Rust converts.
///
/// # Errors
/// When the outcome hangs on whether the literal is an f32 or an f64.
pub(super) fn cast(value: &Value, ty: &TypeDef) -> Result<Option<Value>, String> {
    let (Repr::Literal(lit), TypeDef::Scalar(to)) = (value.repr, *ty) else { return Ok(None) };
    let cast = match (lit, to) {
        (_, Scalar::Bool) | (Lit::Bool(_), Scalar::F32) => return Ok(None),
        (Lit::F32(v, exact), _) => return cast_float(v, exact, to).map(Some),
        (Lit::Bool(v), Scalar::I32) => Lit::I32(v.into()),
        (Lit::Bool(v), Scalar::U32) => Lit::U32(v.into()),
        // An undecided integer is an i32, as in Rust.
        (Lit::Int(v), Scalar::F32) => Lit::F32(v as i32 as f32, f64::from(v as i32)),
        (Lit::I32(_) | Lit::U32(_), Scalar::F32) => Lit::F32(lit.as_i64() as f32, lit.as_i64() as f64),
        (Lit::Int(_) | Lit::I32(_) | Lit::U32(_), Scalar::I32) => Lit::I32(lit.as_i64() as i32),
        (Lit::Int(_) | Lit::I32(_) | Lit::U32(_), Scalar::U32) => Lit::U32(lit.as_i64() as u32),
    };
    Ok(Some(Value::literal(cast)))
}

fn cast_float(v: f32, exact: f64, to: Scalar) -> Result<Value, String> {
    let (lit, same) = match to {
        Scalar::I32 => (Lit::I32(v as i32), v as i32 == exact as i32),
        Scalar::U32 => (Lit::U32(v as u32), v as u32 == exact as u32),
        Scalar::F32 | Scalar::Bool => (Lit::F32(v, exact), v == exact as f32),
    };
    if same {
        return Ok(Value::literal(lit));
    }
    Err("this cast of a literal turns out differently in f32 and in f64: write its outcome".to_owned())
}

/// The bits of a literal as another kind of scalar.
///
/// # Errors
/// When they are no finite float.
pub(super) fn reinterpret(value: &Value, to: Scalar) -> Result<Option<Value>, String> {
    let Repr::Literal(lit) = value.repr else { return Ok(None) };
    Ok(match (lit, to) {
        (Lit::F32(v, _), Scalar::U32) => Some(Value::literal(Lit::U32(v.to_bits()))),
        (Lit::U32(bits), Scalar::F32) => {
            let v = f32::from_bits(bits);
            if !v.is_finite() {
                return Err(format!("these bits are {v}, for which no shading language has a literal"));
            }
            Some(Value::literal(Lit::F32(v, v.into())))
        }
        _ => None,
    })
}
