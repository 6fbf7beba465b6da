//! `lobe export`: a case as one file for others.

use crate::eval::rows;
use crate::fail::{Fail, Outcome};
use crate::model;
use crate::output;
use crate::route::{self, RouteArgs};
use crate::select;
use lobe_backends::executor::Executor;
use lobe_backends::route::Route;
use lobe_backends::routes::Machine;
use lobe_codegen::accuracy::Model;
use lobe_codegen::data::Columns;
use lobe_codegen::def::FunctionRef;
use lobe_tests::cases::Cases;
use lobe_tests::export::{Case, Form, export};
use lobe_tests::judge::{Plan, judge};
use lobe_tests::oracle::Mapping;
use lobe_tests::question::{Answer, Question};
use lobe_tests::subject::Subject;
use lobe_tests::value::parse_rows;
use std::path::PathBuf;

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// The kernel
    kernel: String,
    /// The arguments: a JSON object with the parameters' names, or a file with one a line; `-` reads standard input
    #[arg(long, value_name = "JSON", required_unless_present = "worst", conflicts_with = "worst")]
    input: Option<String>,
    /// Take the row, of those that `lobe check` draws, that uses most of its bound on the route, or on any
    #[arg(long)]
    worst: bool,
    /// Rows to draw for --worst
    #[arg(long, default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    inputs: u64,
    /// Where the drawing begins
    #[arg(long, default_value_t = 7)]
    seed: u64,
    /// Tell in the file what this route returns
    #[arg(long)]
    route: Option<Route>,
    /// What the case is written as
    #[arg(long = "as", value_enum)]
    form: FormName,
    /// Where it is written; standard output unless this is given
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// What drivers are permitted, by specification; see `lobe list --operations`
    #[arg(long, value_name = "MODEL", default_value = "portable", value_parser = model::parser())]
    model: &'static Model,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum FormName {
    /// A complete WGSL shader; `lobe run` takes it with its inputs
    Wgsl,
    /// A script for Amber, with SPIR-V assembly
    Amber,
    /// A test for LLVM's offload test suite, with HLSL
    Offload,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let kernel = select::kernel(&args.kernel)?;
    let subject = Subject::new(kernel)?.with_accuracy(args.model);
    let (rows, route) = match &args.input {
        Some(input) => (rows(kernel(), input)?, args.route.clone()),
        None => worst(kernel, args)?,
    };
    let mut executor = route.map(|route| Machine::look().open(&route)).transpose()?;
    let executor = executor.as_mut().map(|executor| executor.as_mut() as &mut dyn Executor);
    let form = match args.form {
        FormName::Wgsl => Form::Wgsl,
        FormName::Amber => Form::Amber,
        FormName::Offload => Form::Offload,
    };
    let text = export(&Case::new(&subject, &rows, args.model, executor)?, form)?;
    match &args.output {
        Some(path) => output::write_file(path, text.as_bytes())?,
        None => output::print(&text)?,
    }
    Ok(Outcome::Holds)
}

/// The row that uses most of its bound, and the route on which it does.
fn worst(kernel: FunctionRef, args: &Args) -> Result<(Columns, Option<Route>), Fail> {
    let mut executors = match &args.route {
        Some(route) => vec![Machine::look().open(route)?],
        None => route::open(&RouteArgs::default())?.executors,
    };
    let plan = Plan {
        inputs: args.inputs as usize,
        seed: args.seed,
        cases: Cases::standard(),
        mapping: Mapping::standard()?,
        sanitize: false,
        accuracy: args.model,
        drivers: 0,
        search: None,
        expected: Vec::new(),
    };
    let bar = output::progress(plan.inputs);
    let report = judge(kernel, &plan, &mut executors, &|rows| bar.inc(rows as u64));
    bar.finish_and_clear();
    let answers = report.answers.iter().filter(|a| a.question == Question::Conformant);
    let order = |a: &&Answer, b: &&Answer| {
        (a.falls_short(), a.share)
            .partial_cmp(&(b.falls_short(), b.share))
            .unwrap_or(std::cmp::Ordering::Equal)
    };
    let found = answers.filter(|answer| answer.worst.is_some()).max_by(order);
    let Some((answer, worst)) = found.and_then(|answer| Some((answer, answer.worst.as_ref()?))) else {
        let why = report.answers.iter().find_map(|answer| match answer.falls_short() {
            true => Some(format!("{:?}", answer.verdict)),
            false => None,
        });
        let why = why.unwrap_or_else(|| "no row has a bound".to_owned());
        return Err(Fail::Usage(format!(
            "{}: there is no worst row: {why}; give one with --input",
            args.kernel
        )));
    };
    let row = worst.args.to_string();
    let row =
        parse_rows(kernel(), &row).map_err(|cause| Fail::Row { name: "the worst row".to_owned(), cause })?;
    Ok((row, answer.subject.parse().ok()))
}
