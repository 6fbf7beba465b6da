//! Figures of the papers, drawn from the kernels themselves and from independent integrals in f64.
//!
//! No curve is a formula written again for drawing: f32 curves are the native functions, f64 curves the shadow
//! lane's real values, and what they are compared with comes out of [`quadrature`].
//! `lobe figures` writes the pictures; those in `kernels/figures` are committed, and a test says whether they
//! are still what the code gives.

pub mod axis;
mod clamped_cosine;
mod convolution;
mod falloff;
pub mod plot;
pub mod proxies;
pub mod quadrature;
pub mod sheets;
mod steepness;
pub mod svg;
pub mod theme;

use lobe_backends::executor::Program;
use lobe_backends::interp::ShadowColumn;
use lobe_codegen::data::Columns;
use lobe_codegen::def::FunctionRef;
use plot::Figure;
use std::path::PathBuf;

/// Why a figure cannot be drawn.
pub type DrawError = lobe_backends::executor::ExecError;

/// All figures.
///
/// # Errors
/// When a kernel does not run on the interpreter.
pub fn all() -> Result<Vec<Figure>, DrawError> {
    Ok(vec![clamped_cosine::figure()?, steepness::figure()?, falloff::figure()?, convolution::figure()?])
}

/// The folder of the committed pictures.
#[must_use]
pub fn folder() -> PathBuf {
    let here = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here).join("kernels/figures")
}

/// The real values of `kernel`'s first result at rows of f32 arguments.
fn real(kernel: FunctionRef, rows: &[Vec<f32>]) -> Result<Vec<f64>, DrawError> {
    let program = Program::new(kernel)?;
    let words: Vec<Vec<u32>> = rows.iter().map(|row| row.iter().map(|v| v.to_bits()).collect()).collect();
    let args = Columns::from_rows(program.params().len(), &words);
    let shadow = program.exact(&args, None)?;
    Ok(match shadow.columns.into_iter().next() {
        Some(ShadowColumn::Float { exact, .. }) => exact,
        Some(ShadowColumn::Word { .. }) | None => Vec::new(),
    })
}

/// Of largest magnitude.
fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |most: f64, v| if v.abs() > most.abs() { v } else { most })
}
