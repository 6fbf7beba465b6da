//! The product integral of an anisotropic lobe and two isotropic ones.

use super::budget::asg_sg_sg_budget;
use super::cone::{LN_2, vsl_cone, vsl_window};
use crate::asg::{Asg, asg_convolved_at, asg_sg_peak};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Tokuyoshi15, Xu13};
use crate::sg::{Sg, sg_product};
use crate::special::expm1_over_x;
use lobe_codegen::prelude::*;

/// Integral over the sphere of the product of an anisotropic and two isotropic spherical Gaussians.
///
/// The isotropic ones make one lobe ([`sg_product`]), of which half the sharpness goes into
/// [`asg_sg_product_integral`].
/// Source: [Tokuyoshi15] section 3.1, eq. 3 ([Xu13] section 3).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `asg` | reflection lobe at the receiver | bandwidths 0.1 ..= 1e6 | 1 |
/// | `v` | the light's cone | sharpness 0 ..= 1e6 | 1 |
/// | `l` | the light's own lobe, about minus its mirror direction; sharpness 0 for diffuse | sharpness 0 ..= 1e6 | 1 |
///
/// Returns the integral in sr, at least 0.
///
/// Against the exact integrals of the oracle's table the median ratio is 1.0000, the quantiles of 5 and 95 % are 0.989
/// and 1.029; far out, where little is left, it may be off by any factor.
///
/// Numerics: the product's axis enters by its components in the anisotropic frame, each out of the differences
/// `v - z` and `l - z`: near the peak these are exact, while the axis itself carries an error that the root of
/// the bandwidth would multiply.
///
/// [`asg_sg_product_integral`]: crate::asg::asg_sg_product_integral
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] eq. 3",
    domain(asg.lambda = 0.1..=1e6, asg.mu = 0.1..=1e6),
    budget(asg_sg_sg_budget(asg, v, l) * asg_sg_peak(asg.lambda, asg.mu, 0.5 * sg_product(v, l).sharpness) + 1e-23),
    measured
)]
pub fn asg_sg_sg_product_integral(asg: Asg, v: Sg, l: Sg) -> f32 {
    let product = sg_product(v, l);
    let nu = 0.5 * product.sharpness;
    let components = product_components(asg, v, l);
    let value = asg_convolved_at(asg.lambda, asg.mu, nu, components, product.log_amplitude);
    asg.amplitude * (asg_sg_peak(asg.lambda, asg.mu, nu) * value)
}

/// The axis of the product of two lobes in the frame of an anisotropic one.
///
/// `((p·x), (p·y), (p·z))`, `p` the axis of [`sg_product`]. Source: the definition.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `asg` | whose frame | frames | 1 |
/// | `v`, `l` | the lobes | sharpness 0 ..= 1e6 | 1 |
///
/// Returns the components, in -1 ..= 1.
///
/// Numerics: `v·x` is `(v - z)·x`, likewise the others.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] eq. 3",
    budget(
        2e-6 + (1e-6 * (v.sharpness * length(v.axis - asg.z) + l.sharpness * length(l.axis - asg.z))
            + 1e-6 * max(max(v.sharpness, l.sharpness), 1e-30))
            / max(sg_product(v, l).sharpness, 1e-6 * max(max(v.sharpness, l.sharpness), 1e-30))
    ),
    measured
)]
pub fn product_components(asg: Asg, v: Sg, l: Sg) -> Vec3 {
    let largest = max(max(v.sharpness, l.sharpness), 1e-30);
    let rv = v.sharpness / largest;
    let rl = l.sharpness / largest;
    let sum = v.axis + l.axis;
    let gap = rv - rl;
    let norm = max(sqrt(gap * gap + rv * rl * dot(sum, sum)), 1e-6);
    let from_v = v.axis - asg.z;
    let from_l = l.axis - asg.z;
    Vec3::new(
        (rv * dot(from_v, asg.x) + rl * dot(from_l, asg.x)) / norm,
        (rv * dot(from_v, asg.y) + rl * dot(from_l, asg.y)) / norm,
        (rv * dot(v.axis, asg.z) + rl * dot(l.axis, asg.z)) / norm,
    )
}

