//! `lobe merge`: one report out of parts.

use crate::check::finish;
use crate::fail::{Fail, Outcome};
use crate::output::{self, Format};
use crate::report::ReportFiles;
use lobe_tests::report::{human, merge};
use std::path::PathBuf;

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Reports of `lobe check --format json`, or folders of them, as LOBE_REPORT_DIR names one for tests
    #[arg(required = true, value_name = "DIR|FILE")]
    paths: Vec<PathBuf>,
    /// Form of the report
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    /// Show the worst row of every answer, with the command that runs it again
    #[arg(long)]
    worst: bool,
    #[command(flatten)]
    files: ReportFiles,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    args.files.check()?;
    let report = merge::merge(merge::read(&args.paths)?)?;
    if args.format == Format::Human {
        let style = human::Style { worst: args.worst, ..output::style() };
        report.kernels.iter().try_for_each(|kernel| output::print(&human::render_kernel(kernel, style)))?;
    }
    finish(&report, args.format, &args.files)
}
