//! Loads and stores of whole values, scalar by scalar.

use super::super::error::Res;
use super::super::program::{Place, Value};
use super::frame::{Pointer, Root};
use super::{Lowerer, malformed};

impl Lowerer<'_> {
    fn places(&self, pointer: Pointer) -> Res<Vec<(super::Scalar, u32)>> {
        let scalars = self.types().scalars(pointer.shape, self.packing(pointer.root))?;
        Ok(scalars.into_iter().map(|(scalar, at)| (scalar, pointer.offset.saturating_add(at))).collect())
    }

    /// The place of one scalar behind a pointer into memory.
    pub(crate) fn place(pointer: Pointer, offset: u32) -> Option<Place> {
        let index = pointer.index;
        match pointer.root {
            Root::Registers(_) => None,
            Root::Lane(array) => Some(Place::Lane { array, offset, index }),
            Root::Buffer(buffer) => Some(Place::Buffer { buffer, offset, index }),
        }
    }

    /// What `pointer` leads to.
    pub(crate) fn load(&mut self, pointer: Pointer) -> Res<Vec<Value>> {
        let mut out = Vec::new();
        for (scalar, offset) in self.places(pointer)? {
            out.push(match (Self::place(pointer, offset), pointer.root) {
                (Some(place), _) => self.load_place(pointer, place, scalar),
                (None, Root::Registers(first)) => {
                    let value = self.variables[first + offset as usize];
                    self.lasting(value)
                }
                (None, Root::Lane(_) | Root::Buffer(_)) => return Err(malformed("memory without a place")),
            });
        }
        Ok(out)
    }

    /// Writes `values` where `pointer` leads.
    pub(crate) fn store(&mut self, pointer: Pointer, values: &[Value]) -> Res<()> {
        for ((_, offset), value) in self.places(pointer)?.into_iter().zip(values) {
            match (Self::place(pointer, offset), pointer.root) {
                (Some(place), _) => self.store_place(pointer, place, *value),
                (None, Root::Registers(first)) => self.variables[first + offset as usize] = *value,
                (None, Root::Lane(_) | Root::Buffer(_)) => return Err(malformed("memory without a place")),
            }
        }
        Ok(())
    }
}
