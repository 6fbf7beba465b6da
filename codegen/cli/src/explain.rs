//! `lobe explain`: which operation a wrong or poor result comes from.

use crate::eval::rows;
use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use crate::select;
use lobe_backends::route::Route;
use lobe_backends::routes::{Machine, State};
use lobe_codegen::data::Columns;
use lobe_tests::explain::{Explanation, explain, human};
use lobe_tests::subject::Subject;
use serde::Serialize;

/// Version of the format.
const SCHEMA: u32 = 1;

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// The kernel
    kernel: String,
    /// The arguments: a JSON object with the parameters' names, or a file that holds one; `-` reads standard input
    #[arg(long, value_name = "JSON")]
    input: String,
    /// Where to run it; the first driver that is ready unless this is given
    #[arg(long)]
    route: Option<Route>,
    /// Form of the report
    #[arg(long, value_enum, default_value_t = ListFormat::Human)]
    format: ListFormat,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let kernel = select::kernel(&args.kernel)?;
    let row = row(kernel(), &args.input)?;
    let machine = Machine::look();
    let route = args.route.clone().map_or_else(|| first(&machine), Ok)?;
    if route == Route::Native {
        let why =
            "native code tells nothing on the way; take `interp` or a driver (`lobe doctor` lists them)";
        return Err(Fail::Usage(why.to_owned()));
    }
    let mut executor = machine.open(&route)?;
    let found = explain(&Subject::new(kernel)?, executor.as_mut(), &row)?;
    output::print(&match args.format {
        ListFormat::Human => human::render(&found),
        ListFormat::Json => json(&found),
    })?;
    Ok(if found.holds() { Outcome::Holds } else { Outcome::FellShort })
}

/// The one row of arguments.
fn row(kernel: &lobe_codegen::def::FunctionDef, input: &str) -> Result<Columns, Fail> {
    let rows = rows(kernel, input)?;
    match rows.rows {
        1 => Ok(rows),
        n => Err(Fail::Usage(format!("--input: holds {n} rows of arguments; one is explained at a time"))),
    }
}

/// The first route to a driver that is ready.
fn first(machine: &Machine) -> Result<Route, Fail> {
    let ready = machine.routes().into_iter().find_map(|(route, state)| {
        (matches!(route, Route::Gpu { .. }) && state == State::Ready).then_some(route)
    });
    ready.ok_or_else(|| Fail::Missing {
        route: "to a driver".to_owned(),
        what: "none is ready here; `lobe doctor` says how to get one, `--route interp` takes none".to_owned(),
    })
}

#[derive(Serialize)]
struct Report<'a> {
    schema: u32,
    report: &'static str,
    holds: bool,
    #[serde(flatten)]
    found: &'a Explanation,
}

fn json(found: &Explanation) -> String {
    let report = Report { schema: SCHEMA, report: "explain", holds: found.holds(), found };
    // Maps with string keys only: this cannot fail, and if it did the text would say so.
    let text = serde_json::to_string_pretty(&report);
    text.unwrap_or_else(|e| format!("{{\"schema\":{SCHEMA},\"error\":{:?}}}", e.to_string())) + "\n"
}
