//! Elements of accessors: positions and indices, sparse ones too.

use super::buffers::Buffers;
use crate::scene::SceneError;
use crate::scene::limits::refused;
use gltf::Accessor;
use gltf::accessor::sparse::{IndexType, Sparse};
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::View;

/// The most elements of an accessor of which the file holds only some: 12 bytes each are made for them.
const LARGEST_SPARSE: usize = 1 << 24;

/// Points of an accessor of three floats each.
pub(super) fn points(accessor: &Accessor, buffers: &Buffers) -> Result<Vec<[f32; 3]>, SceneError> {
    let at = format!("accessors[{}]", accessor.index());
    if (accessor.dimensions(), accessor.data_type()) != (Dimensions::Vec3, DataType::F32) {
        return refused(&at, "positions are VEC3 of 32-bit floats");
    }
    let mut points = match accessor.view() {
        Some(view) => Layout::of(accessor, &view).read(&at, buffers, point)?,
        None => zeros(&at, accessor)?,
    };
    if let Some(sparse) = accessor.sparse() {
        overlay(&at, &mut points, &sparse, buffers)?;
    }
    Ok(points)
}

/// What a sparse accessor begins with that has no values of its own.
fn zeros(at: &str, accessor: &Accessor) -> Result<Vec<[f32; 3]>, SceneError> {
    if accessor.sparse().is_none() {
        return refused(at, "it has neither a bufferView nor sparse values, so there is nothing to read");
    }
    if accessor.count() > LARGEST_SPARSE {
        return refused(at, format!("its count {} is above {LARGEST_SPARSE}", accessor.count()));
    }
    Ok(vec![[0.0; 3]; accessor.count()])
}

fn overlay(at: &str, points: &mut [[f32; 3]], sparse: &Sparse, buffers: &Buffers) -> Result<(), SceneError> {
    let (indices, values) = (sparse.indices(), sparse.values());
    let at = format!("{at}.sparse");
    let layout = Layout { view: &indices.view(), offset: indices.offset(), count: sparse.count() };
    let kind = match indices.index_type() {
        IndexType::U8 => DataType::U8,
        IndexType::U16 => DataType::U16,
        IndexType::U32 => DataType::U32,
    };
    let places = layout.integers(&format!("{at}.indices"), buffers, kind)?;
    let layout = Layout { view: &values.view(), offset: values.offset(), count: sparse.count() };
    for (place, value) in places.into_iter().zip(layout.read(&format!("{at}.values"), buffers, point)?) {
        let count = points.len();
        match points.get_mut(place as usize) {
            Some(point) => *point = value,
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
        match kind {
            DataType::U8 => self.read(at, buffers, |[byte]: &[u8; 1]| u32::from(*byte)),
            DataType::U16 => self.read(at, buffers, |bytes: &[u8; 2]| u32::from(u16::from_le_bytes(*bytes))),
            DataType::U32 => self.read(at, buffers, |bytes: &[u8; 4]| u32::from_le_bytes(*bytes)),
            _ => refused(at, "indices are unsigned integers of 8, 16 or 32 bits"),
        }
    }

    /// The elements, each made of `N` bytes, once all of them are known to be there.
    fn read<const N: usize, T>(
        &self,
        at: &str,
        buffers: &Buffers,
        make: impl Fn(&[u8; N]) -> T,
    ) -> Result<Vec<T>, SceneError> {
        let bytes = buffers.view(self.view)?;
        let stride = self.view.stride().unwrap_or(N);
        if stride < N {
            return refused(at, format!("its elements have {N} bytes, and byteStride is {stride}"));
        }
        let end = self
            .count
            .checked_sub(1)
            .map_or(Some(0), |last| last.checked_mul(stride)?.checked_add(self.offset)?.checked_add(N));
        if end.is_none_or(|end| end > bytes.len()) {
            let count = self.count;
            let message = format!(
                "{count} elements do not fit into bufferViews[{}] of {} bytes",
                self.view.index(),
                bytes.len()
            );
            return refused(at, message);
        }
        let element = |i: usize| bytes.get(self.offset + i * stride..)?.first_chunk().map(&make);
        Ok((0..self.count).filter_map(element).collect())
    }
}

fn point(bytes: &[u8; 12]) -> [f32; 3] {
    let [a, b, c, d, e, f, g, h, i, j, k, l] = *bytes;
    [[a, b, c, d], [e, f, g, h], [i, j, k, l]].map(f32::from_le_bytes)
}
