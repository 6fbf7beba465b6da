//! Images: PNG and JPEG as words of a buffer.
//!
//! Columns and rows are read before anything else is, and not believed beyond what a scene may have.

use super::Files;
use super::buffers::{Buffers, of_uri};
use crate::scene::SceneError;
use crate::scene::limits::refused;
use gltf::Document;
use gltf::json::image::Image;
use std::borrow::Cow;
use std::io::Cursor;
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// Columns and rows of the largest image.
const LARGEST: u32 = 16_384;
/// Texels of all images of a scene: half a gigabyte.
const MOST_TEXELS: usize = 1 << 27;

/// An image in the buffer of texels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Placed {
    /// Its first texel.
    pub(super) first: u32,
    /// Columns and rows.
    pub(super) size: [u32; 2],
}

/// The images of a document, each read when it is asked for.
pub(super) struct Images<'a> {
    document: &'a Document,
    buffers: &'a Buffers,
    files: Files<'a>,
    placed: Vec<Option<Placed>>,
    /// Red in the lowest byte, then green, blue, alpha.
    pub(super) texels: Vec<u32>,
}

impl<'a> Images<'a> {
    pub(super) fn new(document: &'a Document, buffers: &'a Buffers, files: Files<'a>) -> Self {
        Self { document, buffers, files, placed: vec![None; document.images().len()], texels: Vec::new() }
    }

    /// The image at `index`, which is there.
    pub(super) fn get(&mut self, index: usize) -> Result<Placed, SceneError> {
        if let Some(Some(placed)) = self.placed.get(index) {
            return Ok(*placed);
        }
        let document = self.document;
        let Some(image) = document.as_json().images.get(index) else {
            return refused("images", format!("there is no image {index}"));
        };
        let name = image.name.as_ref().map(|name| format!(" ({name})")).unwrap_or_default();
        let at = format!("images[{index}]{name}");
        let bytes = self.bytes(&at, image)?;
        let size = size(&at, &bytes)?;
        let texels = size.map(|n| n as usize).iter().product::<usize>();
        if texels > MOST_TEXELS - self.texels.len() {
            let [width, height] = size;
            let message = format!(
                "with its {width} by {height} texels there are more than {MOST_TEXELS}; make images smaller"
            );
            return refused(&at, message);
        }
        let placed = Placed { first: self.texels.len() as u32, size };
        let read = decoded(&bytes).and_then(|found| exact(found, texels));
        self.texels.extend(read.or_else(|message| refused(&at, message))?);
        self.placed[index] = Some(placed);
        Ok(placed)
    }

    fn bytes(&self, at: &str, image: &Image) -> Result<Cow<'a, [u8]>, SceneError> {
        match (&image.buffer_view, &image.uri) {
            (Some(view), _) => match self.document.views().nth(view.value()) {
                Some(view) => self.buffers.view(&view).map(Cow::Borrowed),
                None => refused(at, format!("there is no bufferView {}", view.value())),
            },
            (None, Some(uri)) => of_uri(at, uri, self.files).map(Cow::Owned),
            (None, None) => refused(at, "it has neither a bufferView nor a uri"),
        }
    }
}

const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";
const JPEG: &[u8] = b"\xff\xd8\xff";

/// Columns and rows that the header states.
fn size(at: &str, bytes: &[u8]) -> Result<[u32; 2], SceneError> {
    let found = if bytes.starts_with(PNG) {
        png_size(bytes)
    } else if bytes.starts_with(JPEG) {
        jpeg_size(bytes)
    } else {
        Err("it is neither PNG nor JPEG".to_owned())
    };
    let size = found.or_else(|message| refused(at, message))?;
    match size.iter().all(|n| (1..=LARGEST).contains(n)) {
        true => Ok(size),
        false => refused(at, format!("its size {} by {} is not in 1 ..= {LARGEST}", size[0], size[1])),
    }
}

fn png_size(bytes: &[u8]) -> Result<[u32; 2], String> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    let info = decoder.read_header_info().map_err(|error| no("PNG", &error))?;
    Ok([info.width, info.height])
}

fn jpeg_size(bytes: &[u8]) -> Result<[u32; 2], String> {
    let mut decoder = jpeg(bytes);
    decoder.decode_headers().map_err(|error| no("JPEG", &error))?;
    let info = decoder.info().ok_or("it is no JPEG image: it has no size")?;
    Ok([info.width, info.height].map(u32::from))
}

fn jpeg(bytes: &[u8]) -> JpegDecoder<Cursor<&[u8]>> {
    let options = DecoderOptions::default()
        .set_max_width(LARGEST as usize)
        .set_max_height(LARGEST as usize)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    JpegDecoder::new_with_options(Cursor::new(bytes), options)
}

fn no(kind: &str, error: &dyn std::fmt::Display) -> String {
    format!("it is no {kind} image: {error}")
}

/// Texels, row by row.
fn decoded(bytes: &[u8]) -> Result<Vec<u32>, String> {
    if bytes.starts_with(PNG) { decoded_png(bytes) } else { decoded_jpeg(bytes) }
}

fn decoded_png(bytes: &[u8]) -> Result<Vec<u32>, String> {
    let told = |error: png::DecodingError| no("PNG", &error);
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    // Palettes and fewer than 8 bits become 8 bits, and so do 16.
    decoder.set_transformations(png::Transformations::EXPAND | png::Transformations::STRIP_16);
    let mut reader = decoder.read_info().map_err(told)?;
    let bytes = reader.output_buffer_size().ok_or("it is no PNG image: it is too large")?;
    let mut buffer = vec![0; bytes];
    let info = reader.next_frame(&mut buffer).map_err(told)?;
    Ok(buffer.chunks_exact(info.color_type.samples()).map(texel).collect())
}

fn decoded_jpeg(bytes: &[u8]) -> Result<Vec<u32>, String> {
    let buffer = jpeg(bytes).decode().map_err(|error| no("JPEG", &error))?;
    Ok(buffer.chunks_exact(3).map(texel).collect())
}

/// A texel of one, two, three or four channels.
fn texel(channels: &[u8]) -> u32 {
    u32::from_le_bytes(match *channels {
        [grey] => [grey, grey, grey, 255],
        [grey, alpha] => [grey, grey, grey, alpha],
        [r, g, b] => [r, g, b, 255],
        [r, g, b, alpha, ..] => [r, g, b, alpha],
        [] => [0; 4],
    })
}

fn exact(found: Vec<u32>, texels: usize) -> Result<Vec<u32>, String> {
    match found.len() == texels {
        true => Ok(found),
        false => Err(format!("it has {} texels, and its size makes {texels}", found.len())),
    }
}
