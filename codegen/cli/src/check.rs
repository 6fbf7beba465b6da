//! `lobe check`: the four questions.

use crate::fail::{Fail, Outcome};
use crate::model;
use crate::output::{self, Format};
use crate::report::ReportFiles;
use crate::route::{self, RouteArgs};
use crate::select;
use lobe_codegen::accuracy::Model;
use lobe_tests::cases::Cases;
use lobe_tests::expectation;
use lobe_tests::judge::{Plan, Prepared, ahead, judge_prepared};
use lobe_tests::oracle::Mapping;
use lobe_tests::report::part::Share;
use lobe_tests::report::{KernelReport, Report, human, json, junit};
use lobe_tests::search::Limit;
use std::path::PathBuf;
use std::time::Duration;

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Kernels to check; all when none is named
    kernels: Vec<String>,
    /// Rows of arguments to draw for each kernel
    #[arg(long, default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    inputs: u64,
    /// Where the drawing begins; the same seed draws the same rows
    #[arg(long, default_value_t = 7)]
    seed: u64,
    /// Check only a share of the kernels, as the second of three; `lobe merge` joins the JSON reports
    #[arg(long, value_name = "2/3")]
    partition: Option<Share>,
    /// Look for mistakes of the kernels too: division by zero, NaN out of numbers, a place outside an array, ..
    #[arg(long)]
    sanitize: bool,
    /// Run every row on so many drivers drawn by chance too, which err as far as they are permitted: says whether the
    /// bounds are sound, and how tight
    #[arg(long, value_name = "DRIVERS", default_value_t = 0, value_parser = clap::value_parser!(u32).range(0..=1_000_000))]
    perturbed: u32,
    /// Look for so many seconds, for each kernel, for rows that are worse than those drawn
    #[arg(long, value_name = "SECONDS", value_parser = clap::value_parser!(u64).range(1..))]
    search: Option<u64>,
    /// List the rows that the search found to be worse in the folder of cases, so that every check takes them
    #[arg(long, requires = "search")]
    keep: bool,
    /// Known faults of routes; one that is there passes, one that is gone fails [default: expectations.toml in the folder
    /// of cases, if there is one]
    #[arg(long, value_name = "FILE")]
    expectations: Option<PathBuf>,
    /// What drivers are permitted, by specification; see `lobe list --operations`
    #[arg(long, value_name = "MODEL", default_value = "portable", value_parser = model::parser())]
    model: &'static Model,
    #[command(flatten)]
    routes: RouteArgs,
    /// Form of the report
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    #[command(flatten)]
    files: ReportFiles,
    /// Show the worst row of every answer, with the command that runs it again
    #[arg(long)]
    worst: bool,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let mut kernels = select::kernels(&args.kernels)?;
    args.files.check()?;
    let mut opened = route::open(&args.routes)?;
    let cases = Cases::standard();
    let plan = Plan {
        inputs: args.inputs as usize,
        seed: args.seed,
        expected: match &args.expectations {
            Some(file) => expectation::read(file)?,
            None => expectation::of_cases(&cases)?,
        },
        cases,
        mapping: Mapping::standard()?,
        sanitize: args.sanitize,
        accuracy: args.model,
        drivers: args.perturbed as usize,
        search: args.search.map(|seconds| Limit::Time(Duration::from_secs(seconds))),
    };
    let mut report = Report::new("check", args.seed).with_accuracy(args.model).with_routes(&opened.executors);
    if let Some(share) = args.partition {
        let names = kernels.iter().map(|kernel| kernel().name.to_owned()).collect();
        report.part = Some(share.part(names, plan.inputs));
        kernels = kernels.into_iter().enumerate().filter(|(at, _)| share.has(*at)).map(|(_, k)| k).collect();
    }
    let bar = output::progress(kernels.len() * plan.inputs);
    let ahead = ahead(&opened.executors);
    std::thread::scope(|scope| {
        for kernel in Prepared::each(scope, kernels, &plan, ahead) {
            bar.set_message(kernel.def().name);
            let found = judge_prepared(kernel, &plan, &mut opened.executors, &|rows| bar.inc(rows as u64));
            if args.format == Format::Human {
                let style = human::Style { worst: args.worst, ..output::style() };
                bar.suspend(|| output::print(&human::render_kernel(&found, style)))?;
            }
            if args.keep {
                keep(&plan.cases, &found)?;
            }
            report.kernels.push(found);
        }
        Ok::<_, Fail>(())
    })?;
    bar.finish_and_clear();
    report.skipped = opened.skipped;
    finish(&report, args.format, &args.files)
}

/// Lists the rows that the search found to be worse than all before.
fn keep(cases: &Cases, found: &KernelReport) -> Result<(), Fail> {
    let finds = found.search.iter().flat_map(|search| &search.finds);
    let new = finds.filter(|find| find.is_new()).map(|find| &find.args);
    cases.keep(&found.name, new).map_err(|cause| Fail::Write { path: cases.rows(&found.name), cause })
}

/// Writes and prints what is not printed yet, and ends the run.
pub(crate) fn finish(report: &Report, format: Format, files: &ReportFiles) -> Result<Outcome, Fail> {
    files.write(report)?;
    output::print(&match format {
        Format::Human => human::summary(report, output::style()),
        Format::Json => json::render(report),
        Format::Junit => junit::render(report),
    })?;
    Ok(if report.holds() { Outcome::Holds } else { Outcome::FellShort })
}
