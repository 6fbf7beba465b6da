//! How much light there is, and how far off.

use super::Pair;
use lobe_codegen::glam::{DVec3, Vec3};
use lobe_kernels::reference::running_mean::luminance;
use serde::{Deserialize, Serialize};

/// Differences of linear values.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Radiometry {
    /// Mean luminance of the picture over that of the truth; none where the truth is black.
    pub mean_ratio: Option<f64>,
    /// Root of the mean squared difference of the luminances, over the truth's mean; none where the truth is black.
    pub relative_rmse: Option<f64>,
    /// Where they differ most.
    pub worst: Worst,
}

/// The pixel with the largest difference, by its length in linear RGB; the first of several.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Worst {
    /// Column, from the left.
    pub x: u32,
    /// Row, from the top.
    pub y: u32,
    /// Linear RGB of the picture there.
    pub picture: [f32; 3],
    /// That of the truth.
    pub truth: [f32; 3],
}

/// The differences of a pair.
#[must_use]
pub fn radiometry(pair: &Pair<'_>) -> Radiometry {
    let count = pair.truth().len() as f64;
    let mean = |pixels: &[Vec3]| pixels.iter().map(|p| f64::from(luminance(*p))).sum::<f64>() / count;
    let pixels = || pair.picture().iter().zip(pair.truth());
    let gap = |p: Vec3, t: Vec3| f64::from(luminance(p)) - f64::from(luminance(t));
    let squares: f64 = pixels().map(|(p, t)| gap(*p, *t).powi(2)).sum();
    let wanted = mean(pair.truth());
    let over = |value: f64| (wanted > 0.0).then(|| value / wanted).filter(|ratio| ratio.is_finite());
    Radiometry {
        mean_ratio: over(mean(pair.picture())),
        relative_rmse: over((squares / count).sqrt()),
        worst: worst(pair),
    }
}

fn worst(pair: &Pair<'_>) -> Worst {
    let apart = |at: usize| {
        let [p, t]: [DVec3; 2] = [pair.picture()[at].as_dvec3(), pair.truth()[at].as_dvec3()];
        (p - t).length()
    };
    let at = (1..pair.truth().len()).fold(0, |worst, at| if apart(at) > apart(worst) { at } else { worst });
    let [x, y] = pair.place(at);
    Worst { x, y, picture: pair.picture()[at].to_array(), truth: pair.truth()[at].to_array() }
}
