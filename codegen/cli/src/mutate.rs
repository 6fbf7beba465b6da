//! `lobe mutate`: faults are seeded into kernels, and counted as the harness notices them.

use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use crate::select;
use lobe_tests::cases::Cases;
use lobe_tests::mutation::fault::{Kind, Mutant};
use lobe_tests::mutation::report::{self, Count, KernelFaults};
use lobe_tests::mutation::{Plan, mutate};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

/// Options.
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(crate) struct Args {
    /// Kernels to seed faults into; all when none is named
    kernels: Vec<String>,
    /// Rows that each kernel with a fault is run on
    #[arg(long, default_value_t = 10_000, value_parser = clap::value_parser!(u64).range(1..=10_000_000))]
    inputs: u64,
    /// Where the drawing begins; the same seed draws the same rows
    #[arg(long, default_value_t = 7)]
    seed: u64,
    /// Rows on which a fault that changes no bit counts as none; the proof wants 10000000
    #[arg(long, default_value_t = 1_000_000, value_name = "ROWS", value_parser = clap::value_parser!(u64).range(0..=1_000_000_000))]
    equivalence: u64,
    /// Seconds after which no further fault is tried
    #[arg(long, value_name = "SECONDS")]
    limit: Option<u64>,
    /// List the faults too that only bits tell, and no bound
    #[arg(long)]
    survivors: bool,
    /// Form of the report
    #[arg(long, value_enum, default_value_t = ListFormat::Human)]
    format: ListFormat,
}

const HELP: &str = "\
Each fault is one change of a kernel's IR, or of its WGSL: swapped operands, a dropped clamp, a literal that is off, a \
wrong builtin, .. The kernel with the fault is run on the inputs of a check, as if one translator had made it. The bound \
that was derived for the kernel without it may notice it, or else the bits of the other roads to the same driver. What \
neither notices is run on more inputs (--equivalence): faults that never change a bit count for nothing.

Exit codes: 0 the scores are at least 98 % of all faults and 80 % of those of 1e-6, 1 they are not.";

/// Least share of faults of 1e-4 and more that must be noticed.
const SCORE: f64 = 0.98;

/// The same of smaller ones.
const SMALL_SCORE: f64 = 0.8;

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    let kernels = select::kernels(&args.kernels)?;
    let plan = Plan {
        inputs: args.inputs as usize,
        seed: args.seed,
        equivalence: args.equivalence as usize,
        cases: Cases::standard(),
        until: args.limit.map(|seconds| Instant::now() + Duration::from_secs(seconds)),
    };
    let bar = output::progress(kernels.len());
    let mut all = Vec::new();
    for kernel in kernels {
        bar.set_message(kernel().name);
        let faults = mutate(kernel, &plan)?;
        if args.format == ListFormat::Human {
            bar.suspend(|| output::print(&of_kernel(&faults, args.survivors)))?;
        }
        bar.inc(1);
        all.push(faults);
    }
    bar.finish_and_clear();
    output::print(&match args.format {
        ListFormat::Human => summary(&all),
        ListFormat::Json => format!("{:#}\n", as_json(args, &all)),
    })?;
    let (large, small) = scores(&all);
    let holds = large.score() >= SCORE && small.score() >= SMALL_SCORE;
    Ok(if holds { Outcome::Holds } else { Outcome::FellShort })
}

/// How the faults of 1e-4 and more ended, and how the smaller ones.
fn scores(all: &[KernelFaults]) -> (Count, Count) {
    let sum = |wanted: fn(Kind) -> bool| {
        all.iter().map(|k| k.count(wanted)).fold(Count::default(), std::ops::Add::add)
    };
    (sum(|kind| !kind.is_small()), sum(Kind::is_small))
}

fn of_kernel(faults: &KernelFaults, survivors: bool) -> String {
    let count = faults.count(|_| true);
    let mut text = format!("{}   {}\n", faults.kernel, told(count));
    for (mutant, outcome) in &faults.faults {
        let why = match outcome {
            report::Outcome::Missed { rows } => format!("first seen on row {rows} or before"),
            report::Outcome::Unseen { rows } => format!("not seen on {rows} rows"),
            report::Outcome::OtherBits { share, rows } if survivors => {
                format!("only bits of {rows} rows tell, {share:.2} of the bound")
            }
            _ => continue,
        };
        text += &format!("  {}, {why}\n", shown(mutant));
    }
    text
}

fn shown(mutant: &Mutant) -> String {
    let place = mutant.place.map(|p| format!(" at {p} `{}`", brief(p.text))).unwrap_or_default();
    format!("{} in {}{place}: {}", mutant.kind.name(), mutant.function, mutant.change)
}

fn brief(text: &str) -> String {
    let line: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if line.chars().count() > 60 { line.chars().take(57).collect::<String>() + ".." } else { line }
}

fn told(count: Count) -> String {
    let noticed = count.by_bound + count.by_bits;
    let mut text = format!(
        "{:5.1} % ({:5.1} % by the bound): {noticed} noticed",
        100.0 * count.score(),
        100.0 * count.score_of_bound()
    );
    let Count { missed, unseen, equivalent, not_tried, .. } = count;
    for (n, what) in
        [(missed, "missed"), (unseen, "unseen"), (equivalent, "equivalent"), (not_tried, "not tried")]
    {
        if n > 0 {
            text += &format!(", {n} {what}");
        }
    }
    text
}

fn summary(all: &[KernelFaults]) -> String {
    let mut text = "\n".to_owned();
    for (kind, count) in report::by_kind(all) {
        text += &format!("{:22} {}\n", kind.name(), told(count));
    }
    let (large, small) = scores(all);
    text + &format!("\nof 1e-4 and more        {}\nof 1e-6                 {}\n", told(large), told(small))
}

fn as_json(args: &Args, all: &[KernelFaults]) -> Value {
    let counted = |count: Count| {
        let mut value = json!(count);
        value["score"] = json!(count.score());
        value["score_of_bound"] = json!(count.score_of_bound());
        value
    };
    let kernels: Vec<Value> = all
        .iter()
        .map(|kernel| {
            let faults: Vec<Value> = kernel
                .faults
                .iter()
                .filter(|(_, outcome)| *outcome != report::Outcome::Stillborn)
                .map(|(mutant, outcome)| {
                    let mut value = json!(outcome);
                    value["kind"] = json!(mutant.kind);
                    value["function"] = json!(mutant.function);
                    value["place"] = json!(mutant.place.map(|p| p.to_string()));
                    value["change"] = json!(mutant.change);
                    value
                })
                .collect();
            json!({ "kernel": kernel.kernel, "count": counted(kernel.count(|_| true)), "faults": faults })
        })
        .collect();
    let (large, small) = scores(all);
    json!({
        "schema": 1, "report": "mutate", "seed": args.seed, "inputs": args.inputs, "equivalence": args.equivalence,
        "large": counted(large), "small": counted(small), "kernels": kernels,
    })
}
