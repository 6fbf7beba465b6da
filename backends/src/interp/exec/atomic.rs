//! Atomics: lane after lane, in order.

use super::super::error::Res;
use super::super::leaf::Leaf;
use super::super::model::Model;
use super::{Frame, Machine, Value};
use naga::{AtomicFunction, Expression, Handle, ScalarKind};

impl<'m, M: Model> Machine<'m, M> {
    pub(super) fn atomic(
        &mut self,
        frame: &mut Frame<'m, M>,
        pointer: Handle<Expression>,
        fun: &AtomicFunction,
        value: Handle<Expression>,
        result: Option<Handle<Expression>>,
    ) -> Res<()> {
        let signed = self.type_of(frame, value).scalar().is_some_and(|s| s.kind == ScalarKind::Sint);
        let place = frame.pointer(pointer)?;
        let values = frame.scalar(value)?.value_bits(&self.model);
        if let AtomicFunction::Exchange { compare: Some(compare) } = fun {
            let expected = frame.scalar(*compare)?.value_bits(&self.model);
            let swap = |lane: usize, old: u32| if old == expected[lane] { values[lane] } else { old };
            let former = self.memory.update(place, &frame.flow.active, self.lanes, swap)?;
            if let Some(result) = result {
                let same = former.iter().zip(&expected).map(|(a, b)| self.model.boolean(a == b)).collect();
                let leaves = vec![self.words_leaf(&former), Leaf::from_bools(same)];
                frame.values[result.index()] = Some(Value::data(leaves));
            }
            return Ok(());
        }
        let step = operation(fun, signed);
        let former =
            self.memory.update(place, &frame.flow.active, self.lanes, |l, old| step(old, values[l]))?;
        if let Some(result) = result {
            frame.values[result.index()] = Some(Value::data(vec![self.words_leaf(&former)]));
        }
        Ok(())
    }

    fn words_leaf(&self, words: &[u32]) -> Leaf<M> {
        Leaf::from_words(words.iter().map(|w| self.model.word(*w)).collect())
    }
}

fn operation(fun: &AtomicFunction, signed: bool) -> fn(u32, u32) -> u32 {
    match fun {
        AtomicFunction::Add => u32::wrapping_add,
        AtomicFunction::Subtract => u32::wrapping_sub,
        AtomicFunction::And => |a, b| a & b,
        AtomicFunction::ExclusiveOr => |a, b| a ^ b,
        AtomicFunction::InclusiveOr => |a, b| a | b,
        AtomicFunction::Min if signed => |a, b| (a as i32).min(b as i32) as u32,
        AtomicFunction::Min => |a, b| a.min(b),
        AtomicFunction::Max if signed => |a, b| (a as i32).max(b as i32) as u32,
        AtomicFunction::Max => |a, b| a.max(b),
        AtomicFunction::Exchange { .. } => |_, b| b,
    }
}
