//! `lobe golden`: pictures that were accepted, judged on every route, and decisions on new ones.

mod check;
mod decide;

use crate::fail::{Fail, Outcome};
use lobe_golden::{CaseName, Store};
use lobe_tests::cases::Cases;
use lobe_tests::golden::{Case, cases, folder};
use std::path::PathBuf;

/// Options.
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(crate) struct Args {
    #[command(subcommand)]
    command: Command,
}

const HELP: &str = "\
A golden is the true picture with what drivers may be off at each pixel, so one serves every route; tests/GOLDEN.md says more.

Exit codes: 0 all holds, 1 something is missing, damaged, changed or outside, 2 bad usage or input, 3 a required route is \
missing. Where CI is set, or with --no-write, nothing is written.";

#[derive(Debug, clap::Subcommand)]
enum Command {
    /// Judge every golden on every ready route; what is new or changed waits in `pending`
    Check(check::Args),
    /// The same as a page with all pictures, for those who review
    Report(check::ReportArgs),
    /// Accept what waits
    Accept(decide::DecideArgs),
    /// Reject what waits, and remember why
    Reject(decide::DecideArgs),
    /// Carry out the decisions of a file, all or none
    Apply(decide::ApplyArgs),
    /// Take the last decision back
    Undo(decide::ReasonArgs),
    /// Remove goldens that no case names
    Prune(decide::ReasonArgs),
}

/// Where goldens are.
#[derive(Debug, clap::Args)]
struct FolderArgs {
    /// The folder of goldens [default: LOBE_GOLDEN, else that of the source tree]
    #[arg(long, value_name = "DIR")]
    folder: Option<PathBuf>,
    /// Write nothing into it
    #[arg(long)]
    no_write: bool,
}

impl FolderArgs {
    fn path(&self) -> PathBuf {
        self.folder.clone().unwrap_or_else(folder)
    }

    /// CI does not write.
    fn may_write(&self) -> bool {
        let is_set = |value: std::ffi::OsString| !value.is_empty() && value != "false" && value != "0";
        !self.no_write && !std::env::var_os("CI").is_some_and(is_set)
    }

    fn store(&self) -> Store {
        if self.may_write() { Store::open(&self.path()) } else { Store::read_only(&self.path()) }
    }

    fn cases(&self) -> Result<Vec<Case>, Fail> {
        Ok(cases::read(&self.path().join("cases.toml"), &Cases::standard().folder().join("scenes"))?)
    }
}

/// Goldens that no case names.
fn dead(store: &Store, cases: &[Case]) -> Result<Vec<CaseName>, Fail> {
    let accepted = store.accepted_cases()?;
    Ok(accepted.into_iter().filter(|name| cases.iter().all(|case| case.name != *name)).collect())
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    match &args.command {
        Command::Check(args) => check::run(args),
        Command::Report(args) => check::report(args),
        Command::Accept(args) => decide::decide(args, true),
        Command::Reject(args) => decide::decide(args, false),
        Command::Apply(args) => decide::apply(args),
        Command::Undo(args) => decide::undo(args),
        Command::Prune(args) => decide::prune(args),
    }
}
