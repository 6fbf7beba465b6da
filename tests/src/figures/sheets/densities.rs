//! By what the texels of a light's map are drawn, beside what they send to the camera.
//!
//! What each texel sends to each pixel is computed for all pairs. A density that is in proportion to its sum over the pixels
//! is without variance in the picture's mean; one in proportion to the root of its sum of squares has the least in the pixels.

use super::{Artist, Row, SheetError, Tile, Tiles};
use crate::render::{Density, Settings, Survey, VirtualLights};
use lobe_backends::pipeline::Interpreted;
use lobe_codegen::glam::Vec3;
use lobe_kernels::rsm::density::{parts_luminance, receiver_of_point};
use lobe_kernels::rsm::light::vpl_light;
use lobe_kernels::rsm::point::MapPoint;
use lobe_kernels::scene::NOWHERE;
use rayon::prelude::*;

/// Texels along a side of the map.
const MAP: u32 = 128;
/// Pixels along a side of the picture.
const SIDE: u32 = 64;
/// By what a density of mean 1 is multiplied.
const SCALE: f32 = 0.08;
/// Share by power alone, of what is drawn and of what is measured besides.
const FLOORS: [f32; 2] = [0.05, 0.5];
/// Lights whose error is computed.
const LIGHTS: f64 = 1024.0;
/// Texels that are summed at once.
const CHUNK: usize = 256;

impl Artist<'_> {
    /// A light's map, the densities by power, by points and by lights with extent, and what the texels send.
    pub(super) fn densities(&self) -> Result<Tiles, SheetError> {
        let mut tiles = Tiles::new("densities", Vec::new());
        for name in ["caustic_a005", "cornell_L1"] {
            let (row, notes) = self.densities_of(name)?;
            tiles.rows.push(row);
            tiles.notes.extend(notes);
        }
        Ok(tiles)
    }

    fn densities_of(&self, name: &str) -> Result<(Row, Vec<String>), SheetError> {
        let densities = [Density::Power, Density::Vpl, Density::Vsgl];
        let surveyed = |floor| -> Result<Vec<Survey>, SheetError> {
            densities.iter().map(|density| self.survey(name, *density, floor)).collect()
        };
        let [surveys, mixed] = FLOORS.map(surveyed);
        let (surveys, mixed) = (surveys?, mixed?);
        let Some(first) = surveys.first() else { return Ok((Row::new(), Vec::new())) };
        let mut row: Row = vec![Some(first.texels.iter().map(seen).collect())];
        row.extend(surveys.iter().map(|survey| Some(grey(&survey.shares))));
        if !self.with_truth {
            row.push(None);
            return Ok((row, Vec::new()));
        }
        let sent = Sent::new(first);
        let (mean, pixels) = (shares(&sent.sums), shares(&sent.roots()));
        row.push(Some(grey(&mean)));
        let named = |floor: f32, surveys: &[Survey]| -> Vec<(String, Vec<f32>)> {
            let each = densities.iter().zip(surveys);
            each.map(|(density, survey)| (format!("{density}, {floor} by power"), survey.shares.clone()))
                .collect()
        };
        let ideal = [("the sum".to_owned(), mean), ("the root of the squares".to_owned(), pixels)];
        let all = [named(FLOORS[0], &surveys), named(FLOORS[1], &mixed), ideal.to_vec()].concat();
        let note = |(by, shares): &(String, Vec<f32>)| {
            let (chi, error) = (sent.chi_square(shares), sent.error(shares));
            format!("{name}, {by}: chi-square {chi:.3}, relative RMSE of {LIGHTS} points {error:.3}")
        };
        Ok((row, all.iter().map(note).collect()))
    }

    fn survey(&self, name: &str, density: Density, floor_share: f32) -> Result<Survey, SheetError> {
        let (mut scene, proxies) = self.scene(name)?;
        scene.camera.size = [SIDE; 2];
        let virtual_lights = VirtualLights { map: MAP, density, floor_share, ..VirtualLights::default() };
        let settings = Settings { virtual_lights, ..Settings::default() };
        Ok(self.renderer.survey(&scene, &proxies, &settings, &mut Interpreted::default())?)
    }
}

