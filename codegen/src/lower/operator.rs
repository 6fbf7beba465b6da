//! Operators and casts: typing, folding of literals, splatting of scalars.

use super::body::BodyBuilder;
use super::error::{Fail, Lowered};
use super::module::{scalar, vector_size};
use super::value::{BOOL, I32, Lit, Repr, Sink, U32, Value};
use crate::def::{BinaryOp, Expr, ExprKind, Scalar, Span, TypeDef, UnaryOp};
use naga::{BinaryOperator, Expression, RelationalFunction, Statement, UnaryOperator};

impl BodyBuilder<'_> {
    pub(super) fn unary(&mut self, op: UnaryOp, value: Value, span: Span) -> Lowered<Value> {
        if let Some(folded) = fold_unary(op, &value) {
            return Ok(folded);
        }
        let naga_op = match (op, parts(&value.ty)) {
            (UnaryOp::Negate, Some((_, Scalar::F32 | Scalar::I32))) => UnaryOperator::Negate,
            (UnaryOp::Not, Some((_, Scalar::Bool))) => UnaryOperator::LogicalNot,
            (UnaryOp::Not, Some((_, Scalar::I32 | Scalar::U32))) => UnaryOperator::BitwiseNot,
            _ => return Err(Fail::new(span, format!("{} has no such prefix operator", value.ty))),
        };
        let expr = self.handle(value, span);
        Ok(self.value(value.ty, Expression::Unary { op: naga_op, expr }, span))
    }

    /// `left op right` as written; `&&` and `||` evaluate the right side only when it counts.
    pub(super) fn binary_expr(
        &mut self,
        op: BinaryOp,
        left: &'static Expr,
        right: &'static Expr,
        expected: Option<&TypeDef>,
        span: Span,
    ) -> Lowered<Value> {
        let is_logical = matches!(op, BinaryOp::LogicalAnd | BinaryOp::LogicalOr);
        if is_logical && !is_harmless(right) {
            return self.short_circuit(op, left, right, span);
        }
        // A comparison's operands are of their own type, not of the one expected of its outcome.
        let hint = if compares(op) || is_logical { None } else { expected };
        let l = self.expr_expecting(left, hint)?;
        let r = self.expr_expecting(right, (!l.is_undecided()).then_some(&l.ty).or(hint))?;
        self.binary(op, l, r, span)
    }

    fn short_circuit(
        &mut self,
        op: BinaryOp,
        left: &'static Expr,
        right: &'static Expr,
        span: Span,
    ) -> Lowered<Value> {
        let left_value = self.expr(left)?;
        let left_value = self.fit(left_value, &BOOL, left.span)?;
        let place = self.variable(None, &BOOL);
        self.store(place, left_value, span);
        let is_and = op == BinaryOp::LogicalAnd;
        let condition = self.handle(left_value, span);
        let (other, _) = self.nested(|b| {
            b.expr_into(right, &mut Sink::Variable { name: None, expected: Some(BOOL), place: Some(place) })
        })?;
        let (accept, reject) = if is_and { (other, naga::Block::new()) } else { (naga::Block::new(), other) };
        self.push(Statement::If { condition, accept, reject }, span);
        Ok(self.load(place, span))
    }

    /// `l op r` on values.
    pub(super) fn binary(&mut self, op: BinaryOp, l: Value, r: Value, span: Span) -> Lowered<Value> {
        let (l, r) = (l.decide(&r.ty), r.decide(&l.ty));
        if let Some(folded) = fold(op, &l, &r) {
            return Ok(folded);
        }
        if matches!(op, BinaryOp::ShiftLeft | BinaryOp::ShiftRight) {
            return self.shift(op, l, r, span);
        }
        if compares(op) {
            return self.compare(op, l, r, span);
        }
        let Some(ty) = result(op, &l.ty, &r.ty) else {
            return Err(Fail::new(span, format!("no such operation on {} and {}", l.ty, r.ty)));
        };
        let (mut left, mut right) = (self.handle(l, span), self.handle(r, span));
        if needs_splat(op, &l.ty, &r.ty)
            && let TypeDef::Vector(n, _) = ty
        {
            let size = vector_size(n);
            if matches!(l.ty, TypeDef::Scalar(_)) {
                left = self.append(Expression::Splat { size, value: left }, span);
            } else {
                right = self.append(Expression::Splat { size, value: right }, span);
            }
        }
        Ok(self.value(ty, Expression::Binary { op: naga_operator(op, &ty), left, right }, span))
    }

    fn compare(&mut self, op: BinaryOp, l: Value, r: Value, span: Span) -> Lowered<Value> {
        if l.ty != r.ty || parts(&l.ty).is_none() {
            return Err(Fail::new(span, format!("cannot compare {} with {}", l.ty, r.ty)));
        }
        let outcome = self.compare_components(op, l, r, span);
        // Rust's == and != on vectors speak of the whole.
        let fun = match (op, l.ty) {
            (BinaryOp::Equal, TypeDef::Vector(..)) => RelationalFunction::All,
            (BinaryOp::NotEqual, TypeDef::Vector(..)) => RelationalFunction::Any,
            (_, TypeDef::Scalar(_)) => return Ok(outcome),
            _ => return Err(Fail::new(span, "vectors are compared with `cmplt` and its siblings")),
        };
        let argument = self.handle(outcome, span);
        Ok(self.value(BOOL, Expression::Relational { fun, argument }, span))
    }

    /// A comparison of each component.
    pub(super) fn compare_components(&mut self, op: BinaryOp, l: Value, r: Value, span: Span) -> Value {
        let ty = match l.ty {
            TypeDef::Vector(n, _) => TypeDef::Vector(n, Scalar::Bool),
            _ => BOOL,
        };
        let (left, right) = (self.handle(l, span), self.handle(r, span));
        self.value(ty, Expression::Binary { op: naga_operator(op, &l.ty), left, right }, span)
    }

    fn shift(&mut self, op: BinaryOp, l: Value, r: Value, span: Span) -> Lowered<Value> {
        let l = l.decide(&I32);
        let r = r.decide(&U32);
        if !matches!(parts(&l.ty), Some((_, Scalar::I32 | Scalar::U32))) {
            return Err(Fail::new(span, format!("{} has no bits to shift", l.ty)));
        }
        let r = if r.ty == I32 { self.cast(r, &U32, span)? } else { r };
        let (left, right) = (self.handle(l, span), self.handle(r, span));
        Ok(self.value(l.ty, Expression::Binary { op: naga_operator(op, &l.ty), left, right }, span))
    }

    /// `value as ty`.
    pub(super) fn cast(&mut self, value: Value, ty: &TypeDef, span: Span) -> Lowered<Value> {
        if let Some(folded) = fold_cast(&value, ty) {
            return Ok(folded);
        }
        let value = value.decide(&I32);
        if value.ty == *ty {
            return Ok(value);
        }
        match (value.ty, *ty) {
            (TypeDef::Scalar(from), TypeDef::Scalar(to)) if to != Scalar::Bool => {
                if from == Scalar::Bool && to == Scalar::F32 {
                    return Err(Fail::new(span, "`bool as f32` is no Rust; write `select(0.0, 1.0, b)`"));
                }
                Ok(self.convert(value, to, Some(4), span))
            }
            (from, to) => Err(Fail::new(span, format!("no cast from {from} to {to}"))),
        }
    }

    /// Conversion of value (`Some(4)`) or of bits (`None`) to scalars of kind `to`.
    pub(super) fn convert(&mut self, value: Value, to: Scalar, convert: Option<u8>, span: Span) -> Value {
        let ty = match value.ty {
            TypeDef::Vector(n, _) => TypeDef::Vector(n, to),
            _ => TypeDef::Scalar(to),
        };
        let expr = self.handle(value, span);
        self.value(ty, Expression::As { expr, kind: scalar(to).kind, convert }, span)
    }
}

