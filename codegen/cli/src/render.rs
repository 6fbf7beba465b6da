//! `lobe render`: a picture of a scene, by a method and a route.

use crate::fail::{Fail, Outcome};
use crate::output;
use crate::scene;
use crate::virtual_lights::VirtualArgs;
use indicatif::ProgressBar;
use lobe_backends::route::Route;
use lobe_backends::routes::{Machine, OpenError, State};
use lobe_tests::proxies::{self, Options, Proxies};
use lobe_tests::render::{
    FieldSearch, Judged, LightField, Method, PassVerdict, Picture, Renderer, Settings, auto_exposure, exr,
    png, summary,
};
use lobe_tests::scene::{Choices, Scene};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Steps of the progress bar.
const STEPS: usize = 1000;
/// Pixels of a picture, at most: what buffers of 128 MiB hold, the least that drivers bind.
const MOST_PIXELS: u64 = 1 << 20;
/// The same for the method `reference` on a driver, whose means take 256 bytes a pixel.
const MOST_SAMPLED: u64 = 1 << 19;

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// The scene: glTF, or JSON in the format of tests/SCENES.md
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// direct, rect, rect-quadrature, rect-laplace, rect-laplace-single, rect-laplace-fast, rect-sg, rect-paper, vpl, vsl, vsl-wide, vsgl, vsgl2, vsgl2-paper or reference
    #[arg(long, default_value_t = Method::RectQuadrature)]
    method: Method,
    /// What runs the passes, as `interp` or `spirv@lavapipe`
    #[arg(long, default_value_t = Route::Interp)]
    route: Route,
    /// Files to write: `.exr` with linear radiance, `.png` for looking at
    #[arg(short, long, value_name = "FILE", required_unless_present = "check")]
    output: Vec<PathBuf>,
    /// Run every pass on every ready route, from the interpreter's buffers, and judge what it leaves by the derived bounds;
    /// slow: give a small --size
    #[arg(long, conflicts_with_all = ["route", "output"])]
    check: bool,
    /// Of a check: end with exit code 3 if one of these routes is missing
    #[arg(long = "require", value_name = "ROUTE", requires = "check")]
    require: Vec<Route>,
    /// Put every component into the EXR file, as channels `NAME.R`, `NAME.G`, `NAME.B`
    #[arg(long)]
    layers: bool,
    /// Rectangles in place of the scene, by `lobe proxies`; made for it if not given
    #[arg(long, value_name = "FILE")]
    proxies: Option<PathBuf>,
    /// Name of the glTF file's camera, instead of its first
    #[arg(long, value_name = "NAME")]
    camera: Option<String>,
    /// Columns and rows, instead of the scene's
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,
    /// Samples a pixel of the method `reference`
    #[arg(long, default_value_t = 256, value_parser = clap::value_parser!(u32).range(1..=16_000_000))]
    samples: u32,
    /// Radius of the sampling disk of rectangles, over alpha and distance
    #[arg(long, default_value_t = 3.0, value_parser = factor)]
    radius_factor: f32,
    /// Shade by a light-field texture with so many texels along a side of each surface (`rect-quadrature`, `rect-laplace`)
    #[arg(long, value_name = "TEXELS", conflicts_with = "check", value_parser = clap::value_parser!(u32).range(1..=1024))]
    field: Option<u32>,
    /// Rectangles that a texel lists
    #[arg(long, default_value_t = 8, requires = "field", value_parser = clap::value_parser!(u32).range(1..=8))]
    field_ids: u32,
    /// Find them by trying every rectangle instead of by a tree; the lists are the same
    #[arg(long, requires = "field")]
    field_all: bool,
    /// Ask for what stands between a pixel, points of each rectangle and the light: nine points a lobe (`rect-quadrature`) or
    /// one (`rect-laplace`)
    #[arg(long, conflicts_with = "field")]
    shadows: bool,
    /// Stops by which the PNG is brightened; chosen by the picture if not given
    #[arg(long, allow_negative_numbers = true, value_parser = stops)]
    exposure: Option<f32>,
    #[command(flatten, next_help_heading = "Virtual lights (vpl, vsl, vsl-wide, vsgl, vsgl2)")]
    virtual_lights: VirtualArgs,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let writers =
        args.output.iter().map(|path| Ok((path, Form::of(path)?))).collect::<Result<Vec<_>, Fail>>()?;
    let scene = open(args)?;
    check_size(args, scene.camera.size)?;
    check_method(args)?;
    if args.check {
        return judge(args, &scene);
    }
    let begin = Instant::now();
    let picture = picture(args, &scene)?;
    let seconds = begin.elapsed().as_secs_f64();
    for (path, form) in writers {
        output::write_file(path, &form.bytes(&picture, args)?)?;
        let [width, height] = picture.size;
        let (method, route) = (args.method, &args.route);
        output::print(&format!(
            "{}: {width} x {height}, {method} on {route}, {seconds:.2} s\n",
            path.display()
        ))?;
    }
    match picture.is_sound() {
        true => Ok(Outcome::Holds),
        false => Err(Fail::Defect(format!("{} has pixels that are no light", args.scene.display()))),
    }
}

