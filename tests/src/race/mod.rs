//! Methods of rendering against each other: what they cost, and how far they are from the truth, in one run on one route.
//!
//! The layer that counts is the glossy light of glossy surfaces without occlusion, which all methods of rectangles have.
//! Sampling runs beside them with ever more samples, so that its time at the error of each method is known.

mod clock;
mod plot;

pub use plot::plot;

use crate::proxies::Proxies;
use crate::render::{Method, Picture, Renderer, Settings};
use crate::scene::Scene;
use crate::throughput::{median, order};
use clock::Clock;
use lobe_backends::executor::ExecError;
use lobe_backends::pipeline::{Dispatcher, Interpreted};
use lobe_codegen::glam::Vec3;

/// The layer that is compared.
const LAYER: &str = "indirect_specular_fromspec_novis";
/// Samples a pixel of the runners that take samples.
pub const LADDER: [u32; 4] = [4, 16, 64, 256];

/// How a race is held.
#[derive(Debug, Clone, Copy)]
pub struct Rules {
    /// Rounds in which everyone runs once, after one that is not counted.
    pub rounds: usize,
    /// Samples a pixel of the truth: many times the most of [`LADDER`], or sampling seems too good.
    pub truth: u32,
}

/// A scene and what stands in its place.
#[derive(Debug, Clone, Copy)]
pub struct Course<'a> {
    /// Its name.
    pub name: &'a str,
    /// The scene.
    pub scene: &'a Scene,
    /// Its rectangles.
    pub proxies: &'a Proxies,
}

/// What a method did.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Effort {
    /// The scene.
    pub scene: String,
    /// The route.
    pub route: String,
    /// The method.
    pub method: &'static str,
    /// Samples a pixel, of the reference.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub samples: Option<u32>,
    /// Pixels of the picture.
    pub pixels: usize,
    /// Rectangles, each of which every pixel sums for each light.
    pub rectangles: usize,
    /// Lights.
    pub lights: usize,
    /// Rounds.
    pub rounds: usize,
    /// Median time of the passes that find the light of one bounce, with their buffers' way to the driver and back.
    pub seconds: f64,
    /// That a pixel, rectangle and light.
    pub nanoseconds: f64,
    /// Mean of the picture over that of the truth.
    pub mean_ratio: f64,
    /// Root of the mean squared error over the truth's mean.
    pub relative_rmse: f64,
    /// How many times as long sampling takes to the same error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sampling_ratio: Option<f64>,
}

/// Who runs.
#[derive(Debug, Clone, Copy)]
struct Runner {
    method: Method,
    samples: Option<u32>,
}

impl Runner {
    fn all() -> Vec<Self> {
        let methods = Method::ALL.into_iter().filter(|method| method.rect_pass().is_some());
        let rectangles = methods.map(|method| Self { method, samples: None });
        let sampling = LADDER.map(|samples| Self { method: Method::Reference, samples: Some(samples) });
        rectangles.chain(sampling).collect()
    }

    /// Whether a pass is of those that find its light. Shadows are not: the layer has none.
    fn counts(self, pass: &str) -> bool {
        match self.method.rect_pass() {
            Some(own) => pass == own,
            None => pass.starts_with("bounce_"),
        }
    }
}

