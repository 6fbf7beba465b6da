//! Rows of a table as arguments of a kernel: f32 words for the routes, f64 values for the shadow lane.

use super::mapping::{Entry, Scale, Source, Transform};
use super::table::Row;
use crate::domain::unit::normalised;
use crate::subject::covers;
use lobe_backends::executor::Program;
use lobe_codegen::data::{Columns, Leaf};
use lobe_codegen::def::Scalar;
use serde_json::Value;

/// Arguments of a kernel, twice.
#[derive(Debug)]
pub(super) struct Fed {
    /// Rounded to f32.
    pub(super) args: Columns,
    /// As they are, a column for each of `args`.
    pub(super) exact: Vec<Vec<f64>>,
}

/// What of an entry does not fit the table or the kernel.
pub(super) type Unfit = String;

/// The arguments that `entry` makes of `rows`.
pub(super) fn feed(program: &Program, entry: &Entry, rows: &[&Row]) -> Result<Fed, Unfit> {
    let params = program.params();
    check_paths(params, entry)?;
    let mut exact = vec![Vec::with_capacity(rows.len()); params.len()];
    for row in rows {
        for (path, source) in &entry.args {
            let values = resolve(source, row).map_err(|e| format!("line {}: {e}", row.line))?;
            let leaves: Vec<usize> = (0..params.len()).filter(|i| covers(path, &params[*i].path)).collect();
            if values.len() != leaves.len() {
                let (given, wanted) = (values.len(), leaves.len());
                return Err(format!("line {}: `{path}` has {wanted} scalars, {given} are given", row.line));
            }
            leaves.into_iter().zip(values).for_each(|(leaf, value)| exact[leaf].push(value));
        }
    }
    let columns =
        params.iter().zip(&exact).map(|(leaf, c)| c.iter().map(|v| word(leaf.scalar, *v)).collect());
    let args = Columns { columns: columns.collect(), rows: rows.len() };
    Ok(Fed { args, exact })
}

/// Each scalar of the parameters is fed exactly once.
fn check_paths(params: &[Leaf], entry: &Entry) -> Result<(), Unfit> {
    for leaf in params {
        let feeds = entry.args.keys().filter(|path| covers(path, &leaf.path)).count();
        if feeds != 1 {
            let kernel = &entry.kernel;
            return Err(format!(
                "the mapping feeds `{}` of {kernel} {feeds} times instead of once",
                leaf.path
            ));
        }
    }
    match entry.args.keys().find(|path| params.iter().all(|leaf| !covers(path, &leaf.path))) {
        Some(stray) => Err(format!("the mapping feeds `{stray}`, which {} does not take", entry.kernel)),
        None => Ok(()),
    }
}

fn resolve(source: &Source, row: &Row) -> Result<Vec<f64>, Unfit> {
    match source {
        Source::Constant(value) => Ok(vec![*value]),
        Source::Column(path) => numbers(&row.args, path),
        Source::Transformed(Transform::Unit(path)) => Ok(normalised(&numbers(&row.args, path)?)),
        Source::Transformed(Transform::Ln(path)) => {
            Ok(numbers(&row.args, path)?.into_iter().map(f64::ln).collect())
        }
    }
}

/// The numbers at `path`: one, or those of an array.
pub(super) fn numbers(value: &Value, path: &str) -> Result<Vec<f64>, Unfit> {
    let at = member(value, path).ok_or_else(|| format!("it has no `{path}`"))?;
    let numbers = match at {
        Value::Array(items) => items.iter().map(Value::as_f64).collect(),
        other => other.as_f64().map(|v| vec![v]),
    };
    numbers.ok_or_else(|| format!("`{path}` is neither a number nor an array of numbers"))
}

/// The member of `value` at `path`, itself for the empty one.
pub(super) fn member<'a>(value: &'a Value, path: &str) -> Option<&'a Value> {
    path.split('.').filter(|name| !name.is_empty()).try_fold(value, |at, name| at.get(name))
}

/// The quantity `scale` of a row.
pub(super) fn scale(scale: Scale, row: &Row, value: f64) -> f64 {
    let column = |name: &str| numbers(&row.args, name).ok().and_then(|v| v.first().copied());
    match scale {
        Scale::One => 1.0,
        Scale::Value => value.abs(),
        Scale::HemisphereIntegral => {
            let sharpness = column("sharpness").unwrap_or(f64::NAN);
            let mean = if sharpness == 0.0 { 1.0 } else { -(-sharpness).exp_m1() / sharpness };
            std::f64::consts::TAU * mean * column("log_amplitude").unwrap_or(0.0).exp()
        }
    }
}

fn word(scalar: Scalar, value: f64) -> u32 {
    match scalar {
        Scalar::F32 => (value as f32).to_bits(),
        Scalar::I32 => value as i32 as u32,
        Scalar::U32 => value as u32,
        Scalar::Bool => u32::from(value != 0.0),
    }
}
