//! Parts of values and of memory.

use super::super::error::Res;
use super::super::layout::{Packing, Pointee};
use super::super::leaf::Leaf;
use super::super::mask::Mask;
use super::super::memory::Pointer;
use super::super::model::{Model, Pick};
use super::{Frame, InterpError, Machine, Value};
use naga::{Expression, Handle, TypeInner};

impl<'m, M: Model> Machine<'m, M> {
    /// `base[index]`, the index known to the compiler.
    pub(super) fn access_index(
        &self,
        frame: &Frame<'m, M>,
        base: Handle<Expression>,
        index: u32,
    ) -> Res<Value<M>> {
        if let Some(Value::Pointer(pointer)) = &frame.values[base.index()] {
            let (pointee, units) =
                self.types().member(pointer.pointee, index, self.memory.packing(pointer.root))?;
            let offset = pointer.offset.plus(units);
            return Ok(Value::Pointer(Pointer { root: pointer.root, offset, pointee }));
        }
        let ty = self.pointee_of(frame, base)?;
        let (part, at) = match ty {
            // A matrix without a handle.
            None => self.loose_column(frame, base, index)?,
            Some(ty) => {
                let (part, at) = self.types().member(ty, index, Packing::Packed)?;
                (self.types().count(part)?, at)
            }
        };
        let leaves = frame.data(base)?.get(at as usize..(at + part) as usize);
        Ok(Value::data(leaves.ok_or(InterpError::Malformed("an index leads out of its value"))?.to_vec()))
    }

    /// `base[index]`, the index a value; it is clamped.
    pub(super) fn access(
        &mut self,
        frame: &Frame<'m, M>,
        base: Handle<Expression>,
        index: Handle<Expression>,
    ) -> Res<Value<M>> {
        let index = frame.scalar(index)?.words()?;
        self.lose_unknown(&frame.flow.active, index);
        if let Some(Value::Pointer(pointer)) = &frame.values[base.index()] {
            return self.access_memory(pointer, index);
        }
        let leaves = frame.data(base)?;
        let part = match self.pointee_of(frame, base)? {
            None => self.loose_column(frame, base, 0)?.0,
            Some(ty) => self.types().parts(ty, Packing::Packed)?.stride,
        } as usize;
        let last = (leaves.len() / part.max(1)).saturating_sub(1);
        let chosen = |lane: usize| (self.model.word_value(index[lane]) as usize).min(last);
        let gather = |at: usize| {
            let sources: Vec<_> = leaves.iter().skip(at).step_by(part).collect();
            Leaf::gather(&sources, self.lanes, chosen)
        };
        Ok(Value::data((0..part).map(gather).collect::<Res<_>>()?))
    }

    fn access_memory(&self, pointer: &Pointer, index: &[M::W]) -> Res<Value<M>> {
        let parts = self.types().parts(pointer.pointee, self.memory.packing(pointer.root))?;
        let count = parts.count.unwrap_or_else(|| self.runtime_count(pointer, parts.stride));
        let last = count.saturating_sub(1);
        let unit = |w: &M::W| self.model.word_value(*w).min(last) * parts.stride;
        let units: Vec<u32> = index.iter().map(unit).collect();
        let offset = match units.split_first() {
            Some((first, rest)) if rest.iter().all(|u| u == first) => pointer.offset.plus(*first),
            Some(_) | None => pointer.offset.plus_lanes(&units),
        };
        Ok(Value::Pointer(Pointer { root: pointer.root, offset, pointee: parts.part }))
    }

    /// Elements of the runtime-sized array at `pointer`; such an array lies at the same place in all lanes.
    fn runtime_count(&self, pointer: &Pointer, stride: u32) -> u32 {
        let begin = match &pointer.offset {
            super::super::memory::Offset::Uniform(at) => *at,
            super::super::memory::Offset::Lanes(at) => at.first().copied().unwrap_or(0),
        };
        self.memory.units(pointer.root).saturating_sub(begin) / stride.max(1)
    }

