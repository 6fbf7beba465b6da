//! Conversions and reinterpretations.

use super::super::error::Res;
use super::super::leaf::Leaf;
use super::super::model::Model;
use super::{Frame, Machine};
use naga::{Bytes, Expression, Handle, ScalarKind};

impl<'m, M: Model> Machine<'m, M> {
    pub(super) fn cast(
        &mut self,
        frame: &Frame<'m, M>,
        operand: Handle<Expression>,
        to: ScalarKind,
        convert: Option<Bytes>,
    ) -> Res<Vec<Leaf<M>>> {
        let from = self.type_of(frame, operand).scalar().map(|s| s.kind);
        let leaves = frame.data(operand)?;
        let signed = from == Some(ScalarKind::Sint);
        match (convert, to) {
            (None, ScalarKind::Float) => {
                leaves.iter().map(|leaf| self.words_as_floats(frame, leaf)).collect()
            }
            (None, ScalarKind::Sint | ScalarKind::Uint) => {
                leaves.iter().map(|leaf| self.bits_of(leaf)).collect()
            }
            (Some(4), ScalarKind::Float) => {
                leaves.iter().map(|leaf| self.number(frame, leaf, signed)).collect()
            }
            (Some(4), ScalarKind::Sint) => leaves.iter().map(|leaf| self.to_word(leaf, true)).collect(),
            (Some(4), ScalarKind::Uint) => leaves.iter().map(|leaf| self.to_word(leaf, false)).collect(),
            (_, ScalarKind::Bool) => leaves.iter().map(|leaf| self.to_bool(leaf)).collect(),
            (
                Some(_),
                ScalarKind::Float
                | ScalarKind::Sint
                | ScalarKind::Uint
                | ScalarKind::AbstractInt
                | ScalarKind::AbstractFloat,
            )
            | (None, ScalarKind::AbstractInt | ScalarKind::AbstractFloat) => {
                Err(frame.unsupported(format!("a conversion to {to:?} of {convert:?} bytes")))
            }
        }
    }

    /// Marks the active lanes whose word is not known and goes on as a float.
    fn taint(&mut self, frame: &Frame<'m, M>, words: &[M::W]) {
        if M::SHADOW {
            for lane in frame.flow.active.lanes().filter(|lane| !self.model.known(words[*lane])) {
                self.flags.tainted[lane] = true;
            }
        }
    }

    fn words_as_floats(&mut self, frame: &Frame<'m, M>, leaf: &Leaf<M>) -> Res<Leaf<M>> {
        match leaf {
            Leaf::Word(words) => {
                self.taint(frame, words);
                Ok(Leaf::from_floats(words.iter().map(|w| self.model.float_of_bits(*w)).collect()))
            }
            Leaf::Float(_) | Leaf::Bool(_) => Ok(leaf.clone()),
        }
    }

    fn bits_of(&self, leaf: &Leaf<M>) -> Res<Leaf<M>> {
        Ok(match leaf {
            Leaf::Float(floats) => Leaf::from_words(floats.iter().map(|a| self.model.bits(*a)).collect()),
            Leaf::Word(_) | Leaf::Bool(_) => leaf.clone(),
        })
    }

    fn number(&mut self, frame: &Frame<'m, M>, leaf: &Leaf<M>, signed: bool) -> Res<Leaf<M>> {
        match leaf {
            Leaf::Float(_) => Ok(leaf.clone()),
            Leaf::Word(words) => {
                self.taint(frame, words);
                Ok(Leaf::from_floats(words.iter().map(|w| self.model.to_float(*w, signed)).collect()))
            }
            Leaf::Bool(bools) => {
                let (one, zero) = (self.model.constant(1.0), self.model.constant(0.0));
                Ok(Leaf::from_floats(bools.iter().map(|b| self.model.select_f(*b, one, zero)).collect()))
            }
        }
    }

    fn to_word(&self, leaf: &Leaf<M>, signed: bool) -> Res<Leaf<M>> {
        let m = &self.model;
        Ok(match leaf {
            Leaf::Float(floats) => Leaf::from_words(floats.iter().map(|a| m.to_word(*a, signed)).collect()),
            Leaf::Word(_) => leaf.clone(),
            Leaf::Bool(bools) => Leaf::from_words(
                bools
                    .iter()
                    .map(|b| m.word_parts(m.decision(*b).into(), m.decision_exact(*b).into()))
                    .zip(bools.iter())
                    .map(|(word, b)| if m.ambiguous(*b) { m.forget(word) } else { word })
                    .collect(),
            ),
        })
    }

    fn to_bool(&self, leaf: &Leaf<M>) -> Res<Leaf<M>> {
        let m = &self.model;
        Ok(match leaf {
            Leaf::Float(floats) => {
                let zero = m.constant(0.0);
                Leaf::from_bools(floats.iter().map(|a| m.not(m.equal(*a, zero))).collect())
            }
            Leaf::Word(words) => {
                let zero = m.word(0);
                Leaf::from_bools(words.iter().map(|w| m.compare_w(*w, zero, |a, b| a != b)).collect())
            }
            Leaf::Bool(_) => leaf.clone(),
        })
    }
}
