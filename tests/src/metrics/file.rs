//! Pictures out of files.

use super::Image;
use ::exr::prelude::{AnyChannel, AnyChannels, FlatSamples, Layer, ReadChannels, ReadLayers, read};
use lobe_codegen::glam::Vec3;
use std::collections::BTreeMap;
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// What the values of a file mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// What a screen shows: PNG.
    Low,
    /// Radiance: EXR.
    High,
}

/// A picture and where it is from.
#[derive(Debug, Clone, PartialEq)]
pub struct Opened {
    /// The picture, linear RGB.
    pub image: Image,
    /// What its values mean.
    pub range: Range,
}

/// Why a file is no picture to be compared.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// Its name ends otherwise.
    #[error("{}: pictures are read from .exr and .png; name one of them", path.display())]
    Ending {
        /// The file.
        path: PathBuf,
    },
    /// It is not there, or not to be read.
    #[error("{}: cannot be read: {cause}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: std::io::Error,
    },
    /// It is no EXR file.
    #[error("{}: it is no EXR file: {cause}", path.display())]
    Exr {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: ::exr::error::Error,
    },
    /// It is no PNG file.
    #[error("{}: it is no PNG file: {cause}", path.display())]
    Png {
        /// The file.
        path: PathBuf,
        /// Why.
        cause: ::png::DecodingError,
    },
    /// The layer is not in the EXR file.
    #[error("{}: there is no layer {}; there are: {}", path.display(), quoted(wanted), listed(known))]
    Layer {
        /// The file.
        path: PathBuf,
        /// The name that was asked for; empty for that of no name.
        wanted: String,
        /// Those that have red, green and blue.
        known: Vec<String>,
    },
    /// A layer of a PNG file is asked for.
    #[error("{}: a PNG file has no layers; leave --layer out, or give an EXR file", path.display())]
    NoLayers {
        /// The file.
        path: PathBuf,
    },
    /// The PNG file is not opaque.
    #[error("{}: its pixel at column {x}, row {y} is not opaque; put it before a background first", path.display())]
    Transparent {
        /// The file.
        path: PathBuf,
        /// Column of the first such pixel, from the left.
        x: u32,
        /// Row, from the top.
        y: u32,
    },
}

fn quoted(name: &str) -> String {
    if name.is_empty() { "without a name (channels R, G, B)".to_owned() } else { format!("`{name}`") }
}

fn listed(names: &[String]) -> String {
    match names {
        [] => "none that has R, G and B".to_owned(),
        names => names.iter().map(|name| quoted(name)).collect::<Vec<_>>().join(", "),
    }
}

/// The picture in the file: of an EXR file the layer without a name, or `layer`; of a PNG file the linear values of its sRGB.
///
/// # Errors
/// When there is no such file, when it is none of its form, or when it has no such layer.
pub fn open(path: &Path, layer: Option<&str>) -> Result<Opened, ReadError> {
    let path = path.to_owned();
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let read = match (ending.as_deref(), layer) {
        (Some("exr"), _) => exr,
        (Some("png"), None) => png,
        (Some("png"), Some(_)) => return Err(ReadError::NoLayers { path }),
        _ => return Err(ReadError::Ending { path }),
    };
    match std::fs::read(&path) {
        Ok(bytes) => read(bytes, path, layer.unwrap_or_default()),
        Err(cause) => Err(ReadError::File { path, cause }),
    }
}

/// Red, green and blue of a layer, as they are found.
#[derive(Default)]
struct Found<'a>([Option<(&'a FlatSamples, [u32; 2])>; 3]);

fn exr(bytes: Vec<u8>, path: PathBuf, wanted: &str) -> Result<Opened, ReadError> {
    if let Err(cause) = check_claims(&bytes) {
        return Err(ReadError::Exr { path, cause });
    }
    let reader =
        read().no_deep_data().largest_resolution_level().all_channels().all_layers().all_attributes();
    let file = match reader.from_buffered(Cursor::new(bytes)) {
        Ok(file) => file,
        Err(cause) => return Err(ReadError::Exr { path, cause }),
    };
    let mut layers: BTreeMap<String, Found<'_>> = BTreeMap::new();
    for part in &file.layer_data {
        let size = [part.size.width() as u32, part.size.height() as u32];
        for channel in &part.channel_data.list {
            let (layer, colour) = named(part, channel);
            if let Some(at) = ["R", "G", "B"].iter().position(|name| *name == colour) {
                layers.entry(layer).or_default().0[at] = Some((&channel.sample_data, size));
            }
        }
    }
    let whole = |found: &Found<'_>| match found.0 {
        [Some((r, size)), Some((g, other)), Some((b, last))] if size == other && size == last => {
            let pixels = r.values_as_f32().zip(g.values_as_f32()).zip(b.values_as_f32());
            Some(Image { size, pixels: pixels.map(|((r, g), b)| Vec3::new(r, g, b)).collect() })
        }
        _ => None,
    };
    match layers.get(wanted).and_then(whole) {
        Some(image) => Ok(Opened { image, range: Range::High }),
        None => {
            let known = layers.iter().filter(|(_, found)| found.0.iter().all(Option::is_some));
            let known = known.map(|(name, _)| name.clone()).collect();
            Err(ReadError::Layer { path, wanted: wanted.to_owned(), known })
        }
    }
}

