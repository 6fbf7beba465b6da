//! `lobe figures`: the figures of the papers, as SVG and PNG, for light and for dark pages.

use crate::fail::{Fail, Outcome};
use crate::output;
use crate::paint::{self, Painter};
use lobe_tests::figures::theme::Theme;
use lobe_tests::figures::{proxies, sheets, svg};
use std::path::{Path, PathBuf};

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Folder to write into, made if it is missing
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Leave the PNG files out
    #[arg(long)]
    no_png: bool,
    /// Render the sheets of pictures instead, of the scenes in this folder
    #[arg(long, value_name = "SCENES", conflicts_with = "no_png")]
    pictures: Option<PathBuf>,
    /// Of the sheets only this one; can be given several times
    #[arg(long, value_name = "SHEET", requires = "pictures", value_parser = clap::builder::PossibleValuesParser::new(
        std::iter::once(PROXIES).chain(sheets::names())
    ))]
    only: Vec<String>,
}

/// The sheet of rectangles over meshes.
const PROXIES: &str = "proxies";

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let fail = |cause| Fail::Write { path: args.folder.clone(), cause };
    std::fs::create_dir_all(&args.folder).map_err(fail)?;
    if let Some(scenes) = &args.pictures {
        return pictures(&args.folder, scenes, &args.only);
    }
    let painter = Painter::new();
    for figure in lobe_tests::figures::all()? {
        for theme in Theme::ALL {
            let text = svg::render(&figure, theme);
            let path = args.folder.join(svg::file_name(&figure, theme));
            write(&path, text.as_bytes())?;
            if !args.no_png {
                write(&path.with_extension("png"), &painter.png(&text)?)?;
            }
        }
    }
    Ok(Outcome::Holds)
}

/// Writes the sheets.
fn pictures(folder: &Path, scenes: &Path, only: &[String]) -> Result<Outcome, Fail> {
    let is_wanted = |name: &str| only.is_empty() || only.iter().any(|wanted| wanted == name);
    if is_wanted(PROXIES) {
        write(&folder.join(PROXIES).with_extension("png"), &drawings(scenes)?)?;
    }
    for name in sheets::names().filter(|name| is_wanted(name)) {
        let Some(sheet) = sheets::drawn(name, scenes)? else { continue };
        write(&folder.join(sheet.name).with_extension("png"), &paint::rgb(sheet.size, &sheet.pixels)?)?;
        sheet.notes.iter().try_for_each(|note| output::print(&format!("    {note}\n")))?;
    }
    Ok(Outcome::Holds)
}

/// The drawings of proxies, all of one size, side by side as a PNG file.
fn drawings(scenes: &Path) -> Result<Vec<u8>, Fail> {
    let drawings = proxies::drawings(scenes)?;
    let painted: Vec<Vec<u8>> = drawings.iter().map(paint::painted).collect::<Result<_, _>>()?;
    let [width, height] = drawings.first().map_or([0, 0], |drawing| drawing.size);
    let line = |row: u32| {
        let bytes = (3 * row * width) as usize..(3 * (row + 1) * width) as usize;
        painted.iter().flat_map(move |pixels| pixels[bytes.clone()].to_vec())
    };
    let pixels: Vec<u8> = (0..height).flat_map(line).collect();
    paint::rgb([width * drawings.len() as u32, height], &pixels)
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Fail> {
    output::write_file(path, bytes)?;
    output::print(&format!("{} ({} bytes)\n", path.display(), bytes.len()))
}
