//! What a dispatch is given for its variables.

use super::Buffer;
use super::error::{InterpError, Res};
use super::program::{self, Program};
use crate::texture::{Format, Kind, Sampler, Texture, TextureShape};
use naga::{ImageClass, ScalarKind};

/// A texture and where it is bound.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BoundTexture {
    /// Bind group.
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// The texture.
    pub texture: Texture,
}

/// A sampler and where it is bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundSampler {
    /// Bind group.
    pub group: u32,
    /// Binding within the group.
    pub binding: u32,
    /// The sampler.
    pub sampler: Sampler,
}

/// All that a dispatch may use; more than it uses does no harm. Buffers alone turn into it.
#[derive(Debug, Default)]
pub struct Resources<'a> {
    /// Storage buffers, updated in place, and uniform ones.
    pub buffers: &'a mut [Buffer],
    /// Sampled textures, and storage textures, updated in place.
    pub textures: &'a mut [BoundTexture],
    /// Samplers.
    pub samplers: &'a [BoundSampler],
}

impl<'a> From<&'a mut [Buffer]> for Resources<'a> {
    fn from(buffers: &'a mut [Buffer]) -> Self {
        Self { buffers, ..Self::default() }
    }
}

impl<'a, const N: usize> From<&'a mut [Buffer; N]> for Resources<'a> {
    fn from(buffers: &'a mut [Buffer; N]) -> Self {
        Self::from(buffers.as_mut_slice())
    }
}

impl<'a> From<&'a mut Vec<Buffer>> for Resources<'a> {
    fn from(buffers: &'a mut Vec<Buffer>) -> Self {
        Self::from(buffers.as_mut_slice())
    }
}

/// What a program's variables are of the resources.
pub(super) struct Found {
    /// By index; none of workgroup memory.
    pub(super) buffers: Vec<Option<usize>>,
    /// By index.
    pub(super) images: Vec<usize>,
    pub(super) samplers: Vec<Sampler>,
}

impl Found {
    pub(super) fn of(program: &Program, resources: &Resources<'_>) -> Res<Self> {
        Ok(Self {
            buffers: buffers(program, resources.buffers)?,
            samplers: samplers(program, resources)?,
            images: images(program, resources.textures)?,
        })
    }
}

/// The buffer of each variable that has one.
fn buffers(program: &Program, buffers: &[Buffer]) -> Res<Vec<Option<usize>>> {
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
        Ok(Some(index))
    };
    program.buffers.iter().map(find).collect()
}

/// The texture of each variable.
fn images(program: &Program, textures: &[BoundTexture]) -> Res<Vec<usize>> {
    let find = |wanted: &program::Image| {
        let (group, binding) = wanted.binding;
        let found = textures.iter().position(|t| (t.group, t.binding) == (group, binding));
        let missing = || InterpError::MissingTexture { name: wanted.name.clone(), group, binding };
        let found = found.ok_or_else(missing)?;
        let shape = textures[found].texture.shape();
        if let Some(expected) = misfit(wanted, &shape) {
            let (name, found) = (wanted.name.clone(), shape.to_string());
            return Err(InterpError::TextureMisfit { name, expected, found });
        }
        Ok(found)
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
    let plural = if samples == 1 { "" } else { "s" };
    (!fits).then(|| {
        format!("a {} texture of {texels}, {samples} sample{plural} a texel{levels}", wanted.dimension)
    })
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
