//! `lobe bench --lights`: what virtual lights cost.

use super::{Args, SCHEMA, SIZE};
use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use crate::scene;
use lobe_backends::route::{Road, Route};
use lobe_backends::routes::Machine;
use lobe_tests::proxies::{self, Options};
use lobe_tests::race::{self, Course, LightCost, LightFit};
use lobe_tests::render::Renderer;
use lobe_tests::scene::Choices;

/// Measures on all scenes and routes.
pub(super) fn run(args: &Args) -> Result<Outcome, Fail> {
    let machine = Machine::look();
    let renderer = Renderer::new()?;
    let usual = Route::Gpu { road: Road::Spirv, driver: "lavapipe".to_owned() };
    let routes = if args.routes.is_empty() { vec![usual] } else { args.routes.clone() };
    for route in &routes {
        let mut dispatcher = machine.dispatcher(route)?;
        for path in &args.lights {
            let mut scene = scene::open(path, &Choices::default())?;
            scene.camera.size = args.size.unwrap_or(SIZE);
            let proxies = proxies::proxies(&scene, &Options::default())?;
            let course = Course { name: &scene::name(path), scene: &scene, proxies: &proxies };
            let costs = race::light_costs(&renderer, course, dispatcher.as_mut(), args.rounds.into())?;
            output::print(&shown(&costs, args.format, human_cost))?;
            output::print(&shown(&race::light_fits(&costs), args.format, human_fit))?;
        }
    }
    Ok(Outcome::Holds)
}

fn shown<T: serde::Serialize>(found: &[T], format: ListFormat, human: fn(&T) -> String) -> String {
    match format {
        ListFormat::Json => found.iter().map(|object| output::json_line(SCHEMA, object)).collect(),
        ListFormat::Human => found.iter().map(human).collect(),
    }
}

fn human_cost(cost: &LightCost) -> String {
    let LightCost { scene, route, method, lights, pixels, shading, making, nanoseconds, .. } = cost;
    format!(
        "{scene:14} {route:16} {method:10} {lights:5} lights {pixels:7} pixels  shading {:9.2} ms  {nanoseconds:7.2} ns each  \
         making {:8.2} ms\n",
        shading * 1e3,
        making * 1e3
    )
}

fn human_fit(fit: &LightFit) -> String {
    let LightFit { scene, route, method, fixed, each, worst, power_of_lights, power_of_pixels } = fit;
    let power = |value: &Option<f64>| value.map_or("none".to_owned(), |v| format!("{v:.3}"));
    format!(
        "{scene:14} {route:16} {method:10} {:.2} ms + {each:.2} ns each, off by {:.1} % at most; without the first, time \
         grows as lights^{}, pixels^{}\n",
        fixed * 1e3,
        worst * 1e2,
        power(power_of_lights),
        power(power_of_pixels)
    )
}
