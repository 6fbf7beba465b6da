//! Pictures of the rectangle methods beside the truth, as sheets of small pictures.
//!
//! Neither the methods nor the truth beside them know of occlusion between surfaces; direct light has its shadows.

use crate::proxies::{self, Options};
use crate::render::{Method, Picture, Renderer, Settings, encoded};
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

/// All sheets, of the scenes in `folder`.
///
/// `rectangles`: the box under four lights; direct light, one bounce onto diffuse and onto glossy lobes by
/// [`Method::RectLaplace`], their sum, the truth of that, and the difference (red: too bright, blue: too dark).
/// `methods`: the glossy bounce as printed, corrected, by ours with one spot and with two, and the truth.
///
/// # Errors
/// When a scene or the interpreter is not as it should be.
pub fn sheets(folder: &Path) -> Result<Vec<Sheet>, SheetError> {
    let artist = Artist { renderer: Renderer::new()?, folder };
    let lights = ["cornell_L0", "cornell_L1", "cornell_L2", "cornell_L3"];
    let rows: Vec<Vec<Tile>> = lights.iter().map(|name| artist.bounces(name)).collect::<Result<_, _>>()?;
    let scenes = ["cornell_L0", "cornell_L1", "plates_a010"];
    let methods: Vec<Vec<Tile>> = scenes.iter().map(|name| artist.methods(name)).collect::<Result<_, _>>()?;
    Ok(vec![sheet("rectangles", &rows), sheet("methods", &methods)])
}

struct Artist<'a> {
    renderer: Renderer,
    folder: &'a Path,
}

impl Artist<'_> {
    fn picture(&self, name: &str, method: Method) -> Result<Picture, SheetError> {
        let told = |reason: String| SheetError::Scene { name: name.to_owned(), reason };
        let path = self.folder.join(format!("{name}.json"));
        let scene = Scene::open(&path, &Choices::default()).map_err(|e| told(e.to_string()))?;
        let proxies = proxies::proxies(&scene, &Options::default()).map_err(|e| told(e.to_string()))?;
        let settings = Settings { method, samples: SAMPLES, ..Settings::default() };
        Ok(self.renderer.render(&scene, &proxies, &settings, &mut Interpreted::default(), &|_| {})?)
    }

    fn bounces(&self, name: &str) -> Result<Vec<Tile>, SheetError> {
        let ours = self.picture(name, Method::RectLaplace)?;
        let truth = self.picture(name, Method::Reference)?;
        let parts = ["direct_vis", "indirect_diffuse_novis", "indirect_specular_fromspec_novis"];
        let total = |picture: &Picture| {
            parts.iter().map(|part| tile(picture, part)).reduce(added).unwrap_or_default()
        };
        let (ours_total, truth_total) = (total(&ours), total(&truth));
        let difference = ours_total.iter().zip(&truth_total).map(|(a, b)| signed(*a - *b)).collect();
        let shown = parts.iter().map(|part| tile(&ours, part));
        Ok(shown.chain([ours_total, truth_total, difference]).collect())
    }

    fn methods(&self, name: &str) -> Result<Vec<Tile>, SheetError> {
        let methods = [
            Method::RectPaper,
            Method::Rect,
            Method::RectLaplaceSingle,
            Method::RectLaplace,
            Method::Reference,
        ];
        let shown = |method| Ok(tile(&self.picture(name, method)?, "indirect_specular_fromspec_novis"));
        methods.into_iter().map(shown).collect()
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
fn sheet(name: &'static str, rows: &[Vec<Tile>]) -> Sheet {
    let side = rows.first().and_then(|row| row.first()).map_or(0, |tile| tile.len().isqrt());
    let across = rows.first().map_or(0, Vec::len);
    let line = |row: &Vec<Tile>, y: usize| -> Vec<Vec3> {
        row.iter().flat_map(|tile| tile[y * side..(y + 1) * side].to_vec()).collect()
    };
    let colours = rows.iter().flat_map(|row| (0..side).flat_map(move |y| line(row, y)));
    let pixels = colours.flat_map(|colour| (EXPOSURE * colour).to_array().map(encoded)).collect();
    Sheet { name, size: [(side * across) as u32, (side * rows.len()) as u32], pixels }
}
