//! Conversions and reinterpretations.

use super::super::model::Model;
use super::super::program::{Op, Scalar, Value};
use super::super::scalar::eval::eval;
use super::column::{Column, Family, family};
use super::{MISMATCH, Machine, Res, integer};

impl<M: Model> Machine<'_, M> {
    pub(super) fn convert(&self, from: Scalar, into: Scalar, args: &[Value], to: &mut Column<M>) -> Res<()> {
        let &[a] = args else { return Err(MISMATCH) };
        if [from, into].iter().any(|s| s.float() && !M::has(*s)) {
            return self.by_bits(Op::Convert(from, into), args, to);
        }
        match (family::<M>(from), family::<M>(into)) {
            (Family::Float, Family::Float) if from != into => {
                let a = self.floats(a)?;
                by_width!(self.model, into, m => self.each_float(to, |_, l| m.converted(a.at(l), from)))
            }
            (Family::Float, Family::Float) | (Family::Bool, Family::Bool) => self.copy(a, to),
            (Family::Float, Family::Word) => {
                let a = self.floats(a)?;
                by_width!(self.model, from, m => self.each_word(to, |_, l| m.to_word(a.at(l), into)))
            }
            (Family::Float, Family::Bool) => {
                let (a, zero) = (self.floats(a)?, self.model.constant(0.0));
                by_width!(self.model, from, m => self.each_bool(to, |_, l| m.not(m.equal(a.at(l), zero))))
            }
            (Family::Word, Family::Float) => {
                let a = self.words(a)?;
                by_width!(self.model, into, m => self.each_float(to, |_, l| m.to_float(a.at(l), from)))
            }
            (Family::Word, Family::Word) => {
                let a = self.words(a)?;
                self.each_word(to, |m, l| m.map_w(a.at(l), |w| integer::converted(w, from, into)))
            }
            (Family::Word, Family::Bool) => {
                let a = self.words(a)?;
                self.each_bool(to, |m, l| m.compare_w(a.at(l), m.word(0), |a, b| a != b))
            }
            (Family::Bool, Family::Float) => {
                let (a, one, zero) = (self.bools(a)?, self.model.constant(1.0), self.model.constant(0.0));
                self.each_float(to, |m, l| m.select_f(a.at(l), one, zero))
            }
            (Family::Bool, Family::Word) => {
                let a = self.bools(a)?;
                self.each_word(to, |m, l| number(m, a.at(l)))
            }
        }
    }

    pub(super) fn bitcast(&self, from: Scalar, into: Scalar, args: &[Value], to: &mut Column<M>) -> Res<()> {
        let &[a] = args else { return Err(MISMATCH) };
        // What registers hold is what the other type has, but for floats of 16 bits.
        let other = |word| eval(Op::Bitcast(from, into), &[word]).unwrap_or(word);
        match (family::<M>(from), family::<M>(into)) {
            (Family::Float, Family::Word) => {
                let a = self.floats(a)?;
                by_width!(self.model, from, m => self.each_word(to, |_, l| m.map_w(m.bits(a.at(l)), other)))
            }
            (Family::Word, Family::Float) => {
                let a = self.words(a)?;
                by_width!(self.model, into, m => {
                    self.each_float(to, |_, l| m.float_of_bits(m.map_w(a.at(l), other)))
                })
            }
            (Family::Word, Family::Word) => self.by_bits(Op::Bitcast(from, into), args, to),
            (Family::Float, Family::Float) | (Family::Bool, Family::Bool) => self.copy(a, to),
            (Family::Bool, Family::Float | Family::Word) | (Family::Float | Family::Word, Family::Bool) => {
                Err(MISMATCH)
            }
        }
    }
}

/// 0 or 1.
pub(super) fn number<M: Model>(m: &M, b: M::B) -> M::W {
    let word = m.word_parts(m.decision(b).into(), m.decision_exact(b).into());
    if m.ambiguous(b) { m.forget(word) } else { word }
}
