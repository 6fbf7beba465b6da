//! Texels by their numbers.

use super::{Texels, TexelsMut};
use crate::texture::TextureShape;

/// A texel's number: along each axis, layer, level and sample, of whatever sign.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct At {
    pub(crate) place: [i64; 3],
    pub(crate) layer: i64,
    pub(crate) level: i64,
    pub(crate) sample: i64,
}

impl std::fmt::Display for At {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { place: [x, y, z], layer, level, sample } = self;
        write!(f, "texel {x},{y},{z} of layer {layer}, level {level}, sample {sample}")
    }
}

/// The first byte of a texel; `None` out of bounds.
pub(crate) fn inside(shape: TextureShape, at: At) -> Option<usize> {
    let number = |n: i64, count: u32| u32::try_from(n).ok().filter(|n| *n < count);
    let level = number(at.level, shape.levels)?;
    let size = shape.level_size(level);
    let mut place = [0; 3];
    for axis in 0..3 {
        place[axis] = number(at.place[axis], size[axis])?;
    }
    let (layer, sample) = (number(at.layer, shape.layers)?, number(at.sample, shape.samples)?);
    Some(shape.texel(level, layer, place, sample))
}

/// The four numbers of a texel, as bits; out of bounds those of a texel of zeros: an alpha that the format lacks is 1.
pub(crate) fn load(texels: &impl Texels, at: At) -> [u64; 4] {
    let texel = inside(texels.shape(), at).map_or(0, |place| texels.texel(place));
    texels.shape().format.decode(texel)
}

/// Replaces a texel; out of bounds nothing happens.
pub(crate) fn store(texels: &mut impl TexelsMut, at: At, numbers: [u64; 4]) {
    if let Some(place) = inside(texels.shape(), at) {
        let texel = texels.shape().format.encode(numbers);
        texels.set_texel(place, texel);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::{Dimension, Format, Texture};
    use naga::StorageFormat;

    #[test]
    fn out_of_bounds_loads_are_zero_and_stores_do_nothing() {
        let format = Format::Storage(StorageFormat::Rgba8Uint);
        let shape = TextureShape::new(format, Dimension::D2Array, [4, 2, 1]).layered(3).levelled(2);
        let mut texture = Texture::new(shape, vec![7; shape.bytes()]).expect("a texture");
        let inside = At { place: [3, 1, 0], layer: 2, level: 0, sample: 0 };
        assert_eq!(load(&texture, inside), [7; 4]);
        store(&mut texture, inside, [1, 2, 3, 4]);
        assert_eq!(load(&texture, inside), [1, 2, 3, 4]);
        let before = texture.clone();
        let outside = [
            At { place: [4, 1, 0], ..inside },
            At { place: [-1, 1, 0], ..inside },
            At { place: [3, 1, 1], ..inside },
            At { layer: 3, ..inside },
            At { level: 1, ..inside },
            At { level: -1, ..inside },
            At { sample: 1, ..inside },
        ];
        for at in outside {
            store(&mut texture, at, [9; 4]);
            assert_eq!(load(&texture, at), [0; 4], "{at:?}");
        }
        assert_eq!(texture, before);
    }
}
