//! Flicker: what a method adds to the change of a picture while the light turns.
//!
//! A pixel's second difference in time, `d = L(t + 1) - 2 L(t) + L(t - 1)`, is 0 where its light changes evenly, and of noise
//! that is another in each picture its mean square is six times the variance. So `d²/6` is the variance of what flickers, and
//! needs no truth of each picture, whose own noise would have to be far below that of the best method. The variance about a
//! pixel's mean in time stands beside it: it has the light's motion in it, and of [`Method::Reference`], which draws the same
//! numbers for each picture, little else.

mod plot;
mod turn;

pub use plot::plot;
pub use turn::{Turn, turned};

use crate::proxies::Proxies;
use crate::render::{Method, Picture, Renderer, Settings, Visibility};
use crate::scene::Scene;
use lobe_backends::executor::ExecError;
use lobe_backends::pipeline::Dispatcher;
use lobe_codegen::glam::Vec3;
use lobe_kernels::reference::running_mean::luminance;

/// Quantiles that are kept of the pixels, but one.
const QUANTILES: usize = 64;
/// Which pixel is shown: the one that flickers more by the first method than this share of all.
const SHOWN: f64 = 0.9;

/// How a method flickers in a scene.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Flicker {
    /// The scene.
    pub scene: String,
    /// The method.
    pub method: String,
    /// The route.
    pub route: String,
    /// Columns and rows.
    pub size: [u32; 2],
    /// Virtual lights.
    pub lights: u32,
    /// By how much the light turns from picture to picture, in degrees.
    pub degrees: f64,
    /// Pictures.
    pub pictures: usize,
    /// Mean luminance of the light of one bounce, over pixels and pictures.
    pub mean: f64,
    /// Mean over the pixels of the mean of `d²/6`, over the squared mean luminance.
    pub flicker: f64,
    /// That over the first method's.
    pub flicker_ratio: Option<f64>,
    /// Mean over the pixels of the variance about their means in time, over the squared mean luminance.
    pub variance: f64,
    /// That over the first method's.
    pub variance_ratio: Option<f64>,
    /// Of the pixels, from the least to the largest in equal steps, the root of the mean of `d²/6` over the mean luminance.
    pub deviations: Vec<f64>,
    /// Column and row of the pixel that is shown.
    pub pixel: [u32; 2],
    /// Its luminance in each picture.
    pub series: Vec<f64>,
}

/// What is filmed.
#[derive(Debug, Clone, Copy)]
pub struct Take<'a> {
    /// The scene's name.
    pub name: &'a str,
    /// The scene.
    pub scene: &'a Scene,
    /// Its rectangles.
    pub proxies: &'a Proxies,
    /// How its lights turn.
    pub turn: Turn,
}

/// Luminance of the light of one bounce: each picture's pixels.
type Film = Vec<Vec<f64>>;

/// The flicker of `methods`, by `settings` but for the method; `progress` is told which share of the pictures is there.
///
/// # Errors
/// When a pass cannot be run by `dispatcher`.
pub fn flicker<'p>(
    renderer: &'p Renderer,
    take: Take<'_>,
    methods: &[Method],
    settings: &Settings,
    dispatcher: &mut dyn Dispatcher<'p>,
    progress: &dyn Fn(f32),
) -> Result<Vec<Flicker>, ExecError> {
    let mut found: Vec<Flicker> = Vec::with_capacity(methods.len());
    let mut shown = None;
    for (at, method) in methods.iter().enumerate() {
        let settings = Settings { method: *method, ..*settings };
        let done = |share: f32| progress((at as f32 + share) / methods.len() as f32);
        let film = film(renderer, take, &settings, dispatcher, &done)?;
        let noise = each(&film, |series| second_differences(series) / 6.0);
        let pixel = *shown.get_or_insert_with(|| ranked(&noise)[rank(SHOWN, noise.len())]);
        let mut own = measured(take, &settings, &film, &noise, pixel);
        own.route = dispatcher.route().to_string();
        let first = found.first().unwrap_or(&own);
        let ratio = |value: f64, other: f64| (other > 0.0).then(|| value / other);
        let ratios = (ratio(own.flicker, first.flicker), ratio(own.variance, first.variance));
        (own.flicker_ratio, own.variance_ratio) = ratios;
        found.push(own);
    }
    Ok(found)
}