/// Whether the method can do what is asked for.
fn check_method(args: &Args) -> Result<(), Fail> {
    if args.shadows {
        check_can(args.method, "--shadows", Method::has_shadows)?;
    }
    if args.field.is_some() {
        check_can(args.method, "--field", |method| method.field_pass().is_some())?;
    }
    if args.virtual_lights.has_visibility() {
        check_can(args.method, "--visibility", Method::has_visibility)?;
    }
    Ok(())
}

fn check_can(method: Method, option: &str, can: impl Fn(Method) -> bool) -> Result<(), Fail> {
    if can(method) {
        return Ok(());
    }
    let names: Vec<&str> = Method::ALL.into_iter().filter(|m| can(*m)).map(Method::name).collect();
    let names = names.join(", ");
    Err(Fail::Usage(format!("{option} is for {names}; give one of them as --method, not {method}")))
}

/// The scene in the file, in the size that is asked for.
fn open(args: &Args) -> Result<Scene, Fail> {
    let choices = Choices { camera: args.camera.clone(), ..Choices::default() };
    let mut scene = scene::open(&args.scene, &choices)?;
    if let Some(size) = args.size {
        scene.camera.size = size;
    }
    Ok(scene)
}

/// All passes on all ready routes.
fn judge(args: &Args, scene: &Scene) -> Result<Outcome, Fail> {
    let machine = Machine::look();
    for route in &args.require {
        if let State::Missing { what, mend } = machine.state(route) {
            return Err(OpenError::Missing { route: route.clone(), what, mend }.into());
        }
    }
    let renderer = Renderer::new()?;
    let mut routes = Vec::new();
    for (route, state) in machine.routes().into_iter().filter(|(route, _)| *route != Route::Native) {
        match state {
            State::Ready => routes.push(machine.dispatcher(&route)?),
            State::Missing { what, mend } => {
                output::print(&format!("skipped    {route}: {what} ({mend})\n"))?
            }
        }
    }
    let mut judged = Judged::new(routes);
    let proxies = proxies(args, scene)?;
    let bar: ProgressBar = output::progress(STEPS);
    let progress = |share: f32| bar.set_position((share * STEPS as f32) as u64);
    renderer.render(scene, &proxies, &settings(args), &mut judged, &progress)?;
    bar.finish_and_clear();
    report(&summary(&judged.verdicts))
}

/// A line for each pass and route.
fn report(verdicts: &[PassVerdict]) -> Result<Outcome, Fail> {
    for verdict in verdicts {
        let PassVerdict { pass, route, words, differing, unknown, outside, share, .. } = verdict;
        let word = if verdict.holds() { "holds" } else { "falls short" };
        let mut line = format!(
            "{word:12} {pass:24} {route:24} {words} words, {differing} differ, {unknown} without bound, {outside} outside, share {share:.3}\n"
        );
        if let Some(first) = &verdict.first {
            line += &format!("             {first}\n");
        }
        if !verdict.disagrees_with.is_empty() {
            line += &format!("             other bits than {}\n", verdict.disagrees_with.join(", "));
        }
        output::print(&line)?;
    }
    let fell_short = verdicts.iter().filter(|verdict| !verdict.holds()).count();
    output::print(&format!("{} hold, {fell_short} fall short\n", verdicts.len() - fell_short))?;
    Ok(if fell_short == 0 { Outcome::Holds } else { Outcome::FellShort })
}

