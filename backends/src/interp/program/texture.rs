//! Textures and samplers that programs use, and what they do with them.

use super::{BindingArray, Reg, Update, Value};
use crate::texture::Dimension;
use naga::{GlobalVariable, Handle, ImageClass, Span};

/// A texture variable.
#[derive(Debug, Clone)]
pub(crate) struct Image {
    pub(crate) variable: Handle<GlobalVariable>,
    pub(crate) name: String,
    /// Group and binding.
    pub(crate) binding: (u32, u32),
    pub(crate) dimension: Dimension,
    pub(crate) class: ImageClass,
    /// Whether the program writes it.
    pub(crate) written: bool,
    /// Whether it stands for several textures.
    pub(crate) array: Option<BindingArray>,
}

/// A sampler variable.
#[derive(Debug, Clone)]
pub(crate) struct SamplerVariable {
    pub(crate) variable: Handle<GlobalVariable>,
    pub(crate) name: String,
    /// Group and binding.
    pub(crate) binding: (u32, u32),
    /// Whether it compares.
    pub(crate) comparison: bool,
    /// Whether it stands for several samplers.
    pub(crate) array: Option<BindingArray>,
}

/// A texture operation in the active lanes, one after the other.
#[derive(Debug, Clone)]
pub(crate) struct Access {
    /// Of [`super::Program::images`].
    pub(crate) image: u32,
    pub(crate) op: TextureOp,
    pub(crate) operands: Operands<Value>,
    /// Takes what comes out: as many scalars as the operation's type has, of them those that somebody reads.
    pub(crate) to: [Option<Reg>; 4],
    /// Where the source has it.
    pub(crate) at: Span,
}

/// What it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TextureOp {
    Load,
    Store,
    Atomic(Update),
    Sample(Sampling),
    Size,
    Levels,
    Layers,
    Samples,
}

/// What is known of a sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Sampling {
    /// Of [`super::Program::samplers`].
    pub(crate) sampler: u32,
    /// In texels along each axis.
    pub(crate) offset: [i32; 3],
    /// The channel to gather.
    pub(crate) gather: Option<u8>,
    pub(crate) clamp_to_edge: bool,
}

/// Operands of a texture operation, each if it has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Operands<V> {
    /// Integers of a texel, floats of a sample.
    pub(crate) place: [Option<V>; 3],
    pub(crate) layer: Option<V>,
    /// An integer of a load or query, a float of a sample.
    pub(crate) level: Option<V>,
    pub(crate) sample: Option<V>,
    /// Of a sample: by how much coordinates change to the right, then down.
    pub(crate) gradient: [[Option<V>; 3]; 2],
    /// Of a comparing sample.
    pub(crate) reference: Option<V>,
    /// What is stored.
    pub(crate) values: [Option<V>; 4],
    /// Of a binding array of textures: the number of the element among the dispatch's textures.
    pub(crate) texture: Option<V>,
    /// Of a binding array of samplers: the number of the element among the dispatch's samplers.
    pub(crate) sampler: Option<V>,
}

impl TextureOp {
    /// Whether it changes the texture.
    pub(crate) fn writes(self) -> bool {
        match self {
            Self::Store | Self::Atomic(_) => true,
            Self::Load | Self::Sample(_) | Self::Size | Self::Levels | Self::Layers | Self::Samples => false,
        }
    }
}

impl<V> Default for Operands<V> {
    fn default() -> Self {
        Self {
            place: [const { None }; 3],
            layer: None,
            level: None,
            sample: None,
            gradient: [const { [const { None }; 3] }; 2],
            reference: None,
            values: [const { None }; 4],
            texture: None,
            sampler: None,
        }
    }
}

impl<V: Copy> Operands<V> {
    /// The same with `f` of each.
    pub(crate) fn map<W>(&self, mut f: impl FnMut(V) -> W) -> Operands<W> {
        let mut each = |v: Option<V>| v.map(&mut f);
        Operands {
            place: self.place.map(&mut each),
            layer: each(self.layer),
            level: each(self.level),
            sample: each(self.sample),
            gradient: self.gradient.map(|step| step.map(&mut each)),
            reference: each(self.reference),
            values: self.values.map(&mut each),
            texture: each(self.texture),
            sampler: each(self.sampler),
        }
    }
}
