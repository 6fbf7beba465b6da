//! Statements.

use super::super::error::Res;
use super::super::program::Stmt;
use super::control::{Flow, Purpose};
use super::frame::{Frame, Item};
use super::{Lowerer, malformed};
use naga::Statement;

impl<'m> Lowerer<'m> {
    /// Walks one statement.
    pub(crate) fn statement(&mut self, frame: &mut Frame<'m>, statement: &'m Statement) -> Res<Flow> {
        match statement {
            Statement::Emit(range) => {
                range.clone().try_for_each(|handle| self.emit(frame, handle))?;
                Ok(Flow::Falls)
            }
            Statement::Block(inner) => self.sequence(frame, inner, None),
            Statement::If { condition, accept, reject } => {
                self.decide(frame, *condition, (accept, None), (reject, None))
            }
            Statement::Switch { selector, cases } => self.switch(frame, *selector, cases),
            Statement::Loop { body, continuing, break_if } => self.repeat(frame, body, continuing, *break_if),
            Statement::Break => self.jump(Purpose::Break),
            Statement::Continue => self.jump(Purpose::Continue),
            Statement::Return { value } => self.give_back(frame, *value),
            Statement::ControlBarrier(naga::Barrier::SUB_GROUP) => {
                // The lanes of a subgroup are never apart.
                self.b.touch();
                Ok(Flow::Falls)
            }
            Statement::ControlBarrier(_) => Ok(self.barrier(frame)),
            Statement::MemoryBarrier(_) => Ok(Flow::Falls),
            Statement::Store { pointer, value } => {
                let (pointer, values) = (frame.pointer(*pointer)?, frame.data(*value)?);
                self.store(pointer, &values)?;
                Ok(Flow::Falls)
            }
            Statement::Atomic { pointer, fun, value, result } => {
                self.atomic(frame, *pointer, fun, *value, *result)
            }
            Statement::WorkGroupUniformLoad { pointer, result } => {
                self.barrier(frame);
                let values = self.load(frame.pointer(*pointer)?)?;
                frame.values[result.index()] = Some(Item::values(values));
                Ok(self.barrier(frame))
            }
            Statement::Call { function, arguments, result } => {
                self.call(frame, *function, arguments, *result)
            }
            Statement::Kill => Err(frame.unsupported("Statement::Kill")),
            Statement::ImageStore { image, coordinate, array_index, value } => {
                self.store_texel(frame, [*image, *coordinate, *value], *array_index)
            }
            Statement::ImageAtomic { image, coordinate, array_index, fun, value } => {
                self.update_texel(frame, [*image, *coordinate, *value], *array_index, *fun)
            }
            Statement::RayQuery { .. } => Err(frame.unsupported("Statement::RayQuery")),
            Statement::RayPipelineFunction(_) => Err(frame.unsupported("Statement::RayPipelineFunction")),
            Statement::SubgroupBallot { result, predicate } => self.ballot(frame, *predicate, *result),
            Statement::SubgroupGather { mode, argument, result } => {
                self.gather(frame, *mode, *argument, *result)
            }
            Statement::SubgroupCollectiveOperation { op, collective_op, argument, result } => {
                self.collect(frame, *op, *collective_op, *argument, *result)
            }
            Statement::CooperativeStore { .. } => Err(frame.unsupported("Statement::CooperativeStore")),
        }
    }

    fn jump(&mut self, purpose: Purpose) -> Res<Flow> {
        let exit = self.innermost(purpose).ok_or(malformed("nothing encloses a break or continue"))?;
        Ok(self.leave(exit))
    }

    /// All invocations of a workgroup meet; rows of a call are on their own.
    fn barrier(&mut self, frame: &Frame<'m>) -> Flow {
        self.b.touch();
        self.b.program.cooperative = true;
        self.b.push(Stmt::Barrier { function: frame.name, at: self.b.at });
        Flow::Falls
    }
}
