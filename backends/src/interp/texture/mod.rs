//! What texture operations are, for one invocation: plain functions of numbers.
//!
//! They follow the Vulkan specification's chapter on image operations, which is what WebGPU runs on:
//!
//! - `load` reads and writes texels by number. Out of bounds, a load finds a texel of zeros and a store does nothing:
//!   naga leaves images unchecked by default, and so does wgpu where Vulkan's robust image access promises this.
//! - `address` turns coordinates into numbers of texels and weights; `cube` finds faces and what lies past their
//!   edges; `lod` chooses levels.
//! - `sample` puts these together: filtering, gathering, comparing.
//! - `reach` tells what drivers may find in place of that, where nothing is blended.
//! - `perform` is what an executor calls: an operation of a program with its operands.
//!
//! Weights are exact here: coordinates become texel units by one f32 product, all that follows is f64, and a filtered
//! result is rounded once. Drivers may snap weights to divisions of 2^-4, those between levels too, and usually do to 2^-8, so
//! a result may differ from theirs by that share of the largest difference of the texels around for each axis, and once
//! more for levels.

mod address;
mod cube;
mod load;
mod lod;
mod perform;
mod reach;
mod sample;

use load::{At, inside, load, store};
use lod::Lod;
pub(crate) use perform::{astray, perform, texel_at, wanted};
pub(crate) use reach::{Reach, reach};
use sample::{Sample, sample};

use crate::texture::TextureShape;

/// Where texels come from.
pub(crate) trait Texels {
    /// What the texture is.
    fn shape(&self) -> TextureShape;
    /// The texel that begins at a byte, which is in bounds.
    fn texel(&self, at: usize) -> u128;
}

/// Where texels go to as well.
pub(crate) trait TexelsMut: Texels {
    /// Replaces the texel that begins at a byte, which is in bounds.
    fn set_texel(&mut self, at: usize, texel: u128);
}

impl Texels for crate::texture::Texture {
    fn shape(&self) -> TextureShape {
        Self::shape(self)
    }
    fn texel(&self, at: usize) -> u128 {
        let mut bytes = [0; 16];
        let size = self.shape().format.bytes();
        bytes[..size].copy_from_slice(&self.bytes()[at..at + size]);
        u128::from_le_bytes(bytes)
    }
}

impl TexelsMut for crate::texture::Texture {
    fn set_texel(&mut self, at: usize, texel: u128) {
        let size = Texels::shape(self).format.bytes();
        self.bytes_mut()[at..at + size].copy_from_slice(&texel.to_le_bytes()[..size]);
    }
}
