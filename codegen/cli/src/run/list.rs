//! The jobs of a batch.

use super::options::JobArgs;
use crate::fail::Fail;
use clap::Parser;
use lobe_tests::shader::is_shader;
use lobe_tests::shader::job::{Entry, Job};
use std::path::{Path, PathBuf};

/// Begins a line of a shader's text that holds options for it.
const MARK: &str = "// lobe: ";

/// A line of a list.
#[derive(Debug, clap::Parser)]
#[command(name = "line", disable_help_flag = true)]
struct Line {
    #[command(flatten)]
    job: JobArgs,
}

/// A job for each shader in `list`, a folder or a file with one a line; `common` are the options that all share.
pub(super) fn jobs(list: &Path, common: &JobArgs) -> Result<Vec<Job>, Fail> {
    if list.is_dir() {
        let mut files = Vec::new();
        shaders(list, &mut files)?;
        files.sort();
        if files.is_empty() {
            return Err(Fail::Usage(format!(
                "{}: holds no .wgsl, .spv, .glsl or .comp file",
                list.display()
            )));
        }
        return files.into_iter().map(|file| one(file, common, Entry::Each)).collect();
    }
    let text = std::fs::read_to_string(list).map_err(|cause| Fail::Read { path: list.to_owned(), cause })?;
    let lines = (1..).zip(text.lines().map(str::trim)).filter(|(_, l)| !l.is_empty() && !l.starts_with('#'));
    let jobs: Vec<Job> =
        lines.map(|(number, line)| job(list, number, line, common)).collect::<Result<_, _>>()?;
    if jobs.is_empty() {
        return Err(Fail::Usage(format!("{}: names no shader", list.display())));
    }
    Ok(jobs)
}

fn job(list: &Path, number: usize, line: &str, common: &JobArgs) -> Result<Job, Fail> {
    let told = |what: &str| Fail::Usage(format!("{}:{number}: {what}", list.display()));
    let args = parsed(line).map_err(|e| told(&e))?.or(common);
    let file = args.file.clone().ok_or_else(|| told("no shader is named"))?;
    one(file, &args, Entry::Each)
}

/// The options in a line.
fn parsed(line: &str) -> Result<JobArgs, String> {
    let words = shlex::split(line).ok_or("a quote is not closed")?;
    let parsed = Line::try_parse_from(std::iter::once("line".to_owned()).chain(words));
    parsed.map(|line| line.job).map_err(|e| e.to_string().trim_end().to_owned())
}

/// The job for `file`, with the options of `args` and, below those, of the lines of its text that begin with [`MARK`].
pub(super) fn one(file: PathBuf, args: &JobArgs, entries: Entry) -> Result<Job, Fail> {
    // What cannot be read, or is no text, has no options; the run says what is wrong with it.
    let text = std::fs::read_to_string(&file).unwrap_or_default();
    let mut own = JobArgs::default();
    for (number, line) in (1..).zip(text.lines()) {
        let Some(line) = line.strip_prefix(MARK) else { continue };
        let told = |what: &str| Fail::Usage(format!("{}:{number}: {what}", file.display()));
        let more = parsed(line).map_err(|e| told(&e))?;
        if more.names_files() {
            return Err(told("a shader's own options may name no files"));
        }
        own = more.or(&own);
    }
    Ok(args.clone().or(&own).job(file, entries))
}

fn shaders(folder: &Path, files: &mut Vec<PathBuf>) -> Result<(), Fail> {
    let fail = |cause| Fail::Read { path: folder.to_owned(), cause };
    for entry in std::fs::read_dir(folder).map_err(fail)? {
        let entry = entry.map_err(fail)?;
        let path = entry.path();
        // Links are not followed: they may lead round in a circle.
        if entry.file_type().map_err(fail)?.is_dir() {
            shaders(&path, files)?;
        } else if is_shader(&path) {
            files.push(path);
        }
    }
    Ok(())
}
