//! Lobes that stand for a distribution of normals, over half vectors and over directions.

use super::sampling::orthonormal_frame;
use crate::asg::Asg;
use crate::constants::INVERSE_PI;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{RectGlossy, Tokuyoshi15b, Wang09, Xu13};
use crate::sg::Sg;
use lobe_codegen::prelude::*;

/// ln π.
#[kernel]
pub const LOG_PI: f32 = 1.1447298858494001741;

/// The spherical Gaussian that stands for a GGX or Beckmann distribution of normals.
///
/// About the normal, sharpness `2/alpha²`, amplitude `1/(π alpha²)`.
/// Source: [RectGlossy] eq. 6, [Wang09] section 3.2.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal` | unit normal | sphere | 1 |
/// | `alpha` | width | 1e-3 ..= 1 | 1 |
///
/// Returns the lobe over half vectors, 1/sr.
///
/// Its integral is `1 - exp(-4/alpha²)`, so near 1. A distribution of normals has that of `D (n·h)` instead,
/// which here is 0.995 at a width of 0.1, 0.955 at 0.3, 0.875 at 0.5 and 0.57 at 1. It has the peak of GGX, is up
/// to 45 % fatter at one width from it and has no tail: 1 % of GGX at three widths. Not for widths above 0.6.
#[kernel(
    family = "brdf",
    cite = "[RectGlossy] eq. 6",
    domain(normal = unit, alpha = 1e-3..=1.0),
    budget(axis = 0.0, sharpness = 1e-6 * result.sharpness, log_amplitude = 1e-6 * abs(result.log_amplitude) + 2e-6),
    measured
)]
pub fn sg_ndf(normal: Vec3, alpha: f32) -> Sg {
    Sg { axis: normal, sharpness: 2.0 / (alpha * alpha), log_amplitude: -2.0 * log(alpha) - LOG_PI }
}

/// The anisotropic spherical Gaussian that stands for an anisotropic distribution of normals.
///
/// About the normal, bandwidths `1/alpha_x²` and `1/alpha_y²`, amplitude `1/(π alpha_x alpha_y)`.
/// Source: [Xu13] section 4; its isotropic case is [`sg_ndf`] near the peak.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal`, `tangent` | unit normal, unit tangent | perpendicular | 1 |
/// | `alpha_x`, `alpha_y` | widths along the tangent and across | 0.02 ..= 1 | 1 |
///
/// Returns the lobe over half vectors, 1/sr.
#[kernel(
    family = "brdf",
    cite = "[Xu13] section 4",
    domain(normal = unit, tangent = normal_to(normal), alpha_x = 0.02..=1.0, alpha_y = 0.02..=1.0),
    budget(
        z = 0.0, x = 0.0, y = 4e-7,
        lambda = 1e-6 * result.lambda, mu = 1e-6 * result.mu, amplitude = 1e-6 * result.amplitude
    ),
    measured
)]
pub fn asg_ndf(normal: Vec3, tangent: Vec3, alpha_x: f32, alpha_y: f32) -> Asg {
    Asg {
        z: normal,
        x: tangent,
        y: cross(normal, tangent),
        lambda: 1.0 / (alpha_x * alpha_x),
        mu: 1.0 / (alpha_y * alpha_y),
        amplitude: INVERSE_PI / (alpha_x * alpha_y),
    }
}

/// Cosine of the view and the normal for the warps: without sign, at least 1e-5.
///
/// Source: our own; the warped lobes' sharpness would be infinite at grazing incidence.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal`, `view` | unit vectors | sphere | 1 |
///
/// Returns the cosine, in 1e-5 ..= 1.
#[kernel(family = "brdf", cite = "[RectGlossy] eq. 8", domain(normal = unit, view = unit), budget(4e-7), measured)]
pub fn warp_cosine(normal: Vec3, view: Vec3) -> f32 {
    max(abs(dot(normal, view)), 1e-5)
}

