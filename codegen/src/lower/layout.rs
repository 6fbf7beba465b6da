//! WGSL's memory layout of kernel types.

use crate::def::{StructDef, TypeDef};

/// Size and alignment in bytes.
#[derive(Clone, Copy)]
pub(super) struct Layout {
    pub(super) size: u32,
    pub(super) align: u32,
}

impl Layout {
    /// Distance of array elements.
    pub(super) fn stride(self) -> u32 {
        self.size.next_multiple_of(self.align)
    }
}

/// Layout of `ty`; a slice has that of its element.
pub(super) fn layout(ty: &TypeDef) -> Layout {
    match *ty {
        TypeDef::Scalar(_) | TypeDef::Atomic(_) => Layout { size: 4, align: 4 },
        TypeDef::Vector(n, _) => vector(n),
        TypeDef::Matrix(columns, rows) => {
            let column = vector(rows);
            Layout { size: column.stride() * u32::from(columns), align: column.align }
        }
        TypeDef::Array(element, n) => {
            let element = layout(element);
            Layout { size: element.stride() * n, align: element.align }
        }
        TypeDef::Slice(element) => layout(element),
        TypeDef::Struct(def) => members(def()).1,
    }
}

fn vector(n: u8) -> Layout {
    let align = if n == 2 { 8 } else { 16 };
    Layout { size: 4 * u32::from(n), align }
}

/// Offsets of the members, and the layout of the whole.
pub(super) fn members(def: &StructDef) -> (Vec<u32>, Layout) {
    let mut whole = Layout { size: 0, align: 1 };
    let offsets = def
        .fields
        .iter()
        .map(|field| {
            let member = layout(&field.ty);
            let offset = whole.size.next_multiple_of(member.align);
            whole = Layout { size: offset + member.size, align: whole.align.max(member.align) };
            offset
        })
        .collect();
    whole.size = whole.size.next_multiple_of(whole.align);
    (offsets, whole)
}
