//! `lobe oracle`: tables of high-precision values.

use crate::check;
use crate::fail::{Fail, Outcome};
use crate::output::{self, Format};
use crate::report::ReportFiles;
use crate::route::{self, RouteArgs};
use crate::select;
use lobe_tests::oracle::{Mapping, judge_table, table};
use lobe_tests::question::Answer;
use lobe_tests::report::{KernelReport, Report, human};
use std::path::PathBuf;

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Folder of tables, files named `FUNCTION.jsonl`
    folder: PathBuf,
    /// Another mapping of tables to kernels than the standard one (tests/cases/oracle-map/)
    #[arg(long, value_name = "FILE")]
    mapping: Option<PathBuf>,
    #[command(flatten)]
    routes: RouteArgs,
    /// Form of the report
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
    #[command(flatten)]
    files: ReportFiles,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let mapping = match &args.mapping {
        Some(path) => {
            let text = std::fs::read_to_string(path);
            Mapping::parse(&text.map_err(|cause| Fail::Read { path: path.clone(), cause })?)
                .map_err(|cause| Fail::Usage(format!("{}: {cause}", path.display())))?
        }
        None => Mapping::standard()?,
    };
    args.files.check()?;
    let paths = table::list(&args.folder)?;
    let mut opened = route::open(&args.routes)?;
    let mut report = Report::new("oracle", 0).with_routes(&opened.executors);
    for path in paths {
        let found = judge_table(&table::read(&path)?, &mapping, &select::find, &mut opened.executors);
        report.unmapped.extend(found.unmapped);
        for (kernel, answer) in found.answers {
            add(&mut report, &kernel, answer);
        }
    }
    report.skipped = opened.skipped;
    if args.format == Format::Human {
        for kernel in &report.kernels {
            output::print(&human::render_kernel(kernel, output::style()))?;
        }
    }
    check::finish(&report, args.format, &args.files)
}

fn add(report: &mut Report, kernel: &str, answer: Answer) {
    if let Some(known) = report.kernels.iter_mut().find(|k| k.name == kernel) {
        known.answers.push(answer);
        return;
    }
    let mut fresh = match select::find(kernel) {
        Some(found) => KernelReport::new(found()),
        None => KernelReport::unknown(kernel),
    };
    fresh.answers.push(answer);
    report.kernels.push(fresh);
}
