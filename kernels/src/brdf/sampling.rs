//! Random directions: about a normal, of half vectors, of visible normals, and their densities.
//!
//! Uniform numbers come in pairs in 0 ..= 1 - 2^-24, as the generators of the reference
//! makes them. Local directions have the normal for `z`.

use super::ndf::ggx_ndf_between;
use crate::constants::{INVERSE_PI, TWO_PI};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Abramowitz64, Duff17, Dupuy23, Heitz18, Pharr23, Walter07};
use lobe_codegen::prelude::*;

/// Three unit vectors, perpendicular to each other, right-handed.
#[kernel]
pub struct Frame {
    /// Tangent.
    #[domain(unit)]
    pub x: Vec3,
    /// Bitangent, `cross(z, x)`.
    #[domain(normal_to(x))]
    pub y: Vec3,
    /// Normal.
    #[domain(cross(x, y))]
    pub z: Vec3,
}

/// A frame about a normal.
///
/// With `s` the sign of `n.z`, `a = -1/(s + n.z)`: `x = (1 + s a n.x², s a n.x n.y, -s n.x)`,
/// `y = (a n.x n.y, s + a n.y², -n.y)`.
/// Source: [Duff17] listing 3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal` | unit normal `n` | sphere | 1 |
///
/// Returns the frame with `z = n`. It is not continuous across `n.z = 0`.
#[kernel(family = "brdf", cite = "[Duff17] listing 3", domain(normal = unit), budget(7e-7), measured)]
pub fn orthonormal_frame(normal: Vec3) -> Frame {
    let side = select(-1.0, 1.0, normal.z >= 0.0);
    let a = -1.0 / (side + normal.z);
    let b = normal.x * normal.y * a;
    Frame {
        x: Vec3::new(1.0 + side * (normal.x * normal.x * a), side * b, -side * normal.x),
        y: Vec3::new(b, side + normal.y * normal.y * a, -normal.y),
        z: normal,
    }
}

/// A direction of a frame, in the space of the frame's vectors.
///
/// `d.x x + d.y y + d.z z`
/// Source: [Pharr23] section 3.3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `frame` | the frame | orthonormal | 1 |
/// | `local` | components along its vectors | unit | 1 |
///
/// Returns the unit direction.
#[kernel(family = "brdf", cite = "[Pharr23] section 3.3", domain(local = unit), budget(4e-7), measured)]
pub fn frame_to_world(frame: Frame, local: Vec3) -> Vec3 {
    local.x * frame.x + local.y * frame.y + local.z * frame.z
}

/// A direction in a frame.
///
/// `(d·x, d·y, d·z)`
/// Source: [Pharr23] section 3.3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `frame` | the frame | orthonormal | 1 |
/// | `world` | unit direction, in the space of the frame's vectors | sphere | 1 |
///
/// Returns the unit direction's components along the frame's vectors.
#[kernel(family = "brdf", cite = "[Pharr23] section 3.3", domain(world = unit), budget(4e-7), measured)]
pub fn frame_to_local(frame: Frame, world: Vec3) -> Vec3 {
    Vec3::new(dot(world, frame.x), dot(world, frame.y), dot(world, frame.z))
}

/// The sine of an angle of at most a quarter turn.
///
/// `sin 2π t`, by the series up to the 13th power.
/// Source: [Abramowitz64] eq. 4.3.65.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `turn` | `t` | -0.25 ..= 0.25 | turns |
///
/// Returns the sine, within 1e-9 of the exact one.
///
/// Numerics: the shading languages let `sin` err by 5e-4.
#[kernel(family = "brdf", cite = "[Abramowitz64] eq. 4.3.65", domain(turn = -0.25..=0.25), budget(7e-7 * abs(result) + 1e-37), measured)]
pub fn sine_of_turn(turn: f32) -> f32 {
    let x = TWO_PI * turn;
    let q = x * x;
    let high = -2.50521083854417188e-8 + q * 1.60590438368216146e-10;
    let tail = -1.98412698412698413e-4 + q * (2.75573192239858907e-6 + q * high);
    x * (1.0 + q * (-0.166666666666666667 + q * (8.33333333333333333e-3 + q * tail)))
}

