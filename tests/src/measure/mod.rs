//! The worst errors that a kernel's documentation shows: measured, written to a file and compared with it.
//!
//! Each kernel has a file `src/measured/NAME.md` ([`file`](mod@file)), which `#[kernel(measured, ..)]` puts under its doc
//! comment.
//! What is in it is a function of the kernel, the number of inputs and the seed, and, for the routes that have
//! a driver, of that driver: `native`, `interp` and the derived bound give the same figures on every machine.
//! The file names the drivers and carries a fingerprint of the definition that was measured.

pub mod file;
mod fingerprint;
mod number;
pub mod source;
mod worst;

pub use fingerprint::definition;
pub(crate) use fingerprint::{driver, source};
pub use worst::{At, Figure};

use crate::cases::Cases;
use crate::domain::Inputs;
use crate::judge::{JudgeError, each_batch};
use crate::subject::Subject;
use lobe_backends::executor::Executor;
use lobe_backends::route::{Road, Route};
use lobe_backends::routes::Machine;
use lobe_codegen::def::FunctionRef;
use std::path::{Path, PathBuf};

/// What is measured with.
#[derive(Clone, Debug)]
pub struct Setting {
    /// Rows to draw from the domain.
    pub inputs: usize,
    /// Where the drawing begins.
    pub seed: u64,
    /// Where listed cases lie.
    pub cases: Cases,
}

/// What was measured of a kernel.
#[derive(Clone, Debug)]
pub struct Measurement {
    /// Its name.
    pub kernel: &'static str,
    /// Fingerprint of what was measured.
    pub definition: u64,
    /// Rows, the listed ones among them.
    pub rows: usize,
    /// Where the drawing began.
    pub seed: u64,
    /// What the budgets permit: the part of the result, empty for all of it, and the expression.
    pub budgets: Vec<(&'static str, &'static str)>,
    /// Of the derived bound.
    pub bound: Figure,
    /// Of each route.
    pub routes: Vec<(Route, Figure)>,
    /// The drivers among the routes, each with what it is.
    pub drivers: Vec<(String, String)>,
}

/// Measures `kernel` on `routes`, which are routes of `machine`.
///
/// # Errors
/// When it does not run, or its inputs cannot be drawn.
pub fn measure(
    kernel: FunctionRef,
    setting: &Setting,
    routes: &mut [Box<dyn Executor>],
    machine: &Machine,
) -> Result<Measurement, JudgeError> {
    let subject = Subject::new(kernel)?;
    if subject.program().results().is_empty() {
        return Err(JudgeError::NoResult { kernel: subject.def().name });
    }
    let listed = setting.cases.listed(subject.def())?;
    let inputs = Inputs::draw(subject.def(), setting.inputs, setting.seed, &listed)?;
    let mut bound = Figure::default();
    let mut figures: Vec<_> = routes.iter().map(|r| (r.route().clone(), Figure::default())).collect();
    each_batch(&subject, &inputs.args, routes, &mut |batch| {
        bound.take_bound(batch);
        for ((_, figure), (_, output)) in figures.iter_mut().zip(batch.outputs) {
            figure.take_output(batch, output.as_ref());
        }
    })?;
    Ok(Measurement {
        kernel: subject.def().name,
        definition: definition(&subject)?,
        budgets: subject.def().contract.budget.iter().map(|b| (b.path, b.text)).collect(),
        rows: inputs.args.rows,
        seed: setting.seed,
        bound,
        drivers: drivers(&figures, machine),
        routes: figures,
    })
}

fn drivers(figures: &[(Route, Figure)], machine: &Machine) -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = Vec::new();
    for name in figures.iter().filter_map(|(route, _)| route.driver()) {
        if found.iter().all(|(known, _)| known != name) {
            found.push((name.to_owned(), driver(machine, name)));
        }
    }
    found
}

/// Whether documentation shows the figures of `route`.
///
/// The roads of slang, glslang, Tint and OpenGL are left out: all roads to a driver give the same bits, which a check asks of them,
/// and a figure that hangs on fewer compilers is out of date less often.
#[must_use]
pub fn is_documented(route: &Route) -> bool {
    match route {
        Route::Native | Route::Interp => true,
        Route::Gpu { road, .. } => match road {
            Road::Spirv | Road::WgslNaga | Road::HlslDxc => true,
            Road::HlslSlang | Road::GlslGlslang | Road::WgslTint | Road::Glsl => false,
        },
    }
}

/// The folder of the files of this source tree.
#[must_use]
pub fn folder() -> PathBuf {
    root().join("kernels/src/measured")
}

/// The source tree that this was built from.
fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here)
}
