//! Masking and shadowing of GGX facets.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Heitz14, Walter07};
use lobe_codegen::prelude::*;

/// What the masking functions are built of, `1 + 2 Λ = √(1 - alpha² + alpha²/c²)`.
///
/// Source: [Heitz14] eq. 72.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `cosine` | `c`, of a direction and the normal; at most 1e-15 counts as grazing | -1 ..= 1 | 1 |
/// | `alpha` | width | 0.02 ..= 1 | 1 |
///
/// Returns the root, at least 1; `alpha`·1e15 below the horizon.
#[kernel(
    family = "brdf",
    cite = "[Heitz14] eq. 72",
    domain(cosine = -1.0..=1.0, alpha = 0.02..=1.0),
    budget(2e-6 * result),
    measured
)]
pub fn smith_root(cosine: f32, alpha: f32) -> f32 {
    let slope = alpha / max(cosine, 1e-15);
    sqrt((1.0 - alpha) * (1.0 + alpha) + slope * slope)
}

/// Masking of GGX facets: the share that one direction sees.
///
/// `G1 = 2 / (1 + √(1 + alpha² tan²θ))`
/// Source: [Walter07] eq. 34.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `cosine` | of the direction and the normal | -1 ..= 1 | 1 |
/// | `alpha` | width | 0.02 ..= 1 | 1 |
///
/// Returns the share, in 0 ..= 1; 1 at normal incidence, below 1e-12 at the horizon and under it.
#[kernel(
    family = "brdf",
    cite = "[Walter07] eq. 34",
    domain(cosine = -1.0..=1.0, alpha = 0.02..=1.0),
    budget(2e-6 * result),
    measured
)]
pub fn smith_g1(cosine: f32, alpha: f32) -> f32 {
    2.0 / (1.0 + smith_root(cosine, alpha))
}

/// Masking and shadowing of GGX facets: the share that both directions see, correlated by height.
///
/// `G2 = 1 / (1 + Λ(l) + Λ(v))`
/// Source: [Heitz14] eq. 99.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `n_dot_l`, `n_dot_v` | cosines of the directions and the normal | -1 ..= 1 | 1 |
/// | `alpha` | width | 0.02 ..= 1 | 1 |
///
/// Returns the share, in 0 ..= 1, not larger than either direction's [`smith_g1`].
#[kernel(
    family = "brdf",
    cite = "[Heitz14] eq. 99",
    domain(n_dot_l = -1.0..=1.0, n_dot_v = -1.0..=1.0, alpha = 0.02..=1.0),
    budget(3e-6 * result),
    measured
)]
pub fn smith_g2(n_dot_l: f32, n_dot_v: f32, alpha: f32) -> f32 {
    2.0 / (smith_root(n_dot_l, alpha) + smith_root(n_dot_v, alpha))
}

/// Visibility of GGX facets: masking and shadowing over the cosines of the projection.
///
/// `V = G2 / (4 (n·l) (n·v))
///    = 0.5 / (n·l √(alpha² + (1 - alpha²) (n·v)²) + n·v √(alpha² + (1 - alpha²) (n·l)²))`
/// Source: [Heitz14] eq. 99.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `n_dot_l`, `n_dot_v` | cosines of the directions and the normal; negative ones count as 0 | -1 ..= 1 | 1 |
/// | `alpha` | width | 0.02 ..= 1 | 1 |
///
/// Returns the visibility in 1/sr, in 0.25 ..= 5e5. It is finite where one direction grazes the surface, and
/// grows without limit where both do: the sum below the line is held at 1e-6, which is reached with both
/// cosines at 2.5e-5 for the smallest width.
#[kernel(
    family = "brdf",
    cite = "[Heitz14] eq. 99",
    domain(n_dot_l = -1.0..=1.0, n_dot_v = -1.0..=1.0, alpha = 0.02..=1.0),
    budget(3e-6 * result),
    measured
)]
pub fn smith_visibility(n_dot_l: f32, n_dot_v: f32, alpha: f32) -> f32 {
    let light = max(n_dot_l, 0.0);
    let view = max(n_dot_v, 0.0);
    let squared = alpha * alpha;
    let rest = (1.0 - alpha) * (1.0 + alpha);
    let by_view = light * sqrt(squared + rest * (view * view));
    let by_light = view * sqrt(squared + rest * (light * light));
    0.5 / max(by_view + by_light, 1e-6)
}
