//! `lobe run --check`: shaders on many inputs, judged as kernels are.

use super::{Args, Format};
use crate::check::finish;
use crate::fail::{Fail, Outcome};
use crate::output;
use crate::report::ReportFiles;
use lobe_backends::routes::{Machine, State};
use lobe_tests::report::{self, Skipped, human};
use lobe_tests::shader::check::{Extent, gather, runs};
use lobe_tests::shader::job::Job;
use lobe_tests::shader::report::Report;
use lobe_tests::shader::supervise;

/// Options.
#[derive(Debug, clap::Args)]
pub(super) struct CheckArgs {
    /// Judge the shader as kernels are judged: on many inputs, by every route and by drivers drawn by chance
    #[arg(long, conflicts_with = "outputs")]
    pub(super) check: bool,
    /// Inputs of a check: drawn, on the edges of their types, and zeros, in turns
    #[arg(long = "inputs", value_name = "N", requires = "check", default_value_t = 16,
          value_parser = clap::value_parser!(u64).range(1..=100_000))]
    count: u64,
    /// Drivers drawn by chance, for each input of a check
    #[arg(long, value_name = "N", requires = "check", default_value_t = 3,
          value_parser = clap::value_parser!(u64).range(0..=1000))]
    drivers: u64,
    /// Where the drawing begins; the same seed draws the same inputs
    #[arg(long, requires = "check", default_value_t = 0)]
    seed: u64,
    /// Show the worst input of every answer, with the command that runs it again
    #[arg(long, requires = "check")]
    worst: bool,
    #[command(flatten)]
    files: ReportFiles,
}

impl CheckArgs {
    /// Whether nothing is wanted that a check alone gives.
    pub(super) fn require(&self) -> Result<(), Fail> {
        if self.check || self.files.is_empty() {
            return Ok(());
        }
        Err(Fail::Usage("--report goes with --check; a run without it prints its report".to_owned()))
    }

    fn extent(&self) -> Extent {
        Extent { inputs: self.count, drivers: self.drivers, seed: self.seed }
    }
}

/// Checks each of `jobs`.
pub(super) fn run(args: &Args, jobs: &[Job]) -> Result<Outcome, Fail> {
    args.check.files.check()?;
    let (extent, style) = (args.check.extent(), human::Style { worst: args.check.worst, ..output::style() });
    let all: Vec<Job> = jobs.iter().flat_map(|job| runs(job, extent)).collect();
    let of_each = extent.inputs as usize;
    let mut report = report::Report::new("run", extent.seed);
    report.model = jobs.first().and_then(|job| job.model.clone());
    if jobs.iter().any(|job| job.routes.is_empty()) {
        report.skipped = skipped();
    }
    let bar = output::progress(all.len());
    let mut found: Vec<(&Job, Vec<Report>)> = Vec::new();
    // They come in the order in which they were given.
    let mut given = all.iter();
    let mut done = jobs.iter();
    let mut broken = Ok(());
    supervise::supervise(&super::plan(args)?, &all, &mut |_, reports| {
        bar.inc(1);
        found.extend(given.next().map(|run| (run, reports)));
        if found.len() < of_each {
            return;
        }
        let pairs: Vec<(&Job, &[Report])> = found.iter().map(|(run, reports)| (*run, &reports[..])).collect();
        let subjects = done.next().map(|job| gather(job, &pairs)).unwrap_or_default();
        if args.format == Format::Human && broken.is_ok() {
            let text: String = subjects.iter().map(|subject| human::render_kernel(subject, style)).collect();
            broken = bar.suspend(|| output::print(&text));
        }
        take_routes(&mut report, &found);
        report.kernels.extend(subjects);
        found.clear();
    });
    bar.finish_and_clear();
    broken?;
    finish(&report, args.format, &args.check.files)
}

/// Routes to drivers that this machine lacks.
fn skipped() -> Vec<Skipped> {
    let routes = Machine::look().routes().into_iter();
    let missing = routes.filter_map(|(route, state)| match state {
        State::Ready => None,
        State::Missing { what, mend } => Some(Skipped { route: route.to_string(), what, mend }),
    });
    missing.collect()
}

/// Adds the names of routes that ran, but for those drawn by chance.
fn take_routes(report: &mut report::Report, found: &[(&Job, Vec<Report>)]) {
    let routes = found.iter().flat_map(|(_, reports)| reports).flat_map(|report| &report.routes);
    for route in routes.filter(|route| !route.driver.is_empty()) {
        if !report.routes.contains(&route.route) {
            report.routes.push(route.route.clone());
            let driver = route.route.split_once('@').map_or("", |(_, driver)| driver);
            report.drivers.insert(driver.to_owned(), route.driver.clone());
        }
    }
}
