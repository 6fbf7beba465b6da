//! `lobe golden check` and `report`: every golden on every route.

use super::{FolderArgs, dead};
use crate::fail::{Fail, Outcome};
use crate::output::{self, Format};
use lobe_backends::route::Route;
use lobe_backends::routes::{Machine, OpenError, State};
use lobe_golden::{CaseName, StoreError};
use lobe_tests::golden::report::{Report, SCHEMA, Tally};
use lobe_tests::golden::{Case, Choice, Routes, Session, environment, human, junit, page};
use lobe_tests::render::Renderer;
use lobe_tests::report::Skipped;
use std::path::{Path, PathBuf};

/// Options of both.
#[derive(Debug, clap::Args)]
struct Common {
    /// Goldens to judge, as `plots/ggx_ndf` or, all of a scene, `plots`; all when none is named
    #[arg(value_name = "SCENE/METHOD")]
    names: Vec<String>,
    #[command(flatten)]
    folder: FolderArgs,
    /// Take only these routes, as `interp` or `spirv@lavapipe`
    #[arg(long = "route", value_name = "ROUTE")]
    routes: Vec<Route>,
    /// End with exit code 3 if one of these routes is missing
    #[arg(long = "require", value_name = "ROUTE")]
    require: Vec<Route>,
    /// Compute the truth of every golden, not only of those whose hashes changed: slow
    #[arg(long)]
    every_truth: bool,
    /// Form of the report
    #[arg(long, value_enum, default_value_t = Format::Human)]
    format: Format,
}

/// Options of `check`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    #[command(flatten)]
    common: Common,
    /// Leave goldens out whose kernels, scene and settings have the hashes that were accepted, and say which these are
    #[arg(long, conflicts_with = "every_truth")]
    affected: bool,
    /// Write the report to a file too, by its ending: .json or .xml (JUnit)
    #[arg(long = "report", value_name = "FILE")]
    reports: Vec<PathBuf>,
    /// Write all pictures to this folder, as EXR
    #[arg(long, value_name = "DIR")]
    evidence: Option<PathBuf>,
}

/// Options of `report`.
#[derive(Debug, clap::Args)]
pub(crate) struct ReportArgs {
    /// The folder to write `index.html`, `report.json` and all pictures to
    #[arg(value_name = "DIR")]
    to: PathBuf,
    #[command(flatten)]
    common: Common,
}

/// Runs `check`.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let writers =
        args.reports.iter().map(|path| Ok((path, form(path)?))).collect::<Result<Vec<_>, Fail>>()?;
    let report = judged(&args.common, args.affected, args.evidence.clone())?;
    for (path, render) in writers {
        output::write_file(path, render(&report).as_bytes())?;
    }
    finish(&args.common, &report)
}

/// Runs `report`.
pub(crate) fn report(args: &ReportArgs) -> Result<Outcome, Fail> {
    let write = |cause| Fail::Write { path: args.to.clone(), cause };
    std::fs::create_dir_all(&args.to).map_err(write)?;
    let report = judged(&args.common, false, Some(args.to.clone()))?;
    output::write_file(&args.to.join("report.json"), report.json().as_bytes())?;
    let written = page::write(&report, &args.to)?;
    let outcome = finish(&args.common, &report)?;
    if args.common.format == Format::Human {
        output::print(&format!("page: {}\n", written.page.display()))?;
    }
    Ok(outcome)
}

fn form(path: &Path) -> Result<fn(&Report) -> String, Fail> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("json") => Ok(Report::json),
        Some("xml") => Ok(junit::render),
        _ => Err(Fail::Usage(format!("{}: its ending says its form: .json or .xml", path.display()))),
    }
}

fn judged(args: &Common, only_affected: bool, evidence: Option<PathBuf>) -> Result<Report, Fail> {
    let cases = args.folder.cases()?;
    let chosen = choose(&cases, &args.names)?;
    let store = args.folder.store();
    let (routes, skipped) = routes(args)?;
    let renderer = Renderer::new()?;
    let writes_pending = args.folder.may_write();
    let choice =
        Choice { only_affected, every_truth: args.every_truth, writes_pending, evidence: evidence.clone() };
    let mut session = Session::new(&renderer, &store, routes, choice);
    let mut report = Report {
        schema: SCHEMA,
        report: "golden".to_owned(),
        lobe: env!("CARGO_PKG_VERSION").to_owned(),
        environment: environment(),
        golden: args.folder.path().display().to_string(),
        evidence: evidence.map(|folder| folder.display().to_string()),
        routes: session.routes().names(),
        skipped,
        items: Vec::new(),
        dead: Vec::new(),
        interrupted: false,
        pending: writes_pending.then(|| args.folder.path().join("pending").display().to_string()),
        bytes: 0,
        tally: Tally::default(),
    };
    let bar = output::progress(chosen.len());
    for case in chosen {
        bar.set_message(case.name.to_string());
        let item = match session.check(case) {
            Err(StoreError::Interrupted) => break,
            outcome => outcome?,
        };
        if args.format == Format::Human {
            bar.suspend(|| output::print(&human::item(&item)))?;
        }
        report.items.push(item);
        bar.inc(1);
    }
    bar.finish_and_clear();
    report.interrupted = store.is_interrupted();
    if !report.interrupted {
        report.bytes = store.bytes()?;
        if args.names.is_empty() {
            report.dead = dead(&store, &cases)?.iter().map(CaseName::to_string).collect();
        }
    }
    Ok(report.tallied())
}

fn finish(args: &Common, report: &Report) -> Result<Outcome, Fail> {
    output::print(&match args.format {
        Format::Human => human::summary(report),
        Format::Json => report.json(),
        Format::Junit => junit::render(report),
    })?;
    Ok(if report.holds() { Outcome::Holds } else { Outcome::FellShort })
}

/// The cases of these names, or of scenes of these names.
fn choose<'c>(cases: &'c [Case], names: &[String]) -> Result<Vec<&'c Case>, Fail> {
    let is_of = |case: &Case, name: &str| case.name.to_string() == name || case.name.scene.as_str() == name;
    if let Some(name) = names.iter().find(|name| !cases.iter().any(|case| is_of(case, name))) {
        let known: Vec<String> = cases.iter().map(|case| case.name.to_string()).collect();
        let message =
            format!("there is no golden `{}`; there are {}", name.escape_default(), known.join(", "));
        return Err(Fail::Usage(message));
    }
    let is_chosen = |case: &&Case| names.is_empty() || names.iter().any(|name| is_of(case, name));
    Ok(cases.iter().filter(is_chosen).collect())
}

/// The routes that are ready, or those asked for, and those that are missing.
fn routes<'r>(args: &Common) -> Result<(Routes<'r>, Vec<Skipped>), Fail> {
    let machine = Machine::look();
    for route in args.require.iter().chain(&args.routes) {
        if let State::Missing { what, mend } = machine.state(route) {
            return Err(OpenError::Missing { route: route.clone(), what, mend }.into());
        }
    }
    let (mut ready, mut skipped) = (Vec::new(), Vec::new());
    for (route, state) in machine.routes() {
        let is_chosen =
            args.routes.is_empty() || args.routes.contains(&route) || args.require.contains(&route);
        match state {
            State::Ready if is_chosen => ready.push(route),
            State::Missing { what, mend } if is_chosen => {
                skipped.push(Skipped { route: route.to_string(), what, mend });
            }
            State::Ready | State::Missing { .. } => {}
        }
    }
    Ok((Routes::new(machine, ready), skipped))
}
