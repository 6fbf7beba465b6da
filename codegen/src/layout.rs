//! Where the scalars of a value lie in a buffer, by WGSL's rules.
//!
//! Executors speak in columns, one for each scalar ([`crate::data::Columns`]); drivers in bytes with
//! padding.
//! A [`BufferLayout`] is the bridge: the byte offset of each scalar within an element, in the order of
//! the columns (declaration order; matrices column by column, arrays element by element).
//! Offsets come from the naga types themselves, so what is packed is what the shader reads.

use crate::def::Scalar;
use naga::{ArraySize, Handle, Module, ScalarKind, Type, TypeInner, VectorSize};

/// The elements of a buffer.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct BufferLayout {
    /// Bind group.
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// Bytes from one element to the next.
    pub stride: u32,
    /// The scalars of an element.
    pub leaves: Vec<LeafSlot>,
}

/// One scalar of an element.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct LeafSlot {
    /// Bytes from the start of the element.
    pub offset: u32,
    /// What the word means; a `bool` travels as a `u32`, 0 or 1.
    pub scalar: Scalar,
    /// `lobe.axis.x`, `weights[2]`.
    pub path: String,
}

/// Why a type has no layout.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum LayoutError {
    /// A scalar that is not one word.
    #[error("`{path}` is {kind}, and buffers of kernels hold 32-bit floats, integers and booleans only")]
    Scalar {
        /// Where it is.
        path: String,
        /// Its kind.
        kind: String,
    },
    /// No value at all.
    #[error("`{path}` is {kind}, which no value can be copied into")]
    NoValue {
        /// Where it is.
        path: String,
        /// Its kind.
        kind: String,
    },
    /// naga cannot lay the type out.
    #[error("naga cannot lay out the type of `{path}`: {reason}")]
    Layouter {
        /// Where it is.
        path: String,
        /// Why.
        reason: String,
    },
}

/// The layout of a buffer whose elements are of type `element`; paths begin with `name`.
///
/// # Errors
/// When `element` holds something else than 32-bit scalars.
pub fn buffer(
    module: &Module,
    element: Handle<Type>,
    name: &str,
    (group, binding): (u32, u32),
) -> Result<BufferLayout, LayoutError> {
    let mut layouter = naga::proc::Layouter::default();
    layouter
        .update(module.to_ctx())
        .map_err(|error| LayoutError::Layouter { path: name.to_owned(), reason: error.to_string() })?;
    let leaves = leaves(module, element, name)?;
    Ok(BufferLayout { group, binding, stride: layouter[element].to_stride(), leaves })
}

/// The scalars of `ty`; paths begin with `name`.
///
/// # Errors
/// When `ty` holds something else than 32-bit scalars.
pub fn leaves(module: &Module, ty: Handle<Type>, name: &str) -> Result<Vec<LeafSlot>, LayoutError> {
    let mut out = Vec::new();
    push(module, ty, 0, name.to_owned(), &mut out)?;
    Ok(out)
}

fn push(
    module: &Module,
    ty: Handle<Type>,
    offset: u32,
    path: String,
    out: &mut Vec<LeafSlot>,
) -> Result<(), LayoutError> {
    match module.types[ty].inner {
        TypeInner::Scalar(kind) | TypeInner::Atomic(kind) => {
            let scalar = scalar(kind, &path)?;
            out.push(LeafSlot { offset, scalar, path });
            Ok(())
        }
        TypeInner::Vector { size, scalar } => push_vector(size, scalar, offset, &path, out),
        TypeInner::Matrix { columns, rows, scalar } => {
            let stride = column_stride(rows);
            for (i, axis) in
                ["x_axis", "y_axis", "z_axis", "w_axis"].iter().take(columns as usize).enumerate()
            {
                push_vector(rows, scalar, offset + i as u32 * stride, &join(&path, axis), out)?;
            }
            Ok(())
        }
        TypeInner::Array { base, size: ArraySize::Constant(count), stride } => (0..count.get())
            .try_for_each(|i| push(module, base, offset + i * stride, format!("{path}[{i}]"), out)),
        TypeInner::Struct { ref members, .. } => members.iter().enumerate().try_for_each(|(i, member)| {
            let name = member.name.clone().unwrap_or_else(|| i.to_string());
            push(module, member.ty, offset + member.offset, join(&path, &name), out)
        }),
        ref other => Err(LayoutError::NoValue { path, kind: describe(other).to_owned() }),
    }
}

fn push_vector(
    size: VectorSize,
    kind: naga::Scalar,
    offset: u32,
    path: &str,
    out: &mut Vec<LeafSlot>,
) -> Result<(), LayoutError> {
    for (i, component) in ["x", "y", "z", "w"].iter().take(size as usize).enumerate() {
        let path = join(path, component);
        let scalar = scalar(kind, &path)?;
        out.push(LeafSlot { offset: offset + 4 * i as u32, scalar, path });
    }
    Ok(())
}

/// Bytes from one column of a 32-bit matrix to the next: three rows take the room of four.
fn column_stride(rows: VectorSize) -> u32 {
    match rows {
        VectorSize::Bi => 8,
        VectorSize::Tri | VectorSize::Quad => 16,
    }
}