/// Runs all methods over a course.
///
/// # Errors
/// When a pass cannot be run by `dispatcher`.
pub fn race<'p>(
    renderer: &'p Renderer,
    course: Course<'_>,
    dispatcher: &mut dyn Dispatcher<'p>,
    rules: Rules,
) -> Result<Vec<Effort>, ExecError> {
    let truth = run(renderer, course, Method::Reference, rules.truth, &mut Interpreted::default())?;
    let truth = truth.layer(LAYER).unwrap_or_default();
    let runners = Runner::all();
    let mut times = vec![Vec::with_capacity(rules.rounds); runners.len()];
    let mut errors = vec![Error::default(); runners.len()];
    let route = dispatcher.route().to_string();
    for round in 0..=rules.rounds {
        for at in order(runners.len(), round) {
            let runner = runners[at];
            let mut clock = Clock::new(dispatcher);
            let picture =
                run(renderer, course, runner.method, runner.samples.unwrap_or_default(), &mut clock)?;
            errors[at] = Error::of(picture.layer(LAYER).unwrap_or_default(), truth);
            if round > 0 {
                times[at].push(clock.seconds(|pass| runner.counts(pass)));
            }
        }
    }
    let rectangles = course.proxies.rectangles.len();
    let lights = course.scene.lights.len();
    let effort = |at: usize| {
        let seconds = median(times[at].clone());
        Effort {
            scene: course.name.to_owned(),
            route: route.clone(),
            method: runners[at].method.name(),
            samples: runners[at].samples,
            pixels: truth.len(),
            rectangles,
            lights,
            rounds: rules.rounds,
            seconds,
            nanoseconds: seconds * 1e9 / (truth.len() * rectangles * lights) as f64,
            mean_ratio: errors[at].mean_ratio,
            relative_rmse: errors[at].relative_rmse,
            sampling_ratio: None,
        }
    };
    let mut efforts: Vec<Effort> = (0..runners.len()).map(effort).collect();
    compare_with_sampling(&mut efforts);
    Ok(efforts)
}

fn run<'p>(
    renderer: &'p Renderer,
    course: Course<'_>,
    method: Method,
    samples: u32,
    dispatcher: &mut dyn Dispatcher<'p>,
) -> Result<Picture, ExecError> {
    let settings = Settings { method, samples, ..Settings::default() };
    renderer.render(course.scene, course.proxies, &settings, dispatcher, &|_| {})
}

/// Sampling's squared error times its time is one number, but for what each start costs: that of the most samples counts.
fn compare_with_sampling(efforts: &mut [Effort]) {
    let Some(most) = efforts.iter().filter(|e| e.samples.is_some()).max_by_key(|e| e.samples) else { return };
    let work = most.relative_rmse * most.relative_rmse * most.seconds;
    for effort in efforts.iter_mut().filter(|e| e.samples.is_none()) {
        effort.sampling_ratio = Some(work / (effort.relative_rmse * effort.relative_rmse) / effort.seconds);
    }
}

/// How far a layer is from the truth.
#[derive(Debug, Clone, Copy, Default)]
struct Error {
    mean_ratio: f64,
    relative_rmse: f64,
}

impl Error {
    fn of(layer: &[Vec3], truth: &[Vec3]) -> Self {
        let sum = |layer: &[Vec3]| layer.iter().map(|p| p.as_dvec3().element_sum()).sum::<f64>();
        let squares = layer.iter().zip(truth).map(|(a, b)| (a.as_dvec3() - b.as_dvec3()).length_squared());
        let mean = sum(truth) / (3 * truth.len()) as f64;
        let root = (squares.sum::<f64>() / (3 * truth.len()) as f64).sqrt();
        Self { mean_ratio: sum(layer) / sum(truth), relative_rmse: root / mean }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_of_a_layer() {
        let truth = [Vec3::splat(1.0), Vec3::splat(3.0)];
        let found = Error::of(&[Vec3::splat(2.0), Vec3::splat(4.0)], &truth);
        assert_eq!((found.mean_ratio, found.relative_rmse), (1.5, 0.5));
    }

    #[test]
    fn sampling_of_a_hundredth_of_the_error_takes_ten_thousand_times_as_long() {
        let effort = |samples, seconds, relative_rmse| Effort {
            scene: String::new(),
            route: String::new(),
            method: "",
            samples,
            pixels: 1,
            rectangles: 1,
            lights: 1,
            rounds: 1,
            seconds,
            nanoseconds: 0.0,
            mean_ratio: 1.0,
            relative_rmse,
            sampling_ratio: None,
        };
        let mut efforts = [effort(None, 2.0, 0.01), effort(Some(4), 0.5, 9.0), effort(Some(16), 2.0, 1.0)];
        compare_with_sampling(&mut efforts);
        assert_eq!(efforts.map(|e| e.sampling_ratio.map(f64::round)), [Some(1e4), None, None]);
    }
}
