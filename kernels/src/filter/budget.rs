//! The scale that a budget is stated in. No kernel computes with it.

use super::moments::Moments;
#[allow(unused_imports, reason = "the documentation links to it")]
use super::moments::moments_merge4;
use lobe_codegen::prelude::*;

/// Root of the weighted mean square of the distances of four means from their origin.
///
/// What the rounding of [`moments_merge4`] is measured by. Source: the definition.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `a`, `b`, `c`, `d` | moments about the same origin or reference | weight 0 ..= 1e6 | as of the moments |
///
/// Returns the distance, at least 0; 0 for empty sets.
#[kernel]
pub fn moments_distance4(a: Moments, b: Moments, c: Moments, d: Moments) -> f32 {
    let total = max(a.weight + b.weight + c.weight + d.weight, 1e-20);
    let ab = a.weight / total * dot(a.mean, a.mean) + b.weight / total * dot(b.mean, b.mean);
    let cd = c.weight / total * dot(c.mean, c.mean) + d.weight / total * dot(d.mean, d.mean);
    sqrt(ab + cd)
}
