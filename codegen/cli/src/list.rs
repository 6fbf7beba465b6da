//! `lobe list`: the kernels and what they promise; the operations and what is promised of them.

use crate::fail::{Fail, Outcome};
use crate::output::{self, ListFormat};
use crate::select;
use crate::{model, operations};
use lobe_codegen::accuracy::Model;
use lobe_codegen::def::{Domain, FunctionDef};
use serde_json::{Value, json};
use std::fmt::Write;

/// Options.
#[derive(Debug, clap::Args)]
pub(crate) struct Args {
    /// Kernels to list; all when none is named
    kernels: Vec<String>,
    /// List the operations instead, with what each specification permits drivers, and where it says so
    #[arg(long, conflicts_with = "kernels")]
    operations: bool,
    /// Only by this specification
    #[arg(long, value_name = "MODEL", requires = "operations", value_parser = model::parser())]
    model: Option<&'static Model>,
    /// Form of the output
    #[arg(long, value_enum, default_value_t = ListFormat::Human)]
    format: ListFormat,
}

/// Runs the subcommand.
pub(crate) fn run(args: &Args) -> Result<Outcome, Fail> {
    if args.operations {
        let models: Vec<&Model> = args.model.map_or_else(|| Model::all().iter().collect(), |one| vec![one]);
        output::print(&operations::listing(&models, args.format))?;
        return Ok(Outcome::Holds);
    }
    let kernels = select::kernels(&args.kernels)?;
    output::print(&match args.format {
        ListFormat::Human => kernels.iter().map(|k| human(k())).collect(),
        ListFormat::Json => {
            let kernels: Vec<Value> = kernels.iter().map(|k| as_json(k())).collect();
            format!("{:#}\n", json!({ "schema": 1, "kernels": kernels }))
        }
    })?;
    Ok(Outcome::Holds)
}

fn human(kernel: &FunctionDef) -> String {
    let contract = &kernel.contract;
    let mut out = format!("{}\n", signature(kernel));
    let _ = writeln!(out, "    {}", kernel.docs.first().copied().unwrap_or_default());
    let mut part = |name: &str, text: String| {
        if !text.is_empty() {
            let _ = writeln!(out, "    {name:<10} {text}");
        }
    };
    part("family", contract.family.to_owned());
    part("source", contract.cite.to_owned());
    part(
        "domain",
        domains(kernel).into_iter().map(|(p, d)| format!("{p} {d}")).collect::<Vec<_>>().join(", "),
    );
    for budget in contract.budget {
        let of = if budget.path.is_empty() { String::new() } else { format!("{}: ", budget.path) };
        part("budget", format!("{of}{}", budget.text));
    }
    part("variant of", contract.variant_of.map(|f| f().name.to_owned()).unwrap_or_default());
    part("not robust", contract.not_robust.unwrap_or_default().to_owned());
    out
}

fn as_json(kernel: &FunctionDef) -> Value {
    let contract = &kernel.contract;
    let params = kernel.params.iter().map(|p| json!({ "name": p.name, "type": p.ty.to_string() }));
    let domains = domains(kernel).into_iter().map(|(path, domain)| json!({ "path": path, "domain": domain }));
    let budgets = contract.budget.iter().map(|b| json!({ "path": b.path, "permitted": b.text }));
    json!({
        "name": kernel.name,
        "module": kernel.module,
        "signature": signature(kernel),
        "params": params.collect::<Vec<_>>(),
        "result": kernel.ret.map(|ty| ty.to_string()),
        "docs": kernel.docs,
        "family": contract.family,
        "cite": contract.cite,
        "domain": domains.collect::<Vec<_>>(),
        "budget": budgets.collect::<Vec<_>>(),
        "variant_of": contract.variant_of.map(|f| f().name),
        "not_robust": contract.not_robust,
        "has_truth": contract.truth.is_some(),
    })
}

fn signature(kernel: &FunctionDef) -> String {
    let params: Vec<String> = kernel.params.iter().map(|p| format!("{}: {}", p.name, p.ty)).collect();
    let result = kernel.ret.map(|ty| format!(" -> {ty}")).unwrap_or_default();
    format!("{}({}){result}", kernel.name, params.join(", "))
}

/// The domains that the kernel states, then those of its structures' fields.
fn domains(kernel: &FunctionDef) -> Vec<(String, String)> {
    let stated = kernel.contract.domain.iter().map(|d| (d.path.to_owned(), text(&d.domain)));
    let mut all: Vec<(String, String)> = stated.collect();
    for param in kernel.params {
        let lobe_codegen::def::TypeDef::Struct(def) = param.ty else { continue };
        for field in def().fields {
            let path = format!("{}.{}", param.name, field.name);
            if let Some(domain) = &field.domain
                && all.iter().all(|(known, _)| *known != path)
            {
                all.push((path, text(domain)));
            }
        }
    }
    all
}

fn text(domain: &Domain) -> String {
    match domain {
        Domain::Range(lo, hi) => format!("{lo:?}..={hi:?}"),
        Domain::Unit => "unit".to_owned(),
        Domain::NormalTo(other) => format!("normal_to({other})"),
        Domain::Cross(a, b) => format!("cross({a}, {b})"),
        Domain::Values(values) => format!("{values:?}"),
    }
}
