//! Statements.

use super::super::error::{InterpError, Res};
use super::super::model::{Model, Pick};
use super::{Frame, Machine};
use naga::{Block, Expression, Handle, Statement};

impl<'m, M: Model> Machine<'m, M> {
    /// Executes `block` in the active lanes, as long as there are any.
    pub(super) fn block(&mut self, frame: &mut Frame<'m, M>, block: &'m Block) -> Res<()> {
        for statement in block {
            if !frame.flow.active.any() {
                break;
            }
            self.statement(frame, statement)?;
        }
        Ok(())
    }

    fn statement(&mut self, frame: &mut Frame<'m, M>, statement: &'m Statement) -> Res<()> {
        match statement {
            Statement::Emit(range) => range.clone().try_for_each(|handle| self.emit(frame, handle)),
            Statement::Block(inner) => self.block(frame, inner),
            Statement::If { condition, accept, reject } => self.decide(frame, *condition, accept, reject),
            Statement::Switch { selector, cases } => self.switch(frame, *selector, cases),
            Statement::Loop { body, continuing, break_if } => self.repeat(frame, body, continuing, *break_if),
            Statement::Break => {
                let lanes = frame.flow.active.take();
                frame.flow.broke.join(&lanes);
                Ok(())
            }
            Statement::Continue => {
                let lanes = frame.flow.active.take();
                frame.flow.continued.join(&lanes);
                Ok(())
            }
            Statement::Return { value } => self.give_back(frame, *value),
            Statement::ControlBarrier(_) => self.barrier(frame),
            Statement::MemoryBarrier(_) => Ok(()),
            Statement::Store { pointer, value } => {
                let (pointer, value) = (frame.pointer(*pointer)?, frame.data(*value)?);
                let types = self.types();
                self.memory.store(&self.model, types, pointer, value, &frame.flow.active)
            }
            Statement::Atomic { pointer, fun, value, result } => {
                self.atomic(frame, *pointer, fun, *value, *result)
            }
            Statement::WorkGroupUniformLoad { pointer, result } => {
                self.barrier(frame)?;
                let pointer = frame.pointer(*pointer)?;
                let leaves = self.memory.load(&self.model, self.types(), pointer, self.lanes)?;
                frame.values[result.index()] = Some(super::Value::data(leaves));
                Ok(())
            }
            Statement::Call { function, arguments, result } => {
                self.call(frame, *function, arguments, *result)
            }
            Statement::Kill => Err(frame.unsupported("Statement::Kill")),
            Statement::ImageStore { .. } => Err(frame.unsupported("Statement::ImageStore")),
            Statement::ImageAtomic { .. } => Err(frame.unsupported("Statement::ImageAtomic")),
            Statement::RayQuery { .. } => Err(frame.unsupported("Statement::RayQuery")),
            Statement::RayPipelineFunction(_) => Err(frame.unsupported("Statement::RayPipelineFunction")),
            Statement::SubgroupBallot { .. } => Err(frame.unsupported("Statement::SubgroupBallot")),
            Statement::SubgroupGather { .. } => Err(frame.unsupported("Statement::SubgroupGather")),
            Statement::SubgroupCollectiveOperation { .. } => {
                Err(frame.unsupported("Statement::SubgroupCollectiveOperation"))
            }
            Statement::CooperativeStore { .. } => Err(frame.unsupported("Statement::CooperativeStore")),
        }
    }

    /// The active lanes return; lanes that may have returned before (after an ambiguous decision) join
    /// both values.
    fn give_back(&mut self, frame: &mut Frame<'m, M>, value: Option<Handle<Expression>>) -> Res<()> {
        let active = frame.flow.active.take();
        let again = active.filter(|lane| frame.flow.returned.get(lane));
        let first = active.filter(|lane| !frame.flow.returned.get(lane));
        if let Some(value) = value {
            let value = frame.data(value)?.to_vec();
            let flow = &mut frame.flow;
            let (early, early_exact) = (&flow.value_returned, &flow.exact_returned);
            for (result, value) in flow.result.iter_mut().zip(&value) {
                if again.any() {
                    let pick = |lane| Pick { value: !early.get(lane), exact: !early_exact.get(lane) };
                    result.join(&self.model, value, &again, pick)?;
                }
                result.blend(value, &first)?;
            }
        }
        frame.flow.returned.join(&active);
        frame.flow.value_returned.join(&active);
        frame.flow.exact_returned.join(&active);
        Ok(())
    }

    /// All invocations of a workgroup must arrive together; rows of a call are on their own.
    fn barrier(&self, frame: &Frame<'m, M>) -> Res<()> {
        if self.workgroup && !frame.flow.active.every() {
            return Err(InterpError::NonUniformBarrier { function: frame.name() });
        }
        Ok(())
    }
}