/// What is seen in a texel, as if lit from where it is seen.
fn seen(texel: &MapPoint) -> Vec3 {
    let colour = texel.material.diffuse_albedo + texel.material.f0;
    if texel.flux == Vec3::ZERO { Vec3::ZERO } else { 0.5 * texel.normal.dot(texel.dir).max(0.0) * colour }
}

fn grey(shares: &[f32]) -> Tile {
    let all = shares.len() as f32;
    shares.iter().map(|share| Vec3::splat((SCALE * all * share).min(1.0))).collect()
}

/// Values over their sum.
fn shares(values: &[f64]) -> Vec<f32> {
    let sum: f64 = values.iter().sum();
    values.iter().map(|value| (value / sum.max(f64::MIN_POSITIVE)) as f32).collect()
}

/// What all texels send to all pixels, as luminance.
struct Sent {
    /// Of each texel, the sum over the pixels.
    sums: Vec<f64>,
    /// The sum of the squares.
    squares: Vec<f64>,
    /// Of each pixel, the sum over the texels.
    pixels: Vec<f64>,
}

impl Sent {
    fn new(survey: &Survey) -> Self {
        let chunks: Vec<Self> =
            survey.texels.par_chunks(CHUNK).map(|texels| Self::of(texels, &survey.pixels)).collect();
        let nothing =
            || Self { sums: Vec::new(), squares: Vec::new(), pixels: vec![0.0; survey.pixels.len()] };
        chunks.into_iter().fold(nothing(), |mut all, chunk| {
            all.sums.extend(chunk.sums);
            all.squares.extend(chunk.squares);
            all.pixels.iter_mut().zip(chunk.pixels).for_each(|(sum, part)| *sum += part);
            all
        })
    }

    fn of(texels: &[MapPoint], pixels: &[MapPoint]) -> Self {
        let mut sent = Self {
            sums: vec![0.0; texels.len()],
            squares: vec![0.0; texels.len()],
            pixels: vec![0.0; pixels.len()],
        };
        for (at, texel) in texels.iter().enumerate().filter(|(_, texel)| texel.surface != NOWHERE) {
            let lit = pixels.iter().enumerate().filter(|(_, pixel)| pixel.surface != NOWHERE);
            for (to, pixel) in lit {
                let parts = vpl_light(receiver_of_point(*pixel), *texel, 1.0, 0.0);
                let value = f64::from(parts_luminance(parts));
                sent.sums[at] += value;
                sent.squares[at] += value * value;
                sent.pixels[to] += value;
            }
        }
        sent
    }

    fn roots(&self) -> Vec<f64> {
        self.squares.iter().map(|square| square.sqrt()).collect()
    }

    /// Relative variance of the picture's mean by one texel that is drawn.
    fn chi_square(&self, shares: &[f32]) -> f64 {
        let all: f64 = self.sums.iter().sum();
        over(&self.sums.iter().map(|sum| (sum / all).powi(2)).collect::<Vec<_>>(), shares) - 1.0
    }

    /// Relative RMSE of the pixels by texels that are drawn one by one.
    fn error(&self, shares: &[f32]) -> f64 {
        let squares: f64 = self.pixels.iter().map(|pixel| pixel * pixel).sum();
        let mean = self.pixels.iter().sum::<f64>() / self.pixels.len() as f64;
        let variance = (over(&self.squares, shares) - squares) / self.pixels.len() as f64;
        (variance / LIGHTS).sqrt() / mean
    }
}

/// The sum of values over shares, of those that are above 0.
fn over(values: &[f64], shares: &[f32]) -> f64 {
    let each = values.iter().zip(shares).filter(|(value, _)| **value > 0.0);
    each.map(|(value, share)| value / f64::from(*share)).sum()
}
