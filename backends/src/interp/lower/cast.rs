//! Conversions and reinterpretations.

use super::super::error::Res;
use super::super::program::{Op, Scalar, Value};
use super::frame::Frame;
use super::{Lowerer, layout};
use naga::{Bytes, Expression, Handle, ScalarKind};

impl<'m> Lowerer<'m> {
    pub(crate) fn cast(
        &mut self,
        frame: &Frame<'m>,
        operand: Handle<Expression>,
        kind: ScalarKind,
        convert: Option<Bytes>,
    ) -> Res<Vec<Value>> {
        let values = frame.data(operand)?;
        values.iter().map(|value| self.cast_scalar(*value, kind, convert)).collect()
    }

    fn cast_scalar(&mut self, value: Value, kind: ScalarKind, convert: Option<Bytes>) -> Res<Value> {
        let from = self.b.scalar(value);
        let width = convert.unwrap_or(from.bytes() as Bytes);
        let to = layout::scalar(naga::Scalar { kind, width })?;
        let bits = convert.is_none() && from != Scalar::Bool && to != Scalar::Bool;
        Ok(if bits { self.reinterpreted(value, to) } else { self.converted(value, to) })
    }

    /// The number as one of another type.
    pub(crate) fn converted(&mut self, value: Value, to: Scalar) -> Value {
        let from = self.b.scalar(value);
        if from == to { value } else { self.b.eval(Op::Convert(from, to), &[value]) }
    }

    /// The bits as those of another type of the same size.
    pub(crate) fn reinterpreted(&mut self, value: Value, to: Scalar) -> Value {
        let from = self.b.scalar(value);
        if from == to { value } else { self.b.eval(Op::Bitcast(from, to), &[value]) }
    }
}
