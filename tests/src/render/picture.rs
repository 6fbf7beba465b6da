//! What a renderer returns: a picture in layers.

use lobe_codegen::glam::Vec3;

/// A layer: linear RGB, row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Its name, of those in `tests/SCENES.md`.
    pub name: String,
    /// A colour for each pixel.
    pub pixels: Vec<Vec3>,
}

/// A picture: radiance, and the layers that it is the sum of, or that say something of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Columns and rows.
    pub size: [u32; 2],
    /// All light that the method finds, in W/m²/sr.
    pub radiance: Vec<Vec3>,
    /// Its components.
    pub layers: Vec<Layer>,
}

impl Picture {
    /// The layer of this name.
    #[must_use]
    pub fn layer(&self, name: &str) -> Option<&[Vec3]> {
        self.layers.iter().find(|layer| layer.name == name).map(|layer| layer.pixels.as_slice())
    }

    /// Whether every value is finite and at least 0.
    #[must_use]
    pub fn is_sound(&self) -> bool {
        let layers = self.layers.iter().map(|layer| &layer.pixels).chain([&self.radiance]);
        layers.flatten().all(|pixel| pixel.is_finite() && pixel.min_element() >= 0.0)
    }
}

/// The sum of two layers' pixels.
#[must_use]
pub(super) fn sum(a: &[Vec3], b: &[Vec3]) -> Vec<Vec3> {
    a.iter().zip(b).map(|(a, b)| *a + *b).collect()
}
