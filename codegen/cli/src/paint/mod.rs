//! Pictures out of pixels and strokes.

mod figure;

pub(crate) use figure::Painter;

use crate::fail::Fail;
use lobe_tests::figures::plot::Figure;
use lobe_tests::figures::proxies::Drawing;
use lobe_tests::figures::{svg, theme::Theme};
use resvg::tiny_skia::{Pixmap, PremultipliedColorU8, Transform};
use resvg::usvg::{Options, Tree};
use std::path::Path;

/// A form of file for what is drawn.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Form {
    Png,
    Svg,
}

impl Form {
    /// The form that a file's name asks for; `what` is drawn.
    pub(crate) fn of(path: &Path, what: &str) -> Result<Self, Fail> {
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        match extension.as_deref() {
            Some("png") => Ok(Self::Png),
            Some("svg") => Ok(Self::Svg),
            _ => {
                let path = path.display();
                Err(Fail::Usage(format!("{path}: {what} are drawn as .png or .svg; name one of them")))
            }
        }
    }
}

fn defect(why: &dyn std::fmt::Display) -> Fail {
    Fail::Defect(format!("a picture cannot be painted: {why}"))
}

/// The PNG file of 8-bit RGB, row by row, as small as it gets.
pub(crate) fn rgb([width, height]: [u32; 2], pixels: &[u8]) -> Result<Vec<u8>, Fail> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    let written = encoder.write_header().and_then(|mut writer| {
        writer.write_image_data(pixels)?;
        writer.finish()
    });
    written.map_err(|e| defect(&e))?;
    Ok(bytes)
}

/// The pixels of a drawing, 8-bit RGB: its strokes over its ground.
pub(crate) fn painted(drawing: &Drawing) -> Result<Vec<u8>, Fail> {
    let [width, height] = drawing.size;
    let mut canvas = Pixmap::new(width, height).ok_or_else(|| defect(&"no size"))?;
    for (pixel, ground) in canvas.pixels_mut().iter_mut().zip(drawing.ground.chunks_exact(3)) {
        *pixel = PremultipliedColorU8::from_rgba(ground[0], ground[1], ground[2], 255).unwrap_or(*pixel);
    }
    let tree = Tree::from_str(&drawing.strokes(), &Options::default()).map_err(|e| defect(&e))?;
    resvg::render(&tree, Transform::identity(), &mut canvas.as_mut());
    Ok(canvas.pixels().iter().flat_map(|p| [p.red(), p.green(), p.blue()]).collect())
}

/// A figure as a file, for light pages.
pub(crate) fn plotted(figure: &Figure, form: Form) -> Result<Vec<u8>, Fail> {
    let text = svg::render(figure, Theme::Light);
    match form {
        Form::Png => Painter::new().png(&text),
        Form::Svg => Ok(text.into_bytes()),
    }
}

/// A drawing as a file.
pub(crate) fn drawn(drawing: &Drawing, form: Form) -> Result<Vec<u8>, Fail> {
    match form {
        Form::Png => rgb(drawing.size, &painted(drawing)?),
        Form::Svg => Ok(drawing.svg(&rgb(drawing.size, &drawing.ground)?).into_bytes()),
    }
}
