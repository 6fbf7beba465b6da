//! Pictures of the methods beside the truth, as sheets of small pictures.
//!
//! Neither the methods nor the truth beside them know of occlusion between surfaces; direct light has its shadows, and
//! virtual lights are where light falls.

use crate::proxies::{self, Options};
use crate::render::{Method, Picture, Renderer, Settings, VirtualLights, encoded};
use crate::scene::{Choices, Scene};
use lobe_backends::executor::ExecError;
use lobe_backends::pipeline::Interpreted;
use lobe_codegen::glam::Vec3;
use std::path::Path;

/// Samples a pixel of the truth.
const SAMPLES: u32 = 1024;
/// By what radiance is multiplied.
const EXPOSURE: f32 = 1.5;
/// By what differences are multiplied besides.
const DIFFERENCE: f32 = 2.0;

/// Small pictures side by side.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sheet {
    /// Its name.
    pub name: &'static str,
    /// Columns and rows, in pixels.
    pub size: [u32; 2],
    /// 8-bit RGB, row by row.
    pub pixels: Vec<u8>,
}

/// Why a sheet cannot be drawn.
#[derive(Debug, thiserror::Error)]
pub enum SheetError {
    /// A pass was not run.
    #[error(transparent)]
    Exec(#[from] ExecError),
    /// A scene of the tests is not there, or no scene.
    #[error("{name} cannot be drawn: {reason}; run this in a checkout of Lobe")]
    Scene {
        /// The scene.
        name: String,
        /// Why.
        reason: String,
    },
}

/// A small picture.
type Tile = Vec<Vec3>;

/// Small pictures in rows, and the name of their sheet; none where the truth is needed and was not asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Tiles {
    /// The sheet's name.
    pub name: &'static str,
    /// Each row's pictures, square ones of one size, in linear RGB.
    pub rows: Vec<Vec<Option<Vec<Vec3>>>>,
}

/// All sheets, of the scenes in `folder`.
///
/// # Errors
/// When a scene or the interpreter is not as it should be.
pub fn sheets(folder: &Path) -> Result<Vec<Sheet>, SheetError> {
    Ok(tiles(folder, true)?.iter().map(sheet).collect())
}

/// What the sheets are made of; without the truth it takes seconds.
///
/// `rectangles`: the box under four lights; direct light, one bounce onto diffuse and onto glossy lobes by
/// [`Method::RectQuadrature`], their sum, the truth of that, and the difference (red: too bright, blue: too dark).
/// `methods`: the glossy bounce as printed, corrected, by our closed form and by our quadrature, and the truth.
/// `virtual_lights`: all light of one bounce by 1024 point lights, lights with Gaussian lobes and lights with GGX lobes, and
/// the truth.
///
/// # Errors
/// As of [`sheets`].
pub fn tiles(folder: &Path, with_truth: bool) -> Result<Vec<Tiles>, SheetError> {
    let artist = Artist { renderer: Renderer::new()?, folder, with_truth };
    let lights = ["cornell_L0", "cornell_L1", "cornell_L2", "cornell_L3"];
    let glossy = ["cornell_L0", "cornell_L1", "plates_a010"];
    let many = ["caustic_a005", "cornell_L1", "plates_a005"];
    Ok(vec![
        Tiles { name: "rectangles", rows: rows(&lights, |name| artist.bounces(name))? },
        Tiles { name: "methods", rows: rows(&glossy, |name| artist.methods(name))? },
        Tiles { name: "virtual_lights", rows: rows(&many, |name| artist.virtual_lights(name))? },
    ])
}

/// A pixel's colour in a sheet, 8 bits a channel.
#[must_use]
pub fn shown(colour: Vec3) -> [u8; 3] {
    (EXPOSURE * colour).to_array().map(encoded)
}

type Row = Vec<Option<Tile>>;

fn rows(names: &[&str], row: impl Fn(&str) -> Result<Row, SheetError>) -> Result<Vec<Row>, SheetError> {
    names.iter().map(|name| row(name)).collect()
}

struct Artist<'a> {
    renderer: Renderer,
    folder: &'a Path,
    with_truth: bool,
}

