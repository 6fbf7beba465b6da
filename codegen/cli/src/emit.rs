//! `lobe emit`: kernels as shader source.

use crate::fail::{Fail, Outcome};
use crate::output;
use crate::select;
use lobe_codegen::ValidModule;
use lobe_codegen::def::FunctionRef;
use lobe_codegen::emit::{Host, Options, Target, emit, host, prefixed, reflect, with_entries};
use lobe_codegen::lower::lower;
use lobe_codegen::names;
use lobe_codegen::package::{Package, package};
use std::path::{Path, PathBuf};

/// Invocations in a workgroup of an emitted entry point.
const WORKGROUP: u32 = 64;

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Kernels to emit
    #[arg(conflicts_with = "all")]
    kernels: Vec<String>,
    /// Emit every kernel
    #[arg(long)]
    all: bool,
    /// Language: wgsl, spirv, hlsl, glsl, essl or msl; more than one may be given
    #[arg(long = "target", value_name = "TARGET", required_unless_present = "package")]
    targets: Vec<Target>,
    /// Write a folder that an engine takes as it is, with an example, in place of single files
    #[arg(long, value_name = "ENGINE", value_enum, conflicts_with_all = ["targets", "form", "one_file", "hosts", "no_docs", "no_reflection"])]
    package: Option<PackageName>,
    /// Functions to include, or a complete compute shader for each kernel
    #[arg(long, value_enum, default_value_t = Form::Library)]
    form: Form,
    /// Write all kernels into one file, `lobe.EXTENSION`
    #[arg(long)]
    one_file: bool,
    /// Folder to write into, made if it is missing; `-` writes one kernel and target to standard output
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
    /// Put this before every name that is declared: of functions, structures, constants, buffers and entry points;
    /// packages for Unity, Unreal, Godot and three.js have `lobe_` unless something else is said
    #[arg(long)]
    prefix: Option<String>,
    /// Write structures for a host too, laid out as shaders read them; more than one language may be given
    #[arg(long = "host", value_name = "LANGUAGE", value_enum)]
    hosts: Vec<HostLanguage>,
    /// Leave doc comments out
    #[arg(long)]
    no_docs: bool,
    /// Leave out the JSON file beside each kernel's sources, which describes its functions, types and bindings
    #[arg(long)]
    no_reflection: bool,
}

impl Args {
    /// What stands before names; nothing unless it was asked for.
    fn prefix(&self) -> &str {
        self.prefix.as_deref().unwrap_or_default()
    }
}

/// What an artifact is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Form {
    /// Functions to include
    Library,
    /// A complete compute shader that applies the kernel to rows of buffers
    Entry,
}

/// An engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum PackageName {
    /// Folders by language, and structures for hosts
    Plain,
    /// A module for naga_oil
    Bevy,
    /// A package of the package manager
    Unity,
    /// `.ush`
    Unreal,
    /// `.gdshaderinc`
    Godot,
    /// A module of functions for three.js
    Three,
}

impl From<PackageName> for Package {
    fn from(name: PackageName) -> Self {
        match name {
            PackageName::Plain => Self::Plain,
            PackageName::Bevy => Self::Bevy,
            PackageName::Unity => Self::Unity,
            PackageName::Unreal => Self::Unreal,
            PackageName::Godot => Self::Godot,
            PackageName::Three => Self::Three,
        }
    }
}

/// A language that hosts are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum HostLanguage {
    /// `#[repr(C)]` structures with bytemuck
    Rust,
    /// A header for C11 and C++11
    C,
}

impl From<HostLanguage> for Host {
    fn from(language: HostLanguage) -> Self {
        match language {
            HostLanguage::Rust => Self::Rust,
            HostLanguage::C => Self::C,
        }
    }
}

/// A file to write.
struct File {
    name: String,
    bytes: Vec<u8>,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let kernels = select::kernels(&args.kernels)?;
    check_usage(args, kernels.len())?;
    let mut files = Vec::new();
    if let Some(name) = args.package {
        files = package_of(args, name.into(), &kernels)?;
    } else if args.one_file {
        files_of(args, "lobe", &kernels, &mut files)?;
    } else {
        for kernel in &kernels {
            files_of(args, kernel().name, &[*kernel], &mut files)?;
        }
    }
    if args.out.as_os_str() == "-" {
        files.iter().try_for_each(|f| output::write_bytes(&f.bytes))?;
    } else {
        write_all(&args.out, &files)?;
    }
    Ok(Outcome::Holds)
}

