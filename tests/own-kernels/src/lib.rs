//! Kernels beside the library's; `tests/kernels.rs` has them judged on every route.

use lobe_codegen::prelude::*;

/// Light of a lamp at distance `d`, faded out so that nothing is left at `radius`.
///
/// `1 / d²`, kept below 1, times `(1 - (d / r)⁴)²`.
#[kernel(
    family = "light",
    domain(d = 0.0..=200.0, radius = 1.0..=100.0),
    budget(1e-5 * result + 1e-6)
)]
pub fn falloff(d: f32, radius: f32) -> f32 {
    let share = min(d / radius, 1.0);
    let square = share * share;
    let window = 1.0 - square * square;
    window * window / max(d * d, 1.0)
}

/// A colour's share of light that a smooth surface reflects, by Schlick.
#[kernel(
    family = "surface",
    domain(f0.x = 0.0..=1.0, f0.y = 0.0..=1.0, f0.z = 0.0..=1.0, cosine = 0.0..=1.0),
    budget(1e-6)
)]
pub fn reflected(f0: Vec3, cosine: f32) -> Vec3 {
    let m = 1.0 - cosine;
    let m2 = m * m;
    f0 + (Vec3::new(1.0, 1.0, 1.0) - f0) * (m2 * m2 * m)
}
