//! `lobe bench`: throughput of every executor on the same kernels, as ratios.

mod emitted;
mod lights;
mod render;

use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use lobe_backends::gpu::Gpu;
use lobe_backends::interp::Isa;
use lobe_backends::route::{Road, Route};
use lobe_backends::routes::{Machine, OpenError, State};
use lobe_tests::throughput::{self, Executor, MOST, Maker, Measurement, WORKLOADS};
use std::path::PathBuf;
use std::process::Command;

/// Version of the format.
const SCHEMA: u32 = 1;
/// Columns and rows of pictures, unless said otherwise.
const SIZE: [u32; 2] = [128; 2];

/// Options.
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(crate) struct Args {
    /// Kernels to measure: hsg, lights, triad; all when none is named
    #[arg(value_parser = WORKLOADS.map(|w| w.name))]
    kernels: Vec<String>,
    /// Form of the report; JSON is an object for each kernel and executor, a line each
    #[arg(long, value_enum, default_value_t = ListFormat::Human)]
    format: ListFormat,
    /// Rounds, in each of which every executor runs once; one more before them is not counted
    #[arg(long, default_value_t = 9, value_parser = clap::value_parser!(u16).range(1..))]
    rounds: u16,
    /// Invocations of each kernel; by default 4 million, of lights 131072
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=MOST as i64))]
    items: Option<u32>,
    /// Measure only these: native, interp, or a route as spirv@lavapipe
    #[arg(long = "route", value_name = "ROUTE")]
    routes: Vec<Route>,
    /// Threads of the interpreter, of native code and of lavapipe; by default all
    #[arg(long, value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// End with exit code 1 if the interpreter is below half of its goal against lavapipe anywhere, twice in a row; with
    /// --emitted, if any limit does not hold
    #[arg(long)]
    floor: bool,
    /// Measure instead what emitted HLSL costs beside the same functions by hand, and how long emission takes
    #[arg(long, conflicts_with_all = ["kernels", "routes", "threads"])]
    emitted: bool,
    /// Measure instead what the methods of `lobe render` cost on these scenes, and how far they are from the truth
    #[arg(long, value_name = "SCENE", num_args = 1.., conflicts_with_all = ["kernels", "items", "floor", "emitted"])]
    render: Vec<PathBuf>,
    /// Measure instead what the virtual lights of `lobe render` cost in these scenes, over their number and that of the pixels
    #[arg(long, value_name = "SCENE", num_args = 1.., conflicts_with_all = ["kernels", "items", "floor", "emitted", "render"])]
    lights: Vec<PathBuf>,
    /// With --render or --lights: columns and rows, instead of 128x128; of --lights the columns count
    #[arg(long, value_name = "WxH", conflicts_with_all = ["kernels", "emitted"], value_parser = crate::render::size)]
    size: Option<[u32; 2]>,
    /// With --render: samples a pixel of the truth
    #[arg(long, value_name = "SAMPLES", default_value_t = 8192, value_parser = clap::value_parser!(u32).range(1..=1 << 20))]
    truth: u32,
    /// With --render: file to draw error over cost in, `.svg` or `.png`
    #[arg(long, value_name = "FILE", requires = "render")]
    plot: Option<PathBuf>,
}

const HELP: &str = "\
hsg is the integral of an SG, the clamped cosine and a hemisphere; lights sums 64 SG lights an invocation; \
triad is a * 2 + b, bound by memory. Drivers run WGSL through wgpu's naga, with the bounds checks that the \
interpreter has too; SPIR-V of a named route is checked likewise. Data stays where it is: neither upload nor \
compilation is timed, nor the interpreter's lowering and linking.

The ratio to another executor is how many times as fast this one is: the median over the rounds of the other's time \
divided by this one's in the same round. The goals against wgsl+naga@lavapipe for hsg, lights and triad are \
1.4, 3.2 and 8 with AVX-512, 1.0, 2.4 and 8 with AVX2.

With --emitted, six kernels stand beside HLSL by hand, all through DXC -O3: the emitted functions called by the hand's \
entry point (limits: 1.00 x the instructions in SPIR-V and DXIL, 1.01 x the time on lavapipe), and the emitted entry \
point (1.05 x both). Then the time to write each in every target, beside slang's for one, 200 times as long.

With --render, the methods of rectangles and sampling with 4 to 256 samples a pixel take turns on spirv@lavapipe, or on \
the routes that are named: time of the passes that find the light of one bounce, buffers' way to the driver and back \
included, and the error of the glossy light of glossy surfaces, without occlusion, against --truth. The last number \
is how many times as long sampling takes to a method's error.

With --lights, vpl, vsl-wide, vsgl and vsgl2 take turns with 256 to 8192 virtual lights on 128 x 128 pixels, and with 1024 on \
pictures half, twice and four times as wide: time of the pass that adds lights to pixels, and of those that make the lights, buffers' way \
to the driver and back included. Then the times of that pass as a line over lights times pixels.";

/// The route that goals are stated against.
const YARDSTICK: &str = "wgsl+naga@lavapipe";

