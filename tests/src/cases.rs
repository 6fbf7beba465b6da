//! Where cases are kept: `<kernel>.jsonl` with rows that once went wrong, `oracle/` with tables of
//! high-precision values.

use crate::judge::JudgeError;
use crate::value::parse_rows;
use lobe_codegen::data::{Columns, leaves};
use lobe_codegen::def::FunctionDef;
use serde_json::Value;
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// The folder of cases.
#[derive(Clone, Debug)]
pub struct Cases(PathBuf);

impl Cases {
    /// The folder that `LOBE_CASES` names, else `tests/cases` of the source tree that this was built from.
    #[must_use]
    pub fn standard() -> Self {
        Self::named().unwrap_or_else(|| Self(Path::new(env!("CARGO_MANIFEST_DIR")).join("cases")))
    }

    /// The folder that `LOBE_CASES` names, else `tests/cases` of the package in `folder`.
    #[must_use]
    pub fn of_package(folder: &str) -> Self {
        Self::named().unwrap_or_else(|| Self(Path::new(folder).join("tests").join("cases")))
    }

    fn named() -> Option<Self> {
        let named = std::env::var_os("LOBE_CASES").filter(|value| !value.is_empty());
        named.map(|folder| Self(folder.into()))
    }

    /// The cases in `folder`.
    #[must_use]
    pub fn at(folder: impl Into<PathBuf>) -> Self {
        Self(folder.into())
    }

    /// The folder.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.0
    }

    /// The table of values of the function `name`.
    #[must_use]
    pub fn table(&self, name: &str) -> PathBuf {
        self.0.join("oracle").join(format!("{name}.jsonl"))
    }

    /// Where the rows of a kernel are listed.
    #[must_use]
    pub fn rows(&self, kernel: &str) -> PathBuf {
        self.0.join(format!("{kernel}.jsonl"))
    }

    /// Lists more rows of a kernel: arguments as `lobe eval` reads them.
    ///
    /// # Errors
    /// Those of the file system.
    pub fn keep<'a>(&self, kernel: &str, rows: impl IntoIterator<Item = &'a Value>) -> std::io::Result<()> {
        let lines: String = rows.into_iter().map(|row| format!("{row}\n")).collect();
        if lines.is_empty() {
            return Ok(());
        }
        let mut file = OpenOptions::new().create(true).append(true).open(self.rows(kernel))?;
        file.write_all(lines.as_bytes())
    }

    /// The listed rows of `kernel`: arguments as `lobe eval` reads them. A kernel without a file has none.
    ///
    /// # Errors
    /// When the file cannot be read, or a row of it is malformed.
    pub fn listed(&self, kernel: &FunctionDef) -> Result<Columns, JudgeError> {
        let path = self.rows(kernel.name);
        match std::fs::read_to_string(&path) {
            Ok(text) => parse_rows(kernel, &text).map_err(|cause| JudgeError::Listed { path, cause }),
            Err(e) if e.kind() == ErrorKind::NotFound => {
                let width = kernel.params.iter().map(|p| leaves(p.name, &p.ty).len()).sum();
                Ok(Columns::zeros(width, 0))
            }
            Err(cause) => Err(JudgeError::Read { path, cause }),
        }
    }
}
