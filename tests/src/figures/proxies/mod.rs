//! Drawings of proxies over their mesh, from the scene's camera.
//!
//! The mesh is grey, by the cosine at which it is seen; a rectangle tints what lies at or behind it, and the page where
//! there is nothing (`tint.rs`). Outlines and normals are strokes over that, dashed where the mesh hides them
//! (`marks.rs`), so that the drawing is a picture or an SVG file.

mod colour;
mod marks;
mod shapes;
mod tint;
mod view;

use crate::proxies::{self, Options, Proxies};
use crate::scene::{Choices, Scene};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use std::path::Path;
use view::View;

use super::sheets::SheetError;

/// Pixels along the longer side of a drawing, unless its size is given.
const LONGER: f64 = 960.0;
/// Pixels along each side of the drawings of a sheet.
const SIDE: u32 = 320;
/// Halvings of space of the vase and the bush.
const PARTITION: u32 = 4;

/// A drawing: what is grey or tinted as pixels, and strokes over it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Drawing {
    /// Columns and rows.
    pub size: [u32; 2],
    /// 8-bit RGB, row by row.
    pub ground: Vec<u8>,
    /// Elements of SVG, a unit a pixel.
    marks: String,
}

impl Drawing {
    /// Draws `proxies` over the surfaces of `scene`, which they stand for.
    ///
    /// `size` is columns and rows, each at least 1; without it the picture has the camera's shape, and its longer side
    /// 960 pixels.
    #[must_use]
    pub fn new(scene: &Scene, proxies: &Proxies, size: Option<[u32; 2]>) -> Self {
        let size = size.unwrap_or_else(|| enlarged(scene.camera.size));
        let view = View::new(scene, size);
        let ground = tint::ground(&view, &proxies.rectangles);
        Self { size, ground, marks: marks::marks(&view, &proxies.rectangles) }
    }

    /// The strokes alone, as an SVG file of the drawing's size without a background.
    #[must_use]
    pub fn strokes(&self) -> String {
        self.document("")
    }

    /// The whole as an SVG file, in which `ground` is: the drawing's pixels as a PNG file.
    #[must_use]
    pub fn svg(&self, ground: &[u8]) -> String {
        let [width, height] = self.size;
        let data = STANDARD.encode(ground);
        self.document(&format!(
            "<image width=\"{width}\" height=\"{height}\" href=\"data:image/png;base64,{data}\"/>\n"
        ))
    }

    fn document(&self, ground: &str) -> String {
        let ([width, height], marks) = (self.size, &self.marks);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"0 0 {width} {height}\">\n{ground}{marks}</svg>\n"
        )
    }
}

/// The shape of a camera's picture at the size of drawings.
fn enlarged([width, height]: [u32; 2]) -> [u32; 2] {
    let scale = LONGER / f64::from(width.max(height));
    [width, height].map(|side| ((f64::from(side) * scale).round() as u32).max(1))
}

/// The drawings of the sheet `proxies`: the room of the tests in `folder`; a vase of 12288 triangles under a bush of 900
/// leaves, by regions, and by a partition of space.
///
/// # Errors
/// When a scene is not as it should be.
pub fn drawings(folder: &Path) -> Result<Vec<Drawing>, SheetError> {
    let name = "room.gltf";
    let told = |reason: String| SheetError::Scene { name: name.to_owned(), reason };
    let room = Scene::open(&folder.join(name), &Choices::default()).map_err(|e| told(e.to_string()))?;
    let vase = shapes::vase_and_bush()?;
    let partition = Options { partition: Some(PARTITION), ..Options::default() };
    [(&room, Options::default()), (&vase, Options::default()), (&vase, partition)]
        .into_iter()
        .map(|(scene, options)| {
            let told = |reason: String| SheetError::Scene { name: scene.name.clone(), reason };
            let found = proxies::proxies(scene, &options).map_err(|e| told(e.to_string()))?;
            Ok(Drawing::new(scene, &found, Some([SIDE; 2])))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The room of the tests, with its plate or without.
    fn drawn(with_plate: bool, with_proxies: bool) -> Drawing {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/scenes");
        let mut scene = Scene::open(&folder.join("room.gltf"), &Choices::default()).unwrap();
        scene.triangles.retain(|triangle| with_plate || !triangle.two_sided);
        let mut found = proxies::proxies(&scene, &Options::default()).unwrap();
        found.rectangles.retain(|_| with_proxies);
        Drawing::new(&scene, &found, Some([64, 48]))
    }

    #[test]
    fn what_the_mesh_hides_is_dashed() {
        let dashes = |drawing: &Drawing| drawing.strokes().matches("stroke-dasharray").count();
        // The edge of the back wall and the floor, and the normal of the wall, are behind the plate.
        assert_eq!(dashes(&drawn(true, true)), 2);
        assert_eq!(dashes(&drawn(false, true)), 0);
        assert_eq!(drawn(true, true).strokes().matches("<g ").count(), 5);
    }

    #[test]
    fn rectangles_tint_the_mesh_and_not_the_page() {
        let colourful = |drawing: &Drawing| {
            let pixels = drawing.ground.chunks_exact(3);
            pixels.filter(|p| p.iter().max() > p.iter().min()).count()
        };
        let (tinted, grey) = (drawn(true, true), drawn(true, false));
        assert_eq!((&tinted.ground[..3], colourful(&grey)), (&[255; 3][..], 0));
        let of_mesh = grey.ground.chunks_exact(3).filter(|p| p[0] < 255).count();
        assert!(of_mesh > 1000 && colourful(&tinted).abs_diff(of_mesh) <= 100, "{of_mesh}");
    }

    #[test]
    fn a_drawing_has_the_shape_of_its_camera() {
        assert_eq!([[256, 256], [128, 64], [3, 4000]].map(enlarged), [[960, 960], [960, 480], [1, 960]]);
        let svg = drawn(true, true).svg(b"png");
        assert!(svg.contains("width=\"64\" height=\"48\"") && svg.contains("base64,cG5n"), "{svg}");
    }
}
