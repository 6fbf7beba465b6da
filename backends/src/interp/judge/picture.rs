//! What is known of the texels that a program writes.

use super::super::resources::FoundImage;
use super::super::texture::{Texels, TexelsMut};
use crate::texture::{Known, Texture, TextureShape};
use std::collections::BTreeMap;

/// A texture, and what was stored in it.
#[derive(Clone)]
pub(in super::super) struct Picture {
    pub(in super::super) texture: Texture,
    /// Texels that were written, by their first byte. Kept where somebody asks what drivers may have.
    pub(in super::super) stored: BTreeMap<usize, Stored>,
    /// Whether something may have been written that is not known where.
    pub(in super::super) spoiled: bool,
    /// What it is bound to.
    pub(in super::super) found: FoundImage,
}

/// What was stored in a texel.
#[derive(Debug, Clone, Copy)]
pub(in super::super) enum Stored {
    /// Numbers, of which so much is known, or integers, which are.
    Numbers([Known; 4]),
    /// Something that drivers may have otherwise.
    Anything,
}

impl Picture {
    pub(in super::super) fn new(texture: Texture, found: FoundImage) -> Self {
        Self { texture, stored: BTreeMap::new(), spoiled: false, found }
    }

    /// What drivers may find in the texel at a byte, or where there is none, if that is known at all.
    pub(super) fn found(&self, at: Option<usize>) -> Option<[Known; 4]> {
        let format = Texels::shape(&self.texture).format;
        let numbers = match at.and_then(|at| self.stored.get(&at)) {
            _ if self.spoiled => return None,
            Some(Stored::Anything) => return None,
            Some(Stored::Numbers(numbers)) => format.kept(*numbers),
            None => format.numbers(at.map_or(0, |at| self.texture.texel(at))),
        };
        Some(format.read(numbers))
    }

    /// What is known of a texel that may be stored to, or not.
    pub(super) fn perhaps(&self, at: usize, new: Stored) -> Stored {
        let old = match self.stored.get(&at) {
            Some(old) => *old,
            None => Stored::Numbers(Texels::shape(&self.texture).format.numbers(self.texture.texel(at))),
        };
        match (new, old) {
            (Stored::Numbers(new), Stored::Numbers(old)) => {
                Stored::Numbers(std::array::from_fn(|channel| new[channel].or(old[channel])))
            }
            (Stored::Numbers(_) | Stored::Anything, _) => Stored::Anything,
        }
    }
}

impl Texels for Picture {
    fn shape(&self) -> TextureShape {
        Texels::shape(&self.texture)
    }
    fn texel(&self, at: usize) -> u128 {
        self.texture.texel(at)
    }
}

impl TexelsMut for Picture {
    fn set_texel(&mut self, at: usize, texel: u128) {
        self.texture.set_texel(at, texel);
    }
}