/// What the interpreter's threads and lavapipe's go by, each read once when they start.
const THREADS: [&str; 2] = ["RAYON_NUM_THREADS", "LP_NUM_THREADS"];

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    if args.emitted {
        return emitted::run(args);
    }
    if !args.render.is_empty() && args.threads.is_none_or(runs_with) {
        return render::run(args);
    }
    if !args.lights.is_empty() && args.threads.is_none_or(runs_with) {
        return lights::run(args);
    }
    if let Some(threads) = args.threads.filter(|n| !runs_with(*n)) {
        return again(threads);
    }
    let mut executors = open(args)?;
    let makers =
        WORKLOADS.iter().filter(|w| args.kernels.is_empty() || args.kernels.iter().any(|k| k == w.name));
    let mut outcome = Outcome::Holds;
    for maker in makers {
        let items = args.items.map_or(maker.items, |n| n as usize);
        let workload = maker.make(items);
        let mut measured = || -> Result<Vec<Measurement>, Fail> {
            let measured = throughput::measure(&workload, &mut executors, args.rounds.into())?;
            output::print(&shown(&measured, args.format))?;
            Ok(measured)
        };
        let first = measured()?;
        if args.floor && !holds(maker, &first)? {
            // A machine that was busy for a while is no fault of the interpreter's.
            eprintln!("lobe: {}: MEASURED A SECOND TIME, which decides", maker.name);
            if !holds(maker, &measured()?)? {
                outcome = Outcome::FellShort;
            }
        }
    }
    Ok(outcome)
}

/// Whether this process was started with so many threads.
fn runs_with(threads: u16) -> bool {
    THREADS.iter().all(|name| std::env::var(name).is_ok_and(|value| value == threads.to_string()))
}

/// The same command in a process with so many threads: drivers ask the environment, and only once.
fn again(threads: u16) -> Result<Outcome, Fail> {
    let fail = |cause| Fail::Read { path: "lobe".into(), cause };
    let mut command = Command::new(std::env::current_exe().map_err(fail)?);
    command.args(std::env::args_os().skip(1));
    command.envs(THREADS.map(|name| (name, threads.to_string())));
    let code = command.status().map_err(fail)?.code();
    Ok(Outcome::Code(code.and_then(|c| u8::try_from(c).ok()).unwrap_or(1)))
}

fn open(args: &Args) -> Result<Vec<Executor>, Fail> {
    let machine = Machine::look();
    let routes = if args.routes.is_empty() { usual(&machine) } else { args.routes.clone() };
    let mut executors = Vec::new();
    for route in &routes {
        match route {
            Route::Native => executors.push(Executor::Native),
            Route::Interp => executors.extend(Isa::available().into_iter().rev().map(Executor::Interp)),
            Route::Gpu { road, driver } => executors.push(driven(&machine, route, *road, driver)?),
        }
    }
    Ok(executors)
}

/// Everything on the host, and each driver once.
fn usual(machine: &Machine) -> Vec<Route> {
    let drivers =
        machine.drivers().iter().map(|d| Route::Gpu { road: Road::WgslNaga, driver: d.name.clone() });
    [Route::Interp, Route::Native].into_iter().chain(drivers).collect()
}

fn driven(machine: &Machine, route: &Route, road: Road, name: &str) -> Result<Executor, Fail> {
    if let State::Missing { what, mend } = machine.state(route) {
        return Err(OpenError::Missing { route: route.clone(), what, mend }.into());
    }
    let driver = machine.drivers().iter().find(|d| d.name == name);
    let Some(driver) = driver else { return Err(Fail::Usage(format!("{route} is not here"))) };
    let opened = Gpu::open(driver).map_err(|cause| OpenError::Driver { route: route.clone(), cause })?;
    Ok(Executor::Gpu { road, gpu: Box::new(opened) })
}

fn shown(measured: &[Measurement], format: ListFormat) -> String {
    match format {
        ListFormat::Json => {
            measured.iter().map(|measurement| output::json_line(SCHEMA, measurement)).collect()
        }
        ListFormat::Human => measured.iter().map(human).collect(),
    }
}

fn human(measured: &Measurement) -> String {
    let Measurement { kernel, items, seconds, rounds, threads, .. } = measured;
    let rate = *items as f64 / seconds / 1e6;
    let mut text = format!("{kernel:7} {:24} {:9.2} ms {rate:9.1} M/s", measured.name(), seconds * 1e3);
    for (other, ratio) in &measured.ratio_to {
        text += &format!("  {ratio:.2} x {other}");
    }
    text + &format!("  ({items} items, {rounds} rounds, {threads} threads)\n")
}

/// Whether each instruction set keeps half of its goal.
fn holds(maker: &Maker, measured: &[Measurement]) -> Result<bool, Fail> {
    let at = WORKLOADS.iter().position(|w| w.name == maker.name).unwrap_or(0);
    let mut holds = true;
    for isa in Isa::available() {
        let Some(goal) = throughput::goals(isa).map(|goals| goals[at]) else { continue };
        let interp = measured.iter().find(|m| m.isa == Some(isa.to_string()));
        let ratio = interp.and_then(|m| m.ratio_to.get(YARDSTICK)).copied();
        let ratio = ratio.ok_or_else(|| Fail::Usage(format!("--floor needs interp and {YARDSTICK}")))?;
        if ratio < goal / 2.0 {
            let floor = goal / 2.0;
            eprintln!(
                "lobe: {} on {isa}: {ratio:.2} x {YARDSTICK} is below the floor of {floor}",
                maker.name
            );
            holds = false;
        }
    }
    Ok(holds)
}
