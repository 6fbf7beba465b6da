//! Operators and casts: typing, folding of literals, splatting of scalars.

use super::body::BodyBuilder;
use super::error::{Fail, Lowered};
use super::fold;
use super::module::{scalar, vector_size};
use super::value::{BOOL, I32, Lit, Sink, U32, Value};
use crate::def::{BinaryOp, Expr, ExprKind, Scalar, Span, TypeDef, UnaryOp};
use naga::{BinaryOperator, Expression, RelationalFunction, Statement, UnaryOperator};

impl BodyBuilder<'_> {
    pub(super) fn unary(&mut self, op: UnaryOp, value: Value, span: Span) -> Lowered<Value> {
        if let Some(folded) = fold::unary(op, &value) {
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
        // What stands on the other side tells more than what is expected of the whole.
        let peeked = if is_logical { None } else { self.peek_pair(op, left, right) };
        let hint = peeked.as_ref().or(hint);
        let l = self.expr_expecting(left, hint)?;
        let right_hint = match op {
            BinaryOp::ShiftLeft | BinaryOp::ShiftRight => Some(&U32),
            _ if l.is_undecided() => hint,
            _ => Some(&l.ty),
        };
        let r = self.expr_expecting(right, right_hint)?;
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
        let is_shift = matches!(op, BinaryOp::ShiftLeft | BinaryOp::ShiftRight);
        // The two sides of a shift need not have one type.
        let (l, r) = if is_shift { (l, r) } else { (l.follow(&r), r.follow(&l)) };
        if let Some(folded) = fold::binary(op, &l, &r).map_err(|message| Fail::new(span, message))? {
            return Ok(folded);
        }
        if is_shift {
            return self.shift(op, l, r, span);
        }
        if compares(op) {
            return self.compare(op, l, r, span);
        }
        let Some(ty) = result(op, &l.ty, &r.ty) else {
            return Err(Fail::new(span, self.mismatch("no such operation on", "and", &l.ty, &r.ty)));
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
            return Err(Fail::new(span, self.mismatch("cannot compare", "with", &l.ty, &r.ty)));
        }
        if l.ty == BOOL && !matches!(op, BinaryOp::Equal | BinaryOp::NotEqual) {
            return Err(Fail::new(span, "no shading language orders booleans: write `!a && b` for `a < b`"));
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
        let r = match r.ty {
            TypeDef::Vector(_, Scalar::I32) => self.convert(r, Scalar::U32, Some(4), span),
            ty if ty == I32 => self.cast(r, &U32, span)?,
            _ => r,
        };
        let (left, mut right) = (self.handle(l, span), self.handle(r, span));
        if let (TypeDef::Vector(n, _), TypeDef::Scalar(_)) = (l.ty, r.ty) {
            right = self.append(Expression::Splat { size: vector_size(n), value: right }, span);
        }
        Ok(self.value(l.ty, Expression::Binary { op: naga_operator(op, &l.ty), left, right }, span))
    }

    /// `value as ty`.
    pub(super) fn cast(&mut self, value: Value, ty: &TypeDef, span: Span) -> Lowered<Value> {
        if let Some(folded) = fold::cast(&value, ty).map_err(|message| Fail::new(span, message))? {
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
                let converted = self.convert(value, to, Some(4), span);
                Ok(if from == Scalar::F32 { self.saturated(value, converted, to, span) } else { converted })
            }
            (from, to) => Err(Fail::new(span, format!("no cast from {from} to {to}"))),
        }
    }

    /// What Rust converts float `value` to: shaders stop at the largest f32 that the integer type holds, Rust goes on
    /// to the largest integer.
    fn saturated(&mut self, value: Value, converted: Value, to: Scalar, span: Span) -> Value {
        let (beyond, most) = match to {
            Scalar::I32 => (2_147_483_648.0_f32, Lit::I32(i32::MAX)),
            Scalar::U32 => (4_294_967_296.0, Lit::U32(u32::MAX)),
            Scalar::F32 | Scalar::Bool => return converted,
        };
        let left = self.handle(value, span);
        let right = self.handle(Value::literal(Lit::F32(beyond, beyond.into())), span);
        let op = BinaryOperator::GreaterEqual;
        let condition = self.append(Expression::Binary { op, left, right }, span);
        let accept = self.handle(Value::literal(most), span);
        let reject = self.handle(converted, span);
        self.value(TypeDef::Scalar(to), Expression::Select { condition, accept, reject }, span)
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
        ExprKind::Float(..)
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
