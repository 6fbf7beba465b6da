//! Goldens and pictures as EXR files: 32-bit floats, ZIP.
//!
//! Channels `R`, `G`, `B`; of a golden besides `permitted.R`, `permitted.G`, `permitted.B`.
//! The same numbers make the same bytes. A file is not believed: its size and what its header claims are held against
//! limits before anything is decoded.

use crate::golden::{Golden, GoldenError, MOST_PIXELS};
use crate::verdict::CHANNELS;
use ::exr::meta::MetaData;
use ::exr::prelude::{
    AnyChannel, AnyChannels, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes, ReadChannels,
    ReadLayers, SampleType, SmallVec, WritableImage, read,
};
use std::io::Cursor;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Bytes of a file, at most.
pub const MOST_BYTES: u64 = 32 << 20;
/// Channels of a file, at most.
const MOST_CHANNELS: usize = 16;
/// Before the name of a channel of permitted errors.
const PERMITTED: &str = "permitted.";
/// What a file begins with that stands for another one.
const POINTER: &[u8] = b"version https://git-lfs";

/// A picture: RGB, row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Three values for each pixel.
    pub values: Vec<f32>,
}

/// Why bytes are no picture, or a picture has none.
#[derive(Debug, thiserror::Error)]
pub enum ImageError {
    /// There are no bytes.
    #[error("it is empty")]
    Empty,
    /// It stands for a file that is kept elsewhere.
    #[error("it is a pointer of Git LFS and not the picture: run `git lfs pull`")]
    Pointer,
    /// It has more bytes than are read.
    #[error("it has more than {MOST_BYTES} bytes")]
    Long,
    /// It is no EXR file, or damaged.
    #[error("it is no EXR file, or a damaged one: {0}")]
    Exr(#[from] ::exr::error::Error),
    /// The reader broke.
    #[error("it is damaged: the reader of EXR files broke on it")]
    Broken,
    /// It claims more than is believed.
    #[error("it claims {what}, which no golden has: it is damaged, or made to do harm")]
    Claim {
        /// What it claims.
        what: String,
    },
    /// A channel is not there, or of another type.
    #[error("it has no channel {name} of 32-bit floats")]
    Channel {
        /// Its name.
        name: String,
    },
    /// Its numbers are not those of a golden.
    #[error("its numbers make no golden: {0}")]
    Golden(#[from] GoldenError),
}

/// The golden as a file.
///
/// # Errors
/// None that a golden could cause.
pub fn write_golden(golden: &Golden) -> Result<Vec<u8>, ImageError> {
    write(golden.size(), &[("", golden.truth()), (PERMITTED, golden.permitted())])
}

/// The picture as a file.
///
/// # Errors
/// When there are not three values for each pixel, or no pixels.
pub fn write_picture(picture: &Picture) -> Result<Vec<u8>, ImageError> {
    check_size([picture.size[0] as usize, picture.size[1] as usize])?;
    write(picture.size, &[("", &picture.values)])
}

fn write(size: [u32; 2], layers: &[(&str, &[f32])]) -> Result<Vec<u8>, ImageError> {
    let mut channels = SmallVec::<[AnyChannel<FlatSamples>; 4]>::new();
    for (prefix, values) in layers {
        for (at, name) in CHANNELS.iter().enumerate() {
            let samples = FlatSamples::F32(values.iter().skip(at).step_by(3).copied().collect());
            channels.push(AnyChannel::new(format!("{prefix}{name}").as_str(), samples));
        }
    }
    let size = (size[0] as usize, size[1] as usize);
    let layer =
        Layer::new(size, LayerAttributes::default(), Encoding::SMALL_LOSSLESS, AnyChannels::sort(channels));
    let mut file = Cursor::new(Vec::new());
    Image::from_layer(layer).write().non_parallel().to_buffered(&mut file)?;
    Ok(file.into_inner())
}

/// The golden of a file.
///
/// # Errors
/// When it is none, or claims to be larger than goldens are.
pub fn read_golden(bytes: &[u8]) -> Result<Golden, ImageError> {
    let layers = decode(bytes)?;
    let [truth, permitted] = ["", PERMITTED].map(|prefix| layers.interleaved(prefix));
    Ok(Golden::of_floats(layers.size, truth?, permitted?)?)
}

/// The picture of a file.
///
/// # Errors
/// When it is none, or claims to be larger than goldens are.
pub fn read_picture(bytes: &[u8]) -> Result<Picture, ImageError> {
    let layers = decode(bytes)?;
    Ok(Picture { size: layers.size, values: layers.interleaved("")? })
}

/// Whether bytes are what Git LFS leaves in the place of a file.
#[must_use]
pub(crate) fn is_pointer(bytes: &[u8]) -> bool {
    bytes.starts_with(POINTER)
}

struct Layers {
    size: [u32; 2],
    channels: Vec<(String, Vec<f32>)>,
}

impl Layers {
    fn interleaved(&self, prefix: &str) -> Result<Vec<f32>, ImageError> {
        let found = CHANNELS.map(|channel| {
            let name = format!("{prefix}{channel}");
            let found = self.channels.iter().find(|(known, _)| *known == name);
            found.map(|(_, values)| values.as_slice()).ok_or(ImageError::Channel { name })
        });
        let [r, g, b] = found;
        let (r, g, b) = (r?, g?, b?);
        Ok(r.iter().zip(g).zip(b).flat_map(|((r, g), b)| [*r, *g, *b]).collect())
    }
}

fn decode(bytes: &[u8]) -> Result<Layers, ImageError> {
    if bytes.is_empty() {
        return Err(ImageError::Empty);
    }
    if is_pointer(bytes) {
        return Err(ImageError::Pointer);
    }
    if bytes.len() as u64 > MOST_BYTES {
        return Err(ImageError::Long);
    }
    // The reader is not ours: what breaks it breaks one golden, not the run.
    let read = catch_unwind(AssertUnwindSafe(|| {
        check_claims(bytes)?;
        decode_checked(bytes)
    }));
    read.unwrap_or(Err(ImageError::Broken))
}

/// What the header claims, before anything is made by it.
fn check_claims(bytes: &[u8]) -> Result<(), ImageError> {
    let claim = |what: String| Err(ImageError::Claim { what });
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false)?;
    let [header] = meta.headers.as_slice() else {
        return claim(format!("{} parts", meta.headers.len()));
    };
    check_size([header.layer_size.width(), header.layer_size.height()])?;
    let channels = &header.channels.list;
    if header.deep || channels.len() > MOST_CHANNELS {
        return claim(format!("{} channels, deep data: {}", channels.len(), header.deep));
    }
    let is_plain = |c: &::exr::prelude::ChannelDescription| {
        c.sample_type == SampleType::F32 && (c.sampling.x(), c.sampling.y()) == (1, 1)
    };
    if !channels.iter().all(is_plain) {
        return claim("channels of other than 32-bit floats".to_owned());
    }
    match header.compression {
        Compression::Uncompressed | Compression::ZIP1 | Compression::ZIP16 => Ok(()),
        other => claim(format!("compression {other}")),
    }
}

fn check_size([width, height]: [usize; 2]) -> Result<(), ImageError> {
    match width.checked_mul(height) {
        Some(pixels) if (1..=MOST_PIXELS).contains(&pixels) => Ok(()),
        _ => Err(ImageError::Claim { what: format!("{width} x {height} pixels") }),
    }
}

fn decode_checked(bytes: &[u8]) -> Result<Layers, ImageError> {
    let reader = read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let file = reader.all_attributes().pedantic().non_parallel().from_buffered(Cursor::new(bytes))?;
    let layer = file.layer_data;
    let size = [layer.size.width() as u32, layer.size.height() as u32];
    let channels = layer.channel_data.list.into_iter().filter_map(|channel| match channel.sample_data {
        FlatSamples::F32(values) => Some((channel.name.to_string(), values)),
        FlatSamples::F16(_) | FlatSamples::U32(_) => None,
    });
    Ok(Layers { size, channels: channels.collect() })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn golden() -> Golden {
        let number = |at: usize| (at as f64 * 0.37).sin().abs();
        let truth: Vec<f64> = (0..3 * 40 * 20).map(number).collect();
        let mut permitted: Vec<f64> = truth.iter().map(|x| x * 1e-6).collect();
        permitted[7] = f64::INFINITY;
        Golden::new([40, 20], &truth, &permitted).unwrap()
    }

    #[test]
    fn what_is_written_is_read() {
        let bytes = write_golden(&golden()).unwrap();
        assert_eq!(read_golden(&bytes).unwrap(), golden());
        assert_eq!(write_golden(&golden()).unwrap(), bytes, "other bytes of the same numbers");
        let picture = Picture { size: [40, 20], values: golden().truth().to_vec() };
        assert_eq!(read_picture(&write_picture(&picture).unwrap()).unwrap(), picture);
        assert_eq!(read_picture(&bytes).unwrap(), picture);
    }

    #[test]
    fn a_picture_is_no_golden() {
        let picture = Picture { size: [2, 1], values: vec![0.0; 6] };
        let bytes = write_picture(&picture).unwrap();
        assert!(matches!(read_golden(&bytes), Err(ImageError::Channel { name }) if name == "permitted.R"));
        assert!(write_picture(&Picture { size: [0, 1], values: vec![] }).is_err());
    }

    #[test]
    fn what_is_cut_off_is_no_golden() {
        let bytes = write_golden(&golden()).unwrap();
        for end in (0..bytes.len()).step_by(64).chain([bytes.len() - 1]) {
            assert!(read_golden(&bytes[..end]).is_err(), "{end} of {} bytes", bytes.len());
        }
    }

    /// A flipped bit of a pixel may be another picture; the store knows by the hash. Here it must not break anything.
    #[test]
    fn flipped_bits_break_nothing() {
        let bytes = write_golden(&golden()).unwrap();
        for at in 0..bytes.len() {
            let mut flipped = bytes.clone();
            flipped[at] ^= 1 << (at % 8);
            let _ = read_golden(&flipped);
        }
    }

    #[test]
    fn a_pointer_and_nothing_say_so() {
        let pointer = b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n";
        assert!(matches!(read_golden(pointer), Err(ImageError::Pointer)));
        assert!(matches!(read_golden(b""), Err(ImageError::Empty)));
        assert!(matches!(read_golden(b"no picture at all"), Err(ImageError::Exr(_))));
        assert!(matches!(read_golden(&vec![0; MOST_BYTES as usize + 1]), Err(ImageError::Long)));
    }

    /// The header of a small file, changed to claim 2^30 pixels.
    #[test]
    fn a_claim_is_not_believed() {
        let bytes = write_golden(&golden()).unwrap();
        let window = |name: &[u8]| {
            let at = bytes.windows(name.len()).position(|w| w == name).unwrap();
            at + name.len() + b"box2i\0".len() + 4
        };
        let mut bomb = bytes.clone();
        for begin in [window(b"dataWindow\0"), window(b"displayWindow\0")] {
            for place in [begin + 8, begin + 12] {
                bomb[place..place + 4].copy_from_slice(&32_767_i32.to_le_bytes());
            }
        }
        let error = read_golden(&bomb).unwrap_err();
        assert!(matches!(&error, ImageError::Claim { what } if what.contains("32768")), "{error}");
    }
}
