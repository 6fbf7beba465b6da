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
            let leaves: Vec<usize> = (0..params.len()).filter(|i| covers(path, &params[*i].path)).collect();
            let values = resolve(source, row, leaves.len()).map_err(|e| format!("line {}: {e}", row.line))?;
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

/// The numbers that `source` gives for `n` scalars.
fn resolve(source: &Source, row: &Row, n: usize) -> Result<Vec<f64>, Unfit> {
    match source {
        Source::Constant(value) => Ok(vec![*value]),
        Source::Column(path) => numbers(&row.args, path),
        Source::Transformed(transform) => transformed(transform, row, n),
    }
}

fn transformed(transform: &Transform, row: &Row, n: usize) -> Result<Vec<f64>, Unfit> {
    let column = |path: &str| numbers(&row.args, path);
    let each = |path: &str, f: fn(f64) -> f64| Ok(column(path)?.into_iter().map(f).collect());
    match transform {
        Transform::Unit(path) => Ok(normalised(&column(path)?)),
        Transform::Ln(path) => each(path, f64::ln),
        Transform::Cos(path) => each(path, f64::cos),
        Transform::Sin(path) => each(path, f64::sin),
        Transform::Tan(path) => each(path, f64::tan),
        Transform::Sqrt(path) => each(path, f64::sqrt),
        Transform::Negated(path) => each(path, |x| -x),
        Transform::NegatedUnit(path) => Ok(normalised(&column(path)?).into_iter().map(|x| -x).collect()),
        Transform::NormalTo(x, z) => Ok(perpendicular(&column(x)?, &normalised(&column(z)?))),
        Transform::Binormal(x, z) => {
            let z = normalised(&column(z)?);
            cross(&z, &perpendicular(&column(x)?, &z))
        }
        Transform::Padded(path) => padded(flat(member_of(row, path)?)?, n),
        Transform::PaddedUnit(path) => {
            let items = member_of(row, path)?.as_array().ok_or_else(|| format!("`{path}` is no list"))?;
            let units =
                items.iter().map(|item| Ok(normalised(&flat(item)?))).collect::<Result<Vec<_>, Unfit>>()?;
            padded(units.concat(), n)
        }
        Transform::Count(path) => {
            let items = member_of(row, path)?.as_array().ok_or_else(|| format!("`{path}` is no list"))?;
            Ok(vec![items.len() as f64])
        }
    }
}

fn padded(mut numbers: Vec<f64>, n: usize) -> Result<Vec<f64>, Unfit> {
    if numbers.len() > n {
        return Err(format!("a list of {} numbers does not fit into {n}", numbers.len()));
    }
    numbers.resize(n, 0.0);
    Ok(numbers)
}

/// `x` without its part along the unit vector `z`, normalised.
fn perpendicular(x: &[f64], z: &[f64]) -> Vec<f64> {
    let along: f64 = x.iter().zip(z).map(|(a, b)| a * b).sum();
    normalised(&x.iter().zip(z).map(|(a, b)| a - along * b).collect::<Vec<_>>())
}

fn cross(a: &[f64], b: &[f64]) -> Result<Vec<f64>, Unfit> {
    match (a, b) {
        ([ax, ay, az], [bx, by, bz]) => Ok(vec![ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]),
        _ => Err("a cross product needs vectors of three".to_owned()),
    }
}

fn member_of<'a>(row: &'a Row, path: &str) -> Result<&'a Value, Unfit> {
    member(&row.args, path).ok_or_else(|| format!("it has no `{path}`"))
}

