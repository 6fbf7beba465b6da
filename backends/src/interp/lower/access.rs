//! Parts of values and of memory.

use super::super::error::Res;
use super::super::program::op::Comparison;
use super::super::program::{Count, Op, Place, Scalar, Value};
use super::frame::{Frame, Item, Pointer, Root};
use super::layout::{Packing, Shape};
use super::{Lowerer, malformed};
use naga::{Expression, Handle};

/// Parts that a dynamic index may choose from by comparing; more are put into memory.
const COMPARED: usize = 8;

impl<'m> Lowerer<'m> {
    /// The shape of a value.
    pub(crate) fn shape(&self, frame: &Frame<'m>, handle: Handle<Expression>) -> Res<Shape> {
        self.types().shape(&frame.info[handle].ty)
    }

    /// `base[index]`, the index known.
    pub(crate) fn access_index(
        &mut self,
        frame: &Frame<'m>,
        base: Handle<Expression>,
        index: u32,
    ) -> Res<Item> {
        if let Some(array) = self.array_of(frame, base) {
            let index = self.b.u32(index);
            return self.element(frame, base, array, index);
        }
        if let Some(Item::Pointer(pointer)) = &frame.values[base.index()] {
            if pointer.end.is_some() && self.is_runtime_sized(pointer) {
                let index = self.b.u32(index);
                return self.access_memory(pointer, index).map(Item::Pointer);
            }
            self.index_of_elements(pointer, index)?;
            let (shape, units) = self.types().member(pointer.shape, index, self.packing(pointer.root))?;
            let offset = pointer.offset.saturating_add(units);
            return Ok(Item::Pointer(Pointer { offset, shape, ..*pointer }));
        }
        let (part, at) = self.types().member(self.shape(frame, base)?, index, Packing::Packed(1))?;
        let count = self.types().count(part)?;
        let values = frame.data(base)?;
        let part = values.get(at as usize..(at + count) as usize);
        Ok(Item::values(part.ok_or(malformed("an index leads out of its value"))?.to_vec()))
    }

    /// `base[index]`, the index a value; it is clamped.
    pub(crate) fn access(
        &mut self,
        frame: &Frame<'m>,
        base: Handle<Expression>,
        index: Handle<Expression>,
    ) -> Res<Item> {
        let index = frame.single(index)?;
        if let Some(array) = self.array_of(frame, base) {
            return self.element(frame, base, array, index);
        }
        if let Some(known) = self.b.known(index)
            && let Some(count) = self.parts_of(frame, base)?
        {
            self.index_of_parts(index, count, known < u64::from(count));
            return self.access_index(frame, base, known.min(u32::MAX.into()) as u32);
        }
        if let Some(Item::Pointer(pointer)) = &frame.values[base.index()] {
            return self.access_memory(pointer, index).map(Item::Pointer);
        }
        let values = frame.data(base)?;
        let part = self.types().parts(self.shape(frame, base)?, Packing::Packed(1))?.stride as usize;
        Ok(Item::values(self.pick(&values, part, index)?))
    }

    /// How many parts a value or a place in memory has; `None` if that is known only when it runs.
    fn parts_of(&self, frame: &Frame<'m>, base: Handle<Expression>) -> Res<Option<u32>> {
        let parts = match &frame.values[base.index()] {
            Some(Item::Pointer(p)) => self.types().parts(p.shape, self.packing(p.root))?,
            _ => self.types().parts(self.shape(frame, base)?, Packing::Packed(1))?,
        };
        Ok(parts.count)
    }

    /// States an index that no place in memory is computed from: whoever looks for mistakes sees it, nobody else does.
    fn index_of_parts(&mut self, index: Value, count: u32, is_inside: bool) {
        if !is_inside {
            self.b.index(None, index, Count::Fixed(count), 1);
        }
    }

    /// The same of an array whose length is known only when it runs.
    fn index_of_elements(&mut self, pointer: &Pointer, index: u32) -> Res<()> {
        let packing = self.packing(pointer.root);
        if let Ok(parts) = self.types().parts(pointer.shape, packing)
            && parts.count.is_none()
        {
            let (index, count) = (self.b.u32(index), pointer.runtime()?);
            self.b.index(None, index, count, parts.stride);
        }
        Ok(())
    }

    /// Whether a pointer leads to an array whose length is known only when it runs.
    fn is_runtime_sized(&self, pointer: &Pointer) -> bool {
        let parts = self.types().parts(pointer.shape, self.packing(pointer.root));
        parts.is_ok_and(|parts| parts.count.is_none())
    }

    fn access_memory(&mut self, pointer: &Pointer, index: Value) -> Res<Pointer> {
        let parts = self.types().parts(pointer.shape, self.packing(pointer.root))?;
        if let (None, Some(end)) = (parts.count, pointer.end) {
            let index = Some(self.index_within(pointer, end, index, parts.stride));
            return Ok(Pointer { index, shape: parts.part, ..*pointer });
        }
        let count = match parts.count {
            Some(count) => Count::Fixed(count),
            None => pointer.runtime()?,
        };
        if let Root::Registers(_) = pointer.root {
            return Err(malformed("a variable is indexed that lies in registers"));
        }
        let index = Some(self.b.index(pointer.index, index, count, parts.stride));
        Ok(Pointer { index, shape: parts.part, ..*pointer })
    }

    /// The part of `values` that `index` means.
    fn pick(&mut self, values: &[Value], part: usize, index: Value) -> Res<Vec<Value>> {
        let count = values.len() / part.max(1);
        if count > COMPARED {
            return self.pick_from_memory(values, part, index);
        }
        self.index_of_parts(index, count as u32, false);
        let scalar = self.b.scalar(index);
        let mut chosen = values[values.len() - part..].to_vec();
        for (at, candidate) in values.chunks(part).enumerate().take(count - 1).rev() {
            let number = self.b.bits(scalar, at as u64, at as f64);
            let here = self.b.eval(Op::Compare(scalar, Comparison::Equal), &[index, number]);
            for (chosen, candidate) in chosen.iter_mut().zip(candidate) {
                *chosen = self.b.select(here, *candidate, *chosen);
            }
        }
        Ok(chosen)
    }

    fn pick_from_memory(&mut self, values: &[Value], part: usize, index: Value) -> Res<Vec<Value>> {
        let scalars: Vec<Scalar> = values.iter().map(|v| self.b.scalar(*v)).collect();
        let array = self.b.array(&scalars);
        for (offset, value) in (0..).zip(values) {
            self.b.store(Place::Lane { array, offset, index: None }, *value);
        }
        let count = Count::Fixed((values.len() / part) as u32);
        let index = Some(self.b.index(None, index, count, part as u32));
        let load =
            |(offset, scalar): (u32, &Scalar)| self.b.load(Place::Lane { array, offset, index }, *scalar);
        Ok((0..).zip(&scalars[..part]).map(load).collect())
    }

    /// `arrayLength`
    pub(crate) fn array_length(&mut self, frame: &Frame<'m>, array: Handle<Expression>) -> Res<Item> {
        let pointer = frame.pointer(array)?;
        let parts = self.types().parts(pointer.shape, self.packing(pointer.root))?;
        let length = match (parts.count, pointer.end) {
            (Some(count), _) => self.b.u32(count),
            (None, Some(end)) => self.length_within(&pointer, end, parts.stride),
            (None, None) => match pointer.runtime()? {
                Count::Fixed(count) => self.b.u32(count),
                Count::Runtime { buffer, begin } => {
                    self.b.eval(Op::Length { buffer, begin, stride: parts.stride }, &[])
                }
            },
        };
        Ok(Item::values(vec![length]))
    }
}
