//! `lobe golden accept`, `reject`, `apply`, `undo` and `prune`: decisions.

use super::{FolderArgs, dead};
use crate::fail::{Fail, Outcome};
use crate::output;
use lobe_golden::{Action, CaseName, Decision, Reviewer, Step};
use lobe_tests::golden::decisions::Decisions;
use std::path::PathBuf;

/// Bytes of a file of decisions, at most.
const MOST_BYTES: u64 = 16 << 20;

/// Who decides, and why.
#[derive(Debug, clap::Args)]
struct Who {
    /// Who decides [default: the user of this machine]
    #[arg(long, value_name = "NAME")]
    by: Option<String>,
    #[command(flatten)]
    folder: FolderArgs,
}

/// Options of `accept` and `reject`.
#[derive(Debug, clap::Args)]
pub(crate) struct DecideArgs {
    /// What is decided on, as `plots/ggx_ndf`
    #[arg(value_name = "SCENE/METHOD", required_unless_present = "all", conflicts_with = "all")]
    names: Vec<CaseName>,
    /// All that waits, seen or not
    #[arg(long)]
    all: bool,
    /// Why: it stays with the golden, and in decisions.jsonl
    #[arg(long, value_name = "WHY")]
    reason: String,
    #[command(flatten)]
    who: Who,
}

/// Options of `apply`.
#[derive(Debug, clap::Args)]
pub(crate) struct ApplyArgs {
    /// The file that the review page exported
    file: PathBuf,
    #[command(flatten)]
    who: Who,
}

/// Options of `undo` and `prune`.
#[derive(Debug, clap::Args)]
pub(crate) struct ReasonArgs {
    /// Why
    #[arg(long, value_name = "WHY")]
    reason: String,
    #[command(flatten)]
    who: Who,
}

impl Who {
    fn reviewer(&self, otherwise: &str) -> Result<Reviewer, Fail> {
        let user = || ["USER", "USERNAME", "LOGNAME"].iter().find_map(|name| std::env::var(name).ok());
        let named = self.by.clone().or_else(|| Some(otherwise.to_owned()).filter(|name| !name.is_empty()));
        let name = named.or_else(user).filter(|name| !name.trim().is_empty());
        let name =
            name.ok_or_else(|| Fail::Usage("nobody is named who decides: give --by NAME".to_owned()))?;
        Ok(Reviewer::now(&name))
    }
}

/// Runs `accept`, or `reject`.
pub(crate) fn decide(args: &DecideArgs, accepts: bool) -> Result<Outcome, Fail> {
    let store = args.who.folder.store();
    let cases = if args.all { store.pending_cases()? } else { args.names.clone() };
    if cases.is_empty() {
        return Err(Fail::Usage(
            "nothing waits for a decision; `lobe golden check` says what does".to_owned(),
        ));
    }
    let step = |case| Step { case, accepts, reason: args.reason.clone(), chain: None, exr: None };
    let steps: Vec<Step> = cases.into_iter().map(step).collect();
    told(&store.carry_out(&steps, &args.who.reviewer("")?)?)
}

/// Runs `apply`.
pub(crate) fn apply(args: &ApplyArgs) -> Result<Outcome, Fail> {
    let path = &args.file;
    let read = |cause| Fail::Read { path: path.clone(), cause };
    let bytes = std::fs::metadata(path).map_err(read)?.len();
    if bytes > MOST_BYTES {
        let message =
            format!("{}: it has {bytes} bytes; decisions have at most {MOST_BYTES}", path.display());
        return Err(Fail::Usage(message));
    }
    let text = std::fs::read_to_string(path).map_err(read)?;
    let decisions =
        Decisions::parse(&text).map_err(|why| Fail::Usage(format!("{}: {why}", path.display())))?;
    let reviewer = args.who.reviewer(&decisions.by)?;
    told(&args.who.folder.store().carry_out(&decisions.steps(), &reviewer)?)
}

/// Runs `undo`.
pub(crate) fn undo(args: &ReasonArgs) -> Result<Outcome, Fail> {
    let done = args.who.folder.store().undo(&args.who.reviewer("")?, &args.reason)?;
    told(&[done])
}

/// Runs `prune`.
pub(crate) fn prune(args: &ReasonArgs) -> Result<Outcome, Fail> {
    let store = args.who.folder.store();
    let dead = dead(&store, &args.who.folder.cases()?)?;
    if dead.is_empty() {
        output::print("every golden is of a case: nothing is removed\n")?;
        return Ok(Outcome::Holds);
    }
    told(&store.prune(&dead, &args.who.reviewer("")?, &args.reason)?)
}

fn told(decisions: &[Decision]) -> Result<Outcome, Fail> {
    for Decision { action, case, by, reason, .. } in decisions {
        let word = match action {
            Action::Accept => "accepted",
            Action::Reject => "rejected",
            Action::Undo => "taken back",
            Action::Prune => "removed",
        };
        output::print(&format!("{word:12} {case}, by {by}: {reason}\n"))?;
    }
    Ok(Outcome::Holds)
}