/// Whether the bytes can hold what their header claims, before room is made for it.
fn check_claims(bytes: &[u8]) -> ::exr::error::UnitResult {
    let meta = ::exr::meta::MetaData::read_from_buffered(Cursor::new(bytes), false)?;
    let claimed = meta.headers.iter().map(|header| {
        let pixels = (header.layer_size.width() as u64).saturating_mul(header.layer_size.height() as u64);
        pixels.saturating_mul(header.channels.bytes_per_pixel as u64)
    });
    let claimed = claimed.fold(0, u64::saturating_add);
    match claimed <= MOST_TIMES * bytes.len() as u64 {
        true => Ok(()),
        false => {
            let all = bytes.len();
            let why = format!("it claims {claimed} bytes of pixels, more than its {all} bytes can hold");
            Err(::exr::error::Error::Invalid(why.into()))
        }
    }
}

/// The layer that a channel is of, and its own name there; a part's name is a layer's too.
fn named(part: &Layer<AnyChannels<FlatSamples>>, channel: &AnyChannel<FlatSamples>) -> (String, String) {
    let part = part.attributes.layer_name.as_ref().map(ToString::to_string).unwrap_or_default();
    let name = channel.name.to_string();
    let (layer, colour) = name.rsplit_once('.').unwrap_or(("", &name));
    let layer = match (part.as_str(), layer) {
        (part, "") => part.to_owned(),
        ("", layer) => layer.to_owned(),
        (part, layer) if layer == part || layer.starts_with(&format!("{part}.")) => layer.to_owned(),
        (part, layer) => format!("{part}.{layer}"),
    };
    (layer, colour.to_owned())
}

fn png(bytes: Vec<u8>, path: PathBuf, _: &str) -> Result<Opened, ReadError> {
    match samples(bytes) {
        Ok((size, pixels)) => match pixels.iter().position(|[.., alpha]| *alpha < 1.0) {
            Some(at) => {
                let [x, y] = [at as u32 % size[0], at as u32 / size[0]];
                Err(ReadError::Transparent { path, x, y })
            }
            None => {
                let linear = |[r, g, b, _]: &[f32; 4]| Vec3::new(*r, *g, *b).map(decoded);
                let image = Image { size, pixels: pixels.iter().map(linear).collect() };
                Ok(Opened { image, range: Range::Low })
            }
        },
        Err(cause) => Err(ReadError::Png { path, cause }),
    }
}

/// Pixels of the largest picture: a few bytes state as many as they like, which are not believed.
const MOST_PIXELS: u64 = 1 << 28;

/// How much more there is in a file than it is long, at most: what deflate can do.
const MOST_TIMES: u64 = 1032;

/// Columns and rows of a PNG file, and its pixels' codes in 0 ..= 1: red, green, blue, alpha.
fn samples(bytes: Vec<u8>) -> Result<([u32; 2], Vec<[f32; 4]>), ::png::DecodingError> {
    let most = MOST_TIMES * bytes.len() as u64;
    let mut decoder = ::png::Decoder::new(Cursor::new(bytes));
    // Palettes and fewer than 8 bits.
    decoder.set_transformations(::png::Transformations::EXPAND);
    let mut reader = decoder.read_info()?;
    let pixels = u64::from(reader.info().width) * u64::from(reader.info().height);
    let bytes_per_row = reader.info().raw_row_length() as u64;
    if pixels > MOST_PIXELS || bytes_per_row * u64::from(reader.info().height) > most {
        return Err(::png::DecodingError::LimitsExceeded);
    }
    let mut buffer = vec![0; reader.output_buffer_size().ok_or(::png::DecodingError::LimitsExceeded)?];
    let info = reader.next_frame(&mut buffer)?;
    let codes: Vec<f32> = match info.bit_depth {
        ::png::BitDepth::Sixteen => {
            let words = buffer.chunks_exact(2).map(|word| u16::from_be_bytes([word[0], word[1]]));
            words.map(|word| f32::from(word) / 65_535.0).collect()
        }
        _ => buffer.iter().map(|byte| f32::from(*byte) / 255.0).collect(),
    };
    let pixel = |codes: &[f32]| match *codes {
        [grey] => [grey, grey, grey, 1.0],
        [grey, alpha] => [grey, grey, grey, alpha],
        [r, g, b] => [r, g, b, 1.0],
        [r, g, b, alpha, ..] => [r, g, b, alpha],
        [] => [0.0, 0.0, 0.0, 1.0],
    };
    let pixels = codes.chunks_exact(info.color_type.samples()).map(pixel);
    Ok(([info.width, info.height], pixels.collect()))
}

/// The linear value of a code in 0 ..= 1 by the transfer function of sRGB, IEC 61966-2-1.
fn decoded(code: f32) -> f32 {
    if code <= 0.040_45 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::encoded;

    #[test]
    fn codes_come_back() {
        for code in 0..=255_u8 {
            assert_eq!(encoded(decoded(f32::from(code) / 255.0)), code);
        }
    }
}