/// Components (1 for a scalar) and their kind.
pub(super) fn parts(ty: &TypeDef) -> Option<(u8, Scalar)> {
    match *ty {
        TypeDef::Scalar(s) => Some((1, s)),
        TypeDef::Vector(n, s) => Some((n, s)),
        TypeDef::Matrix(..)
        | TypeDef::Array(..)
        | TypeDef::Slice(_)
        | TypeDef::Atomic(_)
        | TypeDef::Struct(_) => None,
    }
}

fn compares(op: BinaryOp) -> bool {
    match op {
        BinaryOp::Equal
        | BinaryOp::NotEqual
        | BinaryOp::Less
        | BinaryOp::LessEqual
        | BinaryOp::Greater
        | BinaryOp::GreaterEqual => true,
        BinaryOp::Add
        | BinaryOp::Subtract
        | BinaryOp::Multiply
        | BinaryOp::Divide
        | BinaryOp::Remainder
        | BinaryOp::LogicalAnd
        | BinaryOp::LogicalOr
        | BinaryOp::And
        | BinaryOp::Or
        | BinaryOp::Xor
        | BinaryOp::ShiftLeft
        | BinaryOp::ShiftRight => false,
    }
}

/// Whether evaluating `e` in vain can neither fail nor cost much.
fn is_harmless(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Float(_)
        | ExprKind::Int(..)
        | ExprKind::Bool(_)
        | ExprKind::Local(_)
        | ExprKind::Constant(_)
        | ExprKind::TypeConstant(..) => true,
        ExprKind::Unary(_, inner) | ExprKind::Field(inner, _) | ExprKind::Cast(inner, _) => {
            is_harmless(inner)
        }
        ExprKind::Binary(op, l, r) => {
            !matches!(op, BinaryOp::Divide | BinaryOp::Remainder) && is_harmless(l) && is_harmless(r)
        }
        ExprKind::Call(..)
        | ExprKind::TypeCall(..)
        | ExprKind::Method(..)
        | ExprKind::Index(..)
        | ExprKind::Struct { .. }
        | ExprKind::Array(_)
        | ExprKind::Repeat(..)
        | ExprKind::If { .. }
        | ExprKind::Match { .. }
        | ExprKind::Block(_) => false,
    }
}

