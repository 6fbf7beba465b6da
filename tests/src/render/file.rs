//! Pictures as files: EXR with linear radiance, PNG for looking at.

use super::Picture;
use ::exr::prelude::{AnyChannel, AnyChannels, FlatSamples, Image, SmallVec, WritableImage};
use lobe_codegen::glam::Vec3;
use std::io::Cursor;

/// Why a picture is no file.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The EXR writer refused it.
    #[error("the picture cannot be written as EXR: {0}")]
    Exr(#[from] ::exr::error::Error),
    /// The PNG writer refused it.
    #[error("the picture cannot be written as PNG: {0}")]
    Png(#[from] ::png::EncodingError),
}

/// The picture as an EXR file of 32-bit floats: channels `R`, `G`, `B`, and with `layers` `NAME.R`, `NAME.G`, `NAME.B` for
/// each layer.
///
/// # Errors
/// When the picture has no size.
pub fn exr(picture: &Picture, layers: bool) -> Result<Vec<u8>, FileError> {
    let mut channels = SmallVec::new();
    push(&mut channels, "", &picture.radiance);
    for layer in picture.layers.iter().filter(|_| layers) {
        push(&mut channels, &format!("{}.", layer.name), &layer.pixels);
    }
    let size = (picture.size[0] as usize, picture.size[1] as usize);
    let image = Image::from_channels(size, AnyChannels::sort(channels));
    let mut file = Cursor::new(Vec::new());
    image.write().to_buffered(&mut file)?;
    Ok(file.into_inner())
}

fn push(channels: &mut SmallVec<[AnyChannel<FlatSamples>; 4]>, prefix: &str, pixels: &[Vec3]) {
    for (at, name) in ["R", "G", "B"].iter().enumerate() {
        let samples = FlatSamples::F32(pixels.iter().map(|pixel| pixel[at]).collect());
        channels.push(AnyChannel::new(format!("{prefix}{name}").as_str(), samples));
    }
}

/// The picture as a PNG file of 8 bits, after scaling by `2^stops`; brighter than white is white.
///
/// # Errors
/// When the picture has no size.
pub fn png(picture: &Picture, stops: f32) -> Result<Vec<u8>, FileError> {
    let scale = stops.exp2();
    let pixels: Vec<u8> =
        picture.radiance.iter().flat_map(|p| (scale * *p).to_array().map(encoded)).collect();
    png_of(picture.size, &pixels)
}

/// A PNG file of 8 bits: red, green and blue of each pixel, in sRGB.
///
/// # Errors
/// When there are not as many pixels as `size` says, or none.
pub(crate) fn png_of(size: [u32; 2], pixels: &[u8]) -> Result<Vec<u8>, FileError> {
    let mut bytes = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut bytes, size[0], size[1]);
    encoder.set_color(::png::ColorType::Rgb);
    encoder.set_source_srgb(::png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(pixels)?;
    writer.finish()?;
    Ok(bytes)
}

/// The stops by which the picture's brightest pixels, but one in fifty, are just below white.
#[must_use]
pub fn auto_exposure(picture: &Picture) -> f32 {
    let mut values: Vec<f32> =
        picture.radiance.iter().map(|p| p.max_element()).filter(|v| *v > 0.0).collect();
    values.sort_by(f32::total_cmp);
    let bright = values.get(values.len() * 49 / 50).copied().unwrap_or(1.0);
    (0.9 / bright).log2()
}

/// A linear value by the transfer function of sRGB, IEC 61966-2-1.
#[must_use]
pub fn encoded(linear: f32) -> u8 {
    let x = linear.clamp(0.0, 1.0);
    let curved = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
    (255.0 * curved + 0.5) as u8
}
