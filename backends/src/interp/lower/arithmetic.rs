//! Prefix and infix operators, and products of matrices in the order in which glam's scalar code adds.

use super::super::error::Res;
use super::super::program::op::{Comparison, FloatOp, IntOp, LogicOp};
use super::super::program::{Op, Scalar, Value};
use super::frame::Frame;
use super::layout::Shape;
use super::{Lowerer, malformed};
use naga::{BinaryOperator, Expression, Handle, UnaryOperator};

impl<'m> Lowerer<'m> {
    pub(crate) fn unary(
        &mut self,
        frame: &Frame<'m>,
        op: UnaryOperator,
        operand: Handle<Expression>,
    ) -> Res<Vec<Value>> {
        let values = frame.data(operand)?;
        let one = |a: &Value| match op {
            UnaryOperator::Negate if self.b.scalar(*a).float() => self.b.float_op(FloatOp::Neg, &[*a]),
            UnaryOperator::Negate => self.b.int_op(IntOp::Neg, &[*a]),
            UnaryOperator::LogicalNot => self.b.not(*a),
            UnaryOperator::BitwiseNot => self.b.int_op(IntOp::Not, &[*a]),
        };
        Ok(values.iter().map(one).collect())
    }

    pub(crate) fn binary(
        &mut self,
        frame: &Frame<'m>,
        op: BinaryOperator,
        left: Handle<Expression>,
        right: Handle<Expression>,
    ) -> Res<Vec<Value>> {
        let (a, b) = (frame.data(left)?, frame.data(right)?);
        if op == BinaryOperator::Multiply {
            let shapes = (self.shape(frame, left)?, self.shape(frame, right)?);
            let matrices = (self.types().matrix(shapes.0), self.types().matrix(shapes.1));
            if matrices != (None, None) {
                return self.matrix_product((shapes.0, &a), (shapes.1, &b));
            }
        }
        let mut failed = None;
        let values = self.pairs(&a, &b, |this, a, b| {
            this.scalar_binary(op, a, b).unwrap_or_else(|error| {
                failed = Some(error);
                a
            })
        });
        failed.map_or(Ok(values), Err)
    }

    fn scalar_binary(&mut self, op: BinaryOperator, a: Value, b: Value) -> Res<Value> {
        match self.b.scalar(a) {
            Scalar::F32 | Scalar::F16 | Scalar::F64 => self.float_binary(op, a, b),
            Scalar::I16 | Scalar::U16 | Scalar::I32 | Scalar::U32 | Scalar::I64 | Scalar::U64 => {
                self.int_binary(op, a, b)
            }
            Scalar::Bool => self.bool_binary(op, a, b),
        }
    }

    fn compare(&mut self, comparison: Comparison, a: Value, b: Value) -> Value {
        let scalar = self.b.scalar(a);
        self.b.eval(Op::Compare(scalar, comparison), &[a, b])
    }

    fn float_binary(&mut self, op: BinaryOperator, a: Value, b: Value) -> Res<Value> {
        use BinaryOperator as O;
        Ok(match op {
            O::Add => self.b.float_op(FloatOp::Add, &[a, b]),
            O::Subtract => self.b.float_op(FloatOp::Sub, &[a, b]),
            O::Multiply => self.b.float_op(FloatOp::Mul, &[a, b]),
            O::Divide => self.b.float_op(FloatOp::Div, &[a, b]),
            O::Modulo => self.b.float_op(FloatOp::Rem, &[a, b]),
            O::Equal => self.compare(Comparison::Equal, a, b),
            O::NotEqual => self.compare(Comparison::NotEqual, a, b),
            O::Less => self.compare(Comparison::Less, a, b),
            O::LessEqual => self.compare(Comparison::LessEqual, a, b),
            O::Greater => self.compare(Comparison::Less, b, a),
            O::GreaterEqual => self.compare(Comparison::LessEqual, b, a),
            O::And
            | O::ExclusiveOr
            | O::InclusiveOr
            | O::LogicalAnd
            | O::LogicalOr
            | O::ShiftLeft
            | O::ShiftRight => return Err(malformed("floats have no bitwise operators")),
        })
    }

