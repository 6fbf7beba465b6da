//! Texel formats: their names and where channels lie.

use super::TextureError;
use super::code::{Code, Coding, Field};
use naga::StorageFormat;
use naga::common::wgsl::ToWgsl;
use std::fmt;

/// How a texel is laid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// One of those that storage textures can have.
    Storage(StorageFormat),
    /// Four bytes, of which three are of the sRGB curve.
    Rgba8UnormSrgb,
    /// The same, blue first.
    Bgra8UnormSrgb,
    /// Depths of 16 bits.
    Depth16Unorm,
    /// Depths that are f32.
    Depth32Float,
}

/// What shaders get of a texel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Floats.
    Float,
    /// Depths: one float.
    Depth,
    /// Signed integers.
    Sint,
    /// Unsigned integers.
    Uint,
}

use StorageFormat as S;

/// All storage formats.
const STORAGE: [StorageFormat; 41] = [
    S::R8Unorm,
    S::R8Snorm,
    S::R8Uint,
    S::R8Sint,
    S::R16Uint,
    S::R16Sint,
    S::R16Float,
    S::Rg8Unorm,
    S::Rg8Snorm,
    S::Rg8Uint,
    S::Rg8Sint,
    S::R32Uint,
    S::R32Sint,
    S::R32Float,
    S::Rg16Uint,
    S::Rg16Sint,
    S::Rg16Float,
    S::Rgba8Unorm,
    S::Rgba8Snorm,
    S::Rgba8Uint,
    S::Rgba8Sint,
    S::Bgra8Unorm,
    S::Rgb10a2Uint,
    S::Rgb10a2Unorm,
    S::Rg11b10Ufloat,
    S::R64Uint,
    S::Rg32Uint,
    S::Rg32Sint,
    S::Rg32Float,
    S::Rgba16Uint,
    S::Rgba16Sint,
    S::Rgba16Float,
    S::Rgba32Uint,
    S::Rgba32Sint,
    S::Rgba32Float,
    S::R16Unorm,
    S::R16Snorm,
    S::Rg16Unorm,
    S::Rg16Snorm,
    S::Rgba16Unorm,
    S::Rgba16Snorm,
];

impl Format {
    /// All formats.
    pub fn all() -> impl Iterator<Item = Self> {
        let own = [Self::Rgba8UnormSrgb, Self::Bgra8UnormSrgb, Self::Depth16Unorm, Self::Depth32Float];
        STORAGE.iter().map(|f| Self::Storage(*f)).chain(own)
    }

    /// The format of this name, as WGSL and WebGPU spell it.
    ///
    /// # Errors
    /// When there is none.
    pub fn named(name: &str) -> Result<Self, TextureError> {
        let mut all = Self::all();
        all.find(|f| f.to_string() == name).ok_or_else(|| TextureError::Format(name.to_owned()))
    }

    /// Bytes of a texel.
    #[must_use]
    pub fn bytes(self) -> usize {
        self.fields().map(|field| field.code.bits as usize).sum::<usize>() / 8
    }

    /// What shaders get of it.
    #[must_use]
    pub fn kind(self) -> Kind {
        match self {
            Self::Depth16Unorm | Self::Depth32Float => Kind::Depth,
            Self::Rgba8UnormSrgb | Self::Bgra8UnormSrgb => Kind::Float,
            Self::Storage(format) => match naga::Scalar::from(format).kind {
                naga::ScalarKind::Sint => Kind::Sint,
                naga::ScalarKind::Uint => Kind::Uint,
                _ => Kind::Float,
            },
        }
    }

    /// Its channels, from the lowest bits on.
    pub(super) fn fields(self) -> impl Iterator<Item = Field> {
        let (channels, order) = self.channels();
        let mut shift = 0;
        channels.into_iter().flatten().zip(order).map(move |(code, channel)| {
            shift += code.bits;
            Field { channel, code, shift: shift - code.bits }
        })
    }

