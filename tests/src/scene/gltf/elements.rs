//! Elements of accessors: vectors and indices, sparse ones too.

use super::buffers::Buffers;
use crate::scene::SceneError;
use crate::scene::limits::refused;
use gltf::Accessor;
use gltf::accessor::sparse::{IndexType, Sparse};
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::View;

/// The most elements of an accessor of which the file holds only some: up to 16 bytes each are made for them.
const LARGEST_SPARSE: usize = 1 << 24;

/// What an accessor of vectors must be.
#[derive(Debug, Clone, Copy)]
pub(super) struct Form {
    /// How many components.
    pub(super) dimensions: Dimensions,
    /// Whether they may also be whole numbers that stand for 0 ..= 1.
    pub(super) may_be_shares: bool,
    /// In words: `positions are VEC3 of 32-bit floats`.
    pub(super) told: &'static str,
}

/// Positions.
pub(super) const POSITIONS: Form =
    Form { dimensions: Dimensions::Vec3, may_be_shares: false, told: "positions are VEC3 of 32-bit floats" };

/// Vectors of an accessor, of `N` numbers each, as `form` has it.
pub(super) fn vectors<const N: usize>(
    accessor: &Accessor,
    buffers: &Buffers,
    form: &Form,
) -> Result<Vec<[f32; N]>, SceneError> {
    let at = format!("accessors[{}]", accessor.index());
    let kind = accessor.data_type();
    let is_share =
        form.may_be_shares && accessor.normalized() && matches!(kind, DataType::U8 | DataType::U16);
    if accessor.dimensions() != form.dimensions || !(kind == DataType::F32 || is_share) {
        return refused(&at, form.told);
    }
    let mut vectors = match accessor.view() {
        Some(view) => Layout::of(accessor, &view).vectors(&at, buffers, kind)?,
        None => zeros(&at, accessor)?,
    };
    if let Some(sparse) = accessor.sparse() {
        overlay(&at, &mut vectors, &sparse, (kind, buffers))?;
    }
    Ok(vectors)
}

/// What a sparse accessor begins with that has no values of its own.
fn zeros<const N: usize>(at: &str, accessor: &Accessor) -> Result<Vec<[f32; N]>, SceneError> {
    if accessor.sparse().is_none() {
        return refused(at, "it has neither a bufferView nor sparse values, so there is nothing to read");
    }
    if accessor.count() > LARGEST_SPARSE {
        return refused(at, format!("its count {} is above {LARGEST_SPARSE}", accessor.count()));
    }
    Ok(vec![[0.0; N]; accessor.count()])
}

fn overlay<const N: usize>(
    at: &str,
    vectors: &mut [[f32; N]],
    sparse: &Sparse,
    (kind, buffers): (DataType, &Buffers),
) -> Result<(), SceneError> {
    let (indices, values) = (sparse.indices(), sparse.values());
    let at = format!("{at}.sparse");
    let layout = Layout { view: &indices.view(), offset: indices.offset(), count: sparse.count() };
    let of_indices = match indices.index_type() {
        IndexType::U8 => DataType::U8,
        IndexType::U16 => DataType::U16,
        IndexType::U32 => DataType::U32,
    };
    let places = layout.integers(&format!("{at}.indices"), buffers, of_indices)?;
    let layout = Layout { view: &values.view(), offset: values.offset(), count: sparse.count() };
    for (place, value) in places.into_iter().zip(layout.vectors(&format!("{at}.values"), buffers, kind)?) {
        let count = vectors.len();
        match vectors.get_mut(place as usize) {
            Some(vector) => *vector = value,
            None => return refused(&at, format!("it changes element {place}, and there are {count}")),
        }
    }
    Ok(())
}

/// Indices of an accessor of unsigned integers.
pub(super) fn indices(accessor: &Accessor, buffers: &Buffers) -> Result<Vec<u32>, SceneError> {
    let at = format!("accessors[{}]", accessor.index());
    if accessor.dimensions() != Dimensions::Scalar || accessor.sparse().is_some() {
        return refused(&at, "indices are SCALAR and not sparse");
    }
    match accessor.view() {
        Some(view) => Layout::of(accessor, &view).integers(&at, buffers, accessor.data_type()),
        None => refused(&at, "it has no bufferView, so there are no indices"),
    }
}

/// Where elements lie.
struct Layout<'a> {
    view: &'a View<'a>,
    offset: usize,
    count: usize,
}

impl<'a> Layout<'a> {
    fn of(accessor: &Accessor, view: &'a View<'a>) -> Self {
        Self { view, offset: accessor.offset(), count: accessor.count() }
    }

    fn integers(&self, at: &str, buffers: &Buffers, kind: DataType) -> Result<Vec<u32>, SceneError> {
        if !matches!(kind, DataType::U8 | DataType::U16 | DataType::U32) {
            return refused(at, "indices are unsigned integers of 8, 16 or 32 bits");
        }
        let integer = |bytes: &[u8]| bytes.iter().rev().fold(0, |high, byte| high << 8 | u32::from(*byte));
        self.read(at, buffers, kind.size(), integer)
    }

    /// Vectors of floats, or of whole numbers that stand for 0 ..= 1.
    fn vectors<const N: usize>(
        &self,
        at: &str,
        buffers: &Buffers,
        kind: DataType,
    ) -> Result<Vec<[f32; N]>, SceneError> {
        let bytes = N * kind.size();
        let number = |element: &[u8], i: usize| {
            let part = element.get(i * kind.size()..).unwrap_or_default();
            match (kind, part) {
                (DataType::U8, [byte, ..]) => f32::from(*byte) / 255.0,
                (DataType::U16, [a, b, ..]) => f32::from(u16::from_le_bytes([*a, *b])) / 65_535.0,
                (_, [a, b, c, d, ..]) => f32::from_le_bytes([*a, *b, *c, *d]),
                _ => 0.0,
            }
        };
        self.read(at, buffers, bytes, |element| std::array::from_fn(|i| number(element, i)))
    }

    /// The elements, each made of `size` bytes, once all of them are known to be there.
    fn read<T>(
        &self,
        at: &str,
        buffers: &Buffers,
        size: usize,
        make: impl Fn(&[u8]) -> T,
    ) -> Result<Vec<T>, SceneError> {
        let bytes = buffers.view(self.view)?;
        let stride = self.view.stride().unwrap_or(size);
        if stride < size {
            return refused(at, format!("its elements have {size} bytes, and byteStride is {stride}"));
        }
        let end = self
            .count
            .checked_sub(1)
            .map_or(Some(0), |last| last.checked_mul(stride)?.checked_add(self.offset)?.checked_add(size));
        if end.is_none_or(|end| end > bytes.len()) {
            let count = self.count;
            let message = format!(
                "{count} elements do not fit into bufferViews[{}] of {} bytes",
                self.view.index(),
                bytes.len()
            );
            return refused(at, message);
        }
        let element = |i: usize| bytes.get(self.offset + i * stride..)?.get(..size).map(&make);
        Ok((0..self.count).filter_map(element).collect())
    }
}