/// The unit vector at a share of a turn.
///
/// `(cos 2π t, sin 2π t)`
/// Source: [Pharr23] section A.5.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `turn` | `t` | 0 ..= 1 | turns |
///
/// Returns the vector.
///
/// Numerics: folding the turn into a quarter is exact; [`sine_of_turn`] does the rest.
#[kernel(family = "brdf", cite = "[Pharr23] section A.5", domain(turn = 0.0..=1.0), budget(7e-7), measured)]
pub fn circle_of_turn(turn: f32) -> Vec2 {
    // sin 2π t = -sin 2π (t - 1/2), and an angle beyond a quarter has the sine of what is left to the half.
    let from_half = turn - 0.5;
    let rest = min(abs(from_half), 0.5 - abs(from_half));
    let sine = sine_of_turn(select(rest, -rest, from_half > 0.0));
    Vec2::new(-sine_of_turn(0.25 - abs(from_half)), sine)
}

/// Random direction about the normal, by the cosine.
///
/// `(√u.y cos 2π u.x, √u.y sin 2π u.x, √(1 - u.y))`
/// Source: [Pharr23] section A.5.3, in polar coordinates.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `u` | two uniform numbers | 0 ..= 1 - 2^-24 | 1 |
///
/// Returns a unit direction in the frame of the normal, `z > 0`; its density is [`cosine_hemisphere_pdf`].
#[kernel(family = "brdf", cite = "[Pharr23] section A.5.3", domain(u = 0.0..=0.99999994), budget(1.5e-6), measured)]
pub fn cosine_sample_hemisphere(u: Vec2) -> Vec3 {
    let circle = sqrt(u.y) * circle_of_turn(u.x);
    Vec3::new(circle.x, circle.y, sqrt(1.0 - u.y))
}

/// Density of [`cosine_sample_hemisphere`].
///
/// `(n·l)⁺/π`
/// Source: [Pharr23] section A.5.3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `n_dot_l` | cosine of the direction and the normal | -1 ..= 1 | 1 |
///
/// Returns the density in 1/sr.
#[kernel(family = "brdf", cite = "[Pharr23] section A.5.3", domain(n_dot_l = -1.0..=1.0), budget(2e-7 * result + 1e-37), measured)]
pub fn cosine_hemisphere_pdf(n_dot_l: f32) -> f32 {
    INVERSE_PI * max(n_dot_l, 0.0)
}

/// Random half vector of the GGX distribution, by `D (n·h)`.
///
/// `tan θ = alpha √(u.y/(1 - u.y))`, azimuth `2π u.x`
/// Source: [Walter07] eq. 35, 36.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `alpha` | width | 0.02 ..= 1 | 1 |
/// | `u` | two uniform numbers | 0 ..= 1 - 2^-24 | 1 |
///
/// Returns a unit half vector in the frame of the normal, `z > 0`, of density `D (n·h)` in 1/sr. A direction
/// mirrored about it has the density [`ggx_half_vector_pdf`].
///
/// Numerics: the vector `(alpha √u.y cos, alpha √u.y sin, √(1 - u.y))`, normalised; no angle is computed.
#[kernel(
    family = "brdf",
    cite = "[Walter07] eq. 35, 36",
    domain(alpha = 0.02..=1.0, u = 0.0..=0.99999994),
    budget(2e-6),
    measured
)]
pub fn ggx_sample_half_vector(alpha: f32, u: Vec2) -> Vec3 {
    // A maximum, so that no compiler takes the 1 to the other side of the sum, where it would drown the rest.
    let rest = max(1.0 - u.y, 0.0);
    let squared = alpha * alpha * u.y + rest;
    let circle = alpha * sqrt(u.y) * circle_of_turn(u.x);
    inverse_sqrt(max(squared, 1e-8)) * Vec3::new(circle.x, circle.y, sqrt(rest))
}

/// Density of a direction that mirrors a view about a half vector of [`ggx_sample_half_vector`].
///
/// `D(h) (n·h) / (4 (v·h))`
/// Source: [Walter07] eq. 38.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `alpha` | width | 0.02 ..= 1 | 1 |
/// | `normal`, `light`, `view` | unit vectors `n`, `l`, `v` | sphere | 1 |
///
/// Returns the density of `l` in 1/sr; 0 for half vectors below the horizon.
///
/// Numerics: with the sum `s = l + v`, `(n·h)/(v·h) = 2 (n·s)/|s|²`. Towards opposite directions it grows without
/// limit, as the density does: `|s|²` is held at 1e-6.
#[kernel(
    family = "brdf",
    cite = "[Walter07] eq. 38",
    domain(alpha = 0.02..=1.0, normal = unit, light = unit, view = unit),
    budget(
        ((3e-6 + 1e-6 / alpha) * result + 5e-7 * ggx_ndf_between(normal, light, view, alpha)
            * inverse_sqrt(max(dot(light + view, light + view), 1e-6))) + 1e-7
    ),
    measured
)]
pub fn ggx_half_vector_pdf(alpha: f32, normal: Vec3, light: Vec3, view: Vec3) -> f32 {
    let sum = light + view;
    let ratio = max(dot(normal, sum), 0.0) / max(dot(sum, sum), 1e-6);
    0.5 * (ratio * ggx_ndf_between(normal, light, view, alpha))
}

