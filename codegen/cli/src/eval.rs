//! `lobe eval`: rows of arguments in, rows of results out, both as JSON lines.

use crate::fail::{Fail, Outcome};
use crate::output;
use crate::select;
use lobe_backends::executor::Program;
use lobe_backends::interp::ShadowColumn;
use lobe_backends::route::Route;
use lobe_backends::routes::Machine;
use lobe_codegen::data::{Columns, WordReader};
use lobe_codegen::def::FunctionDef;
use lobe_tests::value::{Floats, parse_rows, value_json};
use serde_json::{Map, Number, Value, json};
use std::io::Read;
use std::path::PathBuf;

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// The kernel
    kernel: String,
    /// Rows of arguments: a JSON object a line with the parameters' names; `-` reads standard input
    #[arg(long, value_name = "FILE")]
    args: PathBuf,
    /// Where to run it
    #[arg(long, default_value = "native")]
    route: Route,
    /// Give f32 value, f64 value and error bound of each scalar (interpreter only)
    #[arg(long, conflicts_with = "route")]
    shadow: bool,
    /// Write floats in hexadecimal
    #[arg(long)]
    hex: bool,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let kernel = select::kernel(&args.kernel)?;
    let (name, text) = read(&args.args)?;
    let rows = parse_rows(kernel(), &text).map_err(|cause| Fail::Row { name: name.clone(), cause })?;
    if rows.rows == 0 {
        return Err(Fail::Usage(format!("{name}: holds no row of arguments")));
    }
    let program = Program::new(kernel)?;
    let floats = if args.hex { Floats::Hex } else { Floats::Decimal };
    let lines = if args.shadow { shadow(&program, &rows)? } else { values(&program, &rows, args, floats)? };
    output::print(&lines)?;
    Ok(Outcome::Holds)
}

/// The name and text of a file, or of standard input.
fn read(path: &PathBuf) -> Result<(String, String), Fail> {
    if path.as_os_str() == "-" {
        let mut text = String::new();
        let cause = std::io::stdin().read_to_string(&mut text);
        cause.map_err(|cause| Fail::Read { path: "standard input".into(), cause })?;
        return Ok(("standard input".to_owned(), text));
    }
    let text = std::fs::read_to_string(path);
    Ok((path.display().to_string(), text.map_err(|cause| Fail::Read { path: path.clone(), cause })?))
}

/// Rows of arguments that an option gives: JSON itself, or a file that holds it; `-` is standard input.
pub(crate) fn rows(kernel: &FunctionDef, input: &str) -> Result<Columns, Fail> {
    let (name, text) = match input.trim_start().starts_with('{') {
        true => ("--input".to_owned(), input.to_owned()),
        false => read(&PathBuf::from(input))?,
    };
    let rows = parse_rows(kernel, &text).map_err(|cause| Fail::Row { name: name.clone(), cause })?;
    match rows.rows {
        0 => Err(Fail::Usage(format!("{name}: holds no row of arguments"))),
        _ => Ok(rows),
    }
}

fn values(program: &Program, rows: &Columns, args: &Args, floats: Floats) -> Result<String, Fail> {
    let output = Machine::look().open(&args.route)?.run(program, rows)?;
    let line = |row: usize| match &program.def().ret {
        Some(ty) => value_json(ty, &mut WordReader::new(&output.row(row)), floats),
        None => Value::Null,
    };
    Ok((0..rows.rows).map(|row| format!("{}\n", line(row))).collect())
}

fn shadow(program: &Program, rows: &Columns) -> Result<String, Fail> {
    let shadow = program.shadow(rows, None)?;
    let mut lines = String::new();
    for row in 0..rows.rows {
        let leaves = program.results().iter().zip(&shadow.columns);
        let leaves: Map<String, Value> =
            leaves.map(|(leaf, c)| (leaf.path.clone(), scalar(c, row))).collect();
        // A result of one scalar has no name.
        let result = leaves.get("").cloned().unwrap_or(Value::Object(leaves));
        let flags = [("ambiguous", &shadow.ambiguous), ("indeterminate", &shadow.indeterminate)];
        let mut line = Map::from_iter([("result".to_owned(), result)]);
        line.extend(
            flags.map(|(name, rows)| (name.to_owned(), rows.get(row).copied().unwrap_or(false).into())),
        );
        lines += &format!("{}\n", Value::Object(line));
    }
    Ok(lines)
}

fn scalar(column: &ShadowColumn, row: usize) -> Value {
    match column {
        ShadowColumn::Float { value, exact, bound } => json!({
            "value": number(value[row].into()),
            "exact": number(exact[row]),
            "bound": number(bound[row]),
        }),
        ShadowColumn::Word { value, known } => json!({ "value": value[row], "known": known[row] }),
    }
}

fn number(value: f64) -> Value {
    match Number::from_f64(value) {
        Some(number) => Value::Number(number),
        None => Value::String(value.to_string().to_lowercase()),
    }
}