    fn int_binary(&mut self, op: BinaryOperator, a: Value, b: Value) -> Res<Value> {
        use BinaryOperator as O;
        Ok(match op {
            O::Add => self.b.int_op(IntOp::Add, &[a, b]),
            O::Subtract => self.b.int_op(IntOp::Sub, &[a, b]),
            O::Multiply => self.b.int_op(IntOp::Mul, &[a, b]),
            O::Divide => self.b.int_op(IntOp::Div, &[a, b]),
            O::Modulo => self.b.int_op(IntOp::Rem, &[a, b]),
            O::And => self.b.int_op(IntOp::And, &[a, b]),
            O::ExclusiveOr => self.b.int_op(IntOp::Xor, &[a, b]),
            O::InclusiveOr => self.b.int_op(IntOp::Or, &[a, b]),
            O::ShiftLeft => self.shift(IntOp::Shl, a, b),
            O::ShiftRight => self.shift(IntOp::Shr, a, b),
            O::Equal => self.compare(Comparison::Equal, a, b),
            O::NotEqual => self.compare(Comparison::NotEqual, a, b),
            O::Less => self.compare(Comparison::Less, a, b),
            O::LessEqual => self.compare(Comparison::LessEqual, a, b),
            O::Greater => self.compare(Comparison::Less, b, a),
            O::GreaterEqual => self.compare(Comparison::LessEqual, b, a),
            O::LogicalAnd | O::LogicalOr => return Err(malformed("integers have no logical operators")),
        })
    }

    /// The count is of any width outside of WGSL.
    fn shift(&mut self, op: IntOp, a: Value, by: Value) -> Value {
        let by = self.converted(by, Scalar::U32);
        self.b.int_op(op, &[a, by])
    }

    fn bool_binary(&mut self, op: BinaryOperator, a: Value, b: Value) -> Res<Value> {
        use BinaryOperator as O;
        let op = match op {
            O::LogicalAnd | O::And => LogicOp::And,
            O::LogicalOr | O::InclusiveOr => LogicOp::Or,
            O::NotEqual | O::ExclusiveOr => LogicOp::Xor,
            O::Equal => LogicOp::Same,
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
            | O::ShiftRight => return Err(malformed("booleans have no arithmetic")),
        };
        Ok(self.b.eval(Op::Logic(op), &[a, b]))
    }

    /// A product of which at least one operand is a matrix.
    fn matrix_product(&mut self, (sa, a): (Shape, &[Value]), (sb, b): (Shape, &[Value])) -> Res<Vec<Value>> {
        match (self.types().matrix(sa), self.types().matrix(sb)) {
            (Some((columns, rows)), Some(_)) => {
                let columns = b.chunks(columns).map(|b| self.matrix_vector(rows, a, b));
                Ok(columns.collect::<Res<Vec<_>>>()?.concat())
            }
            (Some((_, rows)), None) if b.len() > 1 => self.matrix_vector(rows, a, b),
            (None, Some((_, rows))) if a.len() > 1 => {
                b.chunks(rows).map(|column| self.dot(a, column)).collect()
            }
            (Some(_), None) | (None, Some(_)) => {
                Ok(self.pairs(a, b, |this, a, b| this.b.float_op(FloatOp::Mul, &[a, b])))
            }
            (None, None) => Err(malformed("a matrix product without a matrix")),
        }
    }

    /// `a[0] * b[0] + a[1] * b[1] + ..` over the columns of `a`.
    fn matrix_vector(&mut self, rows: usize, a: &[Value], b: &[Value]) -> Res<Vec<Value>> {
        (0..rows)
            .map(|row| {
                let across: Vec<_> = a.iter().skip(row).step_by(rows).copied().collect();
                self.dot(&across, b)
            })
            .collect()
    }
}
