//! Flicker as a figure: one pixel's light in time, and how much all pixels flicker.

use super::Flicker;
use crate::figures::axis::Axis;
use crate::figures::plot::{Corner, Figure, Mark, Panel, Series, number};

/// Two panels a scene: the light of one pixel, and the deviations of all.
#[must_use]
pub fn plot(measured: &[Flicker]) -> Figure {
    let mut scenes: Vec<&str> = measured.iter().map(|flicker| flicker.scene.as_str()).collect();
    scenes.dedup();
    let panels = scenes.iter().enumerate().flat_map(|(at, scene)| {
        let own: Vec<&Flicker> = measured.iter().filter(|flicker| flicker.scene == *scene).collect();
        [in_time(scene, &own, at == 0), over_pixels(scene, &own)]
    });
    Figure {
        name: "flicker",
        title: "Flicker of virtual lights while the light turns".to_owned(),
        panels: panels.collect(),
        caption: caption(&scenes, measured),
    }
}

fn caption(scenes: &[&str], measured: &[Flicker]) -> String {
    let Some(first) = measured.first() else { return String::new() };
    let ratios = |scene: &&str| {
        let own = measured.iter().filter(|flicker| flicker.scene == **scene).skip(1);
        let each =
            own.filter_map(|flicker| Some(format!("{} {}", flicker.method, number(flicker.flicker_ratio?))));
        format!("{scene}: {}", each.collect::<Vec<_>>().join(", "))
    };
    let [width, height] = first.size;
    format!(
        "All light of one bounce, {} lights, {} pictures of {width} × {height} pixels between which the light turns by {} degrees, \
         by lobe flicker. Left: one pixel, over the mean of all. Right: roots of a sixth of the pixels' mean squared second \
         differences in time, from the pixel that flickers least to the one that flickers most. The mean squares over those of {}: {}.",
        first.lights,
        first.pictures,
        first.degrees,
        first.method,
        scenes.iter().map(ratios).collect::<Vec<_>>().join("; ")
    )
}

fn in_time(scene: &str, methods: &[&Flicker], has_legend: bool) -> Panel {
    let line = |flicker: &Flicker| -> Vec<(f64, f64)> {
        let each = flicker.series.iter().enumerate();
        each.map(|(at, value)| (at as f64, value / flicker.mean.max(f64::MIN_POSITIVE))).collect()
    };
    let lines: Vec<Vec<(f64, f64)>> = methods.iter().map(|flicker| line(flicker)).collect();
    let most = lines.iter().flatten().fold(0.0_f64, |most, (_, value)| most.max(*value));
    let pictures = methods.iter().map(|flicker| flicker.pictures).max().unwrap_or(2);
    let pixel = methods.first().map_or([0, 0], |flicker| flicker.pixel);
    let step = step(most);
    Panel {
        title: format!("{scene}, pixel {}, {}", pixel[0], pixel[1]),
        x: Axis::linear("picture", 0.0, (pictures - 1) as f64, 8.0),
        y: Axis::linear("luminance over the mean", 0.0, step * (most / step + 0.2).ceil(), step),
        series: series(methods, lines),
        legend: has_legend.then_some(Corner::BottomLeft),
    }
}

fn over_pixels(scene: &str, methods: &[&Flicker]) -> Panel {
    let line = |flicker: &&Flicker| -> Vec<(f64, f64)> {
        let last = flicker.deviations.len().saturating_sub(1).max(1) as f64;
        let each = flicker.deviations.iter().enumerate();
        each.filter(|(_, value)| **value >= LEAST).map(|(at, value)| (at as f64 / last, *value)).collect()
    };
    Panel {
        title: format!("{scene}, all pixels"),
        x: Axis::linear("share of the pixels", 0.0, 1.0, 0.25),
        y: Axis::log("deviation over the mean", -5, 3, 1),
        series: series(methods, methods.iter().map(line).collect()),
        legend: None,
    }
}

/// The least deviation that is drawn.
const LEAST: f64 = 1e-5;

fn series(methods: &[&Flicker], lines: Vec<Vec<(f64, f64)>>) -> Vec<Series> {
    let each = methods.iter().zip(lines).enumerate();
    each.map(|(colour, (flicker, line))| Series::new(&flicker.method, colour, Mark::Line(line))).collect()
}

/// A distance of ticks, 1, 2 or 5 times a power of ten, of which four to ten reach `most`.
fn step(most: f64) -> f64 {
    let power = libm::pow(10.0, libm::floor(libm::log10((most / 4.0).max(1e-6))));
    [5.0, 2.0, 1.0].map(|factor| factor * power).into_iter().find(|step| 4.0 * step <= most).unwrap_or(power)
}
