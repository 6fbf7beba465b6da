//! Memory that programs address: of each lane, and shared.

use super::Value;
use naga::{GlobalVariable, Handle};

/// Scalars of each lane that are indexed dynamically: a local or private variable.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LaneArray {
    /// How many.
    pub(crate) len: u32,
    /// Whether they take 64 bits each: then all of them do.
    pub(crate) wide: bool,
}

/// A buffer or a workgroup variable.
#[derive(Debug, Clone)]
pub(crate) struct Buffer {
    /// The variable.
    pub(crate) variable: Handle<GlobalVariable>,
    /// Its name.
    pub(crate) name: String,
    /// Group and binding; `None` for workgroup memory.
    pub(crate) binding: Option<(u32, u32)>,
    /// Bytes that its type needs: of a runtime-sized array one element.
    pub(crate) bytes: u32,
    /// Whether the program writes it.
    pub(crate) written: bool,
    /// Whether shaders may write it, so that loads depend on when they happen.
    pub(crate) writable: bool,
    /// What lies in it.
    pub(crate) content: Content,
}

/// What lies in a buffer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Content {
    /// The variable.
    Variable,
    /// All elements of a binding array, one behind the other.
    Elements(BindingArray),
    /// Where the elements of a binding array of buffers lie among those of [`Content::Elements`]: of each the first byte, and
    /// the byte behind the last.
    Places(BindingArray),
    /// Which elements of a binding array of textures there are, by number among the dispatch's textures.
    Textures(BindingArray),
    /// The same of samplers.
    Samplers(BindingArray),
}

/// A variable that stands for several resources.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct BindingArray {
    /// How many; `None`: as many as are bound.
    pub(crate) count: Option<u32>,
    /// The buffer that says where each element is.
    pub(crate) directory: u32,
}

impl BindingArray {
    /// Bytes of an element's entry in the directory of buffers.
    pub(crate) const PLACE: u32 = 8;
    /// The same in that of textures and samplers.
    pub(crate) const NUMBER: u32 = 4;
}

/// How many elements an index may choose from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Count {
    /// As the type says.
    Fixed(u32),
    /// As many as the buffer holds behind `begin` bytes.
    Runtime { buffer: u32, begin: u32 },
}

/// One scalar in memory; it always exists, since indices are clamped before they are scaled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Place {
    /// Byte `offset + index` of a buffer.
    Buffer { buffer: u32, offset: u32, index: Option<Value> },
    /// Scalar `offset + index` of a lane array.
    Lane { array: u32, offset: u32, index: Option<Value> },
    /// Byte `offset` of an element, `stride` bytes long, of an array that begins with the buffer; the index is
    /// clamped to the last. Made by passes.
    Element { buffer: u32, offset: u32, index: Value, count: Count, stride: u32 },
}

impl Place {
    /// The part of the address that is computed.
    pub(crate) fn index(&self) -> Option<Value> {
        match self {
            Self::Buffer { index, .. } | Self::Lane { index, .. } => *index,
            Self::Element { index, .. } => Some(*index),
        }
    }

    /// The same, to be changed.
    pub(crate) fn index_mut(&mut self) -> Option<&mut Value> {
        match self {
            Self::Buffer { index, .. } | Self::Lane { index, .. } => index.as_mut(),
            Self::Element { index, .. } => Some(index),
        }
    }

    /// Whether both lie in one element, at the same index.
    pub(crate) fn same_element(&self, other: &Self) -> bool {
        match (*self, *other) {
            (
                Self::Element { buffer: a, index: i, count: m, stride: s, .. },
                Self::Element { buffer: b, index: j, count: n, stride: t, .. },
            ) => (a, i, m, s) == (b, j, n, t),
            _ => false,
        }
    }

    /// The buffer, unless it is a lane's own memory.
    pub(crate) fn buffer(&self) -> Option<u32> {
        match self {
            Self::Buffer { buffer, .. } | Self::Element { buffer, .. } => Some(*buffer),
            Self::Lane { .. } => None,
        }
    }
}
