//! Textures and samplers, as a user spells them and as they are without a word.

use super::shape::Shape;
use crate::domain::Rng;
use lobe_backends::gpu::{Access, BindingKind};
use lobe_backends::texture::{Address, Compare, Dimension, Filter, Format, Kind, Sampler, TextureShape};
use naga::{ImageClass, ImageDimension, Scalar, ScalarKind, StorageAccess};

/// Texels along each side of a texture of which nothing is said.
const SIDE: u32 = 16;

/// Pictures, or cubes, of an array of which nothing is said.
const PICTURES: u32 = 4;

/// Samples of a texel in multisampled textures: what every driver has.
const SAMPLES: u32 = 4;

/// A texture's shape but for what its variable says: `FORMAT:WxHxD[:LAYERS[:LEVELS]]`.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Sketch {
    text: String,
    format: Format,
    size: [u32; 3],
    layers: u32,
    levels: u32,
}

impl std::str::FromStr for Sketch {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wanted = || format!("`{text}` is not FORMAT:WxHxD[:LAYERS[:LEVELS]], as rgba8unorm:16x16x1");
        let mut parts = text.split(':');
        let format = Format::named(parts.next().unwrap_or_default()).map_err(|e| e.to_string())?;
        let size = parts.next().unwrap_or_default().split('x').map(|n| n.parse().ok());
        let size: Option<Vec<u32>> = size.collect();
        let size = size.and_then(|s| s.try_into().ok()).ok_or_else(wanted)?;
        let mut number = || parts.next().map_or(Ok(1), |n| n.parse().map_err(|_| wanted()));
        Ok(Self { text: text.to_owned(), format, size, layers: number()?, levels: number()? })
    }
}

impl Sketch {
    fn shape(&self, dimension: Dimension) -> TextureShape {
        let shape = TextureShape::new(self.format, dimension, self.size).levelled(self.levels);
        shape.layered(shape.layers.max(self.layers))
    }
}

impl TryFrom<String> for Sketch {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}

impl From<Sketch> for String {
    fn from(sketch: Sketch) -> Self {
        sketch.text
    }
}

/// A sampler in words: `linear`, `mip-linear`, `repeat`, `mirror`, `less`, .., `lod:LOW:HIGH`, with commas between.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct SamplerWords {
    text: String,
    sampler: Sampler,
}

const COMPARISONS: [(&str, Compare); 8] = [
    ("never", Compare::Never),
    ("less", Compare::Less),
    ("equal", Compare::Equal),
    ("less-equal", Compare::LessEqual),
    ("greater", Compare::Greater),
    ("not-equal", Compare::NotEqual),
    ("greater-equal", Compare::GreaterEqual),
    ("always", Compare::Always),
];

impl std::str::FromStr for SamplerWords {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut sampler = Sampler::default();
        for word in text.split(',') {
            let comparison = COMPARISONS.iter().find(|(name, _)| *name == word);
            match (word, comparison) {
                (_, Some((_, compare))) => sampler.compare = Some(*compare),
                ("nearest", _) => {}
                ("linear", _) => (sampler.magnify, sampler.minify) = (Filter::Linear, Filter::Linear),
                ("mip-linear", _) => sampler.mip = Filter::Linear,
                ("repeat", _) => sampler.address = [Address::Repeat; 3],
                ("mirror", _) => sampler.address = [Address::MirrorRepeat; 3],
                _ => sampler.lod = lod(word).ok_or_else(|| format!("`{word}` says nothing of a sampler"))?,
            }
        }
        Ok(Self { text: text.to_owned(), sampler })
    }
}

fn lod(word: &str) -> Option<[f32; 2]> {
    let (low, high) = word.strip_prefix("lod:")?.split_once(':')?;
    let range: [f32; 2] = [low.parse().ok()?, high.parse().ok()?];
    (0.0 <= range[0] && range[0] <= range[1]).then_some(range)
}

impl TryFrom<String> for SamplerWords {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}

impl From<SamplerWords> for String {
    fn from(words: SamplerWords) -> Self {
        words.text
    }
}

/// A sampler as its words say; without words the nearest texel, and `less-equal` where it compares.
#[must_use]
pub fn sampler(words: Option<&SamplerWords>, is_comparison: bool) -> Sampler {
    let sampler = words.map_or_else(Sampler::default, |w| w.sampler);
    let compare = is_comparison.then(|| sampler.compare.unwrap_or(Compare::LessEqual));
    Sampler { compare, ..sampler }
}