/// The first `pictures` pictures of a pixel by a method: its luminance in each.
///
/// # Errors
/// As of [`flicker`].
pub fn series<'p>(
    renderer: &'p Renderer,
    take: Take<'_>,
    settings: &Settings,
    pixel: [u32; 2],
    dispatcher: &mut dyn Dispatcher<'p>,
) -> Result<Vec<f64>, ExecError> {
    let film = film(renderer, take, settings, dispatcher, &|_| {})?;
    let [width, _] = take.scene.camera.size;
    let at = (pixel[1] * width + pixel[0]) as usize;
    Ok(film.iter().map(|picture| picture[at]).collect())
}

fn film<'p>(
    renderer: &'p Renderer,
    take: Take<'_>,
    settings: &Settings,
    dispatcher: &mut dyn Dispatcher<'p>,
    progress: &dyn Fn(f32),
) -> Result<Film, ExecError> {
    let count = take.turn.pictures;
    let mut film = Film::with_capacity(count);
    for at in 0..count {
        let scene = turned(take.scene, take.turn.degrees * at as f64);
        let done = |share: f32| progress((at as f32 + share) / count as f32);
        film.push(indirect(&renderer.render(&scene, take.proxies, settings, dispatcher, &done)?, settings));
    }
    Ok(film)
}

/// Luminance of the light of one bounce.
fn indirect(picture: &Picture, settings: &Settings) -> Vec<f64> {
    let of = |colour: Vec3| f64::from(luminance(colour));
    let layer = if settings.virtual_lights.visibility != Visibility::None {
        "indirect_total_vis"
    } else {
        "indirect_total_la"
    };
    if let Some(pixels) = picture.layer(layer) {
        return pixels.iter().map(|pixel| of(*pixel)).collect();
    }
    // Methods of rectangles have no such layer.
    let direct = picture.layer("direct_vis").unwrap_or_default();
    picture.radiance.iter().zip(direct).map(|(all, direct)| of(*all - *direct)).collect()
}

/// What `of` makes of each pixel's series.
fn each(film: &Film, of: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    let pixels = film.first().map_or(0, Vec::len);
    (0..pixels).map(|at| of(&film.iter().map(|picture| picture[at]).collect::<Vec<_>>())).collect()
}

/// Mean square of the second differences; 0 of less than three values.
fn second_differences(series: &[f64]) -> f64 {
    mean(series.windows(3).map(|w| (w[2] - 2.0 * w[1] + w[0]).powi(2)))
}

fn variance(series: &[f64]) -> f64 {
    let middle = mean(series.iter().copied());
    mean(series.iter().map(|value| (value - middle).powi(2)))
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len().max(1) as f64;
    values.sum::<f64>() / count
}

/// Indices of values from the least to the largest.
fn ranked(values: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..values.len()).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    order
}

fn rank(share: f64, count: usize) -> usize {
    (share * count.saturating_sub(1) as f64).round() as usize
}

fn measured(take: Take<'_>, settings: &Settings, film: &Film, noise: &[f64], pixel: usize) -> Flicker {
    let size = take.scene.camera.size;
    let average = mean(film.iter().map(|picture| mean(picture.iter().copied())));
    let square = (average * average).max(f64::MIN_POSITIVE);
    let order = ranked(noise);
    let quantile = |at: usize| noise[order[rank(at as f64 / QUANTILES as f64, order.len())]];
    Flicker {
        scene: take.name.to_owned(),
        method: settings.method.name().to_owned(),
        route: String::new(),
        size,
        lights: settings.virtual_lights.count,
        degrees: take.turn.degrees,
        pictures: film.len(),
        mean: average,
        flicker: mean(noise.iter().copied()) / square,
        flicker_ratio: None,
        variance: mean(each(film, variance).into_iter()) / square,
        variance_ratio: None,
        deviations: (0..=QUANTILES).map(|at| (quantile(at) / square).sqrt()).collect(),
        pixel: [pixel as u32 % size[0], pixel as u32 / size[0]],
        series: film.iter().map(|picture| picture[pixel]).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lobe_kernels::reference::random::random_pair;

    #[test]
    fn even_change_is_no_flicker() {
        assert_eq!(second_differences(&[1.0, 3.0, 5.0, 7.0]), 0.0);
        assert!(variance(&[1.0, 3.0, 5.0, 7.0]) == 5.0);
    }

    /// The mean squared second difference of independent values is six times their variance.
    #[test]
    fn noise_counts_by_its_variance() {
        let noise: Vec<f64> = (0..100_000).map(|at| f64::from(random_pair(at, 0, 0).x)).collect();
        let ratio = second_differences(&noise) / 6.0 / variance(&noise);
        assert!((ratio - 1.0).abs() < 0.02, "{ratio}");
    }
}
