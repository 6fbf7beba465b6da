//! Operations that models have no numbers for: on the bits, strictly.

use super::super::model::Model;
use super::super::program::op::FloatOp;
use super::super::program::{Op, Scalar, Value};
use super::super::scalar::eval::eval;
use super::column::{Column, Family, family};
use super::{Machine, Res, cast};

impl<M: Model> Machine<'_, M> {
    /// `op` by its bits. Where drivers may differ in it, or in an operand, nothing is promised of the result.
    pub(super) fn by_bits(&self, op: Op, args: &[Value], to: &mut Column<M>) -> Res<()> {
        let m = &self.model;
        let open = M::SHADOW && rounds(op);
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
            self.set(to, lane, if known { parts } else { m.forget(parts) });
        }
        Ok(())
    }

    /// The bits of an operand as registers hold them.
    pub(super) fn word(&self, value: Value, lane: usize) -> Res<M::W> {
        let m = &self.model;
        Ok(match family(self.program.scalar(value)) {
            Family::Float => m.bits(self.floats(value)?.at(lane)),
            Family::Word => self.words(value)?.at(lane),
            Family::Bool => {
                let one = cast::number(m, self.bools(value)?.at(lane));
                m.map_w(one, |bit| u64::from((bit as u32).wrapping_neg()))
            }
        })
    }

    /// Puts bits where they are numbers.
    pub(super) fn set(&self, to: &mut Column<M>, lane: usize, word: M::W) {
        let m = &self.model;
        match to {
            Column::Float(lanes) => lanes[lane] = m.float_of_bits(word),
            Column::Word(lanes) => lanes[lane] = word,
            Column::Bool(lanes) => lanes[lane] = m.compare_w(word, m.word(0), |a, b| a != b),
        }
    }
}

/// Whether drivers may differ in the result of equal operands: no table says how far.
fn rounds(op: Op) -> bool {
    match op {
        Op::Float(_, op) => !matches!(
            op,
            FloatOp::Neg
                | FloatOp::Abs
                | FloatOp::Nonnegative
                | FloatOp::Sign
                | FloatOp::Floor
                | FloatOp::Ceil
                | FloatOp::Trunc
                | FloatOp::Significand
        ),
        Op::Convert(from, to) => match to {
            Scalar::F16 => true,
            Scalar::F32 => from == Scalar::F64,
            Scalar::F64 => !from.float() && from.wide(),
            _ => false,
        },
        Op::Ldexp(_) => true,
        _ => false,
    }
}