impl Artist<'_> {
    fn picture(&self, name: &str, method: Method) -> Result<Picture, SheetError> {
        let told = |reason: String| SheetError::Scene { name: name.to_owned(), reason };
        let path = self.folder.join(format!("{name}.json"));
        let scene = Scene::open(&path, &Choices::default()).map_err(|e| told(e.to_string()))?;
        let proxies = proxies::proxies(&scene, &Options::default()).map_err(|e| told(e.to_string()))?;
        let virtual_lights = VirtualLights { smoothing: 1.0, ..VirtualLights::default() };
        let settings = Settings { method, samples: SAMPLES, virtual_lights, ..Settings::default() };
        Ok(self.renderer.render(&scene, &proxies, &settings, &mut Interpreted::default(), &|_| {})?)
    }

    /// A layer by a method; none of the truth where that is not asked for.
    fn tile(&self, name: &str, method: Method, layer: &str) -> Result<Option<Tile>, SheetError> {
        match method {
            Method::Reference if !self.with_truth => Ok(None),
            _ => Ok(Some(tile(&self.picture(name, method)?, layer))),
        }
    }

    fn bounces(&self, name: &str) -> Result<Row, SheetError> {
        let parts = ["direct_vis", "indirect_diffuse_novis", "indirect_specular_fromspec_novis"];
        let total = |picture: &Picture| {
            parts.iter().map(|part| tile(picture, part)).reduce(added).unwrap_or_default()
        };
        let ours = self.picture(name, Method::RectQuadrature)?;
        let ours_total = total(&ours);
        let truth = match self.with_truth {
            true => Some(total(&self.picture(name, Method::Reference)?)),
            false => None,
        };
        let less = |truth: &Tile| ours_total.iter().zip(truth).map(|(a, b)| signed(*a - *b)).collect();
        let difference = truth.as_ref().map(less);
        let shown = parts.iter().map(|part| Some(tile(&ours, part)));
        Ok(shown.chain([Some(ours_total), truth, difference]).collect())
    }

    fn methods(&self, name: &str) -> Result<Row, SheetError> {
        let methods =
            [Method::RectPaper, Method::Rect, Method::RectLaplace, Method::RectQuadrature, Method::Reference];
        let layer = "indirect_specular_fromspec_novis";
        methods.into_iter().map(|method| self.tile(name, method, layer)).collect()
    }

    fn virtual_lights(&self, name: &str) -> Result<Row, SheetError> {
        let methods = [Method::Vpl, Method::Vsgl, Method::VslWide, Method::Reference];
        methods.into_iter().map(|method| self.tile(name, method, "indirect_total_la")).collect()
    }
}

fn tile(picture: &Picture, layer: &str) -> Tile {
    picture.layer(layer).map(<[Vec3]>::to_vec).unwrap_or_default()
}

fn added(a: Tile, b: Tile) -> Tile {
    a.iter().zip(&b).map(|(a, b)| *a + *b).collect()
}

/// A difference as a colour: red for more, blue for less.
fn signed(difference: Vec3) -> Vec3 {
    let luminance = DIFFERENCE * difference.element_sum() / 3.0;
    Vec3::new(luminance.max(0.0), 0.0, (-luminance).max(0.0))
}

/// Puts tiles of one size, square ones, side by side.
fn sheet(tiles: &Tiles) -> Sheet {
    let drawn: Vec<Vec<&Tile>> = tiles.rows.iter().map(|row| row.iter().flatten().collect()).collect();
    let side = drawn.first().and_then(|row| row.first()).map_or(0, |tile| tile.len().isqrt());
    let across = drawn.first().map_or(0, Vec::len);
    let line = |row: &Vec<&Tile>, y: usize| -> Vec<Vec3> {
        row.iter().flat_map(|tile| tile[y * side..(y + 1) * side].to_vec()).collect()
    };
    let colours = drawn.iter().flat_map(|row| (0..side).flat_map(move |y| line(row, y)));
    let size = [(side * across) as u32, (side * drawn.len()) as u32];
    Sheet { name: tiles.name, size, pixels: colours.flat_map(shown).collect() }
}