/// All numbers in `value`, in order.
fn flat(value: &Value) -> Result<Vec<f64>, Unfit> {
    match value {
        Value::Array(items) => Ok(items.iter().map(flat).collect::<Result<Vec<_>, _>>()?.concat()),
        other => other.as_f64().map(|v| vec![v]).ok_or_else(|| format!("{other} is no number")),
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

/// The quantity `scale` of a row, of which `value` is compared.
pub(super) fn scale(scale: &Scale, row: &Row, value: f64) -> Result<f64, Unfit> {
    match scale {
        Scale::Quantity(name) => quantity(name, row, value),
        Scale::Product(names) => {
            names.iter().try_fold(1.0, |all, name| Ok(all * quantity(name, row, value)?))
        }
    }
}

/// A quantity by its name; see [`Scale`].
pub(super) fn quantity(name: &str, row: &Row, value: f64) -> Result<f64, Unfit> {
    if let Some(path) = name.strip_prefix("df32.") {
        return magnitude(&row.df32, path);
    }
    match (name, name.strip_prefix("value.")) {
        ("one", _) => Ok(1.0),
        ("value", _) => Ok(value.abs()),
        ("hemisphere_integral", _) => hemisphere_integral(row),
        ("vsgl_unoccluded", _) => vsgl_unoccluded(row),
        (_, Some(path)) => magnitude(&row.value, path),
        (path, None) => match path.strip_prefix("df32.") {
            Some(path) => magnitude(&row.df32, path),
            None => magnitude(&row.args, path),
        },
    }
}

fn magnitude(value: &Value, path: &str) -> Result<f64, Unfit> {
    let at = member(value, path).ok_or_else(|| format!("it has no quantity `{path}`"))?;
    match at.as_array() {
        Some(items) if items.iter().any(Value::is_array) || items.len() > 4 => {
            Ok(flat(at)?.into_iter().map(f64::abs).sum())
        }
        _ => Ok(flat(at)?.into_iter().map(|x| x * x).sum::<f64>().sqrt()),
    }
}

fn hemisphere_integral(row: &Row) -> Result<f64, Unfit> {
    let sharpness = magnitude(&row.args, "sharpness")?;
    let mean = if sharpness == 0.0 { 1.0 } else { -(-sharpness).exp_m1() / sharpness };
    let log_amplitude = numbers(&row.args, "log_amplitude").ok().and_then(|v| v.first().copied());
    Ok(std::f64::consts::TAU * mean * log_amplitude.unwrap_or(0.0).exp())
}

/// What a surface of albedo `R_d` reflects of all the light that a VSGL sends to `p_x`, from whatever side.
fn vsgl_unoccluded(row: &Row) -> Result<f64, Unfit> {
    let vector = |path: &str| -> Result<[f64; 3], Unfit> {
        numbers(&row.args, path)?.try_into().map_err(|_| format!("`{path}` is no vector"))
    };
    let number = |path: &str| magnitude(&row.args, path);
    let (mean, position, axis) = (vector("mean")?, vector("p_x")?, vector("axis")?);
    let axis = normalised(&axis);
    let apart: Vec<f64> = mean.iter().zip(&position).map(|(m, p)| m - p).collect();
    let d2: f64 = apart.iter().map(|x| x * x).sum();
    let sharpness = number("sharpness")?;
    // At the mean itself there is no direction, and the extent has sharpness 0; without extent, none that is too large.
    let variance = number("variance")?.max(1e-30 * d2).max(1e-30);
    let (extent, towards) = (d2 / variance, if d2 > 0.0 { normalised(&apart) } else { axis.clone() });
    // k_in - k - D²/σ², by the chord between the region and the reversed emission.
    let sum2: f64 = towards.iter().zip(&axis).map(|(t, a)| (t - a).powi(2)).sum();
    let gap2: f64 = towards.iter().zip(&axis).map(|(t, a)| (t + a).powi(2)).sum();
    let product = ((extent - sharpness).powi(2) + extent * sharpness * sum2).sqrt();
    let shift = -extent * sharpness * gap2 / (product + extent + sharpness);
    let mean_value = if product == 0.0 { 2.0 } else { -(-2.0 * product).exp_m1() / product };
    // R/π · c/(2πσ²) e^shift · 2π (1 - e^(-2k))/k
    Ok(number("R_d")? * number("c_v")? / (std::f64::consts::PI * variance) * shift.exp() * mean_value)
}

fn word(scalar: Scalar, value: f64) -> u32 {
    match scalar {
        Scalar::F32 => (value as f32).to_bits(),
        Scalar::I32 => value as i32 as u32,
        Scalar::U32 => value as u32,
        Scalar::Bool => u32::from(value != 0.0),
    }
}
