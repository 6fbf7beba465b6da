//! Standard output, colours, progress, files.

use crate::fail::Fail;
use indicatif::{ProgressBar, ProgressStyle};
use lobe_tests::files;
use lobe_tests::report::human::Style;
use std::io::{IsTerminal, Write};
use std::path::Path;

/// Form of a report.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Format {
    /// Text for people
    Human,
    /// JSON with a versioned schema
    Json,
    /// JUnit XML
    Junit,
}

/// Form of a listing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum ListFormat {
    /// Text for people
    #[value(alias = "text")]
    Human,
    /// JSON with a versioned schema
    Json,
}

/// An object as a line of JSON, the version of its format first.
pub(crate) fn json_line(schema: u32, object: &impl serde::Serialize) -> String {
    #[derive(serde::Serialize)]
    struct Versioned<'a, T> {
        schema: u32,
        #[serde(flatten)]
        object: &'a T,
    }
    // Maps with string keys only: this cannot fail, and if it did the text would say so.
    let text = serde_json::to_string(&Versioned { schema, object });
    text.unwrap_or_else(|e| format!("{{\"schema\":{schema},\"error\":{:?}}}", e.to_string())) + "\n"
}

/// Writes `text` to standard output.
pub(crate) fn print(text: &str) -> Result<(), Fail> {
    write_bytes(text.as_bytes())
}

/// Writes `bytes` to standard output.
pub(crate) fn write_bytes(bytes: &[u8]) -> Result<(), Fail> {
    let mut out = std::io::stdout().lock();
    out.write_all(bytes).and_then(|()| out.flush()).map_err(Fail::Stdout)
}

/// Colours on a terminal, unless `NO_COLOR` is set.
pub(crate) fn style() -> Style {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    Style { colour: !refused && std::io::stdout().is_terminal(), worst: false }
}

/// A progress bar on a terminal, nothing elsewhere.
pub(crate) fn progress(rows: usize) -> ProgressBar {
    if !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(rows as u64);
    match ProgressStyle::with_template("{bar:40} {human_pos}/{human_len} rows  {msg}  {eta}") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// Writes a file whole or not at all.
pub(crate) fn write_file(path: &Path, bytes: &[u8]) -> Result<(), Fail> {
    files::write(path, bytes).map_err(|cause| Fail::Write { path: path.to_owned(), cause })
}
