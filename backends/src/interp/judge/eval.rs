//! Pure operations, in the active lanes.

use super::super::model::{Model, Pick};
use super::super::program::op::{Comparison, FloatOp, IntOp, LogicOp, Mark};
use super::super::program::{Eval, Op, Reg, Scalar, Value};
use super::column::{Column, Family, Operand, Single, family};
use super::{MISMATCH, Machine, Res, integer};
use lobe_codegen::def::Truth;

impl<M: Model> Machine<'_, M> {
    pub(super) fn eval(&mut self, eval: &Eval) -> Res<()> {
        if M::SHADOW {
            self.note(eval)?;
        }
        let Reg(at) = eval.to;
        let mut to = std::mem::take(&mut self.registers[at as usize]);
        let done = self.compute(eval, &mut to);
        self.registers[at as usize] = to;
        done
    }

    fn compute(&self, eval: &Eval, to: &mut Column<M>) -> Res<()> {
        let args = &eval.args[..];
        match eval.op {
            Op::Copy(_) => self.copy(*args.first().ok_or(MISMATCH)?, to),
            Op::Input(input, scalar) => self.input(input, scalar, to),
            Op::Float(scalar, op) if op != FloatOp::Significand && M::has(scalar) => {
                by_width!(self.model, scalar, m => self.float(m, op, args, to))
            }
            Op::Int(scalar, op) => self.integer(scalar, op, args, to),
            Op::Compare(scalar, comparison) => self.compare(scalar, comparison, args, to),
            Op::Logic(op) => self.logic(op, args, to),
            Op::IsNan(scalar) if M::has(scalar) => self.test(args, to, M::is_nan),
            Op::IsInf(scalar) if M::has(scalar) => self.test(args, to, M::is_inf),
            Op::Float(..) | Op::IsNan(_) | Op::IsInf(_) | Op::Exponent(_) | Op::Ldexp(_) => {
                self.by_bits(eval.op, args, to)
            }
            Op::Select(_) => self.select(args, to),
            Op::Convert(from, into) => self.convert(from, into, args, to),
            Op::Bitcast(from, into) => self.bitcast(from, into, args, to),
            Op::Index { count, stride } => self.index(count, stride, args, to),
            Op::IndexWithin { stride } => self.index_within(stride, args, to),
            Op::Length { buffer, begin, stride } => {
                let length = self.elements(buffer, begin, stride);
                self.each_word(to, |m, _| m.word(length))
            }
            Op::Load { place, scalar, .. } => self.load(place, scalar, to),
            Op::Mark(scalar, mark) => self.mark(scalar, mark, args, to),
            Op::Fused { .. } | Op::Horner { .. } => Err(self.refuse(format!("{:?}", eval.op))),
        }
    }

    /// Notes what becomes of the active lanes' promises.
    fn note(&mut self, eval: &Eval) -> Res<()> {
        match (eval.op, &eval.args[..]) {
            (Op::Select(_), &[condition, _, _]) => {
                let open = self.open(condition)?;
                open.lanes().for_each(|lane| self.flags.ambiguous[lane] = true);
            }
            (Op::Convert(from, into) | Op::Bitcast(from, into), &[a])
                if family::<M>(from) == Family::Word && family::<M>(into) == Family::Float =>
            {
                let unknown = self.unknown(a)?;
                unknown.lanes().for_each(|lane| self.flags.tainted[lane] = true);
            }
            (Op::Ldexp(_) | Op::Float(_, FloatOp::Significand), _) => {
                self.flow.active.lanes().for_each(|lane| self.flags.tainted[lane] = true);
            }
            (Op::Load { place, .. }, _) => {
                if let Some(index) = place.index() {
                    let unknown = self.unknown(index)?;
                    unknown.lanes().for_each(|lane| self.flags.tainted[lane] = true);
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn integer(&self, scalar: Scalar, op: IntOp, args: &[Value], to: &mut Column<M>) -> Res<()> {
        let words = args.iter().map(|a| self.words(*a)).collect::<Res<Vec<_>>>()?;
        let apply = |f: &dyn Fn(M::W) -> u64, lane: usize| {
            let mut operands = [0; 4];
            operands.iter_mut().zip(&words).for_each(|(to, from)| *to = f(from.at(lane)));
            integer::apply(scalar, op, operands)
        };
        self.each_word(to, |m, lane| {
            let value = apply(&|w| m.word_value(w), lane);
            if !M::SHADOW {
                return m.word(value);
            }
            let parts = m.word_parts(value, apply(&|w| m.word_exact(w), lane));
            if words.iter().all(|w| m.known(w.at(lane))) { parts } else { m.forget(parts) }
        })
    }

    fn compare(&self, scalar: Scalar, comparison: Comparison, args: &[Value], to: &mut Column<M>) -> Res<()> {
        match scalar {
            scalar if M::has(scalar) => {
                by_width!(self.model, scalar, m => self.compare_floats(m, comparison, args, to))
            }
            Scalar::I16 | Scalar::U16 | Scalar::I32 | Scalar::U32 | Scalar::I64 | Scalar::U64 => {
                let &[a, b] = args else { return Err(MISMATCH) };
                let (a, b) = (self.words(a)?, self.words(b)?);
                let holds = |a, b| integer::compare(scalar, comparison, a, b);
                self.each_bool(to, |m, l| m.compare_w(a.at(l), b.at(l), holds))
            }
            Scalar::Bool | Scalar::F16 | Scalar::F32 | Scalar::F64 => {
                self.by_bits(Op::Compare(scalar, comparison), args, to)
            }
        }
    }

    fn logic(&self, op: LogicOp, args: &[Value], to: &mut Column<M>) -> Res<()> {
        let (a, b) = match *args {
            [a] => (self.bools(a)?, self.bools(a)?),
            [a, b] => (self.bools(a)?, self.bools(b)?),
            _ => return Err(MISMATCH),
        };
        match op {
            LogicOp::Not => self.each_bool(to, |m, l| m.not(a.at(l))),
            LogicOp::And => self.each_bool(to, |m, l| m.and(a.at(l), b.at(l))),
            LogicOp::Or => self.each_bool(to, |m, l| m.or(a.at(l), b.at(l))),
            LogicOp::Xor => self.each_bool(to, |m, l| m.xor(a.at(l), b.at(l))),
            LogicOp::Same => self.each_bool(to, |m, l| m.not(m.xor(a.at(l), b.at(l)))),
            LogicOp::AndNot => self.each_bool(to, |m, l| m.and(a.at(l), m.not(b.at(l)))),
        }
    }

    fn select(&self, args: &[Value], to: &mut Column<M>) -> Res<()> {
        let &[condition, accept, reject] = args else { return Err(MISMATCH) };
        let condition = self.bools(condition)?;
        match to {
            Column::Float(_) => {
                let (a, r) = (self.floats(accept)?, self.floats(reject)?);
                self.each_float(to, |m, l| chosen(m, condition.at(l), a.at(l), r.at(l), M::join_f))
            }
            Column::Word(_) => {
                let (a, r) = (self.words(accept)?, self.words(reject)?);
                self.each_word(to, |m, l| chosen(m, condition.at(l), a.at(l), r.at(l), M::join_w))
            }
            Column::Bool(_) => {
                let (a, r) = (self.bools(accept)?, self.bools(reject)?);
                self.each_bool(to, |m, l| chosen(m, condition.at(l), a.at(l), r.at(l), M::join_b))
            }
        }
    }

    fn mark(&self, scalar: Scalar, mark: Mark, args: &[Value], to: &mut Column<M>) -> Res<()> {
        match mark {
            Mark::Settled => self.one(args, to, |a| self.model.settled(a)),
            Mark::Unwritten => {
                *to = Column::zero(&self.model, scalar, self.lanes);
                Ok(())
            }
            Mark::Truth(truth) => {
                let (body, args) = args.split_first().ok_or(MISMATCH)?;
                let body = self.floats(*body)?;
                let args = args.iter().map(|a| self.floats(*a)).collect::<Res<Vec<_>>>()?;
                let exact =
                    |m: &M, at: usize, lane: usize| args.get(at).map_or(f64::NAN, |a| m.exact(a.at(lane)));
                match self.program.truths[truth as usize] {
                    Truth::Unary(f) => {
                        self.each_float(to, |m, l| m.with_truth(body.at(l), f(exact(m, 0, l))))
                    }
                    Truth::Binary(f) => self
                        .each_float(to, |m, l| m.with_truth(body.at(l), f(exact(m, 0, l), exact(m, 1, l)))),
                }
            }
        }
    }

    /// Copies the active lanes.
    pub(super) fn copy(&self, from: Value, to: &mut Column<M>) -> Res<()> {
        match to {
            Column::Float(_) => {
                let from = self.floats(from)?;
                self.each_float(to, |_, lane| from.at(lane))
            }
            Column::Word(_) => {
                let from = self.words(from)?;
                self.each_word(to, |_, lane| from.at(lane))
            }
            Column::Bool(_) => {
                let from = self.bools(from)?;
                self.each_bool(to, |_, lane| from.at(lane))
            }
        }
    }

    pub(super) fn floats(&self, value: Value) -> Res<Operand<'_, M::F>> {
        match value {
            Value::Const(id) => match &self.constants[id as usize] {
                Single::Float(a) => Ok(Operand::Same(*a)),
                Single::Word(_) | Single::Bool(_) => Err(MISMATCH),
            },
            Value::Reg(Reg(at)) => match &self.registers[at as usize] {
                Column::Float(lanes) => Ok(Operand::Each(lanes)),
                Column::Word(_) | Column::Bool(_) => Err(MISMATCH),
            },
        }
    }

    pub(super) fn words(&self, value: Value) -> Res<Operand<'_, M::W>> {
        match value {
            Value::Const(id) => match &self.constants[id as usize] {
                Single::Word(a) => Ok(Operand::Same(*a)),
                Single::Float(_) | Single::Bool(_) => Err(MISMATCH),
            },
            Value::Reg(Reg(at)) => match &self.registers[at as usize] {
                Column::Word(lanes) => Ok(Operand::Each(lanes)),
                Column::Float(_) | Column::Bool(_) => Err(MISMATCH),
            },
        }
    }

    pub(super) fn bools(&self, value: Value) -> Res<Operand<'_, M::B>> {
        match value {
            Value::Const(id) => match &self.constants[id as usize] {
                Single::Bool(a) => Ok(Operand::Same(*a)),
                Single::Float(_) | Single::Word(_) => Err(MISMATCH),
            },
            Value::Reg(Reg(at)) => match &self.registers[at as usize] {
                Column::Bool(lanes) => Ok(Operand::Each(lanes)),
                Column::Float(_) | Column::Word(_) => Err(MISMATCH),
            },
        }
    }

    pub(super) fn each_float(&self, to: &mut Column<M>, f: impl Fn(&M, usize) -> M::F) -> Res<()> {
        let Column::Float(to) = to else { return Err(MISMATCH) };
        self.flow.active.lanes().for_each(|lane| to[lane] = f(&self.model, lane));
        Ok(())
    }

    pub(super) fn each_word(&self, to: &mut Column<M>, f: impl Fn(&M, usize) -> M::W) -> Res<()> {
        let Column::Word(to) = to else { return Err(MISMATCH) };
        self.flow.active.lanes().for_each(|lane| to[lane] = f(&self.model, lane));
        Ok(())
    }

    pub(super) fn each_bool(&self, to: &mut Column<M>, f: impl Fn(&M, usize) -> M::B) -> Res<()> {
        let Column::Bool(to) = to else { return Err(MISMATCH) };
        self.flow.active.lanes().for_each(|lane| to[lane] = f(&self.model, lane));
        Ok(())
    }
}

fn chosen<M: Model, T>(m: &M, condition: M::B, a: T, r: T, join: impl Fn(&M, T, T, Pick) -> T) -> T {
    let pick = Pick { value: m.decision(condition), exact: m.decision_exact(condition) };
    if m.ambiguous(condition) {
        join(m, a, r, pick)
    } else if pick.value {
        a
    } else {
        r
    }
}
