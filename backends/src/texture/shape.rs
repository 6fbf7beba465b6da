//! What a texture is, but for its texels.

use super::{Format, TextureError};
use std::fmt;

/// What kind of array of texels a shader sees.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// A line.
    D1,
    /// A picture.
    D2,
    /// Pictures.
    D2Array,
    /// A block.
    D3,
    /// The six faces of a cube: +x, -x, +y, -y, +z, -z.
    Cube,
    /// Cubes, six layers each.
    CubeArray,
}

/// A texture's shape, which says where its texels lie.
///
/// Level after level, level 0 first; in a level layer after layer, or slice after slice along depth; in a layer row
/// after row; in a row texel after texel; in a texel sample after sample, each in its format's own layout,
/// little-endian. Nothing lies in between.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct TextureShape {
    /// Of its texels.
    pub format: Format,
    /// How shaders see it.
    pub dimension: Dimension,
    /// Width, height and depth of level 0 in texels; each further level has half as many, rounded down, at least 1.
    pub size: [u32; 3],
    /// Pictures of an array, faces of cubes included.
    pub layers: u32,
    /// Levels.
    pub levels: u32,
    /// Samples of a texel: 1, or 4 if it is multisampled.
    pub samples: u32,
}

impl TextureShape {
    /// A shape of one level and as few layers as there can be.
    #[must_use]
    pub fn new(format: Format, dimension: Dimension, size: [u32; 3]) -> Self {
        let layers = match dimension {
            Dimension::Cube | Dimension::CubeArray => 6,
            Dimension::D1 | Dimension::D2 | Dimension::D2Array | Dimension::D3 => 1,
        };
        Self { format, dimension, size, layers, levels: 1, samples: 1 }
    }

    /// The same with so many layers.
    #[must_use]
    pub fn layered(self, layers: u32) -> Self {
        Self { layers, ..self }
    }

    /// The same with so many levels.
    #[must_use]
    pub fn levelled(self, levels: u32) -> Self {
        Self { levels, ..self }
    }

    /// Size of a level.
    #[must_use]
    pub fn level_size(&self, level: u32) -> [u32; 3] {
        self.size.map(|n| n.checked_shr(level).unwrap_or(0).max(1))
    }

    /// Bytes of all texels.
    #[must_use]
    pub fn bytes(&self) -> usize {
        (0..self.levels).fold(0, |sum: usize, level| sum.saturating_add(self.level_bytes(level)))
    }

    /// Bytes of a level.
    #[must_use]
    pub fn level_bytes(&self, level: u32) -> usize {
        let texels = self.level_size(level).into_iter().chain([self.layers, self.samples]);
        texels.fold(self.format.bytes(), |product, n| product.saturating_mul(n as usize))
    }

    /// The first byte of a texel, which must be in bounds; `at` is a place in a layer, or in a block.
    pub(crate) fn texel(&self, level: u32, layer: u32, at: [u32; 3], sample: u32) -> usize {
        let before: usize = (0..level).map(|level| self.level_bytes(level)).sum();
        let [width, height, depth] = self.level_size(level).map(|n| n as usize);
        let [x, y, z] = at.map(|n| n as usize);
        let texel = ((layer as usize * depth + z) * height + y) * width + x;
        before + (texel * self.samples as usize + sample as usize) * self.format.bytes()
    }

    /// Checks that there is such a texture, and that it has so many bytes.
    ///
    /// # Errors
    /// When there is none, or it has another number.
    pub fn check(&self, bytes: usize) -> Result<(), TextureError> {
        if let Some(reason) = self.fault() {
            return Err(TextureError::Shape { shape: self.to_string(), reason });
        }
        let (expected, found) = (self.bytes(), bytes);
        if expected != found {
            return Err(TextureError::Bytes { shape: self.to_string(), expected, found });
        }
        Ok(())
    }

    fn fault(&self) -> Option<&'static str> {
        let &Self { dimension, size: [width, height, depth], layers, levels, samples, .. } = self;
        let largest = match dimension {
            Dimension::D1 => width,
            Dimension::D2 | Dimension::D2Array | Dimension::Cube | Dimension::CubeArray => width.max(height),
            Dimension::D3 => width.max(height).max(depth),
        };
        let layered = match dimension {
            Dimension::D1 | Dimension::D2 | Dimension::D3 => layers == 1,
            Dimension::D2Array => layers > 0,
            Dimension::Cube => layers == 6,
            Dimension::CubeArray => layers > 0 && layers.is_multiple_of(6),
        };
        let cube = matches!(dimension, Dimension::Cube | Dimension::CubeArray);
        let flat = dimension != Dimension::D3;
        let tests = [
            (width == 0 || height == 0 || depth == 0, "its size must be at least 1 along each axis"),
            (dimension == Dimension::D1 && height > 1, "a line has height 1"),
            (flat && depth > 1, "only a 3d texture has a depth above 1"),
            (cube && width != height, "the faces of a cube are square"),
            (!layered, "only arrays have several layers, a cube has 6, an array of cubes 6 each"),
            (levels == 0, "it must have at least one level"),
            (
                levels > largest.checked_ilog2().unwrap_or(0) + 1,
                "it has more levels than its size can be halved",
            ),
            (samples != 1 && samples != 4, "a texel has 1 or 4 samples"),
            (
                samples != 1 && (levels != 1 || dimension != Dimension::D2),
                "with 4 samples it is 2d, of one level",
            ),
            (self.bytes() > isize::MAX as usize, "it is larger than memory can be"),
        ];
        tests.into_iter().find(|(wrong, _)| *wrong).map(|(_, reason)| reason)
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::D1 => "1d",
            Self::D2 => "2d",
            Self::D2Array => "2d_array",
            Self::D3 => "3d",
            Self::Cube => "cube",
            Self::CubeArray => "cube_array",
        })
    }
}

impl fmt::Display for TextureShape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [width, height, depth] = self.size;
        write!(f, "{} {} {width}x{height}x{depth}", self.format, self.dimension)?;
        for (count, one, what) in
            [(self.layers, 1, "layers"), (self.levels, 1, "levels"), (self.samples, 1, "samples")]
        {
            if count != one {
                write!(f, ", {count} {what}")?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texels_lie_level_after_level_without_gaps() {
        let shape =
            TextureShape::new(Format::Depth32Float, Dimension::D2Array, [5, 3, 1]).layered(2).levelled(3);
        let mut next = 0;
        for level in 0..3 {
            let [width, height, _] = shape.level_size(level);
            for layer in 0..2 {
                for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
                    assert_eq!(shape.texel(level, layer, [x, y, 0], 0), next);
                    next += 4;
                }
            }
        }
        assert_eq!(shape.bytes(), next);
    }

    #[test]
    fn impossible_shapes_say_why() {
        let flat = TextureShape::new(Format::Depth32Float, Dimension::D2, [8, 4, 1]);
        let cases = [
            (TextureShape { size: [0, 4, 1], ..flat }, "at least 1"),
            (TextureShape { size: [8, 4, 2], ..flat }, "depth above 1"),
            (flat.layered(2), "only arrays"),
            (flat.levelled(5), "more levels"),
            (TextureShape { samples: 2, ..flat }, "1 or 4 samples"),
            (TextureShape { dimension: Dimension::Cube, layers: 6, ..flat }, "square"),
        ];
        for (shape, part) in cases {
            let message = shape.check(shape.bytes()).expect_err("impossible").to_string();
            assert!(message.contains(part), "{message}");
        }
        assert_eq!(flat.levelled(4).check(4 * (32 + 8 + 2 + 1)), Ok(()));
        assert!(flat.check(3).is_err());
    }
}