    pub(super) fn array_length(&self, frame: &Frame<'m, M>, array: Handle<Expression>) -> Res<Value<M>> {
        let pointer = frame.pointer(array)?;
        let parts = self.types().parts(pointer.pointee, self.memory.packing(pointer.root))?;
        let count = parts.count.unwrap_or_else(|| self.runtime_count(pointer, parts.stride));
        Ok(Value::data(vec![Leaf::from_words(vec![self.model.word(count); self.lanes])]))
    }

    /// The type of a value, unless it is a matrix without a handle.
    fn pointee_of(&self, frame: &Frame<'m, M>, base: Handle<Expression>) -> Res<Option<Pointee>> {
        if let Some(handle) = frame.info[base].ty.handle() {
            return Ok(Some(Pointee::Type(handle)));
        }
        match self.type_of(frame, base) {
            TypeInner::Vector { size, scalar } => Ok(Some(Pointee::Vector(*size, *scalar))),
            TypeInner::Scalar(scalar) => Ok(Some(Pointee::Scalar(*scalar))),
            TypeInner::Matrix { .. } => Ok(None),
            TypeInner::CooperativeMatrix { .. }
            | TypeInner::Atomic(_)
            | TypeInner::Pointer { .. }
            | TypeInner::ValuePointer { .. }
            | TypeInner::Array { .. }
            | TypeInner::Struct { .. }
            | TypeInner::Image { .. }
            | TypeInner::Sampler { .. }
            | TypeInner::AccelerationStructure { .. }
            | TypeInner::RayQuery { .. }
            | TypeInner::BindingArray { .. } => Err(frame.unsupported("parts of this type")),
        }
    }

    /// Scalars and place of a column.
    fn loose_column(&self, frame: &Frame<'m, M>, base: Handle<Expression>, index: u32) -> Res<(u32, u32)> {
        let (_, rows) = super::matrix::dimensions(self.type_of(frame, base))
            .ok_or(InterpError::Malformed("parts of something without parts"))?;
        Ok((rows, index * rows))
    }

    /// Marks the active lanes whose word is not known.
    pub(super) fn lose_unknown(&mut self, active: &Mask, words: &[M::W]) {
        if M::SHADOW {
            for lane in active.lanes().filter(|lane| !self.model.known(words[*lane])) {
                self.flags.lost[lane] = true;
            }
        }
    }

    /// Componentwise choice.
    pub(super) fn select(
        &mut self,
        active: &Mask,
        condition: &[Leaf<M>],
        accept: &[Leaf<M>],
        reject: &[Leaf<M>],
    ) -> Res<Vec<Leaf<M>>> {
        if M::SHADOW {
            for leaf in condition {
                let bools = leaf.bools()?;
                for lane in active.lanes().filter(|lane| self.model.ambiguous(bools[*lane])) {
                    self.flags.ambiguous[lane] = true;
                }
            }
        }
        let conditions = condition.iter().cycle();
        conditions.zip(accept.iter().zip(reject)).map(|(c, (a, r))| self.choose(c, a, r)).collect()
    }

    /// `accept` where `condition` holds.
    pub(super) fn choose(&self, condition: &Leaf<M>, accept: &Leaf<M>, reject: &Leaf<M>) -> Res<Leaf<M>> {
        let m = &self.model;
        let condition = condition.bools()?;
        let mut out = reject.clone();
        let holds = Mask::all(self.lanes).filter(|l| m.decision(condition[l]) && !m.ambiguous(condition[l]));
        out.blend(accept, &holds)?;
        if M::SHADOW {
            let open = Mask::all(self.lanes).filter(|l| m.ambiguous(condition[l]));
            out.join(m, accept, &open, |l| Pick {
                value: m.decision(condition[l]),
                exact: m.decision_exact(condition[l]),
            })?;
        }
        Ok(out)
    }
}
