//! The cone that a spherical light fills.

use crate::constants::{FOUR_PI, TWO_PI};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Hasan09, Tokuyoshi15, Xu14};
use crate::sg::Sg;
use lobe_codegen::prelude::*;

/// ln 2.
#[kernel]
pub const LN_2: f32 = 0.69314718055994530942;

/// The cone of directions from a shading point to a spherical light.
#[kernel]
pub struct Cone {
    /// In sr.
    pub solid_angle: f32,
    /// Of the lobe that stands for it, 4π over the solid angle.
    pub sharpness: f32,
    /// Solid angle over the area `π r²` of the light's disk.
    pub density: f32,
}

/// The cone that a spherical light fills.
///
/// With the slant `s = √(d² + r²)`: solid angle `2π (1 - d/s) = 2π r²/(s (s + d))`, density
/// `|Ω|/(π r²) = 2/(s (s + d))`, sharpness `4π/|Ω|`.
/// Source: [Tokuyoshi15] section 3.1 ([Hasan09]).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `dist` | distance of the centre, `d` | 0 ..= 1e4 | length |
/// | `radius` | `r` | 0 ..= 1e4 | length |
///
/// Returns the cone: solid angle in 0 ..= 2π sr; density in 1/length², `1/d²` for a point light and `2/r²` at the
/// centre. The slant counts as 1e-9 at least.
///
/// Numerics: `1 - cos` cancels ([`vsl_cone_paper`]): by 19 % at `r/d` = 1e-3, wholly at 1e-4. The density needs
/// no division by `r²`. The solid angle `π r²/d²` of [Xu14] is 1.7 times too large at `r = d`, and has no limit.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3.1",
    domain(dist = 0.0..=1e4, radius = 0.0..=1e4),
    budget(
        solid_angle = 4e-6 * result.solid_angle + 1e-19,
        sharpness = 4e-6 * result.sharpness,
        density = 4e-6 * result.density
    ),
    measured
)]
pub fn vsl_cone(dist: f32, radius: f32) -> Cone {
    let area = radius * radius;
    let slant = max(sqrt(dist * dist + area), 1e-9);
    let doubled = slant * (slant + dist);
    Cone {
        solid_angle: TWO_PI * (area / doubled),
        sharpness: 2.0 * (doubled / max(area, 1e-24)),
        density: 2.0 / doubled,
    }
}

/// The cone that a spherical light fills, as printed.
///
/// Solid angle `2π (1 - d/√(d² + r²))`. Source: [Tokuyoshi15] section 3.1. Arguments and result as of
/// [`vsl_cone`].
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3.1",
    domain(dist = 0.0..=1e4, radius = 1e-6..=1e4),
    budget(
        solid_angle = 4e-6 * result.solid_angle + 1e-19,
        sharpness = 4e-6 * result.sharpness,
        density = 4e-6 * result.density
    ),
    variant_of = vsl_cone,
    not_robust = "1 - cos cancels for narrow cones",
    measured
)]
pub fn vsl_cone_paper(dist: f32, radius: f32) -> Cone {
    let solid_angle = TWO_PI * (1.0 - dist / sqrt(dist * dist + radius * radius));
    Cone {
        solid_angle,
        sharpness: FOUR_PI / solid_angle,
        density: solid_angle / (0.5 * TWO_PI * radius * radius),
    }
}

/// The spherical Gaussian that stands for the cone of a spherical light.
///
/// `V(w) ≈ 2 G(w; w_i, 4π/|Ω|)`
/// Source: [Tokuyoshi15] section 3.1, after [Xu14].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `dir` | unit direction to the centre, `w_i` | sphere | 1 |
/// | `dist` | distance of the centre | 0 ..= 1e4 | length |
/// | `radius` | of the light | 0 ..= 1e4 | length |
///
/// Returns the lobe, its sharpness in 2 ..= 2^31. Its integral is `|Ω| (1 - e^(-8π/|Ω|))`, that of the cone to
/// within 0.3 % up to `r/d` = 3 and 1.8 % for the hemisphere.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3.1",
    domain(dir = unit, dist = 0.0..=1e4, radius = 0.0..=1e4),
    budget(axis = 0.0, sharpness = 4e-6 * result.sharpness, log_amplitude = 1e-7),
    measured
)]
pub fn vsl_window(dir: Vec3, dist: f32, radius: f32) -> Sg {
    Sg { axis: dir, sharpness: min(vsl_cone(dist, radius).sharpness, 2147483648.0), log_amplitude: LN_2 }
}