fn check_usage(args: &Args, n_kernels: usize) -> Result<(), Fail> {
    let usage = |text: &str| Err(Fail::Usage(text.to_owned()));
    if args.kernels.is_empty() && !args.all {
        return usage("no kernel is named; name some, or give --all");
    }
    if args.form == Form::Library && args.targets.contains(&Target::Spirv) {
        return usage("SPIR-V has no libraries that Vulkan takes; add --form entry, or take a text target");
    }
    if let Err(error) = names::check(&format!("{}x", args.prefix())) {
        return usage(&format!("--prefix {} begins no name: {error}", args.prefix()));
    }
    if args.package.is_some() && args.out.as_os_str() == "-" {
        return usage("a package is a folder; name one with --out");
    }
    let n_files = (args.targets.len() + args.hosts.len()) * if args.one_file { 1 } else { n_kernels };
    if args.out.as_os_str() == "-" && n_files != 1 {
        return usage("`--out -` takes one kernel and one target, and no host; name a folder instead");
    }
    Ok(())
}

/// The files of a package.
fn package_of(args: &Args, kind: Package, kernels: &[FunctionRef]) -> Result<Vec<File>, Fail> {
    let names: Vec<String> = kernels.iter().map(|k| k().name.to_owned()).collect();
    let prefix = args.prefix.as_deref().unwrap_or(kind.prefix());
    let files = package(&lower(kernels)?, &names, kind, prefix)?;
    Ok(files.into_iter().map(|f| File { name: f.path, bytes: f.text.into_bytes() }).collect())
}

/// The sources of `kernels` in every target, and their description.
fn files_of(args: &Args, stem: &str, kernels: &[FunctionRef], files: &mut Vec<File>) -> Result<(), Fail> {
    let module = match args.prefix() {
        "" => module(args.form, kernels)?,
        prefix => prefixed(&module(args.form, kernels)?, prefix)?,
    };
    let names: Vec<String> = kernels.iter().map(|k| k().name.to_owned()).collect();
    for target in &args.targets {
        let command = Some(command(args, *target, &names));
        let options = Options { docs: !args.no_docs, kernels: names.clone(), command, ..Options::default() };
        let artifact = emit(&module, *target, &options)?;
        let name = format!("{stem}.{}", target.extension());
        files.push(File { name, bytes: artifact.content.bytes() });
    }
    for language in args.hosts.iter().map(|&language| Host::from(language)) {
        let name = format!("{stem}.{}", language.extension());
        files.push(File { name, bytes: host(&module, language).into_bytes() });
    }
    if !args.no_reflection && args.out.as_os_str() != "-" {
        let json = reflect(&module).to_json().map_err(|e| Fail::Defect(e.to_string()))?;
        files.push(File { name: format!("{stem}.json"), bytes: json.into_bytes() });
    }
    Ok(())
}

/// The command that writes a file again.
fn command(args: &Args, target: Target, names: &[String]) -> String {
    let mut command = format!("lobe emit --target {target}");
    if args.form == Form::Entry {
        command.push_str(" --form entry");
    }
    if !args.prefix().is_empty() {
        command.push_str(&format!(" --prefix {}", args.prefix()));
    }
    if args.no_docs {
        command.push_str(" --no-docs");
    }
    match args.one_file && args.all {
        true => command + " --one-file --all",
        false if args.one_file => format!("{command} --one-file {}", names.join(" ")),
        false => format!("{command} {}", names.join(" ")),
    }
}

fn module(form: Form, kernels: &[FunctionRef]) -> Result<ValidModule, Fail> {
    let module = lower(kernels)?;
    if form == Form::Library {
        return Ok(module);
    }
    let functions: Vec<_> = kernels.iter().filter_map(|k| module.function(k().name)).collect();
    Ok(with_entries(&module, &functions, WORKGROUP)?.0)
}

fn write_all(folder: &Path, files: &[File]) -> Result<(), Fail> {
    std::fs::create_dir_all(folder).map_err(|cause| Fail::Write { path: folder.to_owned(), cause })?;
    for file in files {
        let path = folder.join(&file.name);
        let inner = path.parent().unwrap_or(folder);
        std::fs::create_dir_all(inner).map_err(|cause| Fail::Write { path: inner.to_owned(), cause })?;
        output::write_file(&path, &file.bytes)?;
        output::print(&format!("{} ({} bytes)\n", path.display(), file.bytes.len()))?;
    }
    Ok(())
}
