//! Methods of rendering against each other: what they cost, and how far they are from the truth, in one run on one route.
//!
//! The layer that counts is the glossy light of glossy surfaces without occlusion, which all methods of rectangles have.
//! Sampling runs beside them with ever more samples, so that its time at the error of each method is known.

mod clock;
mod lights;
mod plot;

pub use lights::{LightCost, LightFit, light_costs, light_fits};
pub use plot::plot;

use crate::metrics::{Image, Pair, PairError, Radiometry, radiometry};
use crate::proxies::Proxies;
use crate::render::{Method, Renderer, Settings};
use crate::scene::Scene;
use crate::throughput::{median, order};
use clock::Clock;
use lobe_backends::executor::ExecError;
use lobe_backends::pipeline::{Dispatcher, Interpreted};

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
    /// Sides of rectangles that reflect, each of which every pixel sums for each light.
    pub rectangles: usize,
    /// Lights.
    pub lights: usize,
    /// Rounds.
    pub rounds: usize,
    /// Median time of the passes that find the light of one bounce, with their buffers' way to the driver and back.
    pub seconds: f64,
    /// That a pixel, rectangle and light.
    pub nanoseconds: f64,
    /// [`Radiometry::mean_ratio`] of the layer.
    pub mean_ratio: Option<f64>,
    /// [`Radiometry::relative_rmse`] of the layer.
    pub relative_rmse: Option<f64>,
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

    /// The layer that it makes.
    fn run<'p>(
        self,
        renderer: &'p Renderer,
        course: Course<'_>,
        dispatcher: &mut dyn Dispatcher<'p>,
    ) -> Result<Image, ExecError> {
        let settings = Settings {
            method: self.method,
            samples: self.samples.unwrap_or_default(),
            ..Settings::default()
        };
        let picture = renderer.render(course.scene, course.proxies, &settings, dispatcher, &|_| {})?;
        Ok(Image { size: picture.size, pixels: picture.layer(LAYER).unwrap_or_default().to_vec() })
    }

    fn pair<'a>(self, image: &'a Image, truth: &'a Image) -> Result<Pair<'a>, RaceError> {
        Pair::new(image, truth).map_err(|cause| RaceError::Pair { method: self.method, cause })
    }

    fn effort(self, course: Course<'_>, route: &str, times: Vec<f64>, found: &Radiometry) -> Effort {
        let [width, height] = course.scene.camera.size;
        let pixels = width as usize * height as usize;
        let sides = course.proxies.rectangles.iter().map(|proxy| 1 + usize::from(proxy.two_sided));
        let (rectangles, lights) = (sides.sum(), course.scene.lights.len());
        let rounds = times.len();
        let seconds = median(times);
        Effort {
            scene: course.name.to_owned(),
            route: route.to_owned(),
            method: self.method.name(),
            samples: self.samples,
            pixels,
            rectangles,
            lights,
            rounds,
            seconds,
            nanoseconds: seconds * 1e9 / (pixels * rectangles * lights) as f64,
            mean_ratio: found.mean_ratio,
            relative_rmse: found.relative_rmse,
            sampling_ratio: None,
        }
    }

    /// Whether a pass is of those that find its light. Shadows are not: the layer has none.
    fn counts(self, pass: &str) -> bool {
        match self.method.rect_pass() {
            Some(own) => pass == own,
            None => pass.starts_with("bounce_"),
        }
    }
}

/// Why there is no race.
#[derive(Debug, thiserror::Error)]
pub enum RaceError {
    /// A pass was not run.
    #[error(transparent)]
    Exec(#[from] ExecError),
    /// A method's picture is none that can be compared.
    #[error("{method} cannot be compared with the truth: {cause}")]
    Pair {
        /// The method.
        method: Method,
        /// Why.
        cause: PairError,
    },
}

/// Runs all methods over a course.
///
/// # Errors
/// When a pass cannot be run by `dispatcher`, or leaves what is no light.
pub fn race<'p>(
    renderer: &'p Renderer,
    course: Course<'_>,
    dispatcher: &mut dyn Dispatcher<'p>,
    rules: Rules,
) -> Result<Vec<Effort>, RaceError> {
    let reference = Runner { method: Method::Reference, samples: Some(rules.truth) };
    let truth = reference.run(renderer, course, &mut Interpreted::default())?;
    let runners = Runner::all();
    let mut times = vec![Vec::with_capacity(rules.rounds); runners.len()];
    let mut left = vec![None; runners.len()];
    for round in 0..=rules.rounds {
        for at in order(runners.len(), round) {
            let mut clock = Clock::new(dispatcher);
            left[at] = Some(runners[at].run(renderer, course, &mut clock)?);
            if round > 0 {
                times[at].push(clock.seconds(|pass| runners[at].counts(pass)));
            }
        }
    }
    let route = dispatcher.route().to_string();
    let mut efforts = Vec::with_capacity(runners.len());
    for ((runner, times), image) in runners.iter().zip(times).zip(left.iter().flatten()) {
        let found = radiometry(&runner.pair(image, &truth)?);
        efforts.push(runner.effort(course, &route, times, &found));
    }
    compare_with_sampling(&mut efforts);
    Ok(efforts)
}

/// Sampling's squared error times its time is one number, but for what each start costs: that of the most samples counts.
fn compare_with_sampling(efforts: &mut [Effort]) {
    let most = efforts.iter().filter(|effort| effort.samples.is_some()).max_by_key(|effort| effort.samples);
    let Some(work) = most.and_then(Effort::work) else { return };
    for effort in efforts.iter_mut().filter(|effort| effort.samples.is_none()) {
        effort.sampling_ratio = effort.work().filter(|own| *own > 0.0).map(|own| work / own);
    }
}

impl Effort {
    /// The squared error times the time.
    fn work(&self) -> Option<f64> {
        self.relative_rmse.map(|error| error * error * self.seconds)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
            mean_ratio: Some(1.0),
            relative_rmse: Some(relative_rmse),
            sampling_ratio: None,
        };
        let mut efforts = [effort(None, 2.0, 0.01), effort(Some(4), 0.5, 9.0), effort(Some(16), 2.0, 1.0)];
        compare_with_sampling(&mut efforts);
        assert_eq!(efforts.map(|e| e.sampling_ratio.map(f64::round)), [Some(1e4), None, None]);
    }
}
