//! Subgroups: the invocations of a workgroup that run side by side.

use super::super::error::Res;
use super::super::program::subgroup::{Gather, SubgroupOp};
use super::super::program::{Scalar, Stmt, Subgroup, Value};
use super::Lowerer;
use super::control::Flow;
use super::frame::{Frame, Item};
use naga::{CollectiveOperation, Direction, Expression, GatherMode, Handle, SubgroupOperation};

impl<'m> Lowerer<'m> {
    pub(crate) fn ballot(
        &mut self,
        frame: &mut Frame<'m>,
        predicate: Option<Handle<Expression>>,
        result: Handle<Expression>,
    ) -> Res<Flow> {
        let value = match predicate {
            Some(predicate) => frame.single(predicate)?,
            None => self.boolean(true),
        };
        let word = |word| self.exchange(SubgroupOp::Ballot(word), value, None, Scalar::U32);
        let words = (0..4).map(word).collect();
        frame.values[result.index()] = Some(Item::values(words));
        Ok(Flow::Falls)
    }

    pub(crate) fn gather(
        &mut self,
        frame: &mut Frame<'m>,
        mode: GatherMode,
        argument: Handle<Expression>,
        result: Handle<Expression>,
    ) -> Res<Flow> {
        let (gather, index) = match mode {
            GatherMode::BroadcastFirst => (Gather::First, None),
            GatherMode::Broadcast(index) | GatherMode::Shuffle(index) => (Gather::Lane, Some(index)),
            GatherMode::ShuffleDown(by) => (Gather::Down, Some(by)),
            GatherMode::ShuffleUp(by) => (Gather::Up, Some(by)),
            GatherMode::ShuffleXor(bits) => (Gather::Xor, Some(bits)),
            GatherMode::QuadBroadcast(index) => (Gather::Quad, Some(index)),
            GatherMode::QuadSwap(Direction::X) => (Gather::QuadSwap(1), None),
            GatherMode::QuadSwap(Direction::Y) => (Gather::QuadSwap(2), None),
            GatherMode::QuadSwap(Direction::Diagonal) => (Gather::QuadSwap(3), None),
        };
        let index = index.map(|index| frame.single(index)).transpose()?;
        self.each_scalar(frame, argument, result, SubgroupOp::Gather(gather), index)
    }

    pub(crate) fn collect(
        &mut self,
        frame: &mut Frame<'m>,
        op: SubgroupOperation,
        how: CollectiveOperation,
        argument: Handle<Expression>,
        result: Handle<Expression>,
    ) -> Res<Flow> {
        self.each_scalar(frame, argument, result, SubgroupOp::Collect(op, how), None)
    }

    fn each_scalar(
        &mut self,
        frame: &mut Frame<'m>,
        argument: Handle<Expression>,
        result: Handle<Expression>,
        op: SubgroupOp,
        index: Option<Value>,
    ) -> Res<Flow> {
        let values = frame.data(argument)?;
        let results = values.iter().map(|value| self.exchange(op, *value, index, self.b.scalar(*value)));
        let results = results.collect();
        frame.values[result.index()] = Some(Item::values(results));
        Ok(Flow::Falls)
    }

    fn exchange(&mut self, op: SubgroupOp, value: Value, index: Option<Value>, result: Scalar) -> Value {
        self.b.program.cooperative = true;
        let (to, at) = (self.b.register(result), self.b.at);
        self.b.push(Stmt::Subgroup(Subgroup { op, value, index, to, at }));
        Value::Reg(to)
    }
}
