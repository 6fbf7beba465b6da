//! Lights out of a reflective shadow map: their density, mip level and radius.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{KrivanekColbert08, Ritschel11, Tokuyoshi15};
use lobe_codegen::prelude::*;

/// Radius of the spherical light that stands for filtered positions.
///
/// `r² = 2σ²`, `σ²` the trace of the covariance: right for a uniform disk.
/// Source: [Tokuyoshi15] section 3.2.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `trace` | `σ²`, spread of the positions' moments | 0 ..= 1e8 | length² |
///
/// Returns the radius, at least 0. Here the trace itself is meant, unlike in the two-light method
/// ([`planar_variance`]).
///
/// Numerics: the source stores `|x|²` and subtracts, which leaves nothing for positions that are closer together
/// than 1e-3 of their distance from the origin; take [`Moments`].
///
/// [`planar_variance`]: crate::filter::planar_variance
/// [`Moments`]: crate::filter::Moments
#[kernel(family = "vsgl", cite = "[Tokuyoshi15] section 3.2", domain(trace = 0.0..=1e8), budget(2e-6 * result + 1e-18), measured)]
pub fn vsl_radius(trace: f32) -> f32 {
    sqrt(2.0 * max(trace, 0.0))
}

/// Mip level at which a reflective shadow map is sampled.
///
/// `h = h_max - ½ log2(N p/k)`, in 0 ..= `h_max`
/// Source: [Tokuyoshi15] section 3.2 ([KrivanekColbert08]).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `h_max` | the last level, log2 of the resolution | 0 ..= 14 | 1 |
/// | `count` | number of lights, `N` | 1 ..= 65536 | 1 |
/// | `smoothing` | `k`, 4 in the source | 0.1 ..= 100 | 1 |
/// | `pdf` | `p` of the texel, of mean 1 over the map ([`brsm_pdf`]) | 0 ..= 1e6 | 1 |
///
/// Returns the level; `h_max` where the density is 0.
///
/// The source writes the density as one of directions; the formula is consistent only for one that has mean 1
/// over the texels (`p = 1`, `N = 4^h_max`, `k = 1` give level 0): [`brsm_texel_pdf`].
///
/// Numerics: languages allow the logarithm an absolute error of 2^-21 near 1.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3.2",
    domain(h_max = 0.0..=14.0, count = 1.0..=65536.0, smoothing = 0.1..=100.0, pdf = 0.0..=1e6),
    budget(1e-6 + 1e-6 * h_max),
    measured
)]
pub fn vsl_mip_level(h_max: f32, count: f32, smoothing: f32, pdf: f32) -> f32 {
    let samples = max(count * (pdf / smoothing), 1e-20);
    clamp(h_max - 0.5 * log2(samples), 0.0, h_max)
}

/// Density of a texel of a bidirectional reflective shadow map.
///
/// `p = (1 - ε) e/ē + ε`, mean 1 over the map
/// Source: our own; [Tokuyoshi15] section 3 and [Ritschel11] leave the details open.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `estimate` | `e`, luminance that the texel's light gives a subset of the view, without shadows | 0 ..= 1e6 | any |
/// | `average` | `ē`, mean of the estimates over the map | 1e-6 ..= 1e6 | as `estimate` |
/// | `floor_share` | `ε`, share of uniform sampling | 0.001 ..= 1 | 1 |
///
/// Returns the density, at least `ε`, so that no light that the estimates miss has weight infinite; 0.05 is a
/// good share.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3",
    domain(estimate = 0.0..=1e6, average = 1e-6..=1e6, floor_share = 1e-3..=1.0),
    budget(1e-6 * result),
    measured
)]
pub fn brsm_pdf(estimate: f32, average: f32, floor_share: f32) -> f32 {
    (1.0 - floor_share) * (estimate / max(average, 1e-30)) + floor_share
}

/// Density of a texel that has a density of directions.
///
/// `p = p_w Δw T`
/// Source: the definition; [Tokuyoshi15] section 3.2 writes `p(w')`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `directional` | density of directions from the light, `p_w` | 0 ..= 1e6 | 1/sr |
/// | `solid_angle` | of the texel, `Δw` | 1e-9 ..= 1 | sr |
/// | `texels` | how many the map has, `T` | 1 ..= 1e8 | 1 |
///
/// Returns the density of mean 1 over the map.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3.2",
    domain(directional = 0.0..=1e6, solid_angle = 1e-9..=1.0, texels = 1.0..=1e8),
    budget(3e-7 * result + 1e-28),
    measured
)]
pub fn brsm_texel_pdf(directional: f32, solid_angle: f32, texels: f32) -> f32 {
    directional * (solid_angle * texels)
}

/// Weight of a light that was chosen by its density.
///
/// `1/(N p)`
/// Source: importance sampling; [Tokuyoshi15] section 3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `pdf` | `p` ([`brsm_pdf`]) | 1e-3 ..= 1e6 | 1 |
/// | `count` | number of lights chosen, `N` | 1 ..= 65536 | 1 |
///
/// Returns the weight of the light in the sum over the chosen ones, whose expectation is the mean over the map.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3",
    domain(pdf = 1e-3..=1e6, count = 1.0..=65536.0),
    budget(6e-7 * result),
    measured
)]
pub fn brsm_weight(pdf: f32, count: f32) -> f32 {
    1.0 / max(count * pdf, 1e-30)
}
