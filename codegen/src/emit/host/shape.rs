//! Types as arrays of words.

use naga::{ArraySize, Handle, Module, Scalar, ScalarKind, Type, TypeInner, VectorSize};

/// What an array is of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Element {
    Float,
    Signed,
    Unsigned,
    /// A structure of this name.
    Structure(String),
}

/// Elements in rows of rows.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Shape {
    pub(super) element: Element,
    /// Elements along each dimension, the outermost first; none for a single one.
    pub(super) dims: Vec<u32>,
    /// Bytes.
    pub(super) size: u32,
}

impl Shape {
    /// Words that mean nothing.
    pub(super) fn words(count: u32) -> Self {
        Self { element: Element::Unsigned, dims: vec![count], size: 4 * count }
    }

    /// So many of it, each so many bytes from the one before; `None` if it is one element, and shorter.
    fn repeated(mut self, count: u32, stride: u32) -> Option<Self> {
        if self.size < stride {
            // Three words take the room of four.
            *self.dims.last_mut()? += (stride - self.size) / 4;
        }
        self.dims.insert(0, count);
        self.size = count * stride;
        Some(self)
    }
}

/// The shape of a type; `None` if buffers cannot hold it, or if only their length tells how many elements it has.
pub(super) fn of(module: &Module, ty: Handle<Type>) -> Option<Shape> {
    match &module.types[ty].inner {
        TypeInner::Scalar(scalar) | TypeInner::Atomic(scalar) => {
            Some(Shape { element: element(*scalar)?, dims: Vec::new(), size: 4 })
        }
        TypeInner::Vector { size, scalar } => vector(*size, *scalar),
        TypeInner::Matrix { columns, rows, scalar } => {
            let stride = if *rows == VectorSize::Bi { 8 } else { 16 };
            vector(*rows, *scalar)?.repeated(*columns as u32, stride)
        }
        TypeInner::Array { base, size: ArraySize::Constant(count), stride } => {
            of(module, *base)?.repeated(count.get(), *stride)
        }
        TypeInner::Struct { members, span } => {
            members.iter().all(|member| of(module, member.ty).is_some()).then(|| Shape {
                element: Element::Structure(module.types[ty].name.clone().unwrap_or_default()),
                dims: Vec::new(),
                size: *span,
            })
        }
        _ => None,
    }
}

fn vector(size: VectorSize, scalar: Scalar) -> Option<Shape> {
    let count = size as u32;
    Some(Shape { element: element(scalar)?, dims: vec![count], size: 4 * count })
}

fn element(scalar: Scalar) -> Option<Element> {
    match (scalar.kind, scalar.width) {
        (ScalarKind::Float, 4) => Some(Element::Float),
        (ScalarKind::Sint, 4) => Some(Element::Signed),
        (ScalarKind::Uint, 4) => Some(Element::Unsigned),
        _ => None,
    }
}
