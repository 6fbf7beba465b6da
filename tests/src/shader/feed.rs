//! What resources hold when the shader starts.

use super::edges;
use super::given::Given;
use super::json;
use super::number;
use super::resource::{Resource, What};
use super::shape::Shape;
use super::texture::{self, SamplerWords, Sketch};
use crate::domain::Rng;
use lobe_backends::gpu::BindingKind;
use lobe_backends::texture::TextureShape;
use naga::{Scalar, ScalarKind};
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Largest buffer.
pub const LARGEST: usize = 1 << 30;

/// Largest buffer whose length nobody stated.
const UNSTATED: usize = 1 << 26;

/// Fewest elements of a buffer whose length nobody stated.
const FEWEST: u64 = 64;

/// Where the bytes come from.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Feed {
    /// All zero.
    Zeros,
    /// Drawn: floats uniform in -1..1, unsigned integers in 0..64, signed ones in -32..32; atomics are 0; texels that
    /// are no floats are any bits.
    Random(u64),
    /// Drawn: floats on the edges of their type, as zeros of both signs, subnormals, neighbours of 1, and small and large
    /// numbers, beside ordinary ones; integers and texels as [`Feed::Random`] draws them.
    Edges(u64),
    /// These words, little-endian.
    Words(Vec<u32>),
    /// A file: JSON that follows the type of a buffer (`.json`), or else the bytes or texels themselves.
    File(PathBuf),
}

impl FromStr for Feed {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once(':') {
            _ if text == "zeros" => Ok(Self::Zeros),
            Some((kind @ ("random" | "edges"), seed)) => match seed.parse() {
                Ok(seed) if kind == "edges" => Ok(Self::Edges(seed)),
                Ok(seed) => Ok(Self::Random(seed)),
                Err(_) => Err(format!("`{seed}` is no seed; write {kind}:7")),
            },
            Some(("words", words)) => words.split(',').map(word).collect::<Result<_, _>>().map(Self::Words),
            _ if text == "random" || text == "edges" => Err(format!("{text} needs a seed; write {text}:7")),
            _ if text.is_empty() => {
                Err("a file, zeros, random:SEED, edges:SEED or words:WORD,.. is wanted".to_owned())
            }
            _ => Ok(Self::File(PathBuf::from(text))),
        }
    }
}

impl std::fmt::Display for Feed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Zeros => f.write_str("zeros"),
            Self::Random(seed) => write!(f, "random:{seed}"),
            Self::Edges(seed) => write!(f, "edges:{seed}"),
            Self::Words(words) => {
                let words: Vec<String> = words.iter().map(|word| format!("{word:#x}")).collect();
                write!(f, "words:{}", words.join(","))
            }
            Self::File(path) => write!(f, "{}", path.display()),
        }
    }
}

/// A word, in decimal or hexadecimal.
fn word(text: &str) -> Result<u32, String> {
    let parsed = match text.strip_prefix("0x") {
        Some(digits) => u32::from_str_radix(digits, 16),
        None => text.parse(),
    };
    parsed.map_err(|_| format!("`{text}` is no word of 32 bits; write 12 or 0xc"))
}

/// What is said of a resource.
#[derive(Debug, Clone, Copy)]
pub struct Said<'s> {
    /// Where its bytes come from.
    pub feed: &'s Feed,
    /// Bytes of a buffer.
    pub size: Option<usize>,
    /// Shape of a texture.
    pub texture: Option<&'s Sketch>,
    /// Words for a sampler.
    pub sampler: Option<&'s SamplerWords>,
}

/// What `resource` is given.
///
/// A buffer has the stated size, else that of the file, else as many elements as there are invocations, and at least
/// 64; a texture without a word has 16 texels along each side, all its levels, and 4 pictures in an array.
///
/// # Errors
/// When the file cannot be read or does not follow the type, or the size does not fit.
pub fn fill(resource: &Resource, said: Said<'_>, invocations: u64) -> Result<Given, String> {
    let &Resource { ref name, group, binding, element, .. } = resource;
    let given = |kind, data, shape, is_coded| {
        Ok(Given { name: name.clone(), group, binding, element, kind, data, shape, is_coded })
    };
    match &resource.what {
        What::Sampler { is_comparison } => {
            let sampler = texture::sampler(said.sampler, *is_comparison);
            given(BindingKind::Sampler(sampler), Vec::new(), Shape::Struct(Vec::new()), false)
        }
        What::Texture { dimension, is_arrayed, class } => {
            let kind = texture::kind(said.texture, *dimension, *is_arrayed, *class);
            let (BindingKind::Texture(shape) | BindingKind::StorageTexture(shape, _)) = kind else {
                return Err(format!("`{name}` is no texture"));
            };
            let data = texels(resource, shape, said.feed)?;
            let (channels, is_coded) = texture::channels(shape);
            given(kind, data, channels, is_coded)
        }
        What::Buffer { kind, shape, least } => {
            let data = bytes(resource, shape, *least, said, invocations)?;
            given(*kind, data, shape.clone(), false)
        }
    }
}

