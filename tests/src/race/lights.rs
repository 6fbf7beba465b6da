//! What virtual lights cost, over their number and that of the pixels.

use super::Course;
use super::clock::Clock;
use crate::render::{Method, Renderer, Settings, VirtualLights};
use crate::scene::Scene;
use crate::throughput::{median, order};
use lobe_backends::executor::ExecError;
use lobe_backends::pipeline::Dispatcher;

/// Who is measured.
const METHODS: [Method; 4] = [Method::Vpl, Method::VslWide, Method::Vsgl, Method::Vsgl2];
/// Virtual lights, each of a picture of the usual size.
const COUNTS: [u32; 6] = [256, 512, 1024, 2048, 4096, 8192];
/// Of these the one that pictures of other sizes have.
const USUAL: u32 = COUNTS[2];

/// What a method took for a picture.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct LightCost {
    /// The scene.
    pub scene: String,
    /// The route.
    pub route: String,
    /// The method.
    pub method: &'static str,
    /// Virtual lights; 2 of [`Method::Vsgl2`].
    pub lights: u32,
    /// Pixels.
    pub pixels: u32,
    /// Rounds.
    pub rounds: usize,
    /// Median time of the pass that adds the lights to the pixels, with its buffers' way to the driver and back.
    pub shading: f64,
    /// That of the passes that make the lights: maps, chains, densities, drawing.
    pub making: f64,
    /// Time of shading a pixel and light, in ns.
    pub nanoseconds: f64,
}

/// Times of a method as a line over lights times pixels.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct LightFit {
    /// The scene.
    pub scene: String,
    /// The route.
    pub route: String,
    /// The method.
    pub method: &'static str,
    /// What a picture takes however small, in s.
    pub fixed: f64,
    /// What a pixel and light takes besides, in ns.
    pub each: f64,
    /// How far the line is from the times, at most, over the times.
    pub worst: f64,
    /// Power of the number of lights that the time without its fixed part grows with; none of [`Method::Vsgl2`].
    pub power_of_lights: Option<f64>,
    /// The same of the number of pixels.
    pub power_of_pixels: Option<f64>,
}

/// A picture that is timed.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Rung {
    method: Method,
    count: u32,
    side: u32,
}

impl Rung {
    /// Those around a picture of so many pixels along a side, which is a method's first.
    fn all(side: u32) -> Vec<Self> {
        let sides = [side.div_ceil(2), side, 2 * side, 4 * side];
        let each = METHODS.into_iter().flat_map(|method| {
            let by_count = COUNTS.map(|count| Self { method, count, side });
            let by_side = sides.map(|side| Self { method, count: USUAL, side });
            by_count.into_iter().chain(by_side)
        });
        let mut all: Vec<Self> = Vec::new();
        for rung in each {
            let rung = if rung.method == Method::Vsgl2 { Self { count: 2, ..rung } } else { rung };
            if !all.contains(&rung) {
                all.push(rung);
            }
        }
        all
    }

    fn pixels(self) -> u32 {
        self.side * self.side
    }

    fn run<'p>(
        self,
        renderer: &'p Renderer,
        course: Course<'_>,
        dispatcher: &mut dyn Dispatcher<'p>,
    ) -> Result<(), ExecError> {
        let mut scene: Scene = course.scene.clone();
        scene.camera.size = [self.side; 2];
        let virtual_lights = VirtualLights { count: self.count, ..VirtualLights::default() };
        let settings = Settings { method: self.method, virtual_lights, ..Settings::default() };
        renderer.render(&scene, course.proxies, &settings, dispatcher, &|_| {})?;
        Ok(())
    }
}

/// Whether a pass adds lights to pixels.
fn is_shading(pass: &str) -> bool {
    ["vpl_pass", "vsl_wide_pass", "vsgl_pass", "vsgl_reduced_pass", "vsgl_two_pass"].contains(&pass)
}

/// The passes of which one is the first that makes lights: before are those of every method.
const FIRST: [&str; 2] = ["seen_point_pass", "map_ray_pass"];

/// Times the methods, `rounds` times after one round that is not counted, on square pictures: as wide as the scene's camera says,
/// half, twice and four times as wide.
///
/// # Errors
/// When a pass cannot be run by `dispatcher`.
pub fn light_costs<'p>(
    renderer: &'p Renderer,
    course: Course<'_>,
    dispatcher: &mut dyn Dispatcher<'p>,
    rounds: usize,
) -> Result<Vec<LightCost>, ExecError> {
    let rungs = Rung::all(course.scene.camera.size[0]);
    let mut times = vec![(Vec::new(), Vec::new()); rungs.len()];
    for round in 0..=rounds {
        for at in order(rungs.len(), round) {
            let mut clock = Clock::new(dispatcher);
            rungs[at].run(renderer, course, &mut clock)?;
            if round > 0 {
                let shading = clock.seconds(is_shading);
                times[at].0.push(shading);
                times[at].1.push(clock.seconds_from(&FIRST) - shading);
            }
        }
    }
    let route = dispatcher.route().to_string();
    let cost = |(rung, (shading, making)): (&Rung, (Vec<f64>, Vec<f64>))| {
        let shading = median(shading);
        LightCost {
            scene: course.name.to_owned(),
            route: route.clone(),
            method: rung.method.name(),
            lights: rung.count,
            pixels: rung.pixels(),
            rounds,
            shading,
            making: median(making),
            nanoseconds: shading * 1e9 / (f64::from(rung.count) * f64::from(rung.pixels())),
        }
    };
    Ok(rungs.iter().zip(times).map(cost).collect())
}

