//! Tests of floats and of vectors of booleans.

use super::super::error::Res;
use super::super::program::op::LogicOp;
use super::super::program::{Op, Value};
use super::{Lowerer, malformed};
use naga::RelationalFunction;

impl Lowerer<'_> {
    pub(crate) fn relational(&mut self, fun: RelationalFunction, values: &[Value]) -> Res<Vec<Value>> {
        match fun {
            RelationalFunction::All => self.fold(LogicOp::And, values),
            RelationalFunction::Any => self.fold(LogicOp::Or, values),
            RelationalFunction::IsNan => Ok(self.tests(Op::IsNan, values)),
            RelationalFunction::IsInf => Ok(self.tests(Op::IsInf, values)),
        }
    }

    fn fold(&mut self, op: LogicOp, values: &[Value]) -> Res<Vec<Value>> {
        let (first, rest) = values.split_first().ok_or(malformed("a vector without components"))?;
        Ok(vec![rest.iter().fold(*first, |all, v| self.b.eval(Op::Logic(op), &[all, *v]))])
    }

    fn tests(&mut self, op: fn(super::Scalar) -> Op, values: &[Value]) -> Vec<Value> {
        values.iter().map(|v| self.b.eval(op(self.b.scalar(*v)), &[*v])).collect()
    }
}
