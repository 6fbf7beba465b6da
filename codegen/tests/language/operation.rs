//! Operations of [`crate::evaluate`], by component.

use crate::evaluate::Value::{self, Bool, F32, I32, Parts, U32};
use lobe_codegen::math;
use naga::{BinaryOperator as B, MathFunction as M, RelationalFunction, ScalarKind, UnaryOperator};

pub(crate) fn unary(op: UnaryOperator, value: &Value) -> Value {
    match (op, value) {
        (_, Parts(parts)) => Parts(parts.iter().map(|p| unary(op, p)).collect()),
        (UnaryOperator::Negate, F32(v)) => F32(-v),
        (UnaryOperator::Negate, I32(v)) => I32(v.wrapping_neg()),
        (UnaryOperator::LogicalNot, Bool(v)) => Bool(!v),
        (UnaryOperator::BitwiseNot, I32(v)) => I32(!v),
        (UnaryOperator::BitwiseNot, U32(v)) => U32(!v),
        other => panic!("{other:?}"),
    }
}

pub(crate) fn binary(op: B, l: &Value, r: &Value) -> Value {
    match (l, r) {
        (Parts(a), Parts(b)) => Parts(a.iter().zip(b).map(|(a, b)| binary(op, a, b)).collect()),
        (Parts(a), b) if op == B::Multiply => Parts(a.iter().map(|a| binary(op, a, b)).collect()),
        (a, Parts(b)) if op == B::Multiply => Parts(b.iter().map(|b| binary(op, a, b)).collect()),
        (F32(a), F32(b)) => float(op, *a, *b),
        (I32(a), U32(b)) if op == B::ShiftLeft => I32(a << b),
        (I32(a), U32(b)) if op == B::ShiftRight => I32(a >> b),
        (I32(a), I32(b)) => signed(op, *a, *b),
        (U32(a), U32(b)) => unsigned(op, *a, *b),
        (Bool(a), Bool(b)) => Bool(match op {
            B::And | B::LogicalAnd => a & b,
            B::InclusiveOr | B::LogicalOr => a | b,
            B::Equal => a == b,
            B::NotEqual => a != b,
            _ => panic!("{op:?} of booleans"),
        }),
        other => panic!("{op:?} of {other:?}"),
    }
}

fn compared<T: PartialOrd>(op: B, a: T, b: T) -> Value {
    Bool(match op {
        B::Equal => a == b,
        B::NotEqual => a != b,
        B::Less => a < b,
        B::LessEqual => a <= b,
        B::Greater => a > b,
        B::GreaterEqual => a >= b,
        _ => panic!("{op:?} is no comparison"),
    })
}

fn float(op: B, a: f32, b: f32) -> Value {
    F32(match op {
        B::Add => a + b,
        B::Subtract => a - b,
        B::Multiply => a * b,
        B::Divide => a / b,
        B::Modulo => a % b,
        _ => return compared(op, a, b),
    })
}

macro_rules! integer {
    ($name:ident, $ty:ident, $variant:ident, $shift:expr) => {
        fn $name(op: B, a: $ty, b: $ty) -> Value {
            $variant(match op {
                B::Add => a.wrapping_add(b),
                B::Subtract => a.wrapping_sub(b),
                B::Multiply => a.wrapping_mul(b),
                B::Divide => a.wrapping_div(b),
                B::Modulo => a.wrapping_rem(b),
                B::And => a & b,
                B::InclusiveOr => a | b,
                B::ExclusiveOr => a ^ b,
                B::ShiftLeft if $shift => a << b,
                B::ShiftRight if $shift => a >> b,
                _ => return compared(op, a, b),
            })
        }
    };
}
integer!(signed, i32, I32, false);
integer!(unsigned, u32, U32, true);

pub(crate) fn relational(fun: RelationalFunction, value: &Value) -> Value {
    let Parts(parts) = value else { panic!("{fun:?} of {value:?}") };
    Bool(match fun {
        RelationalFunction::All => parts.iter().all(|p| *p == Bool(true)),
        RelationalFunction::Any => parts.contains(&Bool(true)),
        _ => panic!("{fun:?}"),
    })
}

pub(crate) fn convert(value: &Value, kind: ScalarKind, convert: Option<u8>) -> Value {
    match (value, kind, convert) {
        (Parts(parts), ..) => Parts(parts.iter().map(|p| self::convert(p, kind, convert)).collect()),
        (F32(v), ScalarKind::Uint, None) => U32(v.to_bits()),
        (U32(v), ScalarKind::Float, None) => F32(f32::from_bits(*v)),
        (F32(v), ScalarKind::Sint, Some(4)) => I32(math::scalar::to_i32(*v)),
        (F32(v), ScalarKind::Uint, Some(4)) => U32(math::scalar::to_u32(*v)),
        (I32(v), ScalarKind::Float, Some(4)) => F32(*v as f32),
        (U32(v), ScalarKind::Float, Some(4)) => F32(*v as f32),
        (I32(v), ScalarKind::Uint, Some(4)) => U32(*v as u32),
        (U32(v), ScalarKind::Sint, Some(4)) => I32(*v as i32),
        (Bool(v), ScalarKind::Sint, Some(4)) => I32((*v).into()),
        (Bool(v), ScalarKind::Uint, Some(4)) => U32((*v).into()),
        other => panic!("{other:?}"),
    }
}

pub(crate) fn math(fun: M, arguments: &[Value]) -> Value {
    match (fun, arguments) {
        (M::Dot, [Parts(a), Parts(b)]) => {
            let products = a.iter().zip(b).map(|(a, b)| binary(B::Multiply, a, b));
            products.reduce(|sum, p| binary(B::Add, &sum, &p)).expect("a component")
        }
        (M::Length, [a]) => math(M::Sqrt, &[math(M::Dot, &[a.clone(), a.clone()])]),
        (M::Cross, [Parts(a), Parts(b)]) => {
            let product = |i: usize, j: usize| binary(B::Multiply, &a[i], &b[j]);
            let part = |i, j| binary(B::Subtract, &product(i, j), &product(j, i));
            Parts(vec![part(1, 2), part(2, 0), part(0, 1)])
        }
        (_, [Parts(first), ..]) => Parts(
            (0..first.len())
                .map(|i| math(fun, &arguments.iter().map(|a| component(a, i)).collect::<Vec<_>>()))
                .collect(),
        ),
        (M::Abs, [F32(v)]) => F32(v.abs()),
        (M::Abs, [I32(v)]) => I32(v.wrapping_abs()),
        (M::Sqrt, [F32(v)]) => F32(v.sqrt()),
        (M::Exp, [F32(v)]) => F32(math::scalar::exp(*v)),
        (M::Floor, [F32(v)]) => F32(v.floor()),
        (M::Min, [F32(a), F32(b)]) => F32(math::scalar::min(*a, *b)),
        (M::Max, [F32(a), F32(b)]) => F32(math::scalar::max(*a, *b)),
        (M::Min, [I32(a), I32(b)]) => I32(*a.min(b)),
        (M::Max, [U32(a), U32(b)]) => U32(*a.max(b)),
        (M::Fma, [F32(a), F32(b), F32(c)]) => F32(a.mul_add(*b, *c)),
        other => panic!("{other:?}"),
    }
}

fn component(value: &Value, i: usize) -> Value {
    let Parts(parts) = value else { panic!("{value:?} has no parts") };
    parts[i].clone()
}
