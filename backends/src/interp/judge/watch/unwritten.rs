//! Values of variables that nothing was written to: they may be moved, not used.

use super::super::super::error::Res;
use super::super::super::mask::Mask;
use super::super::super::model::Model;
use super::super::super::program::op::Mark;
use super::super::super::program::{Eval, Op, Place, Reg, Stmt, Value};
use super::super::Machine;
use naga::Span;

/// The lanes of registers and cells that hold nothing, if there are any.
#[derive(Debug, Default)]
pub(super) struct Unwritten {
    registers: Vec<Option<Mask>>,
    /// Of each array, each cell.
    arrays: Vec<Vec<Option<Mask>>>,
    /// Words of workgroup memory that nothing was written to; nothing of buffers.
    own: Vec<Vec<bool>>,
}

impl Unwritten {
    pub(super) fn begin<M: Model>(&mut self, m: &Machine<'_, M>) {
        self.registers = vec![None; m.registers.len()];
        self.arrays = m.arrays.iter().map(|cells| vec![None; cells.len()]).collect();
        let own = m.program.buffers.iter().zip(&m.shared);
        let words = |bound: bool, count: usize| if bound { Vec::new() } else { vec![true; count] };
        self.own = own.map(|(b, shared)| words(b.binding.is_some(), shared.cells.len())).collect();
    }

    /// A lane that uses an operand without a value, and where; follows what a statement moves.
    pub(super) fn before<M: Model>(&mut self, m: &Machine<'_, M>, stmt: &Stmt) -> Res<Option<(usize, Span)>> {
        match stmt {
            Stmt::Eval(eval) => Ok(self.operand(m, eval).map(|lane| (lane, eval.at))),
            Stmt::Set { to, value } => {
                self.take(m, *to, *value);
                Ok(None)
            }
            Stmt::Store { place, value, at } => {
                let place_used = place.index().and_then(|index| self.used(m, index));
                let used = match *place {
                    Place::Lane { array, offset, index } => {
                        self.store(m, array, &m.addresses(offset, index)?, *value);
                        None
                    }
                    Place::Buffer { buffer, offset, index } => {
                        self.write(m, buffer, &m.addresses(offset, index)?, *value);
                        self.used(m, *value)
                    }
                    // Made by passes; the judge refuses it.
                    Place::Element { .. } => None,
                };
                Ok(place_used.or(used).map(|lane| (lane, *at)))
            }
            Stmt::Atomic(atomic) => {
                let mut used = None;
                stmt.operands(&mut |value| used = used.or_else(|| self.used(m, value)));
                if let Place::Buffer { buffer, offset, index } = atomic.place {
                    self.write(m, buffer, &m.addresses(offset, index)?, atomic.value);
                }
                Ok(used.map(|lane| (lane, atomic.at)))
            }
            Stmt::If { condition, accept, .. } => {
                let at = super::last_span(accept).unwrap_or_default();
                Ok(self.used(m, *condition).map(|lane| (lane, at)))
            }
            Stmt::Texture(access) => {
                let mut used = None;
                stmt.operands(&mut |value| used = used.or_else(|| self.used(m, value)));
                Ok(used.map(|lane| (lane, access.at)))
            }
            Stmt::Subgroup(subgroup) => Ok(self.used(m, subgroup.value).map(|lane| (lane, subgroup.at))),
            Stmt::Loop { .. } | Stmt::Scope { .. } | Stmt::Leave(_) | Stmt::Barrier { .. } => Ok(None),
        }
    }

    /// A lane that uses an operand of an operation that does more than move it.
    fn operand<M: Model>(&self, m: &Machine<'_, M>, eval: &Eval) -> Option<usize> {
        let args = &eval.args[..];
        let used = match eval.op {
            Op::Copy(_) => &[],
            Op::Select(_) => &args[..1],
            _ => args,
        };
        let place = eval.op.place().and_then(|place| place.index());
        used.iter().copied().chain(place).find_map(|value| self.used(m, value))
    }

