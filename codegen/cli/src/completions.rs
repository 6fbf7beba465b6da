//! `lobe completions` and `lobe man`: what shells and `man` want to know of the command line.

use crate::fail::{Fail, Outcome};
use crate::output;
use std::path::PathBuf;

/// Options of `lobe completions`.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// The shell, whose script goes to standard output
    shell: clap_complete::Shell,
}

/// Options of `lobe man`.
#[derive(Debug, clap::Args)]
pub(crate) struct ManArgs {
    /// Folder to write `lobe.1` and a page for each subcommand into, made if it is missing
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
}

/// Runs `lobe completions` for the program that `command` describes.
pub(crate) fn run(args: &Args, mut command: clap::Command) -> Result<Outcome, Fail> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut command, "lobe", &mut script);
    output::write_bytes(&script)?;
    Ok(Outcome::Holds)
}

/// Runs `lobe man`.
pub(crate) fn man(args: &ManArgs, command: clap::Command) -> Result<Outcome, Fail> {
    let folder = &args.out;
    std::fs::create_dir_all(folder).map_err(|cause| Fail::Write { path: folder.clone(), cause })?;
    let mut command = command.disable_help_subcommand(true);
    command.build();
    let subcommands = command.get_subcommands().cloned().collect::<Vec<_>>();
    for page in std::iter::once(command).chain(subcommands) {
        let man = clap_mangen::Man::new(page);
        let path = folder.join(man.get_filename());
        let mut text = Vec::new();
        man.render(&mut text).map_err(|cause| Fail::Write { path: path.clone(), cause })?;
        output::write_file(&path, &text)?;
        output::print(&format!("{}\n", path.display()))?;
    }
    Ok(Outcome::Holds)
}
