//! Binding arrays: variables that stand for several resources.
//!
//! The elements of an array of buffers lie one behind the other in one buffer of the program, so that loads, stores and
//! atomics need to know of nothing but addresses; a directory says where each begins and ends.
//! Of textures and samplers the directory says which of the dispatch's each element is.
//! An index beyond the last element means the last, as naga's bounds policy `Restrict` has it.

use super::super::error::Res;
use super::super::program::op::IntOp;
use super::super::program::{BindingArray, Buffer, Content, Count, Op, Place, Scalar, Value};
use super::frame::{Choice, Frame, Item, Pointer, Root};
use super::layout::Shape;
use super::{Lowerer, malformed};
use naga::{Expression, GlobalVariable, Handle, TypeInner};

impl<'m> Lowerer<'m> {
    /// The type of what a variable stands for, one or many.
    pub(crate) fn bound_type(&self, variable: &GlobalVariable) -> Handle<naga::Type> {
        match self.types().inner(variable.ty) {
            TypeInner::BindingArray { base, .. } => *base,
            _ => variable.ty,
        }
    }

    /// The array that a variable is, with a new directory for it; `None` if it stands for one resource.
    pub(crate) fn binding_array(
        &mut self,
        handle: Handle<GlobalVariable>,
        content: fn(BindingArray) -> Content,
    ) -> Res<Option<BindingArray>> {
        let variable = &self.module.module().global_variables[handle];
        let TypeInner::BindingArray { size, .. } = *self.types().inner(variable.ty) else {
            return Ok(None);
        };
        let place = variable.binding.map(|b| (b.group, b.binding));
        let binding = Some(place.ok_or(malformed("a binding array has no binding"))?);
        let directory = self.b.program.buffers.len() as u32;
        let array = BindingArray { count: self.types().elements(size)?, directory };
        self.b.program.buffers.push(Buffer {
            variable: handle,
            name: variable.name.clone().unwrap_or_default(),
            binding,
            bytes: 0,
            written: false,
            writable: false,
            content: content(array),
        });
        Ok(Some(array))
    }

    /// The binding array that an expression is, if it is one.
    pub(crate) fn array_of(&self, frame: &Frame<'m>, base: Handle<Expression>) -> Option<BindingArray> {
        let program = &self.b.program;
        match frame.values[base.index()] {
            Some(Item::Pointer(Pointer { root: Root::Buffer(buffer), end: None, .. })) => {
                match program.buffers[buffer as usize].content {
                    Content::Elements(array) => Some(array),
                    Content::Variable | Content::Places(_) | Content::Textures(_) | Content::Samplers(_) => {
                        None
                    }
                }
            }
            Some(Item::Image(Choice { variable, element: None })) => program.images[variable as usize].array,
            Some(Item::Sampler(Choice { variable, element: None })) => {
                program.samplers[variable as usize].array
            }
            Some(Item::Pointer(_) | Item::Image(_) | Item::Sampler(_) | Item::Values(_)) | None => None,
        }
    }

    /// `base[index]` where `base` is binding array `array`.
    pub(crate) fn element(
        &mut self,
        frame: &Frame<'m>,
        base: Handle<Expression>,
        array: BindingArray,
        index: Value,
    ) -> Res<Item> {
        match frame.values[base.index()] {
            Some(Item::Pointer(pointer)) => self.buffer_of(pointer, array, index).map(Item::Pointer),
            Some(Item::Image(Choice { variable, .. })) => {
                Ok(Item::Image(self.chosen(variable, array, index)))
            }
            Some(Item::Sampler(Choice { variable, .. })) => {
                Ok(Item::Sampler(self.chosen(variable, array, index)))
            }
            Some(Item::Values(_)) | None => Err(malformed("something else is used as a binding array")),
        }
    }

    fn buffer_of(&mut self, pointer: Pointer, array: BindingArray, index: Value) -> Res<Pointer> {
        let Shape::Type(ty) = pointer.shape else {
            return Err(malformed("a binding array has no type"));
        };
        let TypeInner::BindingArray { base, .. } = *self.types().inner(ty) else {
            return Err(malformed("a binding array is of another type"));
        };
        let (offset, entry) = self.entry_of(array, index, BindingArray::PLACE);
        let mut word = |offset| {
            let place = Place::Buffer { buffer: array.directory, offset, index: entry };
            Some(self.b.load(place, Scalar::U32))
        };
        let (index, end) = (word(offset), word(offset + 4));
        Ok(Pointer { offset: 0, index, end, shape: Shape::Type(base), ..pointer })
    }

    fn chosen(&mut self, variable: u32, array: BindingArray, index: Value) -> Choice {
        let (offset, index) = self.entry_of(array, index, BindingArray::NUMBER);
        let place = Place::Buffer { buffer: array.directory, offset, index };
        Choice { variable, element: Some(self.b.load(place, Scalar::U32)) }
    }

    /// Where the entry of an element lies in its array's directory: bytes that are known, and such that are computed.
    fn entry_of(&mut self, array: BindingArray, index: Value, size: u32) -> (u32, Option<Value>) {
        let count = match array.count {
            Some(count) => Count::Fixed(count),
            None => Count::Runtime { buffer: array.directory, begin: 0 },
        };
        match (self.b.known(index), array.count) {
            (Some(known), Some(count)) if known < count.into() => ((known as u32).saturating_mul(size), None),
            _ => (0, Some(self.b.index(None, index, count, size))),
        }
    }

    /// How many elements the runtime-sized array has that `pointer` leads to, which lies in an element of a binding array
    /// that has its `end`.
    pub(crate) fn length_within(&mut self, pointer: &Pointer, end: Value, stride: u32) -> Value {
        let (offset, stride) = (self.b.u32(pointer.offset), self.b.u32(stride.max(1)));
        let begin = match pointer.index {
            Some(index) => self.b.int_op(IntOp::Add, &[index, offset]),
            None => offset,
        };
        let bytes = self.b.int_op(IntOp::Sub, &[end, begin]);
        self.b.int_op(IntOp::Div, &[bytes, stride])
    }

    /// The address of an element of that array.
    pub(crate) fn index_within(&mut self, pointer: &Pointer, end: Value, index: Value, stride: u32) -> Value {
        let count = self.length_within(pointer, end, stride);
        let base = pointer.index.unwrap_or_else(|| self.b.u32(0));
        self.b.eval(Op::IndexWithin { stride }, &[index, base, count])
    }
}