fn texels(resource: &Resource, shape: TextureShape, feed: &Feed) -> Result<Vec<u8>, String> {
    let name = &resource.title();
    let size = checked(name, shape.bytes())?;
    let data = match feed {
        Feed::Zeros => vec![0; size],
        Feed::Random(seed) | Feed::Edges(seed) => {
            texture::drawn(shape, &mut Rng::new(*seed, &resource.place()))
        }
        Feed::Words(words) => bytes_of(words),
        Feed::File(path) => {
            std::fs::read(path).map_err(|e| format!("{}: cannot be read: {e}", path.display()))?
        }
    };
    shape.check(data.len()).map_err(|e| format!("`{name}`: {e}"))?;
    Ok(data)
}

fn bytes(
    resource: &Resource,
    shape: &Shape,
    least: usize,
    said: Said<'_>,
    invocations: u64,
) -> Result<Vec<u8>, String> {
    let (name, size) = (&resource.title(), said.size);
    let mut bytes = match said.feed {
        Feed::File(path) => read(name, shape, least, path)?,
        Feed::Words(words) => bytes_of(words),
        Feed::Zeros | Feed::Random(_) | Feed::Edges(_) => {
            vec![0; checked(name, size.unwrap_or_else(|| usual(shape, least, invocations)))?]
        }
    };
    let size = checked(name, size.unwrap_or(bytes.len()))?;
    if size < least || size % 4 != 0 {
        return Err(format!("`{name}` needs {least} bytes or more, a multiple of 4; it has {size}"));
    }
    if bytes.len() > size {
        return Err(format!("`{name}`: the {} bytes given are more than the size of {size}", bytes.len()));
    }
    bytes.resize(size, 0);
    match said.feed {
        Feed::Random(seed) => draw(shape, &mut Rng::new(*seed, &resource.place()), &mut bytes, number),
        Feed::Edges(seed) => draw(shape, &mut Rng::new(*seed, &resource.place()), &mut bytes, edges::number),
        Feed::Zeros | Feed::Words(_) | Feed::File(_) => {}
    }
    Ok(bytes)
}

fn bytes_of(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

fn checked(name: &str, size: usize) -> Result<usize, String> {
    if size <= LARGEST {
        return Ok(size);
    }
    Err(format!("`{name}` would have {size} bytes, more than the {LARGEST} that a buffer may have"))
}

/// An element for each invocation, and [`FEWEST`] at least, if the buffer says how many it has.
fn usual(shape: &Shape, least: usize, invocations: u64) -> usize {
    let Some((offset, stride)) = shape.tail() else { return least };
    let stride = u64::from(stride.max(1));
    let elements = invocations.max(FEWEST).min(UNSTATED as u64 / stride).max(1);
    let size = u64::from(offset) + elements * stride;
    least.max((size as usize).next_multiple_of(4))
}

fn read(name: &str, shape: &Shape, least: usize, path: &Path) -> Result<Vec<u8>, String> {
    let told = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let bytes = std::fs::read(path).map_err(|e| told(&format!("cannot be read: {e}")))?;
    if path.extension().is_none_or(|e| e != "json") {
        return Ok(bytes);
    }
    let value = serde_json::from_slice(&bytes).map_err(|e| told(&e))?;
    json::bytes(name, shape, least, &value).map_err(|e| told(&e))
}

fn draw(shape: &Shape, rng: &mut Rng, bytes: &mut [u8], number: fn(Scalar, &mut Rng) -> Vec<u8>) {
    let end = bytes.len();
    shape.visit(end, &mut |at, scalar, is_atomic| {
        if !is_atomic {
            let drawn = number(scalar, rng);
            bytes[at..at + drawn.len()].copy_from_slice(&drawn);
        }
    });
}

/// An ordinary number.
pub(super) fn number(scalar: Scalar, rng: &mut Rng) -> Vec<u8> {
    match scalar.kind {
        ScalarKind::Float => number::float_bytes(scalar.width, rng.range(-1.0, 1.0)),
        ScalarKind::Sint => (rng.below(64) as i64 - 32).to_le_bytes()[..usize::from(scalar.width)].to_vec(),
        _ => (rng.below(64) as u64).to_le_bytes()[..usize::from(scalar.width)].to_vec(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn feeds_are_spelt_as_they_print() {
        for text in ["zeros", "random:7", "edges:7", "words:0x1,0xffffffff", "data.bin", "a/b.json"] {
            assert_eq!(text.parse::<Feed>().map(|f| f.to_string()), Ok(text.to_owned()));
        }
        let broken = [
            "random",
            "random:",
            "random:x",
            "edges",
            "edges:-1",
            "words:",
            "words:0x1ffffffff",
            "words:1.5",
            "",
        ];
        for text in broken {
            assert!(text.parse::<Feed>().is_err(), "{text}");
        }
    }
}
