//! `--report`: the report as files, beside what is printed.

use crate::fail::Fail;
use crate::output;
use lobe_tests::report::{Report, html, json, junit};
use std::path::{Path, PathBuf};

/// Options of the subcommands that report on kernels.
#[derive(Debug, clap::Args)]
pub(crate) struct ReportFiles {
    /// Write the report to a file too, by its ending: .html (a page that loads nothing), .json or .xml (JUnit)
    #[arg(long = "report", value_name = "FILE", value_parser = parse)]
    files: Vec<ReportFile>,
}

/// A file and what it is to hold.
#[derive(Clone, Debug)]
struct ReportFile {
    path: PathBuf,
    render: fn(&Report) -> String,
}

fn parse(text: &str) -> Result<ReportFile, String> {
    let path = PathBuf::from(text);
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let render = match ending.as_deref() {
        Some("html" | "htm") => html::render,
        Some("json") => json::render,
        Some("xml") => junit::render,
        _ => return Err("its ending says its form: .html, .json or .xml".to_owned()),
    };
    Ok(ReportFile { path, render })
}

impl ReportFiles {
    /// Whether no file is wanted.
    pub(crate) fn is_empty(&self) -> bool {
        self.files.is_empty()
    }

    /// Whether the files can stand where they are wanted; a check is long, so this is asked before.
    pub(crate) fn check(&self) -> Result<(), Fail> {
        for ReportFile { path, .. } in &self.files {
            let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
            if !folder.is_dir() {
                let what = format!("{}: there is no folder {}", path.display(), folder.display());
                return Err(Fail::Usage(what));
            }
        }
        Ok(())
    }

    /// Writes them.
    pub(crate) fn write(&self, report: &Report) -> Result<(), Fail> {
        self.files
            .iter()
            .try_for_each(|file| output::write_file(&file.path, (file.render)(report).as_bytes()))
    }
}