fn naga_operator(op: BinaryOp, ty: &TypeDef) -> BinaryOperator {
    let is_bool = matches!(parts(ty), Some((_, Scalar::Bool)));
    match op {
        BinaryOp::Add => BinaryOperator::Add,
        BinaryOp::Subtract => BinaryOperator::Subtract,
        BinaryOp::Multiply => BinaryOperator::Multiply,
        BinaryOp::Divide => BinaryOperator::Divide,
        BinaryOp::Remainder => BinaryOperator::Modulo,
        BinaryOp::Equal => BinaryOperator::Equal,
        BinaryOp::NotEqual => BinaryOperator::NotEqual,
        BinaryOp::Less => BinaryOperator::Less,
        BinaryOp::LessEqual => BinaryOperator::LessEqual,
        BinaryOp::Greater => BinaryOperator::Greater,
        BinaryOp::GreaterEqual => BinaryOperator::GreaterEqual,
        BinaryOp::LogicalAnd => BinaryOperator::LogicalAnd,
        BinaryOp::LogicalOr => BinaryOperator::LogicalOr,
        BinaryOp::And => BinaryOperator::And,
        BinaryOp::Or => BinaryOperator::InclusiveOr,
        // Booleans differ where their exclusive or holds.
        BinaryOp::Xor if is_bool => BinaryOperator::NotEqual,
        BinaryOp::Xor => BinaryOperator::ExclusiveOr,
        BinaryOp::ShiftLeft => BinaryOperator::ShiftLeft,
        BinaryOp::ShiftRight => BinaryOperator::ShiftRight,
    }
}