    /// The code of each channel, and which it is.
    fn channels(self) -> ([Option<Code>; 4], [usize; 4]) {
        const ORDER: [usize; 4] = [0, 1, 2, 3];
        const SWAPPED: [usize; 4] = [2, 1, 0, 3];
        let codes = |bits: [u32; 4], coding| bits.map(|bits| (bits > 0).then_some(Code { bits, coding }));
        let srgb = || {
            let [r, g, b, _] = codes([8; 4], Coding::Srgb);
            [r, g, b, Some(Code { bits: 8, coding: Coding::Unorm })]
        };
        match self {
            Self::Rgba8UnormSrgb => (srgb(), ORDER),
            Self::Bgra8UnormSrgb => (srgb(), SWAPPED),
            Self::Depth16Unorm => (codes([16, 0, 0, 0], Coding::Unorm), ORDER),
            Self::Depth32Float => (codes([32, 0, 0, 0], Coding::Float), ORDER),
            Self::Storage(S::Bgra8Unorm) => (codes([8; 4], Coding::Unorm), SWAPPED),
            Self::Storage(format) => {
                let (bits, coding) = storage(format);
                (codes(bits, coding), ORDER)
            }
        }
    }
}

/// Bits of each channel and their coding.
fn storage(format: StorageFormat) -> ([u32; 4], Coding) {
    let (bits, channels) = match format {
        S::R8Unorm | S::R8Snorm | S::R8Uint | S::R8Sint => (8, 1),
        S::R16Uint | S::R16Sint | S::R16Float | S::R16Unorm | S::R16Snorm => (16, 1),
        S::Rg8Unorm | S::Rg8Snorm | S::Rg8Uint | S::Rg8Sint => (8, 2),
        S::R32Uint | S::R32Sint | S::R32Float => (32, 1),
        S::Rg16Uint | S::Rg16Sint | S::Rg16Float | S::Rg16Unorm | S::Rg16Snorm => (16, 2),
        S::Rgba8Unorm | S::Rgba8Snorm | S::Rgba8Uint | S::Rgba8Sint | S::Bgra8Unorm => (8, 4),
        S::Rgb10a2Uint | S::Rgb10a2Unorm => (10, 3),
        S::Rg11b10Ufloat => (11, 2),
        S::R64Uint => (64, 1),
        S::Rg32Uint | S::Rg32Sint | S::Rg32Float => (32, 2),
        S::Rgba16Uint | S::Rgba16Sint | S::Rgba16Float | S::Rgba16Unorm | S::Rgba16Snorm => (16, 4),
        S::Rgba32Uint | S::Rgba32Sint | S::Rgba32Float => (32, 4),
    };
    let last = match format {
        S::Rgb10a2Uint | S::Rgb10a2Unorm => [10, 10, 10, 2],
        S::Rg11b10Ufloat => [11, 11, 10, 0],
        _ => std::array::from_fn(|at| if at < channels { bits } else { 0 }),
    };
    (last, coding(format))
}

fn coding(format: StorageFormat) -> Coding {
    match format {
        S::R8Unorm
        | S::Rg8Unorm
        | S::Rgba8Unorm
        | S::Bgra8Unorm
        | S::Rgb10a2Unorm
        | S::R16Unorm
        | S::Rg16Unorm
        | S::Rgba16Unorm => Coding::Unorm,
        S::R8Snorm | S::Rg8Snorm | S::Rgba8Snorm | S::R16Snorm | S::Rg16Snorm | S::Rgba16Snorm => {
            Coding::Snorm
        }
        S::R8Uint
        | S::R16Uint
        | S::Rg8Uint
        | S::R32Uint
        | S::Rg16Uint
        | S::Rgba8Uint
        | S::Rgb10a2Uint
        | S::R64Uint
        | S::Rg32Uint
        | S::Rgba16Uint
        | S::Rgba32Uint => Coding::Uint,
        S::R8Sint
        | S::R16Sint
        | S::Rg8Sint
        | S::R32Sint
        | S::Rg16Sint
        | S::Rgba8Sint
        | S::Rg32Sint
        | S::Rgba16Sint
        | S::Rgba32Sint => Coding::Sint,
        S::R16Float
        | S::R32Float
        | S::Rg16Float
        | S::Rg11b10Ufloat
        | S::Rg32Float
        | S::Rgba16Float
        | S::Rgba32Float => Coding::Float,
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Storage(format) => format.to_wgsl(),
            Self::Rgba8UnormSrgb => "rgba8unorm-srgb",
            Self::Bgra8UnormSrgb => "bgra8unorm-srgb",
            Self::Depth16Unorm => "depth16unorm",
            Self::Depth32Float => "depth32float",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_one_formats_own() {
        for format in Format::all() {
            assert_eq!(Format::named(&format.to_string()), Ok(format));
            assert!(matches!(format.bytes(), 1 | 2 | 4 | 8 | 16), "{format}: {} bytes", format.bytes());
        }
        assert!(Format::named("rgba8").is_err());
    }
}
