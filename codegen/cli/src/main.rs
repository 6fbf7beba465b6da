//! `lobe`: emit, check, evaluate and judge shader kernels.
//!
//! One file a subcommand; everything that they do is in the libraries.

mod bench;
mod check;
mod compare;
mod completions;
mod doctor;
mod emit;
mod eval;
mod explain;
mod export;
mod fail;
mod figures;
mod flicker;
mod golden;
mod list;
mod measure;
mod merge;
mod model;
mod mutate;
mod operations;
mod oracle;
mod output;
mod paint;
mod proxies;
mod render;
mod report;
mod route;
mod run;
mod scene;
mod select;
mod virtual_lights;

use clap::{CommandFactory, Parser, Subcommand};
use fail::{Fail, Outcome};
use std::process::ExitCode;

/// Spherical-Gaussian lighting as tested shader source.
///
/// Exit codes: 0 all holds, 1 something fell short, 2 bad usage or input, 3 a required route or tool is missing.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// List the kernels with signature, source, domain and budget
    List(list::Args),
    /// Write kernels as WGSL, SPIR-V, HLSL, GLSL or MSL
    Emit(emit::Args),
    /// Run a kernel on rows of arguments
    Eval(eval::Args),
    /// Name the operation that a wrong or poor result of a kernel comes from
    Explain(explain::Args),
    /// Write a kernel at given arguments as one file for others: WGSL, Amber, LLVM's offload test suite
    Export(export::Args),
    /// Run a compute shader of your own on the interpreter and on every GPU route, and compare
    Run(Box<run::Args>),
    /// Ask kernels the four questions: correct, robust, conformant, agree
    Check(check::Args),
    /// Join the reports of parts: of shares of a check, or of tests that were split over machines
    Merge(merge::Args),
    /// Judge kernels by a folder of tables of high-precision values
    Oracle(oracle::Args),
    /// Measure the worst errors that the documentation of kernels shows
    Measure(measure::Args),
    /// Seed faults into kernels and count those that the harness notices
    Mutate(mutate::Args),
    /// Make a few rectangles in place of a scene's triangles
    Proxies(proxies::Args),
    /// Render a scene by a method of interreflection, or the truth by sampling
    Render(render::Args),
    /// Say how far a picture is from another: mean, error, FLIP
    Compare(compare::Args),
    /// Judge golden images on every route; accept and reject what is new
    Golden(golden::Args),
    /// Draw the figures of the papers from the kernels
    Figures(figures::Args),
    /// Measure how much virtual lights flicker while the light turns
    Flicker(flicker::Args),
    /// Measure the throughput of the interpreter, native code and drivers, side by side
    Bench(bench::Args),
    /// Say which routes and tools this machine has, and how to get the others
    Doctor(doctor::Args),
    /// Print the script that completes this command line in a shell
    Completions(completions::Args),
    /// Write the manual pages
    Man(completions::ManArgs),
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    match lobe_codegen::quietly(|| execute(&cli.command)) {
        Ok(Ok(outcome)) => outcome.into(),
        Ok(Err(fail)) => fail.report(),
        Err(message) => Fail::Defect(message).report(),
    }
}

fn execute(command: &Command) -> Result<Outcome, Fail> {
    match command {
        Command::List(args) => list::run(args),
        Command::Emit(args) => emit::run(args),
        Command::Eval(args) => eval::run(args),
        Command::Explain(args) => explain::run(args),
        Command::Export(args) => export::run(args),
        Command::Run(args) => run::run(args),
        Command::Check(args) => check::run(args),
        Command::Merge(args) => merge::run(args),
        Command::Oracle(args) => oracle::run(args),
        Command::Measure(args) => measure::run(args),
        Command::Mutate(args) => mutate::run(args),
        Command::Proxies(args) => proxies::run(args),
        Command::Render(args) => render::run(args),
        Command::Compare(args) => compare::run(args),
        Command::Golden(args) => golden::run(args),
        Command::Figures(args) => figures::run(args),
        Command::Flicker(args) => flicker::run(args),
        Command::Bench(args) => bench::run(args),
        Command::Doctor(args) => doctor::run(args),
        Command::Completions(args) => completions::run(args, Cli::command()),
        Command::Man(args) => completions::man(args, Cli::command()),
    }
}
