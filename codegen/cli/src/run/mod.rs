//! `lobe run`: somebody's own compute shader, on the interpreter and on every GPU route.

mod check;
mod junit;
mod list;
mod options;
mod text;

use crate::fail::{Fail, Outcome};
use crate::output::{self, Format};
use lobe_tests::expectation::{self, Expectation};
use lobe_tests::shader::job::{Entry, Job};
use lobe_tests::shader::report::{Report, Status};
use lobe_tests::shader::routes::{Routes, ShaderRoute};
use lobe_tests::shader::{READY, serve, supervise};
use options::JobArgs;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Options.
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(crate) struct Args {
    #[command(flatten)]
    job: JobArgs,
    /// Run many shaders, a line of the report each: a folder of shaders, or a file with a shader and its options a line
    #[arg(long, value_name = "LIST", conflicts_with_all = ["file", "outputs"])]
    batch: Option<PathBuf>,
    /// Shaders that a batch runs at a time; by default one for each processor
    #[arg(long, value_name = "N", requires = "batch", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Known faults of routes; one that is there passes, one that is gone fails
    #[arg(long, value_name = "FILE")]
    expectations: Option<PathBuf>,
    /// Form of the report
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    #[command(flatten)]
    check: check::CheckArgs,
    /// Take jobs from standard input, for a `lobe run` that watches over this one
    #[arg(long, hide = true)]
    serve: bool,
}

const HELP: &str = "\
Each buffer that the entry point uses is filled as --input says, else with random:0. \
random:SEED draws floats from -1..1, u32 from 0..64 and i32 from -32..32; edges:SEED draws floats on the edges of \
their type (zeros, subnormals, neighbours of 1, small and large numbers) and integers alike; atomics start at 0. \
words:WORD,.. are 32-bit words, as 12 or 0xc. \
FILE is JSON that follows the type (.json: arrays, objects, floats also as \"0x1.8p3\", \"nan\", \"inf\"), \
or else the bytes themselves. \
A buffer that ends in an array without length gets an element for each invocation, 64 at least, and at most 64 MiB.

Elements of a binding array are NAME[INDEX] or GROUP:BINDING[INDEX], in quotes where the shell wants them; \
NAME alone means all of them.

Routes are TARGET+TRANSLATOR@DRIVER as `lobe doctor` lists them, original@DRIVER (the words of a SPIR-V file), \
ready (all of these that this machine has), perturbed:SEED (a driver drawn by chance, which takes liberties that are \
permitted), judge (the interpreter's second opinion, to the bit), interp (compare with none).

Lines of a shader's text that begin with `// lobe: ` hold options for it; the command line wins over them.

A batch runs every compute entry point of a file that names none. In a list, what a line says wins over \
what the command line says; empty lines and lines that begin with # are passed over.

A check asks whether every route is within the derived bound on every input (conformant), whether routes to one \
driver are equal bit for bit or both within the bound (agree), and for mistakes of the program; it counts the outputs that have no bound, \
and keeps the worst input with the command that runs it again. What --input names stays the same in all of them.

Results: ok, or differs (by more than is permitted), unjudged (floats differ, and no bound says by how much they may), \
findings (the program does something wrong), refused (the interpreter does not execute something), \
invalid (naga refuses the file), error (an option does not fit), timeout, crashed.

Exit codes: 0 all ok, 2 nothing worse than invalid or error, 3 a route named by --route is missing, else 1.";

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    if args.serve {
        return serve::serve().map(|()| Outcome::Holds).map_err(Fail::Stdout);
    }
    let mut jobs = match (&args.batch, &args.job.file) {
        (Some(list), _) => list::jobs(list, &args.job)?,
        (None, Some(file)) => vec![list::one(file.clone(), &args.job, Entry::Only)?],
        (None, None) => {
            return Err(Fail::Usage("name a shader, or a list of shaders with --batch".to_owned()));
        }
    };
    check_routes(&jobs)?;
    args.check.require()?;
    if let Some(file) = &args.expectations {
        let all = expectation::read(file)?;
        jobs.iter_mut().for_each(|job| job.expected = of(&job.file, &all));
    }
    if args.check.check { check::run(args, &jobs) } else { report(args, &jobs) }
}

/// Those of `all` that are about a shader.
fn of(shader: &Path, all: &[Expectation]) -> Vec<Expectation> {
    let name = shader.file_stem().unwrap_or_default().to_string_lossy();
    all.iter().filter(|e| e.is_of(&name)).cloned().collect()
}

/// Whether this machine has every route that is asked for by name.
fn check_routes(jobs: &[Job]) -> Result<(), Fail> {
    let is_route = |name: &&String| *name != "interp" && *name != READY;
    let mut named: Vec<&String> = jobs.iter().flat_map(|j| &j.routes).filter(is_route).collect();
    named.sort_unstable();
    named.dedup();
    if named.is_empty() {
        return Ok(());
    }
    let routes = Routes::look();
    for name in named {
        let route: ShaderRoute = name.parse().map_err(Fail::Usage)?;
        if let Some(what) = routes.missing(&route) {
            return Err(Fail::Missing { route: name.clone(), what });
        }
    }
    Ok(())
}

fn report(args: &Args, jobs: &[Job]) -> Result<Outcome, Fail> {
    let mut tally = BTreeMap::new();
    let mut broken = Ok(());
    let mut all = Vec::new();
    supervise::supervise(&plan(args)?, jobs, &mut |_, reports| {
        for report in reports {
            *tally.entry(report.status).or_insert(0) += 1;
            if args.format == Format::Junit {
                all.push(report);
            } else if broken.is_ok() {
                broken = print(args, &report);
            }
        }
    });
    broken?;
    if args.format == Format::Junit {
        output::print(&junit::render(&all))?;
    } else if args.batch.is_some() {
        output::print(&text::summary(&tally, args.format))?;
    }
    Ok(outcome(&tally))
}

fn plan(args: &Args) -> Result<supervise::Plan, Fail> {
    let program = std::env::current_exe().map_err(|cause| Fail::Read { path: "lobe".into(), cause })?;
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let is_many = args.batch.is_some() || args.check.check;
    let workers = if is_many { args.jobs.map_or(processors, usize::from) } else { 1 };
    let arguments = ["run", "--serve"].map(str::to_owned).to_vec();
    let threads = is_many.then(|| (processors / workers).max(1));
    Ok(supervise::Plan { program, arguments, workers, threads })
}

fn print(args: &Args, report: &Report) -> Result<(), Fail> {
    match (args.format, &args.batch) {
        (Format::Json | Format::Junit, _) => output::print(&text::json(report)),
        (Format::Human, Some(_)) => output::print(&text::line(report)),
        (Format::Human, None) => output::print(&text::whole(report)),
    }
}

fn outcome(tally: &BTreeMap<Status, usize>) -> Outcome {
    let are_all = |wanted: &[Status]| tally.keys().all(|status| wanted.contains(status));
    if are_all(&[Status::Ok]) {
        Outcome::Holds
    } else if are_all(&[Status::Ok, Status::Invalid, Status::Error]) {
        Outcome::BadInput
    } else {
        Outcome::FellShort
    }
}
