//! `lobe measure`: the worst errors that the documentation of kernels shows.

use crate::fail::{Fail, Outcome};
use crate::output;
use crate::route::{self, RouteArgs};
use crate::select;
use lobe_backends::routes::Machine;
use lobe_codegen::def::{FunctionDef, FunctionRef};
use lobe_tests::cases::Cases;
use lobe_tests::measure::file::{self, File};
use lobe_tests::measure::{self, Setting, source};
use std::collections::BTreeMap;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Kernels to measure; all when none is named
    #[arg(conflicts_with = "all")]
    kernels: Vec<String>,
    /// Measure every kernel
    #[arg(long)]
    all: bool,
    /// Write each kernel's file, and `measured` into its attribute where that is missing
    #[arg(long)]
    write: bool,
    /// Fail where a file is not what would be written
    #[arg(long, conflicts_with = "write")]
    check: bool,
    /// Rows of arguments to draw for each kernel
    #[arg(long, default_value_t = 20_000, value_parser = clap::value_parser!(u64).range(1..=100_000_000))]
    inputs: u64,
    /// Where the drawing begins; the same seed draws the same rows
    #[arg(long, default_value_t = 7)]
    seed: u64,
    /// Folder of the files, instead of kernels/src/measured; nothing is put into sources then
    #[arg(long, value_name = "DIR")]
    folder: Option<PathBuf>,
    #[command(flatten)]
    routes: RouteArgs,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let kernels = select::kernels(&args.kernels)?;
    let mut opened = route::open_usual(&args.routes, measure::is_documented)?;
    let machine = Machine::look();
    let setting = Setting { inputs: args.inputs as usize, seed: args.seed, cases: Cases::standard() };
    let mut run = Run {
        args,
        folder: args.folder.clone().unwrap_or_else(measure::folder),
        stale: 0,
        not_compared: BTreeMap::new(),
    };
    for kernel in &kernels {
        let measured = measure::measure(*kernel, &setting, &mut opened.executors, &machine)?;
        run.take(kernel(), File::new(&measured))?;
    }
    if args.check {
        return run.finish(&kernels);
    }
    Ok(Outcome::Holds)
}

struct Run<'a> {
    args: &'a Args,
    folder: PathBuf,
    /// Files that are not what would be written.
    stale: usize,
    /// Drivers of which files hold figures that could not be measured here, and how many files.
    not_compared: BTreeMap<String, usize>,
}

impl Run<'_> {
    fn take(&mut self, kernel: &FunctionDef, mut fresh: File) -> Result<(), Fail> {
        let path = file::path(&self.folder, kernel.name);
        let text = read(&path)?;
        let earlier = text.as_deref().and_then(File::parse);
        if self.args.check {
            let taken = earlier.map(|e| fresh.take_over(&e, true)).unwrap_or_default();
            for driver in taken {
                *self.not_compared.entry(driver).or_default() += 1;
            }
            self.check(kernel, &path, text.as_deref(), &fresh.render())
        } else if self.args.write {
            if let Some(earlier) = earlier {
                fresh.take_over(&earlier, false);
            }
            self.write(kernel, &path, text.as_deref(), &fresh.render())
        } else {
            output::print(&format!("# {}\n\n{}\n", kernel.name, fresh.render()))
        }
    }

    fn write(&self, kernel: &FunctionDef, path: &Path, old: Option<&str>, new: &str) -> Result<(), Fail> {
        let fail = |cause| Fail::Write { path: self.folder.clone(), cause };
        std::fs::create_dir_all(&self.folder).map_err(fail)?;
        if old != Some(new) {
            output::write_file(path, new.as_bytes())?;
            output::print(&format!("{}\n", path.display()))?;
        }
        if kernel.contract.measured.is_some() || self.args.folder.is_some() {
            return Ok(());
        }
        match source::with_measured(kernel) {
            Some((path, text)) => {
                output::write_file(&path, text.as_bytes())?;
                output::print(&format!("{}: `measured` put at {}\n", path.display(), kernel.name))
            }
            None => output::print(&format!(
                "{}:{}: put `measured` into the #[kernel(..)] of {}\n",
                kernel.source.file, kernel.source.line, kernel.name
            )),
        }
    }

    fn check(&mut self, kernel: &FunctionDef, path: &Path, old: Option<&str>, new: &str) -> Result<(), Fail> {
        let why = match old {
            None => "there is no such file".to_owned(),
            Some(old) if old == new => return Ok(()),
            Some(old) => difference(old, new),
        };
        self.stale += 1;
        output::print(&format!(
            "NO {}: {why}\n   mend: lobe measure {} --write\n",
            path.display(),
            kernel.name
        ))
    }

    /// Files of kernels that are no more, then the account.
    fn finish(mut self, kernels: &[FunctionRef]) -> Result<Outcome, Fail> {
        if self.args.kernels.is_empty() {
            self.orphans(kernels)?;
        }
        for (driver, files) in &self.not_compared {
            output::print(&format!(
                "NOT COMPARED: {driver} in {files} file(s): this machine lacks it, or has another version of it, of \
                 DXC or of the processor\n"
            ))?;
        }
        let n = kernels.len();
        match self.stale {
            0 => output::print(&format!("{n} kernels: all files are what would be written\n"))?,
            stale => output::print(&format!("{n} kernels: {stale} files are stale\n"))?,
        }
        Ok(if self.stale == 0 { Outcome::Holds } else { Outcome::FellShort })
    }

    fn orphans(&mut self, kernels: &[FunctionRef]) -> Result<(), Fail> {
        let fail = |cause| Fail::Read { path: self.folder.clone(), cause };
        let mut entries: Vec<PathBuf> = std::fs::read_dir(&self.folder)
            .map_err(fail)?
            .map(|entry| entry.map(|e| e.path()).map_err(fail))
            .collect::<Result<_, _>>()?;
        entries.sort();
        for path in entries {
            if kernels.iter().all(|k| file::path(&self.folder, k().name) != path) {
                self.stale += 1;
                output::print(&format!(
                    "NO {}: no kernel has this name\n   mend: remove it\n",
                    path.display()
                ))?;
            }
        }
        Ok(())
    }
}

/// The text of a file, if there is one.
fn read(path: &Path) -> Result<Option<String>, Fail> {
    match std::fs::read_to_string(path) {
        Ok(text) => Ok(Some(text)),
        Err(e) if e.kind() == ErrorKind::NotFound => Ok(None),
        Err(cause) => Err(Fail::Read { path: path.to_owned(), cause }),
    }
}

/// The first lines that differ.
fn difference(old: &str, new: &str) -> String {
    let mut lines = old.lines().zip(new.lines());
    match lines.find(|(a, b)| a != b) {
        Some((old, new)) => format!("stale\n   file: {old}\n   now:  {new}"),
        None => "stale: it has another length".to_owned(),
    }
}
