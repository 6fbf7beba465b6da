//! Point lights, spherical lights, and when a lobe is smooth enough for its value in one direction.

use super::cone::vsl_cone;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Hasan09, Keller97, Tokuyoshi15};
use lobe_codegen::prelude::*;

/// What a virtual point light sends to the viewer, before the distance is taken into account.
///
/// `ρ = Φ f(x_s) f(x_i) ⟨w, n_s⟩ ⟨-w, n_i⟩`
/// Source: [Tokuyoshi15] section 2 ([Keller97]).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `flux` | of the light, `Φ` | 0 ..= 1e6 | power |
/// | `receiver`, `emitter` | BRDF at the shading point and at the light | 0 ..= 1e6 | 1/sr |
/// | `cos_receiver`, `cos_emitter` | cosines of `w` to `n_s` and of `-w` to `n_i` | -1 ..= 1 | 1 |
///
/// Returns the product, at least 0; 0 from behind.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] eq. 1",
    domain(
        flux = 0.0..=1e6, receiver = 0.0..=1e6, emitter = 0.0..=1e6,
        cos_receiver = -1.0..=1.0, cos_emitter = -1.0..=1.0
    ),
    budget(6e-7 * result + 1e-18),
    measured
)]
pub fn vpl_transfer(flux: f32, receiver: f32, emitter: f32, cos_receiver: f32, cos_emitter: f32) -> f32 {
    flux * receiver * emitter * (max(cos_receiver, 0.0) * max(cos_emitter, 0.0))
}

/// Radiance reflected towards the viewer out of a virtual point light.
///
/// `L = ρ/d²`
/// Source: [Tokuyoshi15] eq. 1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `transfer` | `ρ` ([`vpl_transfer`]) | 0 ..= 1e6 | power/sr² |
/// | `dist` | `d` | 1e-3 ..= 1e4 | length |
///
/// Returns the radiance; without limit for a vanishing distance. A distance below 1e-15 counts as that.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] eq. 1",
    domain(transfer = 0.0..=1e6, dist = 1e-3..=1e4),
    budget(1e-6 * result + 1e-37 / (dist * dist) + 1e-37),
    measured
)]
pub fn vpl_radiance(transfer: f32, dist: f32) -> f32 {
    let d = max(dist, 1e-15);
    transfer / (d * d)
}

/// Radiance reflected towards the viewer out of a virtual spherical light, where the lobes are smooth.
///
/// `∫ ρ V dw/(π r²) ≈ ρ(w_i) |Ω|/(π r²)`
/// Source: [Tokuyoshi15] section 3.3 (of eq. 2, [Hasan09]).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `transfer` | `ρ` towards the centre ([`vpl_transfer`]) | 0 ..= 1e6 | power/sr² |
/// | `dist` | `d` | 0 ..= 1e4 | length |
/// | `radius` | `r` | 0 ..= 1e4 | length |
///
/// Returns the radiance. Of the point light's it is 1.0000 at `r/d` = 1e-3, 0.9926 at 0.1, 0.845 at 0.5 and 0.586
/// at 1; so it converges to [`vpl_radiance`], and it has a limit at the centre, `2ρ/r²`.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3.3",
    domain(transfer = 0.0..=1e6, dist = 0.0..=1e4, radius = 0.0..=1e4),
    budget(4e-6 * result + 1e-13),
    measured
)]
pub fn vsl_radiance(transfer: f32, dist: f32, radius: f32) -> f32 {
    transfer * vsl_cone(dist, radius).density
}

/// Upper bound of the sharpness of `ρ`, receiver's lobe times light's.
///
/// `2 max(lambda, mu) + k`
/// Source: [Tokuyoshi15] section 3.3, which says that it can be computed and not how; our own: an anisotropic
/// lobe falls along one axis as an isotropic one of twice its bandwidth, and sharpnesses add up at most.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `lambda`, `mu` | bandwidths of the receiver's lobe | 0 ..= 1e6 | 1 |
/// | `sharpness` | of the light's lobe, `k` | 0 ..= 1e6 | 1 |
///
/// Returns the sharpness. Of several pairs of lobes, take the largest.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3.3",
    domain(lambda = 0.0..=1e6, mu = 0.0..=1e6, sharpness = 0.0..=1e6),
    budget(2e-7 * result + 1e-37),
    measured
)]
pub fn vsgl_transfer_sharpness(lambda: f32, mu: f32, sharpness: f32) -> f32 {
    2.0 * max(lambda, mu) + sharpness
}

/// How sharp `ρ` is against the light's cone.
///
/// `η |Ω|/(4π)`
/// Source: [Tokuyoshi15] section 3.3: it takes `ρ` for smooth where this is below a threshold of 1e-3 or so.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `sharpness` | `η` ([`vsgl_transfer_sharpness`]) | 0 ..= 4e6 | 1 |
/// | `dist`, `radius` | of the light | 0 ..= 1e4 | length |
///
/// Returns the ratio, at least 0; 0 for a point light. [`vsgl_reduce_bias`] decides by it.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3.3",
    domain(sharpness = 0.0..=4e6, dist = 0.0..=1e4, radius = 0.0..=1e4),
    budget(5e-6 * result + 1e-12),
    measured
)]
pub fn vsgl_smoothness(sharpness: f32, dist: f32, radius: f32) -> f32 {
    sharpness * (vsl_cone(dist, radius).solid_angle / 12.566370614359172954)
}

/// The radiance out of the BRDFs themselves where they are smooth over the light's cone, otherwise out of their
/// lobes.
///
/// Source: [Tokuyoshi15] section 3.3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `smoothness` | [`vsgl_smoothness`] | 0 ..= 1e6 | 1 |
/// | `threshold` | `α` of the source | 1e-6 ..= 1 | 1 |
/// | `pulled_out` | the radiance where it is below: [`vsl_radiance`] | 0 ..= 1e6 | radiance |
/// | `lobes` | the radiance otherwise: sum of the pairs of lobes | 0 ..= 1e6 | radiance |
///
/// Returns one of the two. With more and smaller lights the cones shrink, the lobes count less, and the result
/// converges to that of point lights.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] section 3.3",
    domain(smoothness = 0.0..=1e6, threshold = 1e-6..=1.0, pulled_out = 0.0..=1e6, lobes = 0.0..=1e6),
    budget(1e-37),
    measured
)]
pub fn vsgl_reduce_bias(smoothness: f32, threshold: f32, pulled_out: f32, lobes: f32) -> f32 {
    select(lobes, pulled_out, smoothness < threshold)
}
