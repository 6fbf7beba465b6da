//! Textures and samplers as every executor takes them: what they are, and texel bytes.
//!
//! A [`Texture`] is what a shader's variable sees, levels and layers and all: an executor makes of it whatever its
//! machine calls a texture and a view.

mod code;
mod format;
mod sampler;
mod shape;
mod stored;

pub use format::{Format, Kind};
pub use sampler::{Address, Compare, Filter, Sampler};
pub use shape::{Dimension, TextureShape};
pub(crate) use stored::Known;

/// Why there is no such texture or sampler.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TextureError {
    /// The texels do not fill the shape.
    #[error("a texture of {shape} has {expected} bytes, but {found} were given")]
    Bytes {
        /// The shape, in words.
        shape: String,
        /// Bytes that it has.
        expected: usize,
        /// Bytes given.
        found: usize,
    },
    /// No texture has this shape.
    #[error("there is no texture of {shape}: {reason}")]
    Shape {
        /// The shape, in words.
        shape: String,
        /// What is wrong with it, and what would be right.
        reason: &'static str,
    },
    /// No format has this name.
    #[error(
        "`{0}` is no texture format; formats have WGSL's names, such as rgba8unorm, r32float or depth32float"
    )]
    Format(String),
}

/// A texture: its shape and its texels.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Texture {
    shape: TextureShape,
    bytes: Vec<u8>,
}

impl Texture {
    /// A texture with these texels, laid out as [`TextureShape`] says.
    ///
    /// # Errors
    /// When there is no such shape, or it has another number of bytes.
    pub fn new(shape: TextureShape, bytes: Vec<u8>) -> Result<Self, TextureError> {
        shape.check(bytes.len())?;
        Ok(Self { shape, bytes })
    }

    /// A texture whose bytes are all zero.
    ///
    /// # Errors
    /// When there is no such shape.
    pub fn zeros(shape: TextureShape) -> Result<Self, TextureError> {
        let bytes = shape.bytes();
        shape.check(bytes)?;
        Ok(Self { shape, bytes: vec![0; bytes] })
    }

    /// What it is.
    #[must_use]
    pub fn shape(&self) -> TextureShape {
        self.shape
    }

    /// Its texels.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The same, to be changed.
    pub fn bytes_mut(&mut self) -> &mut [u8] {
        &mut self.bytes
    }

    /// Its texels, alone.
    #[must_use]
    pub fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }
}
