//! The radiance that a pixel sends to the viewer.

use crate::rect::Rectangle;
use crate::rect::laplace::frame::{
    Receiver, Reflector, rect_laplace_bitangent, rect_laplace_receiver, rect_laplace_reflector,
};
use crate::rect::laplace::integral::{
    rect_laplace_fast_integral, rect_laplace_fast_integral_sg, rect_laplace_integral,
    rect_laplace_integral_sg,
};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Lobe;
use lobe_codegen::prelude::*;

/// π², of the peaks of two distributions.
#[kernel]
pub const PI_SQUARE: f32 = 9.8696044010893586188;

/// Irradiance times both reflectances, the factor of the integrals.
#[kernel]
pub fn rect_laplace_scale(reflector: Reflector, receiver: Receiver) -> f32 {
    reflector.irradiance * reflector.reflectance * receiver.reflectance
}

/// What the radiance is measured against: both distributions at their peaks over the rectangle's solid angle, as it
/// would be seen straight on from the distance of its middle, 2π at most.
#[kernel]
pub fn rect_laplace_ceiling(rectangle: Rectangle, reflector: Reflector, receiver: Receiver) -> f32 {
    let way = receiver.position - rectangle.position;
    let solid_angle = min(4.0 * rectangle.half_x * rectangle.half_y / max(dot(way, way), 1e-9), 6.2831853);
    let roughness = reflector.alpha * receiver.alpha;
    rect_laplace_scale(reflector, receiver) * solid_angle / (PI_SQUARE * (roughness * roughness))
}

/// Radiance that a GGX pixel reflects of a glossy rectangle under one directional light.
///
/// `L = E M_r M_x cos_i ∫ D_r(h_r) D_x(h_x) (n_x·w)+ cos_y / d² dA(y)`, approximated by the integrand at its largest spot
/// times an effective area.
/// Source: [Lobe], [`laplace`](crate::rect::laplace).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the reflecting rectangle | middle in -100 ..= 100, half extents 1e-3 ..= 100 | length |
/// | `reflector` | its material and the light | alpha 0.02 ..= 1, reflectance 0 ..= 10 | 1, irradiance |
/// | `receiver` | the pixel | position in -100 ..= 100, alpha 0.02 ..= 1, reflectance 0 ..= 10 | length, 1 |
///
/// Returns the radiance, at least 0; 0 where the light, the pixel, the viewer or the whole rectangle is behind a
/// surface. Within a factor of 1.06 of the integral in the mean; see [`laplace`](crate::rect::laplace) for where
/// it is not.
///
/// Numerics: the pixel's normal forms of the half vectors have no difference of near values; extents are inverse and
/// their denominator is of one sign; the edges are exact where the spot is clamped to them. f32 differs from f64
/// by 3e-7 in the median. NUM1
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(1e-3 * result + 1e-5 * rect_laplace_ceiling(rectangle, reflector, receiver) + 1e-30),
    not_robust = "the interval of the spot that the Gauss-Newton step finds grows with every quantity it is made of; see the numerics",
    measured
)]
pub fn rect_laplace(rectangle: Rectangle, reflector: Reflector, receiver: Receiver) -> f32 {
    let bitangent = rect_laplace_bitangent(rectangle);
    let ours = rect_laplace_reflector(rectangle, bitangent, reflector);
    let theirs = rect_laplace_receiver(rectangle, bitangent, receiver);
    rect_laplace_scale(reflector, receiver) * rect_laplace_integral(ours, theirs).value
}

/// Radiance that a pixel with a spherical Gaussian for its distribution reflects of a glossy rectangle.
///
/// Source: [Lobe], [`laplace`](crate::rect::laplace). Arguments, domain and result as of [`rect_laplace`]; the pixel's
/// distribution is `exp(2 (cos - 1)/alpha²)/(π alpha²)`.
///
/// Numerics: as of [`rect_laplace`]. `1 - cos` is written by the tangent, so that it does not cancel. NUM2
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(1e-3 * result + 1e-5 * rect_laplace_ceiling(rectangle, reflector, receiver) + 1e-30),
    not_robust = "the interval of the spot that the Gauss-Newton step finds grows with every quantity it is made of; see the numerics",
    measured
)]
pub fn rect_laplace_sg(rectangle: Rectangle, reflector: Reflector, receiver: Receiver) -> f32 {
    let bitangent = rect_laplace_bitangent(rectangle);
    let ours = rect_laplace_reflector(rectangle, bitangent, reflector);
    let theirs = rect_laplace_receiver(rectangle, bitangent, receiver);
    rect_laplace_scale(reflector, receiver) * rect_laplace_integral_sg(ours, theirs).value
}

/// Radiance that a GGX pixel reflects of a glossy rectangle, with one evaluation.
///
/// Source: [Lobe], [`laplace`](crate::rect::laplace), without the Gauss-Newton step and with one order of integration.
/// Arguments, domain and result as of [`rect_laplace`].
///
/// Within a factor of 1.09 of the integral in the mean, far less accurate for grazing light and for a peak off the rectangle.
///
/// Numerics: the result jumps by up to some percent where the order changes. NUM3
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(1e-3 * result + 1e-5 * rect_laplace_ceiling(rectangle, reflector, receiver) + 1e-30),
    not_robust = "the value jumps where the order of integration changes, and at pixels near the rectangle's plane the intervals grow; see the numerics",
    measured
)]
pub fn rect_laplace_fast(rectangle: Rectangle, reflector: Reflector, receiver: Receiver) -> f32 {
    let bitangent = rect_laplace_bitangent(rectangle);
    let ours = rect_laplace_reflector(rectangle, bitangent, reflector);
    let theirs = rect_laplace_receiver(rectangle, bitangent, receiver);
    rect_laplace_scale(reflector, receiver) * rect_laplace_fast_integral(ours, theirs).value
}

/// Radiance that a pixel with a spherical Gaussian for its distribution reflects of a glossy rectangle, with one evaluation.
///
/// Source: [Lobe], [`laplace`](crate::rect::laplace). Arguments, domain and result as of [`rect_laplace_sg`].
///
/// Numerics: as of [`rect_laplace_fast`]. NUM4
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(1e-3 * result + 1e-5 * rect_laplace_ceiling(rectangle, reflector, receiver) + 1e-30),
    not_robust = "the value jumps where the order of integration changes, and at pixels near the rectangle's plane the intervals grow; see the numerics",
    measured
)]
pub fn rect_laplace_fast_sg(rectangle: Rectangle, reflector: Reflector, receiver: Receiver) -> f32 {
    let bitangent = rect_laplace_bitangent(rectangle);
    let ours = rect_laplace_reflector(rectangle, bitangent, reflector);
    let theirs = rect_laplace_receiver(rectangle, bitangent, receiver);
    rect_laplace_scale(reflector, receiver) * rect_laplace_fast_integral_sg(ours, theirs).value
}