/// The shape of a texture and what the shader does with it; without a sketch [`SIDE`] texels along each side,
/// [`PICTURES`] in an array, and all the levels that there can be.
#[must_use]
pub fn kind(
    sketch: Option<&Sketch>,
    dim: ImageDimension,
    is_arrayed: bool,
    class: ImageClass,
) -> BindingKind {
    let dimension = match (dim, is_arrayed) {
        (ImageDimension::D1, _) => Dimension::D1,
        (ImageDimension::D2, false) => Dimension::D2,
        (ImageDimension::D2, true) => Dimension::D2Array,
        (ImageDimension::D3, _) => Dimension::D3,
        (ImageDimension::Cube, false) => Dimension::Cube,
        (ImageDimension::Cube, true) => Dimension::CubeArray,
    };
    let is_multisampled =
        matches!(class, ImageClass::Sampled { multi: true, .. } | ImageClass::Depth { multi: true });
    let shape = sketch.map_or_else(|| usual_shape(dimension, class, is_multisampled), |s| s.shape(dimension));
    let shape = TextureShape { samples: if is_multisampled { SAMPLES } else { 1 }, ..shape };
    match class {
        ImageClass::Storage { access, .. } => BindingKind::StorageTexture(shape, self::access(access)),
        ImageClass::Sampled { .. } | ImageClass::Depth { .. } | ImageClass::External => {
            BindingKind::Texture(shape)
        }
    }
}

fn usual_shape(dimension: Dimension, class: ImageClass, is_multisampled: bool) -> TextureShape {
    let shape = TextureShape::new(usual_format(class), dimension, usual_size(dimension));
    let is_array = matches!(dimension, Dimension::D2Array | Dimension::CubeArray);
    let has_levels =
        dimension != Dimension::D1 && !is_multisampled && !matches!(class, ImageClass::Storage { .. });
    let shape = shape.layered(if is_array { shape.layers * PICTURES } else { shape.layers });
    shape.levelled(if has_levels { SIDE.ilog2() + 1 } else { 1 })
}

fn usual_format(class: ImageClass) -> Format {
    use naga::StorageFormat::{Rgba8Sint, Rgba8Uint, Rgba8Unorm};
    match class {
        ImageClass::Storage { format, .. } => Format::Storage(format),
        ImageClass::Depth { .. } => Format::Depth32Float,
        ImageClass::Sampled { kind: ScalarKind::Sint, .. } => Format::Storage(Rgba8Sint),
        ImageClass::Sampled { kind: ScalarKind::Uint, .. } => Format::Storage(Rgba8Uint),
        ImageClass::Sampled { .. } | ImageClass::External => Format::Storage(Rgba8Unorm),
    }
}

fn usual_size(dimension: Dimension) -> [u32; 3] {
    match dimension {
        Dimension::D1 => [SIDE, 1, 1],
        Dimension::D2 | Dimension::D2Array | Dimension::Cube | Dimension::CubeArray => [SIDE, SIDE, 1],
        Dimension::D3 => [SIDE; 3],
    }
}

fn access(access: StorageAccess) -> Access {
    let (load, store) = (access.contains(StorageAccess::LOAD), access.contains(StorageAccess::STORE));
    match (load, store) {
        _ if access.contains(StorageAccess::ATOMIC) => Access::Atomic,
        (true, true) => Access::ReadWrite,
        (false, true) => Access::Write,
        (_, false) => Access::Read,
    }
}

/// Texels by chance: any codes, but of floats numbers from -1 to 1, of depths from 0. What is multisampled can only begin as zeros.
#[must_use]
pub fn drawn(shape: TextureShape, rng: &mut Rng) -> Vec<u8> {
    let size = shape.format.bytes();
    if shape.samples > 1 || size == 0 {
        return vec![0; shape.bytes()];
    }
    let is_float = shape.format.to_string().ends_with("float");
    let is_depth = shape.format.kind() == Kind::Depth;
    let mut texel = || match is_float {
        true if is_depth => u128::from((rng.range(0.0, 1.0) as f32).to_bits()),
        true => shape.format.encode([(); 4].map(|()| (rng.range(-1.0, 1.0) as f32).to_bits().into())),
        false => u128::from(rng.bits()) << 64 | u128::from(rng.bits()),
    };
    (0..shape.bytes() / size).flat_map(|_| texel().to_le_bytes().into_iter().take(size)).collect()
}

