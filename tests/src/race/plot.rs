//! Error over cost, as a figure.

use super::{Effort, LADDER};
use crate::figures::axis::Axis;
use crate::figures::plot::{Corner, Figure, Mark, Panel, Series};

/// A panel a scene: each method's error over its cost, and the curve of sampling.
#[must_use]
pub fn plot(efforts: &[Effort]) -> Figure {
    let mut scenes: Vec<&str> = efforts.iter().map(|effort| effort.scene.as_str()).collect();
    scenes.dedup();
    let panels = scenes.iter().enumerate().map(|(at, scene)| {
        let own: Vec<&Effort> = efforts.iter().filter(|effort| effort.scene == *scene).collect();
        panel(scene, &own, at == 0)
    });
    let route = efforts.first().map_or("", |effort| effort.route.as_str());
    Figure {
        name: "cost",
        title: "Glossy light of glossy rectangles: error over cost".to_owned(),
        panels: panels.collect(),
        caption: format!(
            "Relative root mean squared error over the time a pixel, rectangle and light on {route}, by lobe bench --render. \
             Sampling takes {} to {} samples a pixel; its time is that of its passes, without shadows, divided by the same number.",
            LADDER[0],
            LADDER[LADDER.len() - 1]
        ),
    }
}

fn panel(scene: &str, efforts: &[&Effort], has_legend: bool) -> Panel {
    let points = efforts.iter().filter(|effort| effort.samples.is_none()).enumerate();
    let dots = points.map(|(colour, effort)| {
        Series::new(effort.method, colour + 1, Mark::Dots(place(effort).into_iter().collect()))
    });
    let sampling = efforts.iter().filter(|effort| effort.samples.is_some());
    let curve = sampling.filter_map(|effort| place(effort)).collect();
    Panel {
        title: scene.to_owned(),
        x: Axis::log("ns a pixel, rectangle and light", 1, 6, 1),
        y: Axis::log("relative RMSE", -3, 1, 1),
        series: [Series::new("sampling", 0, Mark::Line(curve))].into_iter().chain(dots).collect(),
        legend: has_legend.then_some(Corner::BottomRight),
    }
}

/// Where an effort is; nowhere if the truth is black.
fn place(effort: &Effort) -> Option<(f64, f64)> {
    effort.relative_rmse.map(|error| (effort.nanoseconds, error))
}
