//! `lobe emit`: kernels as shader source.

use crate::fail::{Fail, Outcome};
use crate::output;
use crate::select;
use lobe_codegen::ValidModule;
use lobe_codegen::def::FunctionRef;
use lobe_codegen::emit::{Options, Target, emit, reflect, with_entries};
use lobe_codegen::lower::lower;
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
    #[arg(long = "target", value_name = "TARGET", required = true)]
    targets: Vec<Target>,
    /// Functions to include, or a complete compute shader for each kernel
    #[arg(long, value_enum, default_value_t = Form::Library)]
    form: Form,
    /// Write all kernels into one file, `lobe.EXTENSION`
    #[arg(long)]
    one_file: bool,
    /// Folder to write into, made if it is missing; `-` writes one kernel and target to standard output
    #[arg(long, value_name = "DIR", default_value = ".")]
    out: PathBuf,
    /// Leave doc comments out
    #[arg(long)]
    no_docs: bool,
    /// Leave out the JSON file beside each kernel's sources, which describes its functions, types and bindings
    #[arg(long)]
    no_reflection: bool,
}

/// What an artifact is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum Form {
    /// Functions to include
    Library,
    /// A complete compute shader that applies the kernel to rows of buffers
    Entry,
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
    if args.one_file {
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
    let n_files = args.targets.len() * if args.one_file { 1 } else { n_kernels };
    if args.out.as_os_str() == "-" && n_files != 1 {
        return usage("`--out -` takes one kernel and one target; name a folder instead");
    }
    Ok(())
}

/// The sources of `kernels` in every target, and their description.
fn files_of(args: &Args, stem: &str, kernels: &[FunctionRef], files: &mut Vec<File>) -> Result<(), Fail> {
    let module = module(args.form, kernels)?;
    let names = kernels.iter().map(|k| k().name.to_owned()).collect();
    let options = Options { docs: !args.no_docs, kernels: names, ..Options::default() };
    for target in &args.targets {
        let artifact = emit(&module, *target, &options)?;
        let name = format!("{stem}.{}", target.extension());
        files.push(File { name, bytes: artifact.content.bytes() });
    }
    if !args.no_reflection && args.out.as_os_str() != "-" {
        let json = reflect(&module).to_json().map_err(|e| Fail::Defect(e.to_string()))?;
        files.push(File { name: format!("{stem}.json"), bytes: json.into_bytes() });
    }
    Ok(())
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
        output::write_file(&path, &file.bytes)?;
        output::print(&format!("{} ({} bytes)\n", path.display(), file.bytes.len()))?;
    }
    Ok(())
}
