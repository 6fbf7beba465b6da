//! `lobe bench --render`: what the methods of rendering cost, and how far they are from the truth.

use super::{Args, SCHEMA, SIZE};
use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use crate::paint::{Form, plotted};
use crate::scene;
use lobe_backends::route::{Road, Route};
use lobe_backends::routes::Machine;
use lobe_tests::proxies::{self, Options};
use lobe_tests::race::{self, Course, Effort, Rules};
use lobe_tests::render::Renderer;
use lobe_tests::scene::Choices;

/// Measures on all scenes and routes.
pub(super) fn run(args: &Args) -> Result<Outcome, Fail> {
    let plot = args.plot.as_ref().map(|path| Ok::<_, Fail>((path, Form::of(path, "plots")?))).transpose()?;
    let machine = Machine::look();
    let renderer = Renderer::new()?;
    let usual = Route::Gpu { road: Road::Spirv, driver: "lavapipe".to_owned() };
    let routes = if args.routes.is_empty() { vec![usual] } else { args.routes.clone() };
    let rules = Rules { rounds: args.rounds.into(), truth: args.truth };
    let mut all = Vec::new();
    for route in &routes {
        let mut dispatcher = machine.dispatcher(route)?;
        for path in &args.render {
            let mut scene = scene::open(path, &Choices::default())?;
            scene.camera.size = args.size.unwrap_or(SIZE);
            let proxies = proxies::proxies(&scene, &Options::default())?;
            let course = Course { name: &scene::name(path), scene: &scene, proxies: &proxies };
            let efforts = race::race(&renderer, course, dispatcher.as_mut(), rules)?;
            output::print(&shown(&efforts, args.format))?;
            all.extend(efforts);
        }
    }
    if let Some((path, form)) = plot {
        output::write_file(path, &plotted(&race::plot(&all), form)?)?;
    }
    Ok(Outcome::Holds)
}

fn shown(efforts: &[Effort], format: ListFormat) -> String {
    match format {
        ListFormat::Json => efforts.iter().map(|effort| output::json_line(SCHEMA, effort)).collect(),
        ListFormat::Human => efforts.iter().map(human).collect(),
    }
}

fn human(effort: &Effort) -> String {
    let Effort { scene, route, method, seconds, nanoseconds, mean_ratio, relative_rmse, .. } = effort;
    let number = |value: &Option<f64>| value.map_or("none".to_owned(), |v| format!("{v:.3}"));
    let method = match effort.samples {
        Some(samples) => format!("{method} {samples}"),
        None => (*method).to_owned(),
    };
    let sampling = effort.sampling_ratio.map(|ratio| format!("  {ratio:8.1} x as long by sampling"));
    format!(
        "{scene:14} {route:16} {method:20} {:9.2} ms {nanoseconds:10.1} ns a pixel, rectangle, light  mean {}  RMSE {}{}\n",
        seconds * 1e3,
        number(mean_ratio),
        number(relative_rmse),
        sampling.unwrap_or_default()
    )
}
