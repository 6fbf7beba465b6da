//! A set of virtual point lights as one light.

use crate::filter::{Moments, moments_to_lobe, planar_variance};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Tokuyoshi15b;
use crate::sg::sg_integral;
use lobe_codegen::prelude::*;

/// A virtual spherical-Gaussian light: radiant intensity `intensity G(w; axis, sharpness)`, from positions with
/// an isotropic Gaussian distribution.
#[kernel]
pub struct Vsgl {
    /// Mean of the positions.
    #[domain(-1e4..=1e4)]
    pub mean: Vec3,
    /// Variance of the positions along one axis.
    #[domain(0.0..=1e4)]
    pub variance: f32,
    /// Unit axis of the emission.
    #[domain(unit)]
    pub axis: Vec3,
    /// Sharpness of the emission.
    #[domain(0.0..=1e6)]
    pub sharpness: f32,
    /// Radiant intensity along the axis.
    #[domain(0.0..=1e6)]
    pub intensity: f32,
}

/// Radiant intensity along the axis of a light of a given power.
///
/// `c = W/A(k)`, `A` = [`sg_integral`]
/// Source: [Tokuyoshi15b] section 2.1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `weight` | sum of power times reflectance, `W` | 0 ..= 1e6 | power |
/// | `sharpness` | `k` | 0 ..= 1e6 | 1 |
///
/// Returns the intensity in power/sr, at least 0.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15b] section 2.1",
    domain(weight = 0.0..=1e6, sharpness = 0.0..=1e6),
    budget(3e-6 * result + 1e-32),
    measured
)]
pub fn vsgl_intensity(weight: f32, sharpness: f32) -> f32 {
    weight / max(sg_integral(sharpness), 1e-30)
}

/// The light that stands for virtual point lights, by their moments.
///
/// Source: [Tokuyoshi15b] section 2, with half the trace for the variance ([`planar_variance`]).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `positions`, `origin` | moments of the positions, and their origin | within 1e4 | length |
/// | `lobes`, `reference` | moments of the emission lobes, and their reference | spread 1e-7 ..= 1 | 1 |
///
/// Returns the light. One each for diffuse and specular reflection; a diffuse lobe counts as a sharpness of 2
/// about the normal, which has the mean direction of the clamped cosine.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15b] section 2",
    domain(
        origin = -1e4..=1e4, reference = -1.0..=1.0,
        lobes.mean = -1.0..=1.0, lobes.spread = 1e-7..=1.0
    ),
    budget(
        mean = 2e-7 * length(origin + positions.mean) + 1e-37,
        variance = 1e-37,
        axis = 1e-6 + 1e-6 / max(length(reference + lobes.mean), 1e-6),
        sharpness = 1.6e-6 * (result.sharpness + 1.0 / max(lobes.spread, 1e-12)),
        intensity = 5e-6 * result.intensity + 1e-6 * lobes.weight / lobes.spread + 1e-32
    ),
    measured
)]
pub fn vsgl_from_moments(positions: Moments, origin: Vec3, lobes: Moments, reference: Vec3) -> Vsgl {
    let lobe = moments_to_lobe(lobes, reference);
    Vsgl {
        mean: origin + positions.mean,
        variance: planar_variance(positions.spread),
        axis: lobe.axis,
        sharpness: lobe.sharpness,
        intensity: vsgl_intensity(lobes.weight, lobe.sharpness),
    }
}

/// The light that stands for virtual point lights, as printed.
///
/// The variance is the trace of the covariance. Source: [Tokuyoshi15b] section 2.2. Arguments and domain as of
/// [`vsgl_from_moments`].
///
/// Returns a light that is too large, by √2 in radius, and so too dark from near: of disks of VPLs with radius
/// 0.1, 0.3 and 1 times the distance it gives 0.968, 0.930 and 0.731 of their light.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15b] section 2.2",
    domain(
        origin = -1e4..=1e4, reference = -1.0..=1.0,
        lobes.mean = -1.0..=1.0, lobes.spread = 1e-7..=1.0
    ),
    budget(
        mean = 2e-7 * length(origin + positions.mean) + 1e-37,
        variance = 1e-37,
        axis = 1e-6 + 1e-6 / max(length(reference + lobes.mean), 1e-6),
        sharpness = 1.6e-6 * (result.sharpness + 1.0 / max(lobes.spread, 1e-12)),
        intensity = 5e-6 * result.intensity + 1e-6 * lobes.weight / lobes.spread + 1e-32
    ),
    variant_of = vsgl_from_moments,
    measured
)]
pub fn vsgl_from_moments_paper(positions: Moments, origin: Vec3, lobes: Moments, reference: Vec3) -> Vsgl {
    Vsgl { variance: positions.spread, ..vsgl_from_moments(positions, origin, lobes, reference) }
}
