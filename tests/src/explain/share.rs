//! What the error of each operation does to the result: the kernel in real numbers, with that one error put in.

use super::ExplainError;
use super::local::{Judged, Local};
use super::value::Value;
use lobe_backends::executor::Program;
use lobe_backends::interp::{Interpreter, ShadowColumn};
use lobe_codegen::data::Columns;
use lobe_codegen::trace::{Site, inject};

/// Errors that are put in at most; the largest, in ULP, are taken.
pub const LARGEST: usize = 4096;

/// An error on its way to the result.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// Its place in what was judged.
    pub judged: usize,
    /// Which scalar of the operation.
    pub component: usize,
    /// What it does to the result, in real numbers.
    pub effect: f64,
}

/// The result without any error, and what each error does to it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Shares {
    /// In real numbers, of the kernel's formula.
    pub formula: f64,
    /// Largest effect first.
    pub shares: Vec<Share>,
    /// Errors that were not put in, since there were more than [`LARGEST`].
    pub left_out: usize,
}

/// The shares of scalar `leaf` of the result.
///
/// # Errors
/// When the kernel does not run with an error put in.
pub fn shares(
    program: &Program,
    args: &Columns,
    (sites, values, judged): (&[Site], &[Value], &[Judged]),
    leaf: usize,
) -> Result<Shares, ExplainError> {
    let mut errors = errors(judged);
    errors.sort_by(|a, b| b.ulp.total_cmp(&a.ulp));
    let left_out = errors.len().saturating_sub(LARGEST);
    errors.truncate(LARGEST);
    let row = |site: u32, hit: u32, error: f32| {
        let mut row = args.row(0);
        row.extend([site, hit, error.to_bits()]);
        row
    };
    // The first row has no error.
    let mut rows = vec![row(sites.len() as u32, 0, 0.0)];
    rows.extend(errors.iter().map(|e| {
        let value = &values[judged[e.judged].value];
        let site =
            sites.iter().position(|s| (s.function, s.expression) == value.place).unwrap_or(sites.len());
        row((site + e.component) as u32, value.hit, e.error as f32)
    }));
    let injected = inject(program.module(), program.handle())?;
    let width = args.width() + 3;
    let args = Columns::from_rows(width, &rows);
    let outcome = Interpreter::new(&injected.module)?.exact(injected.function, &args, None)?;
    let Some(ShadowColumn::Float { exact, .. }) = outcome.columns.get(leaf) else {
        return Ok(Shares::default());
    };
    let formula = exact[0];
    let mut shares: Vec<Share> = errors
        .iter()
        .zip(&exact[1..])
        .map(|(e, with)| Share { judged: e.judged, component: e.component, effect: with - formula })
        .collect();
    shares.sort_by(|a, b| b.effect.abs().total_cmp(&a.effect.abs()));
    Ok(Shares { formula, shares, left_out })
}

struct Error {
    judged: usize,
    component: usize,
    error: f64,
    ulp: f64,
}

fn errors(judged: &[Judged]) -> Vec<Error> {
    let mut all = Vec::new();
    for (index, one) in judged.iter().enumerate() {
        for (component, local) in one.scalars.iter().enumerate() {
            if let (Local::Float { exact, .. }, Some(error)) = (local, local.error())
                && error != 0.0
            {
                all.push(Error { judged: index, component, error, ulp: super::ulps(error, *exact) });
            }
        }
    }
    all
}
