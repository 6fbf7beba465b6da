//! Atomics.

use super::super::error::Res;
use super::super::program::op::Comparison;
use super::super::program::{Atomic, Op, Stmt, Update, Value};
use super::control::Flow;
use super::frame::{Frame, Item};
use super::{Lowerer, malformed};
use naga::{AtomicFunction, Expression, Handle};

impl<'m> Lowerer<'m> {
    pub(crate) fn atomic(
        &mut self,
        frame: &mut Frame<'m>,
        pointer: Handle<Expression>,
        fun: &AtomicFunction,
        value: Handle<Expression>,
        result: Option<Handle<Expression>>,
    ) -> Res<Flow> {
        let pointer = frame.pointer(pointer)?;
        let place = Self::place(pointer, pointer.offset)
            .ok_or(malformed("an atomic lies in workgroup or storage memory"))?;
        if let super::super::program::Place::Buffer { buffer, .. } = place {
            self.b.program.buffers[buffer as usize].written = true;
        }
        let value = frame.single(value)?;
        let expected = match fun {
            AtomicFunction::Exchange { compare: Some(compare) } => Some(frame.single(*compare)?),
            AtomicFunction::Exchange { compare: None }
            | AtomicFunction::Add
            | AtomicFunction::Subtract
            | AtomicFunction::And
            | AtomicFunction::ExclusiveOr
            | AtomicFunction::InclusiveOr
            | AtomicFunction::Min
            | AtomicFunction::Max => None,
        };
        let old = result.map(|_| self.b.register(self.b.scalar(value)));
        let at = self.b.at;
        self.b.touch();
        self.b.push(Stmt::Atomic(Atomic { place, fun: update(fun), value, expected, old, at }));
        if let (Some(result), Some(old)) = (result, old) {
            let old = Value::Reg(old);
            let mut values = vec![old];
            if let Some(expected) = expected {
                let scalar = self.b.scalar(old);
                values.push(self.b.eval(Op::Compare(scalar, Comparison::Equal), &[old, expected]));
            }
            frame.values[result.index()] = Some(Item::values(values));
        }
        Ok(Flow::Falls)
    }
}

pub(super) fn update(fun: &AtomicFunction) -> Update {
    match fun {
        AtomicFunction::Add => Update::Add,
        AtomicFunction::Subtract => Update::Subtract,
        AtomicFunction::And => Update::And,
        AtomicFunction::ExclusiveOr => Update::Xor,
        AtomicFunction::InclusiveOr => Update::Or,
        AtomicFunction::Min => Update::Min,
        AtomicFunction::Max => Update::Max,
        AtomicFunction::Exchange { compare: None } => Update::Exchange,
        AtomicFunction::Exchange { compare: Some(_) } => Update::CompareExchange,
    }
}