fn scalar(scalar: naga::Scalar, path: &str) -> Result<Scalar, LayoutError> {
    match (scalar.kind, scalar.width) {
        (ScalarKind::Float, 4) => Ok(Scalar::F32),
        (ScalarKind::Sint, 4) => Ok(Scalar::I32),
        (ScalarKind::Uint, 4) => Ok(Scalar::U32),
        (ScalarKind::Bool, _) => Ok(Scalar::Bool),
        (kind, width) => Err(LayoutError::Scalar {
            path: path.to_owned(),
            kind: format!("a {}-bit {kind:?}", u32::from(width) * 8),
        }),
    }
}

/// What a type without scalars is, in words.
fn describe(inner: &TypeInner) -> &'static str {
    match inner {
        TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. } => "a pointer",
        TypeInner::Array { .. } => "an array without a fixed length",
        TypeInner::Image { .. } => "a texture",
        TypeInner::Sampler { .. } => "a sampler",
        TypeInner::AccelerationStructure { .. } | TypeInner::RayQuery { .. } => "a ray query",
        TypeInner::BindingArray { .. } => "an array of bindings",
        TypeInner::CooperativeMatrix { .. } => "a cooperative matrix",
        TypeInner::Scalar(_)
        | TypeInner::Vector { .. }
        | TypeInner::Matrix { .. }
        | TypeInner::Atomic(_)
        | TypeInner::Struct { .. } => "a value",
    }
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") }
}

/// The bytes of `rows` elements whose scalars are `columns`; padding, and whatever a column lacks, is zero.
pub fn pack(layout: &BufferLayout, columns: &[Vec<u32>], rows: usize) -> Vec<u8> {
    let stride = layout.stride as usize;
    let mut bytes = vec![0; stride * rows];
    for (leaf, column) in layout.leaves.iter().zip(columns) {
        for (element, word) in bytes.chunks_exact_mut(stride.max(1)).zip(column) {
            if let Some(place) = element.get_mut(leaf.offset as usize..leaf.offset as usize + 4) {
                place.copy_from_slice(&word.to_le_bytes());
            }
        }
    }
    bytes
}

/// The columns of `rows` elements; scalars past the end of `bytes` are zero.
pub fn unpack(layout: &BufferLayout, bytes: &[u8], rows: usize) -> Vec<Vec<u32>> {
    let word = |row: usize, leaf: &LeafSlot| {
        let start = row * layout.stride as usize + leaf.offset as usize;
        let place = bytes.get(start..start + 4).and_then(|place| <[u8; 4]>::try_from(place).ok());
        place.map_or(0, u32::from_le_bytes)
    };
    layout.leaves.iter().map(|leaf| (0..rows).map(|row| word(row, leaf)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "
        struct Inner { axis: vec3<f32>, sharpness: f32, frame: mat3x3<f32> }
        struct Outer { flag: u32, inner: Inner, pairs: array<vec3<i32>, 2>, thin: mat3x2<f32> }
        fn f(o: Outer) -> u32 { return o.flag; }
    ";

    fn outer() -> BufferLayout {
        let module = crate::validate::from_wgsl(TEXT).unwrap();
        let function = module.function("f").unwrap();
        let ty = module.module().functions[function].arguments[0].ty;
        buffer(module.module(), ty, "o", (1, 2)).unwrap()
    }

    #[test]
    fn offsets_are_those_of_the_wgsl_specification() {
        let layout = outer();
        assert_eq!((layout.group, layout.binding, layout.stride), (1, 2, 144));
        let offset = |path: &str| layout.leaves.iter().find(|l| l.path == path).map(|l| l.offset);
        for (path, expected) in [
            ("o.flag", 0),
            ("o.inner.axis.z", 24),
            ("o.inner.sharpness", 28),
            ("o.inner.frame.x_axis.x", 32),
            ("o.inner.frame.z_axis.y", 68),
            ("o.pairs[0].x", 80),
            ("o.pairs[1].z", 104),
            ("o.thin.y_axis.x", 120),
            ("o.thin.z_axis.y", 132),
        ] {
            assert_eq!(offset(path), Some(expected), "{path}");
        }
        assert_eq!(layout.leaves.len(), 1 + 3 + 1 + 9 + 6 + 6);
    }

    #[test]
    fn packing_and_unpacking_give_back_every_word() {
        let layout = outer();
        let rows = 5;
        let columns: Vec<Vec<u32>> = (0..layout.leaves.len())
            .map(|c| (0..rows).map(|r| (c * 1000 + r) as u32 ^ 0x7fc0_0001).collect())
            .collect();
        let bytes = pack(&layout, &columns, rows);
        assert_eq!(bytes.len(), rows * 144);
        assert_eq!(unpack(&layout, &bytes, rows), columns);
        // No two scalars share a byte: each word occurs as often as it was put in.
        let words = bytes.chunks_exact(4).filter(|w| *w != [0; 4]).count();
        assert_eq!(words, columns.iter().flatten().filter(|w| **w != 0).count());
    }

    #[test]
    fn too_few_bytes_or_columns_are_zeros_and_no_panic() {
        let layout = outer();
        assert!(unpack(&layout, &[1, 2, 3], 2).iter().flatten().all(|w| *w == 0));
        assert_eq!(pack(&layout, &[], 1), vec![0; 144]);
    }
}
