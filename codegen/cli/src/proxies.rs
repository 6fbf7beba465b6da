//! `lobe proxies`: rectangles in place of a mesh.

use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use crate::paint::{self, Form};
use crate::render::size;
use crate::scene;
use lobe_codegen::prelude::Vec3;
use lobe_tests::figures::proxies::Drawing;
use lobe_tests::proxies::{DEEPEST, Options, proxies};
use lobe_tests::scene::{Choices, Light};
use std::path::PathBuf;

/// Options.
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(crate) struct Args {
    /// The scene: `.gltf`, `.glb`, or JSON (tests/SCENES.md)
    scene: PathBuf,
    /// File to write the proxies to, as JSON
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Merge down to at most so many, those first that add least error
    #[arg(long, value_name = "N")]
    count: Option<usize>,
    /// How far normals may be from the mean of their rectangle, in degrees
    #[arg(long, value_name = "DEG", default_value_t = 10.0)]
    angle: f64,
    /// How far corners may be from their rectangle, in metres; 0.005 of the scene's diagonal unless this is given
    #[arg(long, value_name = "M")]
    distance: Option<f64>,
    /// Halve space so many times, and put together what is in one cell: for leaves, and for what is finely curved
    #[arg(long, value_name = "DEPTH", value_parser = clap::value_parser!(u32).range(..=i64::from(DEEPEST)))]
    partition: Option<u32>,
    /// Merge surfaces of several materials too; a rectangle has the one of most area
    #[arg(long)]
    merge_materials: bool,
    /// Files to draw the rectangles over the mesh into, from the scene's camera: `.png` or `.svg`
    #[arg(long, value_name = "FILE")]
    picture: Vec<PathBuf>,
    /// Name of the glTF file's camera, instead of its first
    #[arg(long, value_name = "NAME", requires = "picture")]
    camera: Option<String>,
    /// Columns and rows of the picture; of the camera's shape, 960 pixels along its longer side, unless this is given
    #[arg(long, value_name = "WxH", value_parser = size, requires = "picture")]
    size: Option<[u32; 2]>,
    /// Form of the report
    #[arg(long, value_enum, default_value_t = ListFormat::Human)]
    format: ListFormat,
}

const HELP: &str = "\
Regions grow over triangles that share an edge and a material, as long as --angle and --distance hold; the proxy of a \
region is the rectangle of least area around it in its mean plane. With --partition, the regions of a cell of space are put \
together that have one material and normals about one axis, as soon as a rectangle stands for them that holds --angle and \
--distance and is half full, and in the last cells in any case. With --count, the pair of regions is merged that adds \
least error: area counts once where it is --distance off the plane, once where its normals are --angle off, and once where \
a rectangle is empty. Rectangles of a JSON scene are proxies as they are.

A --picture has the mesh in grey, and each rectangle in a colour of its own: it tints what is in its plane or behind it. \
Outlines are dashed where the mesh hides them; the stroke from the middle of a rectangle is its normal.

Exit codes: 0 the proxies are made, 2 the scene or an option is refused.";

/// Pixels of a picture, at most.
const MOST_PIXELS: u64 = 1 << 24;
/// Taken where a file has no light: proxies are made of surfaces alone.
const ANY: Light = Light::Directional { to_light: Vec3::Y, irradiance: Vec3::ONE };

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let forms: Vec<Form> =
        args.picture.iter().map(|path| Form::of(path, "proxies")).collect::<Result<_, _>>()?;
    if let Some([width, height]) =
        args.size.filter(|size| size.iter().map(|n| u64::from(*n)).product::<u64>() > MOST_PIXELS)
    {
        let message = format!("{width} x {height} are too many pixels: at most {MOST_PIXELS} are drawn");
        return Err(Fail::Usage(message));
    }
    let choices = Choices { light: Some(ANY), camera: args.camera.clone(), ..Choices::default() };
    let scene = scene::open(&args.scene, &choices)?;
    let options = Options {
        angle: args.angle.to_radians(),
        distance: args.distance,
        partition: args.partition,
        count: args.count,
        merge_materials: args.merge_materials,
    };
    let found = proxies(&scene, &options)?;
    let json = found.to_json()?;
    if let Some(path) = &args.output {
        output::write_file(path, json.as_bytes())?;
    }
    if !forms.is_empty() {
        let drawing = Drawing::new(&scene, &found, args.size);
        for (path, form) in args.picture.iter().zip(forms) {
            output::write_file(path, &paint::drawn(&drawing, form)?)?;
        }
    }
    output::print(&match args.format {
        ListFormat::Human => found.summary().to_string(),
        ListFormat::Json => json,
    })?;
    Ok(Outcome::Holds)
}