/// The spherical Gaussian of the distribution of normals, over the directions that are reflected to a viewer.
///
/// About the mirrored view `2 (o·n) n - o`, sharpness `1/(2 |o·n| alpha²)`, amplitude `1/(π alpha²)`.
/// Source: [RectGlossy] eq. 8, [Tokuyoshi15b] section 1.1, after [Wang09] section 4.1. Its `h` is the
/// distribution's axis, here the normal.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal`, `view` | unit vectors `n`, `o` | sphere | 1 |
/// | `alpha` | width | 1e-3 ..= 1 | 1 |
///
/// Returns the lobe over directions of incidence, 1/sr.
///
/// The cosine is held at 1e-5, since the sharpness is infinite at grazing incidence. The lobe has the energy of the
/// distribution but not its shape, which is stretched in the plane of incidence: the difference is 0.1 % at
/// normal incidence, 9 % at 30°, 43 % at 60°, 80 % at 75° for a width of 0.05; [`asg_ndf_warp`] has the stretch.
///
/// Numerics: the cosine's own error, 2e-7, enters relatively, so the sharpness at grazing incidence is as good as
/// the cosine is.
#[kernel(
    family = "brdf",
    cite = "[RectGlossy] eq. 8",
    domain(normal = unit, view = unit, alpha = 1e-3..=1.0),
    budget(
        axis = 1.5e-6,
        sharpness = (2e-6 + 4e-7 / warp_cosine(normal, view)) * result.sharpness,
        log_amplitude = 1e-6 * abs(result.log_amplitude) + 2e-6
    ),
    measured
)]
pub fn sg_ndf_warp(normal: Vec3, view: Vec3, alpha: f32) -> Sg {
    Sg {
        axis: 2.0 * dot(normal, view) * normal - view,
        sharpness: 0.5 / (alpha * alpha * warp_cosine(normal, view)),
        log_amplitude: -2.0 * log(alpha) - LOG_PI,
    }
}

/// Unit vector across the plane of incidence; any tangent for a view along the normal.
///
/// `n x o / |n x o|`
/// Source: our own, for [`asg_ndf_warp`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal`, `view` | unit vectors `n`, `o` | sphere | 1 |
///
/// Returns a unit vector perpendicular to both. Where they are closer than 1e-10 it is the tangent of
/// [`orthonormal_frame`].
///
/// Numerics: the product is that with the chord `o - n`, or `o + n` for a view from below, which are exact where
/// the vectors nearly agree.
#[kernel(
    family = "brdf",
    cite = "[Xu13] section 4",
    domain(normal = unit, view = unit),
    budget(2e-6),
    measured
)]
pub fn incidence_tangent(normal: Vec3, view: Vec3) -> Vec3 {
    let near = cross(normal, view - normal);
    let far = cross(normal, view + normal);
    let across = select(far, near, dot(normal, view) >= 0.0);
    let squared = dot(across, across);
    let fallback = orthonormal_frame(normal).x;
    select(fallback, across * inverse_sqrt(max(squared, 1e-20)), squared > 1e-20)
}

/// The anisotropic spherical Gaussian of the distribution of normals, over the directions that are reflected to a
/// viewer.
///
/// `z = 2 (o·n) n - o`, `x` across the plane of incidence, `y = z x x`; bandwidths `1/(4 alpha² (o·n)²)` and
/// `1/(4 alpha²)`, amplitude `1/(π alpha²)`.
/// Source: [Tokuyoshi15b] section 3.2 uses it and does not state it; this is [Xu13] section 4 for an isotropic
/// distribution.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal`, `view` | unit vectors `n`, `o` | sphere | 1 |
/// | `alpha` | width | 1e-3 ..= 1 | 1 |
///
/// Returns the lobe over directions of incidence, 1/sr; any `x` for a view along the normal, where both bandwidths
/// are equal.
///
/// The cosine is held at 1e-5. The difference to the reflected distribution is 0.3 % at normal incidence,
/// 0.5 % at 30°, 3.7 % at 60°, 10 % at 75° for a width of 0.05; 7, 7, 17 and 34 % for 0.3. From a width of 0.6 on
/// it loses 30 % of the energy, and [`sg_ndf_warp`] is better.
#[kernel(
    family = "brdf",
    cite = "[Tokuyoshi15b] section 3.2",
    domain(normal = unit, view = unit, alpha = 1e-3..=1.0),
    budget(
        z = 1.5e-6,
        x = 2e-6,
        y = 5e-6,
        lambda = (3e-6 + 8e-7 / warp_cosine(normal, view) + 2e-13 / (warp_cosine(normal, view) * warp_cosine(normal, view))) * result.lambda,
        mu = 1e-6 * result.mu,
        amplitude = 1e-6 * result.amplitude
    ),
    measured
)]
pub fn asg_ndf_warp(normal: Vec3, view: Vec3, alpha: f32) -> Asg {
    let mirrored = 2.0 * dot(normal, view) * normal - view;
    let across = incidence_tangent(normal, view);
    let slope = alpha * warp_cosine(normal, view);
    Asg {
        z: mirrored,
        x: across,
        y: cross(mirrored, across),
        lambda: 0.25 / (slope * slope),
        mu: 0.25 / (alpha * alpha),
        amplitude: INVERSE_PI / (alpha * alpha),
    }
}