    /// An active lane in which the value is none.
    pub(super) fn used<M: Model>(&self, m: &Machine<'_, M>, value: Value) -> Option<usize> {
        let Value::Reg(Reg(at)) = value else {
            return None;
        };
        let empty = self.registers[at as usize].as_ref()?;
        m.flow.active.lanes().find(|lane| empty.get(*lane))
    }

    /// Notes what an operation has returned.
    pub(super) fn result<M: Model>(&mut self, m: &Machine<'_, M>, eval: &Eval) -> Res<()> {
        match (eval.op, &eval.args[..]) {
            (Op::Mark(_, Mark::Unwritten), _) => self.put(m, eval.to, |_| true),
            (Op::Copy(_), &[value]) => self.take(m, eval.to, value),
            (Op::Select(_), &[condition, accept, reject]) => {
                let condition = m.bools(condition)?;
                let (accept, reject) = (self.empty(accept), self.empty(reject));
                let chosen =
                    |lane: usize| if m.model.decision(condition.at(lane)) { &accept } else { &reject };
                self.put(m, eval.to, |lane| chosen(lane).as_ref().is_some_and(|mask| mask.get(lane)));
            }
            (Op::Load { place: Place::Lane { array, offset, index }, .. }, _) => {
                let at = m.addresses(offset, index)?;
                let cells = std::mem::take(&mut self.arrays[array as usize]);
                let last = cells.len().saturating_sub(1);
                let empty = |lane: usize| cells[at[lane].min(last)].as_ref().is_some_and(|c| c.get(lane));
                self.put(m, eval.to, empty);
                self.arrays[array as usize] = cells;
            }
            (Op::Load { place: Place::Buffer { buffer, offset, index }, .. }, _) => {
                let at = m.addresses(offset, index)?;
                let own = std::mem::take(&mut self.own[buffer as usize]);
                self.put(m, eval.to, |lane| own.get(at[lane] / 4).copied().unwrap_or(false));
                self.own[buffer as usize] = own;
            }
            _ => self.put(m, eval.to, |_| false),
        }
        Ok(())
    }

    fn empty(&self, value: Value) -> Option<Mask> {
        match value {
            Value::Reg(Reg(at)) => self.registers[at as usize].clone(),
            Value::Const(_) => None,
        }
    }

    fn take<M: Model>(&mut self, m: &Machine<'_, M>, to: Reg, value: Value) {
        let empty = self.empty(value);
        self.put(m, to, |lane| empty.as_ref().is_some_and(|mask| mask.get(lane)));
    }

    /// Sets the active lanes of a register.
    fn put<M: Model>(&mut self, m: &Machine<'_, M>, Reg(to): Reg, empty: impl Fn(usize) -> bool) {
        let to = &mut self.registers[to as usize];
        put(m, to, m.flow.active.lanes(), empty);
    }

    fn store<M: Model>(&mut self, m: &Machine<'_, M>, array: u32, at: &[usize], value: Value) {
        let empty = self.empty(value);
        let cells = &mut self.arrays[array as usize];
        let last = cells.len().saturating_sub(1);
        for lane in m.flow.active.lanes() {
            let is_empty = empty.as_ref().is_some_and(|mask| mask.get(lane));
            put(m, &mut cells[at[lane].min(last)], std::iter::once(lane), |_| is_empty);
        }
    }

    /// Words of workgroup memory get a value.
    fn write<M: Model>(&mut self, m: &Machine<'_, M>, buffer: u32, at: &[usize], value: Value) {
        let own = &mut self.own[buffer as usize];
        let words = if m.program.scalar(value).wide() { 2 } else { 1 };
        for lane in m.flow.active.lanes() {
            own.iter_mut().skip(at[lane] / 4).take(words).for_each(|word| *word = false);
        }
    }
}

fn put<M: Model>(
    m: &Machine<'_, M>,
    to: &mut Option<Mask>,
    lanes: impl Iterator<Item = usize>,
    empty: impl Fn(usize) -> bool,
) {
    for lane in lanes {
        let is_empty = empty(lane);
        if is_empty || to.is_some() {
            to.get_or_insert_with(|| Mask::none(m.lanes)).set(lane, is_empty);
        }
    }
}