/// A line for each method.
#[must_use]
pub fn light_fits(costs: &[LightCost]) -> Vec<LightFit> {
    METHODS
        .iter()
        .filter_map(|method| fit(costs.iter().filter(|cost| cost.method == method.name()).collect()))
        .collect()
}

/// The line of least squared relative distances.
fn fit(costs: Vec<&LightCost>) -> Option<LightFit> {
    let first = *costs.first()?;
    let points: Vec<(f64, f64)> =
        costs.iter().map(|cost| (f64::from(cost.lights) * f64::from(cost.pixels), cost.shading)).collect();
    let (fixed, slope) = line(&points)?;
    let distance = |(x, y): &(f64, f64)| ((fixed + slope * x) / y - 1.0).abs();
    let power = |of: fn(&LightCost) -> u32, is_of: &dyn Fn(&LightCost) -> bool| {
        let own = costs.iter().filter(|cost| is_of(cost));
        let log =
            |cost: &&LightCost| (libm::log(f64::from(of(cost))), libm::log((cost.shading - fixed).max(1e-9)));
        slope_of(&own.map(log).collect::<Vec<_>>(), |_| 1.0)
    };
    Some(LightFit {
        scene: first.scene.clone(),
        route: first.route.clone(),
        method: first.method,
        fixed,
        each: slope * 1e9,
        worst: points.iter().map(distance).fold(0.0, f64::max),
        power_of_lights: power(|cost| cost.lights, &|cost| cost.pixels == first.pixels),
        power_of_pixels: power(|cost| cost.pixels, &|cost| [2, USUAL].contains(&cost.lights)),
    })
}

/// Intercept and slope of a line, each point weighed by its reciprocal square; none where all are above one place.
fn line(points: &[(f64, f64)]) -> Option<(f64, f64)> {
    let weight = |(_, y): &(f64, f64)| 1.0 / (y * y).max(1e-30);
    let slope = slope_of(points, weight)?;
    let (mean_x, mean_y) = means(points, weight);
    Some((mean_y - slope * mean_x, slope))
}

fn means(points: &[(f64, f64)], weight: impl Fn(&(f64, f64)) -> f64) -> (f64, f64) {
    let total: f64 = points.iter().map(&weight).sum();
    let of = |value: fn(&(f64, f64)) -> f64| points.iter().map(|p| weight(p) * value(p)).sum::<f64>() / total;
    (of(|p| p.0), of(|p| p.1))
}

fn slope_of(points: &[(f64, f64)], weight: impl Fn(&(f64, f64)) -> f64) -> Option<f64> {
    let (mean_x, mean_y) = means(points, &weight);
    let both: f64 = points.iter().map(|p| weight(p) * (p.0 - mean_x) * (p.1 - mean_y)).sum();
    let square: f64 = points.iter().map(|p| weight(p) * (p.0 - mean_x).powi(2)).sum();
    (square > 0.0).then(|| both / square)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Costs of `fixed + 2 ns (lights pixels)^power`.
    fn costs(power: f64) -> Vec<LightCost> {
        let cost = |rung: &Rung| LightCost {
            scene: String::new(),
            route: String::new(),
            method: rung.method.name(),
            lights: rung.count,
            pixels: rung.pixels(),
            rounds: 1,
            shading: 2e-9 * libm::pow(f64::from(rung.count) * f64::from(rung.pixels()), power),
            making: 0.0,
            nanoseconds: 0.0,
        };
        Rung::all(128).iter().map(cost).collect()
    }

    #[test]
    fn a_line_is_found() {
        let mut all = costs(1.0);
        all.iter_mut().for_each(|cost| cost.shading += 3e-3);
        let fits = light_fits(&all);
        assert_eq!(fits.len(), METHODS.len());
        for fit in fits {
            let is_close = (fit.fixed - 3e-3).abs() < 1e-6 && (fit.each - 2.0).abs() < 1e-3;
            assert!(is_close && fit.worst < 1e-6, "{fit:?}");
            let powers = [fit.power_of_lights, fit.power_of_pixels];
            assert!(powers.into_iter().flatten().all(|power| (power - 1.0).abs() < 1e-2), "{fit:?}");
        }
    }

    #[test]
    fn what_is_no_line_is_seen() {
        assert!(light_fits(&costs(1.3)).iter().all(|fit| fit.worst > 0.1));
    }
}
