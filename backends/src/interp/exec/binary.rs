//! Infix operators.

use super::super::error::Res;
use super::super::leaf::Leaf;
use super::super::model::Model;
use super::{Frame, InterpError, Machine};
use naga::{BinaryOperator, Expression, Handle, ScalarKind, TypeInner};

impl<'m, M: Model> Machine<'m, M> {
    pub(super) fn binary(
        &self,
        frame: &Frame<'m, M>,
        op: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Res<Vec<Leaf<M>>> {
        let (a, b) = (frame.data(left)?, frame.data(right)?);
        let (ty_a, ty_b) = (self.type_of(frame, left), self.type_of(frame, right));
        if op == BinaryOperator::Multiply && (is_matrix(ty_a) || is_matrix(ty_b)) {
            return self.matrix_product((ty_a, a), (ty_b, b));
        }
        match ty_a.scalar().map(|s| s.kind) {
            Some(ScalarKind::Float) => self.columns(a, b, |a, b| self.float_binary(op, a, b)),
            Some(ScalarKind::Sint) => self.columns(a, b, |a, b| self.signed_binary(op, a, b)),
            Some(ScalarKind::Uint) => self.columns(a, b, |a, b| self.unsigned_binary(op, a, b)),
            Some(ScalarKind::Bool) => self.columns(a, b, |a, b| self.bool_binary(op, a, b)),
            Some(ScalarKind::AbstractInt | ScalarKind::AbstractFloat) | None => {
                Err(frame.unsupported(format!("{op:?} of these operands")))
            }
        }
    }

    fn float_binary(&self, op: BinaryOperator, a: &Leaf<M>, b: &Leaf<M>) -> Res<Leaf<M>> {
        use BinaryOperator as O;
        let m = &self.model;
        match op {
            O::Add => self.zip_f(a, b, |a, b| m.add(a, b)),
            O::Subtract => self.zip_f(a, b, |a, b| m.sub(a, b)),
            O::Multiply => self.mul_leaf(a, b),
            O::Divide => self.zip_f(a, b, |a, b| m.div(a, b)),
            O::Modulo => self.zip_f(a, b, |a, b| m.rem(a, b)),
            O::Equal => self.compare_f(a, b, |a, b| m.equal(a, b)),
            O::NotEqual => self.compare_f(a, b, |a, b| m.not(m.equal(a, b))),
            O::Less => self.compare_f(a, b, |a, b| m.less(a, b)),
            O::LessEqual => self.compare_f(a, b, |a, b| m.less_equal(a, b)),
            O::Greater => self.compare_f(a, b, |a, b| m.less(b, a)),
            O::GreaterEqual => self.compare_f(a, b, |a, b| m.less_equal(b, a)),
            O::And
            | O::ExclusiveOr
            | O::InclusiveOr
            | O::LogicalAnd
            | O::LogicalOr
            | O::ShiftLeft
            | O::ShiftRight => Err(InterpError::Malformed("floats have no bitwise operators")),
        }
    }

    fn signed_binary(&self, op: BinaryOperator, a: &Leaf<M>, b: &Leaf<M>) -> Res<Leaf<M>> {
        use BinaryOperator as O;
        let compare = |f: fn(&i32, &i32) -> bool| self.compare_w(a, b, |a, b| f(&(a as i32), &(b as i32)));
        match op {
            O::Divide => self.zip_w(a, b, |a, b| signed_quotient(a as i32, b as i32) as u32),
            O::Modulo => self.zip_w(a, b, |a, b| signed_remainder(a as i32, b as i32) as u32),
            O::Less => compare(i32::lt),
            O::LessEqual => compare(i32::le),
            O::Greater => compare(i32::gt),
            O::GreaterEqual => compare(i32::ge),
            O::ShiftRight => self.zip_w(a, b, |a, b| (a as i32).wrapping_shr(b) as u32),
            O::Add
            | O::Subtract
            | O::Multiply
            | O::Equal
            | O::NotEqual
            | O::And
            | O::ExclusiveOr
            | O::InclusiveOr
            | O::LogicalAnd
            | O::LogicalOr
            | O::ShiftLeft => self.unsigned_binary(op, a, b),
        }
    }

    /// On unsigned integers; those that do not depend on the sign serve signed ones too.
    fn unsigned_binary(&self, op: BinaryOperator, a: &Leaf<M>, b: &Leaf<M>) -> Res<Leaf<M>> {
        use BinaryOperator as O;
        match op {
            O::Add => self.zip_w(a, b, u32::wrapping_add),
            O::Subtract => self.zip_w(a, b, u32::wrapping_sub),
            O::Multiply => self.zip_w(a, b, u32::wrapping_mul),
            O::Divide => self.zip_w(a, b, |a, b| a.checked_div(b).unwrap_or(a)),
            O::Modulo => self.zip_w(a, b, |a, b| a.checked_rem(b).unwrap_or(0)),
            O::Equal => self.compare_w(a, b, |a, b| a == b),
            O::NotEqual => self.compare_w(a, b, |a, b| a != b),
            O::Less => self.compare_w(a, b, |a, b| a < b),
            O::LessEqual => self.compare_w(a, b, |a, b| a <= b),
            O::Greater => self.compare_w(a, b, |a, b| a > b),
            O::GreaterEqual => self.compare_w(a, b, |a, b| a >= b),
            O::And => self.zip_w(a, b, |a, b| a & b),
            O::ExclusiveOr => self.zip_w(a, b, |a, b| a ^ b),
            O::InclusiveOr => self.zip_w(a, b, |a, b| a | b),
            O::ShiftLeft => self.zip_w(a, b, u32::wrapping_shl),
            O::ShiftRight => self.zip_w(a, b, u32::wrapping_shr),
            O::LogicalAnd | O::LogicalOr => Err(InterpError::Malformed("integers have no logical operators")),
        }
    }

    fn bool_binary(&self, op: BinaryOperator, a: &Leaf<M>, b: &Leaf<M>) -> Res<Leaf<M>> {
        use BinaryOperator as O;
        let m = &self.model;
        match op {
            O::LogicalAnd | O::And => self.zip_b(a, b, |a, b| m.and(a, b)),
            O::LogicalOr | O::InclusiveOr => self.zip_b(a, b, |a, b| m.or(a, b)),
            O::NotEqual | O::ExclusiveOr => self.zip_b(a, b, |a, b| m.xor(a, b)),
            O::Equal => self.zip_b(a, b, |a, b| m.not(m.xor(a, b))),
            O::Add
            | O::Subtract
            | O::Multiply
            | O::Divide
            | O::Modulo
            | O::Less
            | O::LessEqual
            | O::Greater
            | O::GreaterEqual
            | O::ShiftLeft
            | O::ShiftRight => Err(InterpError::Malformed("booleans have no arithmetic")),
        }
    }
}

fn is_matrix(ty: &TypeInner) -> bool {
    super::matrix::dimensions(ty).is_some()
}

/// `a` when `b` is zero or the quotient overflows.
fn signed_quotient(a: i32, b: i32) -> i32 {
    a.checked_div(b).unwrap_or(a)
}

/// 0 when `b` is zero or the quotient overflows.
fn signed_remainder(a: i32, b: i32) -> i32 {
    a.checked_rem(b).unwrap_or(0)
}
