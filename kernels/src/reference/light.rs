//! Lights that scenes of the reference have beside the distant one.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Abramowitz64, Pharr23};
use lobe_codegen::prelude::*;

/// 1/√2.
#[kernel]
pub const INVERSE_ROOT_TWO: f32 = 0.70710678118654752440;

/// The angle between two directions up to a right one.
///
/// `acos c = √(1 - c) P(c)`, `P` of degree 7, with `√(1 - c) = |a - b|/√2`.
/// Source: [Abramowitz64] eq. 4.4.46.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `a`, `b` | unit directions | sphere | 1 |
///
/// Returns the angle, in 0 ..= π/2; between π/2 and 2.23 for directions farther apart.
///
/// Numerics: within 2e-8 of the exact angle; the shading languages let `acos` err by 7e-5. The chord is exact for
/// near directions.
#[kernel(family = "reference", cite = "[Abramowitz64] eq. 4.4.46", domain(a = unit, b = unit), budget(2e-6 * result + 1e-18), measured)]
pub fn angle_between(a: Vec3, b: Vec3) -> f32 {
    let chord = a - b;
    let c = max(dot(a, b), 0.0);
    let high = -0.0170881256 + c * (0.0066700901 + c * -0.0012624911);
    let tail = -0.0501743046 + c * (0.0308918810 + c * high);
    let curve = 1.5707963050 + c * (-0.2145988016 + c * (0.0889789874 + c * tail));
    INVERSE_ROOT_TWO * sqrt(dot(chord, chord)) * curve
}

/// Irradiance of a spotlight of intensity 1 W/sr across its direction.
///
/// `E = clamp((outer - angle)/blend, 0, 1) / d²`
/// Source: [Pharr23] section 12.2.1, with a falloff that is linear in the angle.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `axis` | unit direction of the middle of the cone, away from the light | sphere | 1 |
/// | `outer` | half the angle of the cone beyond which there is no light | 0.02 ..= 1.57 | rad |
/// | `blend` | by how much less the half angle is of the cone in which all of it is | 1e-3 ..= 1.57 | rad |
/// | `light` | unit direction to the light | sphere | 1 |
/// | `dist` | distance `d` to the light | 1e-3 ..= 1e4 | m |
///
/// Returns the irradiance in W/m², at least 0.
#[kernel(
    family = "reference",
    cite = "[Pharr23] section 12.2.1",
    domain(axis = unit, outer = 0.02..=1.57, blend = 1e-3..=1.57, light = unit, dist = 1e-3..=1e4),
    budget((6e-7 + 3e-6 / blend) / (dist * dist)),
    measured
)]
pub fn spot_irradiance(axis: Vec3, outer: f32, blend: f32, light: Vec3, dist: f32) -> f32 {
    let falloff = clamp((outer - angle_between(axis, -light)) / blend, 0.0, 1.0);
    falloff / (dist * dist)
}