fn settings(args: &Args) -> Settings {
    let Args { method, samples, radius_factor, shadows, .. } = *args;
    Settings { method, samples, radius_factor, shadows, virtual_lights: args.virtual_lights.settings() }
}

fn picture(args: &Args, scene: &Scene) -> Result<Picture, Fail> {
    let renderer = Renderer::new()?;
    let mut dispatcher = Machine::look().dispatcher(&args.route)?;
    let proxies = proxies(args, scene)?;
    if let Some(side) = args.field {
        let mut field = LightField::new(side, args.field_ids);
        field.search = if args.field_all { FieldSearch::All } else { FieldSearch::Tree };
        let settings = settings(args);
        return Ok(renderer.render_by_field(scene, &proxies, &settings, &mut field, dispatcher.as_mut())?);
    }
    let bar: ProgressBar = output::progress(STEPS);
    let progress = |share: f32| bar.set_position((share * STEPS as f32) as u64);
    let picture = renderer.render(scene, &proxies, &settings(args), dispatcher.as_mut(), &progress)?;
    bar.finish_and_clear();
    Ok(picture)
}

/// The rectangles in place of the scene: those of a file, or made for it.
fn proxies(args: &Args, scene: &Scene) -> Result<Proxies, Fail> {
    let Some(path) = &args.proxies else { return Ok(proxies::proxies(scene, &Options::default())?) };
    let text = std::fs::read_to_string(path).map_err(|cause| Fail::Read { path: path.clone(), cause })?;
    let found =
        Proxies::from_json(&text).map_err(|cause| Fail::Usage(format!("{}: {cause}", path.display())))?;
    let known = scene.materials.len();
    match found.rectangles.iter().find(|proxy| proxy.material >= known) {
        Some(proxy) => Err(Fail::Usage(format!(
            "{}: a proxy has material {}, and the scene has {known}: make the proxies of this scene by `lobe proxies`",
            path.display(),
            proxy.material
        ))),
        None => Ok(found),
    }
}

/// A form of file.
#[derive(Debug, Clone, Copy)]
enum Form {
    Exr,
    Png,
}

impl Form {
    fn of(path: &Path) -> Result<Self, Fail> {
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
        match extension.as_deref() {
            Some("exr") => Ok(Self::Exr),
            Some("png") => Ok(Self::Png),
            _ => {
                let message =
                    format!("{}: pictures are written as .exr or .png; name one of them", path.display());
                Err(Fail::Usage(message))
            }
        }
    }

    fn bytes(self, picture: &Picture, args: &Args) -> Result<Vec<u8>, Fail> {
        Ok(match self {
            Self::Exr => exr(picture, args.layers)?,
            Self::Png => png(picture, args.exposure.unwrap_or_else(|| auto_exposure(picture)))?,
        })
    }
}

fn check_size(args: &Args, [width, height]: [u32; 2]) -> Result<(), Fail> {
    let is_sampled = args.method == Method::Reference && matches!(args.route, Route::Gpu { .. });
    let most = if is_sampled { MOST_SAMPLED } else { MOST_PIXELS };
    if u64::from(width) * u64::from(height) <= most {
        return Ok(());
    }
    let (method, route) = (args.method, &args.route);
    let message = format!(
        "{method} on {route} makes pictures of at most {most} pixels, {width} x {height} are more; give a --size"
    );
    Err(Fail::Usage(message))
}

/// Columns and rows, as `128x128`.
pub(crate) fn size(text: &str) -> Result<[u32; 2], String> {
    let wanted = || format!("`{text}` is no size; write columns and rows, as 128x128");
    let (width, height) = text.split_once('x').ok_or_else(wanted)?;
    let side = |text: &str| text.parse::<u32>().ok().filter(|n| (1..=1 << 20).contains(n)).ok_or_else(wanted);
    Ok([side(width)?, side(height)?])
}

fn factor(text: &str) -> Result<f32, String> {
    let value = text.parse().ok().filter(|v| (0.1..=10.0).contains(v));
    value.ok_or_else(|| format!("`{text}` is no factor; take one from 0.1 to 10"))
}

fn stops(text: &str) -> Result<f32, String> {
    let value = text.parse().ok().filter(|v| (-100.0..=100.0).contains(v));
    value.ok_or_else(|| format!("`{text}` is no number of stops; take one from -100 to 100"))
}
