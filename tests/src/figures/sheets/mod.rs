//! Pictures of the methods beside the truth, as sheets of small pictures.
//!
//! Neither the methods nor the truth beside them know of occlusion between surfaces; direct light has its shadows, and
//! virtual lights are where light falls.

mod densities;
mod lights;

use crate::proxies::{self, Options, Proxies};
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
    /// What was measured besides, a line each.
    pub notes: Vec<String>,
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

/// Small pictures in rows, and the name of their sheet; none where the truth, or as much time, is needed and was not asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Tiles {
    /// The sheet's name.
    pub name: &'static str,
    /// Each row's pictures, square ones of one size, in linear RGB.
    pub rows: Vec<Vec<Option<Vec<Vec3>>>>,
    /// What was measured besides, a line each; nothing without the truth.
    pub notes: Vec<String>,
}

impl Tiles {
    fn new(name: &'static str, rows: Vec<Row>) -> Self {
        Self { name, rows, notes: Vec::new() }
    }
}

/// What draws a sheet.
type Draw = fn(&Artist<'_>) -> Result<Tiles, SheetError>;

/// The sheets, by name.
const SHEETS: [(&str, Draw); 7] = [
    ("rectangles", |artist| artist.rectangles()),
    ("methods", |artist| artist.methods()),
    ("virtual_lights", |artist| artist.virtual_lights()),
    ("densities", |artist| artist.densities()),
    ("lobes", |artist| artist.lobes()),
    ("bias", |artist| artist.bias()),
    ("two_lights", |artist| artist.two_lights()),
];

/// The names of all sheets.
pub fn names() -> impl Iterator<Item = &'static str> {
    SHEETS.iter().map(|(name, _)| *name)
}

/// The sheet of this name, of the scenes in `folder`; none if there is no such.
///
/// # Errors
/// When a scene or the interpreter is not as it should be.
pub fn drawn(name: &str, folder: &Path) -> Result<Option<Sheet>, SheetError> {
    Ok(tiles(name, folder, true)?.map(|tiles| sheet(&tiles)))
}

/// What the sheet of this name is made of; without the truth it takes seconds.
///
/// # Errors
/// As of [`drawn`].
pub fn tiles(name: &str, folder: &Path, with_truth: bool) -> Result<Option<Tiles>, SheetError> {
    let Some((_, draw)) = SHEETS.iter().find(|(known, _)| *known == name) else { return Ok(None) };
    Ok(Some(draw(&Artist { renderer: Renderer::new()?, folder, with_truth })?))
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
    fn scene(&self, name: &str) -> Result<(Scene, Proxies), SheetError> {
        let told = |reason: String| SheetError::Scene { name: name.to_owned(), reason };
        let path = self.folder.join(format!("{name}.json"));
        let scene = Scene::open(&path, &Choices::default()).map_err(|e| told(e.to_string()))?;
        let proxies = proxies::proxies(&scene, &Options::default()).map_err(|e| told(e.to_string()))?;
        Ok((scene, proxies))
    }

    fn picture(&self, name: &str, method: Method) -> Result<Picture, SheetError> {
        let (scene, proxies) = self.scene(name)?;
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

    /// The box under four lights: direct light, one bounce onto diffuse and onto glossy lobes by [`Method::RectQuadrature`], their
    /// sum, the truth of that, and the difference (red: too bright, blue: too dark).
    fn rectangles(&self) -> Result<Tiles, SheetError> {
        let lights = ["cornell_L0", "cornell_L1", "cornell_L2", "cornell_L3"];
        Ok(Tiles::new("rectangles", rows(&lights, |name| self.bounces(name))?))
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

    /// The glossy bounce as printed, corrected, by our closed form and by our quadrature, and the truth.
    fn methods(&self) -> Result<Tiles, SheetError> {
        let methods =
            [Method::RectPaper, Method::Rect, Method::RectLaplace, Method::RectQuadrature, Method::Reference];
        let layer = "indirect_specular_fromspec_novis";
        let row = |name: &str| methods.into_iter().map(|method| self.tile(name, method, layer)).collect();
        Ok(Tiles::new("methods", rows(&["cornell_L0", "cornell_L1", "plates_a010"], row)?))
    }

    /// All light of one bounce by 1024 point lights, lights with Gaussian lobes and lights with GGX lobes, and the truth.
    fn virtual_lights(&self) -> Result<Tiles, SheetError> {
        let methods = [Method::Vpl, Method::Vsgl, Method::VslWide, Method::Reference];
        let layer = "indirect_total_la";
        let row = |name: &str| methods.into_iter().map(|method| self.tile(name, method, layer)).collect();
        Ok(Tiles::new("virtual_lights", rows(&["caustic_a005", "cornell_L1", "plates_a005"], row)?))
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
    Sheet { name: tiles.name, size, pixels: colours.flat_map(shown).collect(), notes: tiles.notes.clone() }
}
