//! Operations that models have no numbers for: on the bits, strictly.

use super::super::model::Model;
use super::super::program::{Op, Scalar, Value};
use super::super::scalar::eval::eval;
use super::column::{Column, Family, family};
use super::{Machine, Res, cast};

impl<M: Model> Machine<'_, M> {
    /// `op` by its bits. Where drivers may differ in an operand, or in how they round, nothing is promised of the result.
    pub(super) fn by_bits(&self, op: Op, args: &[Value], to: &mut Column<M>) -> Res<()> {
        let m = &self.model;
        let open = M::SHADOW && matches!(op, Op::Ldexp(_));
        let lanes: Vec<usize> = self.flow.active.lanes().collect();
        for lane in lanes {
            let words = args.iter().map(|a| self.word(*a, lane)).collect::<Res<Vec<_>>>()?;
            let result = |bits: &dyn Fn(&M::W) -> u64| {
                let bits: Vec<u64> = words.iter().map(bits).collect();
                eval(op, &bits).ok_or_else(|| self.refuse(format!("{op:?}")))
            };
            let value = result(&|w| m.word_value(*w))?;
            let exact = if M::SHADOW { result(&|w| m.word_exact(*w))? } else { value };
            let parts = m.word_parts(value, exact);
            let known = !open && words.iter().all(|w| m.known(*w));
            self.set(to, op.result(), lane, if known { parts } else { m.forget(parts) });
        }
        Ok(())
    }

    /// The bits of an operand as registers hold them.
    pub(super) fn word(&self, value: Value, lane: usize) -> Res<M::W> {
        let m = &self.model;
        let scalar = self.program.scalar(value);
        Ok(match family::<M>(scalar) {
            Family::Float => {
                let a = self.floats(value)?.at(lane);
                by_width!(self.model, scalar, m => m.bits(a))
            }
            Family::Word => self.words(value)?.at(lane),
            Family::Bool => {
                let one = cast::number(m, self.bools(value)?.at(lane));
                m.map_w(one, |bit| u64::from((bit as u32).wrapping_neg()))
            }
        })
    }

    /// Puts bits where they are numbers.
    pub(super) fn set(&self, to: &mut Column<M>, scalar: Scalar, lane: usize, word: M::W) {
        let m = &self.model;
        match to {
            Column::Float(lanes) => lanes[lane] = by_width!(self.model, scalar, m => m.float_of_bits(word)),
            Column::Word(lanes) => lanes[lane] = word,
            Column::Bool(lanes) => lanes[lane] = m.compare_w(word, m.word(0), |a, b| a != b),
        }
    }
}
