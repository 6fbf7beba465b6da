//! The memory behind a program's variables.
#![allow(unsafe_code, reason = "buffers and textures are shared by threads")]

use super::super::super::error::{InterpError, Res};
use super::super::super::program::{self, Count, Program};
use super::super::super::resources::{BoundTexture, Resources};
use super::super::machine::Bound;
use super::super::together::BoundImage;
use super::order;
use crate::interp::Buffer;
use crate::texture::{Format, Kind, Sampler, TextureShape};
use naga::{ImageClass, ScalarKind};

/// The memory of all buffers and textures of a program; none yet behind workgroup variables.
pub(super) struct Memory {
    pub(super) buffers: Vec<Bound>,
    pub(super) images: Vec<BoundImage>,
    pub(super) samplers: Vec<Sampler>,
}

// SAFETY: the bytes outlive the dispatch; threads write them at the same time only if no order can show
// (`order`), by atomics or at places of their own.
unsafe impl Sync for Memory {}

impl Memory {
    /// Length of the shortest of these arrays.
    pub(super) fn shortest(&self, arrays: &[order::Elements]) -> usize {
        let length = |array: &order::Elements| match array.count {
            Count::Fixed(count) => count as usize,
            Count::Runtime { buffer, begin } => {
                self.buffers[buffer as usize].len.saturating_sub(begin as usize)
                    / array.stride.max(1) as usize
            }
        };
        arrays.iter().map(length).min().unwrap_or(usize::MAX)
    }
}

/// The bytes of a buffer where atomics can use them.
struct Aligned {
    index: usize,
    words: Option<Vec<u64>>,
}

impl Aligned {
    fn new(index: usize, buffer: &Buffer) -> Self {
        let aligned = buffer.data.as_ptr().addr().is_multiple_of(align_of::<u64>());
        let words = (!aligned).then(|| {
            let mut padded = buffer.data.clone();
            padded.resize(buffer.data.len().next_multiple_of(8), 0);
            padded.as_chunks().0.iter().map(|c| u64::from_ne_bytes(*c)).collect()
        });
        Self { index, words }
    }

    fn bound(&mut self, buffers: &mut [Buffer]) -> Bound {
        let data = &mut buffers[self.index].data;
        let ptr = self.words.as_mut().map_or(data.as_mut_ptr(), |w| w.as_mut_ptr().cast());
        Bound { ptr, len: data.len() }
    }

    fn write_back(self, buffers: &mut [Buffer]) {
        if let Some(words) = self.words {
            let bytes = words.iter().flat_map(|w| w.to_ne_bytes());
            buffers[self.index].data.iter_mut().zip(bytes).for_each(|(to, byte)| *to = byte);
        }
    }
}

/// Lends `body` the memory that `resources` are for `program`.
pub(super) fn bound(
    program: &Program,
    resources: &mut Resources<'_>,
    body: impl FnOnce(&Memory) -> Res<()>,
) -> Res<()> {
    let mut aligned = buffers(program, resources.buffers)?;
    let samplers = samplers(program, resources)?;
    let images = images(program, resources.textures)?;
    let bound = |a: &mut Option<Aligned>| match a {
        Some(a) => a.bound(resources.buffers),
        None => Bound { ptr: std::ptr::dangling_mut(), len: 0 },
    };
    let outcome = body(&Memory { buffers: aligned.iter_mut().map(bound).collect(), images, samplers });
    aligned.into_iter().flatten().for_each(|a| a.write_back(resources.buffers));
    outcome
}

/// The buffer of each variable that has one.
fn buffers(program: &Program, buffers: &[Buffer]) -> Res<Vec<Option<Aligned>>> {
    let find = |wanted: &program::Buffer| {
        let Some((group, binding)) = wanted.binding else {
            return Ok(None);
        };
        let name = || wanted.name.clone();
        let index = buffers
            .iter()
            .position(|b| (b.group, b.binding) == (group, binding))
            .ok_or_else(|| InterpError::MissingBuffer { name: name(), group, binding })?;
        let (expected, found) = (wanted.bytes as usize, buffers[index].data.len());
        if found < expected {
            return Err(InterpError::BufferTooSmall { name: name(), expected, found });
        }
        Ok(Some(Aligned::new(index, &buffers[index])))
    };
    program.buffers.iter().map(find).collect()
}

/// The texture of each variable.
fn images(program: &Program, textures: &mut [BoundTexture]) -> Res<Vec<BoundImage>> {
    let find = |wanted: &program::Image| {
        let (group, binding) = wanted.binding;
        let found = textures.iter_mut().find(|t| (t.group, t.binding) == (group, binding));
        let missing = || InterpError::MissingTexture { name: wanted.name.clone(), group, binding };
        let texture = &mut found.ok_or_else(missing)?.texture;
        let shape = texture.shape();
        if let Some(expected) = misfit(wanted, &shape) {
            let (name, found) = (wanted.name.clone(), shape.to_string());
            return Err(InterpError::TextureMisfit { name, expected, found });
        }
        let bytes = texture.bytes_mut();
        Ok(BoundImage { shape, ptr: bytes.as_mut_ptr(), len: bytes.len() })
    };
    program.images.iter().map(find).collect()
}

/// What a variable wants, unless the shape is it.
fn misfit(wanted: &program::Image, shape: &TextureShape) -> Option<String> {
    let (texels, samples, fits) = match wanted.class {
        ImageClass::Sampled { kind, multi } => {
            let (texels, kinds) = match kind {
                ScalarKind::Sint => ("signed integers".to_owned(), [Kind::Sint; 2]),
                ScalarKind::Uint => ("unsigned integers".to_owned(), [Kind::Uint; 2]),
                _ => ("floats".to_owned(), [Kind::Float, Kind::Depth]),
            };
            (texels, if multi { 4 } else { 1 }, kinds.contains(&shape.format.kind()))
        }
        ImageClass::Depth { multi } => {
            ("depths".to_owned(), if multi { 4 } else { 1 }, shape.format.kind() == Kind::Depth)
        }
        ImageClass::Storage { format, .. } => {
            let format = Format::Storage(format);
            (format.to_string(), 1, shape.format == format)
        }
        ImageClass::External => ("an external source".to_owned(), 1, false),
    };
    let single = !matches!(wanted.class, ImageClass::Storage { .. }) || shape.levels == 1;
    let fits = fits && single && shape.samples == samples && shape.dimension == wanted.dimension;
    let levels = if single { "" } else { ", 1 level" };
    (!fits).then(|| format!("a {} texture of {texels}, {samples} a texel{levels}", wanted.dimension))
}

/// The sampler of each variable.
fn samplers(program: &Program, resources: &Resources<'_>) -> Res<Vec<Sampler>> {
    let find = |wanted: &program::SamplerVariable| {
        let (group, binding) = wanted.binding;
        let found = resources.samplers.iter().find(|s| (s.group, s.binding) == (group, binding));
        let name = || wanted.name.clone();
        let sampler =
            found.ok_or_else(|| InterpError::MissingSampler { name: name(), group, binding })?.sampler;
        if sampler.compare.is_some() != wanted.comparison {
            return Err(InterpError::SamplerMisfit { name: name(), comparison: wanted.comparison });
        }
        Ok(sampler)
    };
    program.samplers.iter().map(find).collect()
}
