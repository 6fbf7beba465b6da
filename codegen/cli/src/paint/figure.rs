//! Figures as PNG files.

use crate::fail::Fail;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Pixels of a PNG for each unit of the SVG.
const SCALE: f32 = 2.0;
/// The only font: none of the system is asked for, so that the same figure gives the same picture.
const FONT: &str = "Ubuntu";

/// Makes pictures of SVG texts.
pub(crate) struct Painter(Options<'static>);

impl Painter {
    pub(crate) fn new() -> Self {
        let mut options = Options { font_family: FONT.to_owned(), ..Options::default() };
        let fonts = Arc::make_mut(&mut options.fontdb);
        fonts.load_font_data(epaint_default_fonts::UBUNTU_LIGHT.to_vec());
        // The weight that is asked for is the regular one; this family has but the light one.
        fonts.set_sans_serif_family(FONT);
        Self(options)
    }

    pub(crate) fn png(&self, svg: &str) -> Result<Vec<u8>, Fail> {
        let defect = |why: &dyn std::fmt::Display| Fail::Defect(format!("a figure cannot be painted: {why}"));
        let tree = Tree::from_str(svg, &self.0).map_err(|e| defect(&e))?;
        let size = tree.size();
        let pixels = |length: f32| (length * SCALE).ceil() as u32;
        let mut canvas =
            Pixmap::new(pixels(size.width()), pixels(size.height())).ok_or_else(|| defect(&"no size"))?;
        resvg::render(&tree, Transform::from_scale(SCALE, SCALE), &mut canvas.as_mut());
        encode(&canvas).map_err(|e| defect(&e))
    }
}

type Colour = [u8; 3];

/// As small as it gets: the 256 most frequent colours, which all but few pixels have, and no alpha channel.
fn encode(canvas: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let pixels: Vec<Colour> = canvas.pixels().iter().map(|p| [p.red(), p.green(), p.blue()]).collect();
    let mut counts: BTreeMap<Colour, usize> = BTreeMap::new();
    for pixel in &pixels {
        *counts.entry(*pixel).or_default() += 1;
    }
    let mut palette: Vec<Colour> = counts.keys().copied().collect();
    palette.sort_by_key(|colour| std::cmp::Reverse(counts[colour]));
    palette.truncate(256);
    let indices: BTreeMap<Colour, u8> = counts.keys().map(|c| (*c, nearest(&palette, *c))).collect();
    let indices: Vec<u8> = pixels.iter().map(|pixel| indices[pixel]).collect();

    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, canvas.width(), canvas.height());
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_palette(palette.concat());
    encoder.set_compression(png::Compression::High);
    encoder.set_filter(png::Filter::NoFilter);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&indices)?;
    writer.finish()?;
    Ok(bytes)
}

/// The place of the colour of `palette` that is nearest to `colour`.
fn nearest(palette: &[Colour], colour: Colour) -> u8 {
    let distance = |other: &Colour| -> u32 {
        other.iter().zip(colour).map(|(a, b)| u32::from(a.abs_diff(b)) * u32::from(a.abs_diff(b))).sum()
    };
    let best = (0..palette.len()).min_by_key(|i| distance(&palette[*i]));
    best.unwrap_or(0) as u8
}