/// Random normal among those that a viewer sees, of the GGX distribution.
///
/// By `D_v = G1(v) D(h) (v·h)⁺ / (n·v)`: a spherical cap about the stretched view.
/// Source: [Dupuy23] listing 1, [Heitz18].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `view` | unit direction in the frame of the normal; the height's sign is not read | sphere | 1 |
/// | `alpha` | width | 0.02 ..= 1 | 1 |
/// | `u` | two uniform numbers | 0 ..= 1 - 2^-24 | 1 |
///
/// Returns a unit normal in the frame, `z > 0`. The view mirrored about it has the density
/// [`ggx_visible_normal_pdf`].
///
/// Numerics: with `t = u.y (1 + w.z)` of the stretched view `w`, the cap's sine is `√(t (2 - t))`; here
/// `2 - t = (w.x² + w.y²)/(1 + w.z) + (1 - u.y)(1 + w.z)` and the normal's height above the cap
/// `(1 - u.y)(1 + w.z)`, which do not cancel. For oblique views and `u.y` near 1 the normal is the difference of
/// two vectors, and turns by their error over `1 - u.y`.
#[kernel(
    family = "brdf",
    cite = "[Dupuy23] listing 1",
    domain(view = unit, alpha = 0.02..=1.0, u = 0.0..=0.99999994),
    budget(3e-6 + 2.5e-6 * alpha / (1.0 - u.y)),
    measured
)]
pub fn ggx_sample_visible_normal(view: Vec3, alpha: f32, u: Vec2) -> Vec3 {
    let stretched = Vec3::new(alpha * view.x, alpha * view.y, abs(view.z));
    let w = stretched * inverse_sqrt(max(dot(stretched, stretched), 1e-8));
    let rise = 1.0 + w.z;
    let height = (1.0 - u.y) * rise;
    let across = (w.x * w.x + w.y * w.y) / rise;
    let circle = sqrt(u.y * rise * (across + height)) * circle_of_turn(u.x);
    let cap = Vec3::new(alpha * (circle.x + w.x), alpha * (circle.y + w.y), height);
    cap * inverse_sqrt(max(dot(cap, cap), 1e-20))
}

/// Density of a direction that mirrors a view about a normal of [`ggx_sample_visible_normal`].
///
/// `G1(v) D(h) / (4 (n·v)) = D(h) / (2 (n·v + √(alpha² + (1 - alpha²) (n·v)²)))`
/// Source: [Heitz18] eq. 17, 18.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `alpha` | width | 0.02 ..= 1 | 1 |
/// | `normal`, `light`, `view` | unit vectors `n`, `l`, `v` | sphere | 1 |
///
/// Returns the density of `l` in 1/sr, where the half vector is above the horizon; finite for a grazing view.
#[kernel(
    family = "brdf",
    cite = "[Heitz18] eq. 17",
    domain(alpha = 0.02..=1.0, normal = unit, light = unit, view = unit),
    budget((6e-6 + 3e-6 / alpha) * result + 1e-9),
    measured
)]
pub fn ggx_visible_normal_pdf(alpha: f32, normal: Vec3, light: Vec3, view: Vec3) -> f32 {
    let n_dot_v = max(dot(normal, view), 0.0);
    let root = sqrt(alpha * alpha + (1.0 - alpha) * (1.0 + alpha) * (n_dot_v * n_dot_v));
    ggx_ndf_between(normal, light, view, alpha) * (0.5 / (n_dot_v + root))
}

/// A direction mirrored about an axis.
///
/// `2 (d·h) h - d`
/// Source: [Walter07] eq. 39.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `dir` | unit direction `d`, away from the surface | sphere | 1 |
/// | `axis` | unit vector `h` | sphere | 1 |
///
/// Returns the unit direction on the other side of the axis.
#[kernel(family = "brdf", cite = "[Walter07] eq. 39", domain(dir = unit, axis = unit), budget(1.5e-6), measured)]
pub fn mirror(dir: Vec3, axis: Vec3) -> Vec3 {
    2.0 * dot(dir, axis) * axis - dir
}
