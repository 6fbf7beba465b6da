//! FLIP: the difference that somebody sees who is shown one picture and then, in its place, the other.
//!
//! - P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild, "FLIP: A Difference
//!   Evaluator for Alternating Images", HPG 2020.
//! - P. Andersson, J. Nilsson, P. Shirley, T. Akenine-Möller,
//!   "Visualizing Errors in Rendered High Dynamic Range Images", Eurographics 2021 (short papers).
//!
//! Each map has a number in 0 ..= 1 for each pixel, 0 where nothing is seen. `tests/cases/metrics` holds figures of the
//! authors' own program, which [`ldr`] and [`hdr`] must meet.

mod colour;
mod exposure;
mod features;
mod filter;

pub use exposure::{Exposures, ToneMap, exposures};

use super::{Map, Pair};
use colour::{Colours, hunt_adjusted, hyab};
use features::Features;
use filter::{Contrast, GRAIN, Plane};
use lobe_codegen::glam::Vec3;
use rayon::prelude::*;

/// Pixels in a degree of the eye's angle: a screen 0.7 m wide of 3840 columns, seen from 0.7 m.
pub const PIXELS_PER_DEGREE: f32 = 67.020_64;

/// The exponent of a colour difference.
const COLOUR_POWER: f32 = 0.7;
/// A difference of so large a share of the largest ..
const KNEE: f32 = 0.4;
/// .. is mapped to so much.
const KNEE_VALUE: f32 = 0.95;

/// FLIP of pictures that a screen shows as they are, linear RGB in 0 ..= 1; what is beyond is clipped.
#[must_use]
pub fn ldr(pair: &Pair<'_>, pixels_per_degree: f32) -> Map {
    let eye = Eye::new(pixels_per_degree);
    let shown = |pixels: &[Vec3]| pixels.iter().map(|p| p.clamp(Vec3::ZERO, Vec3::ONE)).collect::<Vec<_>>();
    let values = eye.compare(pair.size(), &shown(pair.picture()), &shown(pair.truth()));
    Map { size: pair.size(), values }
}

/// FLIP of pictures of any range: the largest of [`ldr`]'s over `exposures`, by which both are brightened before `tone_map`.
/// Negative values count as 0.
#[must_use]
pub fn hdr(pair: &Pair<'_>, pixels_per_degree: f32, tone_map: ToneMap, exposures: &Exposures) -> Map {
    let eye = Eye::new(pixels_per_degree);
    let mut values = vec![0.0_f32; pair.truth().len()];
    for stops in exposures.stops() {
        let shown = |pixels: &[Vec3]| pixels.iter().map(|p| tone_map.shown(*p, stops)).collect::<Vec<_>>();
        let here = eye.compare(pair.size(), &shown(pair.picture()), &shown(pair.truth()));
        values.iter_mut().zip(here).for_each(|(most, here)| *most = most.max(here));
    }
    Map { size: pair.size(), values }
}

/// What somebody sees at a distance from the screen.
struct Eye {
    colours: Colours,
    contrast: Contrast,
    features: Features,
    /// The colour difference that all are measured by: that of green and blue.
    largest: f32,
}

impl Eye {
    fn new(pixels_per_degree: f32) -> Self {
        let colours = Colours::default();
        let [green, blue] = [Vec3::Y, Vec3::Z].map(|rgb| hunt_adjusted(colours.lab(rgb)));
        let largest = hyab(green, blue).powf(COLOUR_POWER);
        let (contrast, features) = (Contrast::new(pixels_per_degree), Features::new(pixels_per_degree));
        Self { colours, contrast, features, largest }
    }

    /// The map of two pictures in 0 ..= 1.
    fn compare(&self, size: [u32; 2], picture: &[Vec3], truth: &[Vec3]) -> Vec<f32> {
        let width = size[0] as usize;
        let [picture, truth] = [picture, truth].map(|pixels| {
            let opponent = self.opponent(width, pixels);
            let features = self.features.of(&opponent[0].map(|lightness| (lightness + 16.0) / 116.0));
            (self.seen(&opponent), features)
        });
        (0..truth.0.len())
            .into_par_iter()
            .with_min_len(GRAIN)
            .map(|i| {
                let colour = self.colour_error(picture.0[i], truth.0[i]);
                let feature = features::error(picture.1[i], truth.1[i]);
                colour.powf(1.0 - feature)
            })
            .collect()
    }

    /// Lightness and two opponent colours, a plane each.
    fn opponent(&self, width: usize, pixels: &[Vec3]) -> [Plane; 3] {
        let colours: Vec<Vec3> = pixels.iter().map(|rgb| self.colours.opponent(*rgb)).collect();
        [0, 1, 2].map(|channel| Plane::new(width, colours.iter().map(|c| c[channel]).collect()))
    }

    /// The colours that are left when the eye cannot tell neighbours apart, perceptually uniform.
    fn seen(&self, opponent: &[Plane; 3]) -> Vec<Vec3> {
        let [lightness, red_green, blue_yellow] = self.contrast.filtered(opponent);
        let one = |i: usize| Vec3::new(lightness.values[i], red_green.values[i], blue_yellow.values[i]);
        (0..lightness.values.len())
            .into_par_iter()
            .with_min_len(GRAIN)
            .map(|i| {
                let rgb = self.colours.rgb_of_opponent(one(i)).clamp(Vec3::ZERO, Vec3::ONE);
                hunt_adjusted(self.colours.lab(rgb))
            })
            .collect()
    }

    /// The difference of two colours in 0 ..= 1 (Andersson et al. 2020): large ones are compressed, since beyond some
    /// difference all are seen alike.
    fn colour_error(&self, a: Vec3, b: Vec3) -> f32 {
        let error = hyab(a, b).powf(COLOUR_POWER);
        let knee = KNEE * self.largest;
        if error < knee {
            return KNEE_VALUE / knee * error;
        }
        (KNEE_VALUE + (error - knee) / (self.largest - knee) * (1.0 - KNEE_VALUE)).min(1.0)
    }
}
