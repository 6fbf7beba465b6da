//! What a dispatch is given for its variables.

pub(super) mod elements;

use super::Buffer;
use super::error::{InterpError, Res};
use super::program::{self, Content, Program};
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
///
/// What is given for one place several times are the elements of a binding array, in order.
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
    /// By index.
    pub(super) buffers: Vec<FoundBuffer>,
    /// By index; then the elements of binding arrays, which directories name by their place in this list.
    pub(super) images: Vec<FoundImage>,
    /// Likewise.
    pub(super) samplers: Vec<Sampler>,
}

/// What one of a program's buffers is of the resources.
pub(super) enum FoundBuffer {
    /// Memory of the workgroup.
    Own,
    /// A buffer.
    One(usize),
    /// Several, one behind the other.
    Elements(elements::Elements),
    /// A directory.
    Directory(Vec<u32>),
}

/// A texture among the resources.
#[derive(Clone, Copy)]
pub(super) struct FoundImage {
    /// Which.
    pub(super) at: usize,
    /// The variable that it is bound to; none of a binding array as a whole.
    pub(super) variable: Option<usize>,
    /// Its number in a binding array.
    pub(super) element: u32,
}

impl Found {
    pub(super) fn of(program: &Program, resources: &Resources<'_>) -> Res<Self> {
        let mut found = Self {
            buffers: buffers(program, resources.buffers)?,
            samplers: samplers(program, resources)?,
            images: images(program, resources.textures)?,
        };
        found.elements(program, resources)?;
        Ok(found)
    }
}

/// The buffer of each variable that stands for one.
fn buffers(program: &Program, buffers: &[Buffer]) -> Res<Vec<FoundBuffer>> {
    let find = |wanted: &program::Buffer| {
        let Some((group, binding)) = wanted.binding else {
            return Ok(FoundBuffer::Own);
        };
        if wanted.content != Content::Variable {
            return Ok(FoundBuffer::Directory(Vec::new()));
        }
        let index = buffers
            .iter()
            .position(|b| (b.group, b.binding) == (group, binding))
            .ok_or_else(|| InterpError::MissingBuffer { name: wanted.name.clone(), group, binding })?;
        check_size(wanted, &buffers[index])?;
        Ok(FoundBuffer::One(index))
    };
    program.buffers.iter().map(find).collect()
}

/// Whether a buffer has room for what its variable wants.
fn check_size(wanted: &program::Buffer, buffer: &Buffer) -> Res<()> {
    let (expected, found) = (wanted.bytes as usize, buffer.data.len());
    if found < expected {
        return Err(InterpError::BufferTooSmall { name: wanted.name.clone(), expected, found });
    }
    Ok(())
}

/// The texture of each variable.
fn images(program: &Program, textures: &[BoundTexture]) -> Res<Vec<FoundImage>> {
    let find = |(index, wanted): (usize, &program::Image)| {
        let (group, binding) = wanted.binding;
        let found = textures.iter().position(|t| (t.group, t.binding) == (group, binding));
        let missing = || InterpError::MissingTexture { name: wanted.name.clone(), group, binding };
        let found = found.ok_or_else(missing)?;
        check_texture(wanted, &textures[found])?;
        let variable = wanted.array.is_none().then_some(index);
        Ok(FoundImage { at: found, variable, element: 0 })
    };
    program.images.iter().enumerate().map(find).collect()
}

/// Whether a texture is what its variable wants.
fn check_texture(wanted: &program::Image, texture: &BoundTexture) -> Res<()> {
    let shape = texture.texture.shape();
    match misfit(wanted, &shape) {
        Some(expected) => {
            let (name, found) = (wanted.name.clone(), shape.to_string());
            Err(InterpError::TextureMisfit { name, expected, found })
        }
        None => Ok(()),
    }
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
        let missing = || InterpError::MissingSampler { name: wanted.name.clone(), group, binding };
        let sampler = found.ok_or_else(missing)?.sampler;
        check_sampler(wanted, &sampler)?;
        Ok(sampler)
    };
    program.samplers.iter().map(find).collect()
}

/// Whether a sampler is what its variable wants.
fn check_sampler(wanted: &program::SamplerVariable, sampler: &Sampler) -> Res<()> {
    if sampler.compare.is_some() != wanted.comparison {
        let (name, comparison) = (wanted.name.clone(), wanted.comparison);
        return Err(InterpError::SamplerMisfit { name, comparison });
    }
    Ok(())
}
