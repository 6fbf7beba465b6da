//! From JSON to words, saying where a value has the wrong shape.

use super::hex::parse_hex;
use lobe_codegen::data::Columns;
use lobe_codegen::def::{FieldDef, FunctionDef, Scalar, TypeDef};
use serde_json::{Map, Value};

/// Why a row of arguments could not be read.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}, column {column}: {reason}")]
pub struct RowError {
    /// Line of the text, from 1.
    pub line: usize,
    /// Column of the line, from 1.
    pub column: usize,
    /// What is wrong, and what would be right.
    pub reason: String,
}

/// A value of the wrong shape: the path to it, for a column, and the reason.
struct Wrong {
    key: String,
    reason: String,
}

type Parsed = Result<(), Wrong>;

/// Reads a row of arguments a line; empty lines are passed over.
///
/// # Errors
/// With line and column of the first line that is no row of `kernel`'s arguments.
pub fn parse_rows(kernel: &FunctionDef, text: &str) -> Result<Columns, RowError> {
    let mut rows = Vec::new();
    for (index, line) in text.lines().enumerate() {
        if !line.trim().is_empty() {
            rows.push(parse_row(kernel, line).map_err(|e| RowError { line: index + 1, ..e })?);
        }
    }
    let width = kernel.params.iter().map(|p| lobe_codegen::data::leaves(p.name, &p.ty).len()).sum();
    Ok(Columns::from_rows(width, &rows))
}

/// Reads one row of arguments.
///
/// # Errors
/// With the column at which `line` is no row of `kernel`'s arguments; the line is 1.
pub fn parse_row(kernel: &FunctionDef, line: &str) -> Result<Vec<u32>, RowError> {
    let value: Value = serde_json::from_str(line).map_err(|e| RowError {
        line: 1,
        column: e.column().max(1),
        reason: format!("no JSON: {}", without_place(&e)),
    })?;
    let members: Vec<(&str, &TypeDef)> = kernel.params.iter().map(|p| (p.name, &p.ty)).collect();
    let mut words = Vec::new();
    let owner = format!("{}'s arguments", kernel.name);
    object(&owner, "", &members, &value, &mut words).map_err(|wrong| RowError {
        line: 1,
        column: column_of(line, &wrong.key),
        reason: wrong.reason,
    })?;
    Ok(words)
}

/// serde_json ends its messages with the place, which [`RowError`] states itself.
fn without_place(error: &serde_json::Error) -> String {
    let text = error.to_string();
    text.split(" at line ").next().unwrap_or(&text).to_owned()
}

/// Where the last name of a path stands as a key; the line's first column when it does not.
fn column_of(line: &str, path: &str) -> usize {
    let name = path.rsplit('.').next().unwrap_or(path).split('[').next().unwrap_or(path);
    let at = (!name.is_empty()).then(|| line.find(&format!("\"{name}\""))).flatten().unwrap_or(0);
    line[..at].chars().count() + 1
}

fn wrong(path: &str, reason: String) -> Parsed {
    Err(Wrong { key: path.to_owned(), reason })
}

fn object(
    owner: &str,
    path: &str,
    members: &[(&str, &TypeDef)],
    value: &Value,
    out: &mut Vec<u32>,
) -> Parsed {
    let names = members.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ");
    let Value::Object(map) = value else {
        return wrong(path, format!("{owner} are an object with the members {names}, not {}", kind(value)));
    };
    unknown_member(owner, path, members, map, &names)?;
    for (name, ty) in members {
        let below = join(path, name);
        match map.get(*name) {
            Some(value) => any(&below, ty, value, out)?,
            None => return wrong(path, format!("{owner} lack `{below}` ({ty}); they are {names}")),
        }
    }
    Ok(())
}

fn unknown_member(
    owner: &str,
    path: &str,
    members: &[(&str, &TypeDef)],
    map: &Map<String, Value>,
    names: &str,
) -> Parsed {
    match map.keys().find(|key| members.iter().all(|(name, _)| name != key)) {
        Some(key) => wrong(&join(path, key), format!("`{}` is none of {owner}: {names}", join(path, key))),
        None => Ok(()),
    }
}

fn any(path: &str, ty: &TypeDef, value: &Value, out: &mut Vec<u32>) -> Parsed {
    match *ty {
        TypeDef::Scalar(scalar) => self::scalar(path, scalar, value, out),
        TypeDef::Vector(n, scalar) => list(path, ty, n.into(), &TypeDef::Scalar(scalar), value, out),
        TypeDef::Matrix(columns, rows) => {
            list(path, ty, columns.into(), &TypeDef::Vector(rows, Scalar::F32), value, out)
        }
        TypeDef::Array(element, n) => list(path, ty, n as usize, element, value, out),
        TypeDef::Struct(def) => {
            let members: Vec<_> = def().fields.iter().map(|f: &FieldDef| (f.name, &f.ty)).collect();
            object(&format!("the fields of `{path}`"), path, &members, value, out)
        }
        TypeDef::Slice(_) | TypeDef::Atomic(_) => wrong(path, format!("`{path}`: {ty} has no value to give")),
    }
}

fn list(path: &str, ty: &TypeDef, n: usize, element: &TypeDef, value: &Value, out: &mut Vec<u32>) -> Parsed {
    match value {
        Value::Array(items) if items.len() == n => items
            .iter()
            .enumerate()
            .try_for_each(|(i, item)| any(&format!("{path}[{i}]"), element, item, out)),
        Value::Array(items) => {
            wrong(path, format!("`{path}` ({ty}) has {n} elements, {} are given", items.len()))
        }
        other => wrong(path, format!("`{path}` ({ty}) is an array of {n} elements, not {}", kind(other))),
    }
}

fn scalar(path: &str, scalar: Scalar, value: &Value, out: &mut Vec<u32>) -> Parsed {
    let word = match scalar {
        Scalar::F32 => float(value).map(|v| (v as f32).to_bits()),
        Scalar::I32 => value.as_i64().and_then(|v| i32::try_from(v).ok()).map(|v| v as u32),
        Scalar::U32 => value.as_u64().and_then(|v| u32::try_from(v).ok()),
        Scalar::Bool => value.as_bool().map(u32::from),
    };
    match word {
        Some(word) => {
            out.push(word);
            Ok(())
        }
        None => wrong(path, format!("`{path}` is {}, not {}", wanted(scalar), kind(value))),
    }
}

fn float(value: &Value) -> Option<f64> {
    match value {
        Value::Number(number) => number.as_f64(),
        Value::String(text) => parse_hex(text),
        Value::Null | Value::Bool(_) | Value::Array(_) | Value::Object(_) => None,
    }
}

fn wanted(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::F32 => "a number (or a string as \"0x1.8p3\", \"nan\", \"inf\")",
        Scalar::I32 => "an integer of 32 bits",
        Scalar::U32 => "a non-negative integer of 32 bits",
        Scalar::Bool => "true or false",
    }
}

fn kind(value: &Value) -> String {
    match value {
        Value::Null => "null".to_owned(),
        Value::Bool(_) | Value::Number(_) | Value::String(_) => value.to_string(),
        Value::Array(_) => "an array".to_owned(),
        Value::Object(_) => "an object".to_owned(),
    }
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") }
}
