//! What a dispatch is given for its variables.

use super::Buffer;
use crate::texture::{Sampler, Texture};

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