/// Radiance reflected towards the viewer out of one pair of lobes, receiver's and light's.
///
/// `q ∫ Ǵ G_l G_V dw / (π r²)`, `q = 2 c_j c_l ⟨w_i, n_s⟩ ⟨-w_i, n_i⟩`.
/// Source: [Tokuyoshi15] eq. 2, 3.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `asg` | lobe of the receiver's BRDF, amplitude `c_j` | bandwidths 0.1 ..= 1e6 | 1/sr |
/// | `lobe` | of the light's BRDF times its flux, `c_l` in the log amplitude, about minus the mirror direction | sharpness 0 ..= 1e6 | power/sr |
/// | `dir` | unit direction to the light, `w_i` | sphere | 1 |
/// | `dist`, `radius` | of the light | 1e-3 ..= 1e4, 0 ..= 1e4 | length |
/// | `cosines` | `⟨w_i, n_s⟩ ⟨-w_i, n_i⟩` | 0 ..= 1 | 1 |
///
/// Returns the radiance, at least 0. Add up the four pairs of diffuse and specular lobes; a diffuse lobe of the
/// receiver is a constant: [`vsgl_pair_radiance_diffuse`].
///
/// Numerics: `2/(π r²)` is the cone's density over half its solid angle, so no division by `r²` is left; for a
/// vanishing radius it is the point light's `1/d²` times the values of the lobes.
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] eq. 2, 3",
    domain(
        asg.lambda = 0.1..=1e6, asg.mu = 0.1..=1e6,
        dir = unit, dist = 1e-3..=1e4, radius = 0.0..=1e4, cosines = 0.0..=1.0
    ),
    budget(
        asg_sg_sg_budget(asg, vsl_window(dir, dist, radius), lobe) * cosines * vsl_cone(dist, radius).density
            * vsl_window(dir, dist, radius).sharpness
            * asg_sg_peak(asg.lambda, asg.mu, 0.5 * sg_product(vsl_window(dir, dist, radius), lobe).sharpness) / 3.0
            + 1e-23
    ),
    measured
)]
pub fn vsgl_pair_radiance(asg: Asg, lobe: Sg, dir: Vec3, dist: f32, radius: f32, cosines: f32) -> f32 {
    let window = vsl_window(dir, dist, radius);
    let product = sg_product(Sg { log_amplitude: 0.0, ..window }, lobe);
    let nu = 0.5 * product.sharpness;
    // Over half the solid angle, 2π over the window's sharpness.
    let half = 0.5 * window.sharpness;
    let width = sqrt(half / max(asg.lambda + nu, 1e-10)) * sqrt(half / max(asg.mu + nu, 1e-10));
    let components = product_components(asg, window, lobe);
    let value = asg_convolved_at(asg.lambda, asg.mu, nu, components, product.log_amplitude);
    asg.amplitude * (cosines * vsl_cone(dist, radius).density) * (width * value)
}

/// Radiance reflected towards the viewer out of a lobe of the light, by a receiver whose lobe is constant.
///
/// `2 c_l ⟨w_i, n_s⟩ ⟨-w_i, n_i⟩ ∫ G_l G_V dw / (π r²)`, to be multiplied by the receiver's constant `c_0`.
/// Source: [Tokuyoshi15] eq. 2, 3, for a lobe of sharpness 0 at the receiver; the integral is exact.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `lobe` | of the light's BRDF times its flux, `c_l` in the log amplitude, about minus the mirror direction | sharpness 0 ..= 1e6 | power/sr |
/// | `dir` | unit direction to the light, `w_i` | sphere | 1 |
/// | `dist`, `radius` | of the light | 1e-3 ..= 1e4, 0 ..= 1e4 | length |
/// | `cosines` | `⟨w_i, n_s⟩ ⟨-w_i, n_i⟩` | 0 ..= 1 | 1 |
///
/// Returns the radiance over `c_0`, at least 0.
///
/// Numerics: as of [`vsgl_pair_radiance`].
#[kernel(
    family = "vsgl",
    cite = "[Tokuyoshi15] eq. 2, 3",
    domain(dir = unit, dist = 1e-3..=1e4, radius = 0.0..=1e4, cosines = 0.0..=1.0),
    budget(
        (3e-5 + 1.2e-5 * abs(sg_product(vsl_window(dir, dist, radius), lobe).log_amplitude - lobe.log_amplitude - LN_2) + 2e-6 * abs(lobe.log_amplitude)
            + 2e-5 * max(vsl_window(dir, dist, radius).sharpness, lobe.sharpness)
                / (1.0 + sg_product(vsl_window(dir, dist, radius), lobe).sharpness)) * result + 1e-23
    ),
    measured
)]
pub fn vsgl_pair_radiance_diffuse(lobe: Sg, dir: Vec3, dist: f32, radius: f32, cosines: f32) -> f32 {
    let window = vsl_window(dir, dist, radius);
    let product = sg_product(Sg { log_amplitude: 0.0, ..window }, lobe);
    // The product's integral over the window's, 2π over its sharpness.
    let mean = 2.0 * window.sharpness * expm1_over_x(-2.0 * product.sharpness);
    cosines * vsl_cone(dist, radius).density * (mean * exp(product.log_amplitude))
}