/// The channels of all texels of a level, and whether they are codes of numbers.
#[must_use]
pub fn channels(shape: TextureShape) -> (Shape, bool) {
    let (name, bytes) = (shape.format.to_string(), shape.format.bytes());
    let letters = name.chars().take_while(char::is_ascii_alphabetic).filter(|c| "rgba".contains(*c)).count();
    // Channels of one width lie side by side; others are taken as one number.
    let is_packed = name.starts_with("rgb10") || name.starts_with("rg11");
    let is_even = [1, 2, 4].contains(&letters) && bytes.is_multiple_of(letters) && !is_packed;
    let count = if is_even { letters } else { 1 };
    let width = bytes / count;
    let kind = match shape.format.kind() {
        Kind::Sint => ScalarKind::Sint,
        Kind::Float | Kind::Depth if name.ends_with("float") && width >= 2 && is_even => ScalarKind::Float,
        Kind::Float | Kind::Depth | Kind::Uint => ScalarKind::Uint,
    };
    let is_coded = kind == ScalarKind::Uint && shape.format.kind() != Kind::Uint;
    let scalar = Scalar { kind, width: width as u8 };
    let list = |part: Shape, count: u32, stride: usize, is_vector| Shape::List {
        part: Box::new(part),
        count: Some(count),
        stride: stride as u32,
        is_vector,
    };
    let one = Shape::Scalar { scalar, is_atomic: false };
    let texel = if count > 1 { list(one, count as u32, width, true) } else { one };
    let [w, h, d] = shape.size;
    let (row, page) = (bytes * w as usize, bytes * w as usize * h as usize);
    (list(list(list(texel, w, bytes, false), h, row, false), d * shape.layers, page, false), is_coded)
}

/// Whether the numbers of the texel around byte `at` are no further apart than `bound`, channel by channel.
///
/// Coded numbers only: codes that are integers are none.
#[must_use]
pub fn is_near(format: Format, at: usize, [ours, theirs]: [&[u8]; 2], bound: f64) -> bool {
    let begin = at - at % format.bytes();
    let numbers = |bytes: &[u8]| {
        let texel = bytes.iter().skip(begin).take(format.bytes()).rev();
        let numbers = format.decode(texel.fold(0, |texel, byte| texel << 8 | u128::from(*byte)));
        numbers.map(|bits| f64::from(f32::from_bits(bits as u32)))
    };
    let (ours, theirs) = (numbers(ours), numbers(theirs));
    let is_near = |a: f64, b: f64| a == b || a.is_nan() && b.is_nan() || (a - b).abs() <= bound;
    ours.into_iter().zip(theirs).all(|(a, b)| is_near(a, b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn textures_and_samplers_are_spelt_as_they_travel() {
        for text in ["rgba8unorm:16x16x1", "r32float:4x4x4", "depth32float:8x8x1:6:4"] {
            assert_eq!(text.parse::<Sketch>().map(String::from), Ok(text.to_owned()));
        }
        for text in ["", "rgba8unorm", "rgba8unorm:16", "nix:1x1x1", "r8unorm:1x1x1:x"] {
            assert!(text.parse::<Sketch>().is_err(), "{text}");
        }
        for text in ["linear,repeat", "nearest", "linear,less", "lod:0:2"] {
            assert_eq!(text.parse::<SamplerWords>().map(String::from), Ok(text.to_owned()));
        }
        for text in ["", "cubic", "lod:2:1"] {
            assert!(text.parse::<SamplerWords>().is_err(), "{text}");
        }
    }

    #[test]
    fn packed_texels_are_near_if_each_channel_is() {
        let format = Format::named("rg11b10ufloat").unwrap();
        let texel = |numbers: [f32; 3]| {
            let [r, g, b] = numbers.map(|x| u64::from(x.to_bits()));
            [vec![0; 4], format.encode([r, g, b, 0]).to_le_bytes()[..4].to_vec()].concat()
        };
        let ours = texel([1.0, 0.5, 0.25]);
        for (theirs, bound, expected) in [
            ([1.0, 0.5, 0.25], 0.0, true),
            ([1.015625, 0.5, 0.25], 0.02, true),
            ([1.015625, 0.5, 0.25], 0.01, false),
            ([1.0, 0.5, 0.3125], 0.02, false),
        ] {
            assert_eq!(is_near(format, 6, [&ours, &texel(theirs)], bound), expected, "{theirs:?} {bound}");
        }
    }

    #[test]
    fn every_format_has_channels_that_fill_its_texels() {
        for format in Format::all() {
            let shape = TextureShape::new(format, Dimension::D2, [3, 2, 1]);
            let (channels, _) = channels(shape);
            let (mut count, mut bytes) = (0, 0);
            channels.visit(shape.bytes(), &mut |at, scalar, _| {
                assert_eq!(at, bytes, "{format}");
                bytes += usize::from(scalar.width);
                count += 1;
            });
            assert_eq!((bytes, count % 6), (shape.bytes(), 0), "{format}");
        }
    }
}
