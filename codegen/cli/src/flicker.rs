//! `lobe flicker`: how much virtual lights flicker while the light turns.

use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use crate::paint::{Form, plotted};
use crate::scene;
use crate::virtual_lights::VirtualArgs;
use lobe_backends::route::Route;
use lobe_backends::routes::Machine;
use lobe_tests::flicker::{self, Flicker, Take, Turn};
use lobe_tests::proxies::{self, Options};
use lobe_tests::render::{Method, Renderer, Settings};
use lobe_tests::scene::Choices;
use std::path::PathBuf;

/// Version of the format.
const SCHEMA: u32 = 1;
/// Steps of the progress bar.
const STEPS: usize = 1000;

/// Options.
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(crate) struct Args {
    /// The scenes: glTF, or JSON in the format of tests/SCENES.md
    #[arg(value_name = "SCENE", required = true)]
    scenes: Vec<PathBuf>,
    /// Methods of `lobe render`, the first of which the others are compared with; vpl, vsl-wide and vsgl if none is given
    #[arg(long = "method", value_name = "METHOD")]
    methods: Vec<Method>,
    /// By how much every light turns from picture to picture, in degrees
    #[arg(long, value_name = "DEGREES", default_value_t = 0.1, value_parser = degrees)]
    turn: f64,
    /// Pictures
    #[arg(long, default_value_t = 32, value_parser = clap::value_parser!(u16).range(3..=4096))]
    pictures: u16,
    /// Columns and rows
    #[arg(long, value_name = "WxH", default_value = "48x48", value_parser = crate::render::size)]
    size: [u32; 2],
    /// Samples a pixel of the method `reference`
    #[arg(long, default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=16_000_000))]
    samples: u32,
    /// What runs the passes, as `interp` or `spirv@lavapipe`
    #[arg(long, default_value_t = Route::Interp)]
    route: Route,
    /// File to draw one pixel's light in time and all pixels' flicker in, `.svg` or `.png`
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Form of the report; JSON is an object for each scene and method, a line each
    #[arg(long, value_enum, default_value_t = ListFormat::Human)]
    format: ListFormat,
    #[command(flatten, next_help_heading = "Virtual lights")]
    virtual_lights: VirtualArgs,
}

const HELP: &str = "\
Each light turns about an axis across its direction, the same in all runs. What flickers is measured by second differences \
in time, L(t + 1) - 2 L(t) + L(t - 1), of each pixel's luminance: they are 0 where light changes evenly, and of noise that is \
another in each picture their mean square is six times its variance. Flicker is a sixth of that mean square, over all \
pixels, over the squared mean luminance; variance is that about each pixel's own mean in time, the light's motion included.";

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let plot = args.plot.as_ref().map(|path| Ok::<_, Fail>((path, Form::of(path, "plots")?))).transpose()?;
    let usual = [Method::Vpl, Method::VslWide, Method::Vsgl];
    let methods = if args.methods.is_empty() { &usual[..] } else { &args.methods };
    let renderer = Renderer::new()?;
    let mut dispatcher = Machine::look().dispatcher(&args.route)?;
    let virtual_lights = args.virtual_lights.settings();
    let settings = Settings { samples: args.samples, virtual_lights, ..Settings::default() };
    let turn = Turn { degrees: args.turn, pictures: args.pictures.into() };
    let mut all = Vec::new();
    for path in &args.scenes {
        let mut scene = scene::open(path, &Choices::default())?;
        scene.camera.size = args.size;
        let proxies = proxies::proxies(&scene, &Options::default())?;
        let take = Take { name: &scene::name(path), scene: &scene, proxies: &proxies, turn };
        let bar = output::progress(STEPS);
        let progress = |share: f32| bar.set_position((share * STEPS as f32) as u64);
        let found = flicker::flicker(&renderer, take, methods, &settings, dispatcher.as_mut(), &progress)?;
        bar.finish_and_clear();
        output::print(&shown(&found, args.format))?;
        all.extend(found);
    }
    if let Some((path, form)) = plot {
        output::write_file(path, &plotted(&flicker::plot(&all), form)?)?;
    }
    Ok(Outcome::Holds)
}

fn shown(found: &[Flicker], format: ListFormat) -> String {
    match format {
        ListFormat::Json => found.iter().map(|flicker| output::json_line(SCHEMA, flicker)).collect(),
        ListFormat::Human => found.iter().map(human).collect(),
    }
}

fn human(found: &Flicker) -> String {
    let Flicker { scene, method, flicker, flicker_ratio, variance, variance_ratio, .. } = found;
    let ratio = |value: &Option<f64>| value.map_or("none".to_owned(), |v| format!("{v:.4}"));
    format!(
        "{scene:14} {method:12} flicker {flicker:.3e} (ratio {})  variance {variance:.3e} (ratio {})\n",
        ratio(flicker_ratio),
        ratio(variance_ratio)
    )
}

fn degrees(text: &str) -> Result<f64, String> {
    let value = text.parse().ok().filter(|value| (0.0..=90.0).contains(value));
    value.ok_or_else(|| format!("`{text}` is no angle from 0 to 90 degrees"))
}