/// The type of an arithmetic, logical or bitwise operation.
fn result(op: BinaryOp, l: &TypeDef, r: &TypeDef) -> Option<TypeDef> {
    use BinaryOp as B;
    match op {
        B::LogicalAnd | B::LogicalOr => (*l == BOOL && *r == BOOL).then_some(BOOL),
        B::And | B::Or | B::Xor => (l == r && parts(l)?.1 != Scalar::F32).then_some(*l),
        _ => match (*l, *r) {
            (TypeDef::Matrix(c, n), TypeDef::Vector(m, Scalar::F32)) if op == B::Multiply && c == m => {
                Some(TypeDef::Vector(n, Scalar::F32))
            }
            (TypeDef::Matrix(..), TypeDef::Matrix(..)) if l == r => {
                matches!(op, B::Add | B::Subtract | B::Multiply).then_some(*l)
            }
            (m @ TypeDef::Matrix(..), TypeDef::Scalar(Scalar::F32))
            | (TypeDef::Scalar(Scalar::F32), m @ TypeDef::Matrix(..)) => (op == B::Multiply).then_some(m),
            _ => {
                let ((n, s), (m, t)) = (parts(l)?, parts(r)?);
                let fits = s == t && s != Scalar::Bool && (n == m || n == 1 || m == 1);
                fits.then_some(if n >= m { *l } else { *r })
            }
        },
    }
}

/// Whether a scalar operand must be spread: naga multiplies vectors by scalars, and nothing else.
fn needs_splat(op: BinaryOp, l: &TypeDef, r: &TypeDef) -> bool {
    let mixed = match (l, r) {
        (TypeDef::Scalar(s), TypeDef::Vector(..)) | (TypeDef::Vector(..), TypeDef::Scalar(s)) => Some(*s),
        _ => None,
    };
    match mixed {
        None => false,
        Some(s) => op != BinaryOp::Multiply || s != Scalar::F32,
    }
}

fn fold_unary(op: UnaryOp, value: &Value) -> Option<Value> {
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

/// Two literals become one here, in f32: left to a compiler they may be folded in f64.
fn fold(op: BinaryOp, l: &Value, r: &Value) -> Option<Value> {
    let (Repr::Literal(l), Repr::Literal(r)) = (l.repr, r.repr) else { return None };
    match (l, r) {
        (Lit::F32(a, x), Lit::F32(b, y)) => {
            let (value, exact) = match op {
                BinaryOp::Add => (a + b, x + y),
                BinaryOp::Subtract => (a - b, x - y),
                BinaryOp::Multiply => (a * b, x * y),
                BinaryOp::Divide => (a / b, x / y),
                _ => return None,
            };
            value.is_finite().then(|| Value::literal(Lit::F32(value, exact)))
        }
        (Lit::Int(a), Lit::Int(b)) => fold_int(op, a, b).map(|v| Value::literal(Lit::Int(v))),
        (Lit::I32(a), Lit::I32(b)) => {
            fold_int(op, a.into(), b.into()).map(|v| Value::literal(Lit::I32(v as i32)))
        }
        (Lit::U32(a), Lit::U32(b)) => {
            fold_int(op, a.into(), b.into()).map(|v| Value::literal(Lit::U32(v as u32)))
        }
        _ => None,
    }
}

fn fold_int(op: BinaryOp, a: i64, b: i64) -> Option<i64> {
    match op {
        BinaryOp::Add => Some(a.wrapping_add(b)),
        BinaryOp::Subtract => Some(a.wrapping_sub(b)),
        BinaryOp::Multiply => Some(a.wrapping_mul(b)),
        BinaryOp::And => Some(a & b),
        BinaryOp::Or => Some(a | b),
        BinaryOp::Xor => Some(a ^ b),
        _ => None,
    }
}

fn fold_cast(value: &Value, ty: &TypeDef) -> Option<Value> {
    let (Repr::Literal(lit), TypeDef::Scalar(to)) = (value.repr, *ty) else { return None };
    let number = match lit {
        Lit::Int(v) => v,
        Lit::I32(v) => v.into(),
        Lit::U32(v) => v.into(),
        Lit::F32(..) | Lit::Bool(_) => return None,
    };
    Some(Value::literal(match to {
        Scalar::F32 => Lit::F32(number as f32, number as f64),
        Scalar::I32 => Lit::I32(number as i32),
        Scalar::U32 => Lit::U32(number as u32),
        Scalar::Bool => return None,
    }))
}
