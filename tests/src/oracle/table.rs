//! Tables of high-precision values: JSON lines, a row of arguments and its value each.

use serde::Deserialize;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A row of a table.
#[derive(Clone, Debug, Deserialize)]
pub struct Row {
    /// The function.
    #[serde(rename = "fn")]
    pub function: String,
    /// Arguments by name.
    pub args: Value,
    /// `formula-f64` or `exact-integral`.
    pub kind: String,
    /// Which of several formulas.
    #[serde(default)]
    pub variant: Option<String>,
    /// The value: a number, or members by name; null where there is none.
    pub value: Value,
    /// What f32 rounding of the arguments alone does to the value, in the same shape.
    #[serde(default)]
    pub df32: Value,
    /// What is special about the row.
    #[serde(default)]
    pub tag: String,
    /// The line it stands in.
    #[serde(skip)]
    pub line: usize,
}

/// Why a table cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum TableError {
    /// The file or folder cannot be read.
    #[error("{}: cannot be read: {cause}", path.display())]
    Read {
        /// The file or folder.
        path: PathBuf,
        /// The system's words.
        cause: std::io::Error,
    },
    /// A line is no row.
    #[error("{}:{line}:{column}: no row of a table: {reason}", path.display())]
    Row {
        /// The file.
        path: PathBuf,
        /// From 1.
        line: usize,
        /// From 1.
        column: usize,
        /// What is wrong.
        reason: String,
    },
    /// Nothing to judge by.
    #[error("{}: holds no rows (tables are files named <function>.jsonl)", path.display())]
    Empty {
        /// The file or folder.
        path: PathBuf,
    },
}

/// Reads the table at `path`.
///
/// # Errors
/// When the file cannot be read, a line is malformed, or there is none.
pub fn read(path: &Path) -> Result<Vec<Row>, TableError> {
    let text =
        std::fs::read_to_string(path).map_err(|cause| TableError::Read { path: path.to_owned(), cause })?;
    let mut rows = Vec::new();
    for (index, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let row: Row = serde_json::from_str(line).map_err(|e| TableError::Row {
            path: path.to_owned(),
            line: index + 1,
            column: e.column(),
            reason: e.to_string(),
        })?;
        rows.push(Row { line: index + 1, ..row });
    }
    if rows.is_empty() {
        return Err(TableError::Empty { path: path.to_owned() });
    }
    Ok(rows)
}

/// The tables in `folder`, by name.
///
/// # Errors
/// When the folder cannot be read or holds none.
pub fn list(folder: &Path) -> Result<Vec<PathBuf>, TableError> {
    let fail = |cause| TableError::Read { path: folder.to_owned(), cause };
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(fail)? {
        let path = entry.map_err(fail)?.path();
        if path.extension().is_some_and(|e| e == "jsonl") {
            paths.push(path);
        }
    }
    paths.sort();
    if paths.is_empty() {
        return Err(TableError::Empty { path: folder.to_owned() });
    }
    Ok(paths)
}
