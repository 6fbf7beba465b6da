//! What a file of kernels looks like.
#![deny(warnings)]
use lobe_codegen::prelude::*;

/// A lobe.
#[kernel]
pub struct Sg {
    /// Axis.
    #[domain(unit)]
    pub axis: Vec3,
    /// Sharpness.
    #[domain(0.0..=1e6)]
    pub sharpness: f32,
}

/// Half of it.
#[kernel]
pub const HALF_OF_IT: f32 = 0.5;

/// Evaluates.
#[kernel(
    family = "sg",
    cite = "[Wang09] section 3",
    domain(dir = unit, k = [0.0, 1.0]),
    budget(1e-6 * result + HALF_OF_IT * 0.0),
)]
pub fn evaluate(dir: Vec3, sg: Sg, k: f32) -> f32 {
    exp(sg.sharpness * (dot(dir, sg.axis) - 1.0)) * HALF_OF_IT * k
}

fn exact(x: f64) -> f64 {
    x
}

/// Another form.
#[kernel(variant_of = evaluate, not_robust = "a test", truth = exact)]
pub fn other(x: f32) -> f32 {
    x
}

#[kernel(budget(sharpness = 1e-6, axis = 1e-5))]
fn build(axis: Vec3) -> Sg {
    Sg { axis, sharpness: 1.0 }
}

/// Names are plain in the output, raw or not.
#[kernel]
fn raw(r#dyn: f32) -> f32 {
    r#dyn
}

fn main() {
    let sg = build(Vec3::Z);
    assert_eq!(evaluate(Vec3::Z, sg, 1.0), 0.5);
    assert_eq!(other(raw(1.0)), 1.0);
}
