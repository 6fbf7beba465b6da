//! The radiance that a pixel sends to the viewer.

use crate::rect::laplace::budget::{
    rect_laplace_ceiling, rect_laplace_difficulty, rect_laplace_fast_jump, rect_laplace_fast_jump_sg,
};
use crate::rect::laplace::frame::{
    Reflector, rect_laplace_bitangent, rect_laplace_receiver, rect_laplace_reflector,
};
use crate::rect::laplace::integral::{
    rect_laplace_fast_integral, rect_laplace_fast_integral_sg, rect_laplace_integral,
    rect_laplace_integral_sg,
};
use crate::rect::{GlossyReceiver, Rectangle};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Lobe;
use lobe_codegen::prelude::*;

/// Irradiance times both reflectances, the factor of the integrals.
#[kernel]
pub fn rect_laplace_scale(reflector: Reflector, receiver: GlossyReceiver) -> f32 {
    reflector.irradiance * reflector.reflectance * receiver.reflectance
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
/// | `receiver` | the pixel | position in -1e4 ..= 1e4, alpha 0.02 ..= 1, reflectance 0 ..= 10 | length, 1 |
///
/// Returns the radiance, at least 0; 0 where the light, the pixel, the viewer or the whole rectangle is behind a
/// surface. Within a factor of 1.06 of the integral in the mean; see [`laplace`](crate::rect::laplace) for where
/// it is not.
///
/// Numerics: the pixel's normal forms of the half vectors have no difference of near values; extents are inverse and
/// their denominator is of one sign; the edges are exact where the spot is clamped to them. f32 differs from f64
/// by 3e-7 in the median. The bound that the intervals give is 1e-4 of the
/// result in the median of what is lit, 5e-3 for nine in ten, and without limit where rounding errors of the first
/// evaluation reach the second through the Gauss-Newton step; the budget, 1e-3 of the result and 1e-5 of
/// [`rect_laplace_ceiling`], is exceeded by 2 in 1000 of the inputs, with f32 itself 0.3 of the budget off in 1 of 1000 of
/// the lit ones.
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(1e-3 * result + 1e-5 * rect_laplace_ceiling(rectangle, reflector, receiver) + 1e-30),
    not_robust = "the interval of the spot that the Gauss-Newton step finds grows with every quantity it is made of; see the numerics",
    measured
)]
pub fn rect_laplace(rectangle: Rectangle, reflector: Reflector, receiver: GlossyReceiver) -> f32 {
    let bitangent = rect_laplace_bitangent(rectangle);
    let reflector_in_frame = rect_laplace_reflector(rectangle, bitangent, reflector);
    let receiver_in_frame = rect_laplace_receiver(rectangle, bitangent, receiver);
    rect_laplace_scale(reflector, receiver)
        * rect_laplace_integral(reflector_in_frame, receiver_in_frame).value
}

/// Radiance that a pixel with a spherical Gaussian for its distribution reflects of a glossy rectangle.
///
/// Source: [Lobe], [`laplace`](crate::rect::laplace). Arguments, domain and result as of [`rect_laplace`]; the pixel's
/// distribution is `exp(2 (cos - 1)/alpha²)/(π alpha²)`.
///
/// Numerics: as of [`rect_laplace`]. `1 - cos` is written by the tangent, so that it does not cancel. As for [`rect_laplace`], 2 in 1000
/// of the inputs have a bound above the budget.
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(1e-3 * result + 1e-5 * rect_laplace_ceiling(rectangle, reflector, receiver) + 1e-30),
    not_robust = "the interval of the spot that the Gauss-Newton step finds grows with every quantity it is made of; see the numerics",
    measured
)]
pub fn rect_laplace_sg(rectangle: Rectangle, reflector: Reflector, receiver: GlossyReceiver) -> f32 {
    let bitangent = rect_laplace_bitangent(rectangle);
    let reflector_in_frame = rect_laplace_reflector(rectangle, bitangent, reflector);
    let receiver_in_frame = rect_laplace_receiver(rectangle, bitangent, receiver);
    rect_laplace_scale(reflector, receiver)
        * rect_laplace_integral_sg(reflector_in_frame, receiver_in_frame).value
}

/// Radiance that a GGX pixel reflects of a glossy rectangle, with one evaluation.
///
/// Source: [Lobe], [`laplace`](crate::rect::laplace), without the Gauss-Newton step and with one order of integration.
/// Arguments, domain and result as of [`rect_laplace`].
///
/// Within a factor of 1.10 of the integral in the mean, far less accurate for grazing light and for a peak off the rectangle.
///
/// Numerics: the result jumps by up to some percent where the order changes. The budget is, straight on, 1.2e-2 of the
/// result and 1.2e-4 of [`rect_laplace_ceiling`]; the bound itself is 5e-5 of the result in the median, 6e-4 for nine in ten
/// of what is lit.
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(
        rect_laplace_difficulty(rectangle, receiver)
            * (1e-3 * result + 1e-5 * rect_laplace_ceiling(rectangle, reflector, receiver))
            + 2.0 * rect_laplace_fast_jump(rectangle, reflector, receiver) * result
            + 1e-30
    ),
    measured
)]
pub fn rect_laplace_fast(rectangle: Rectangle, reflector: Reflector, receiver: GlossyReceiver) -> f32 {
    let bitangent = rect_laplace_bitangent(rectangle);
    let reflector_in_frame = rect_laplace_reflector(rectangle, bitangent, reflector);
    let receiver_in_frame = rect_laplace_receiver(rectangle, bitangent, receiver);
    rect_laplace_scale(reflector, receiver)
        * rect_laplace_fast_integral(reflector_in_frame, receiver_in_frame).value
}

/// Radiance that a pixel with a spherical Gaussian for its distribution reflects of a glossy rectangle, with one evaluation.
///
/// Source: [Lobe], [`laplace`](crate::rect::laplace). Arguments, domain and result as of [`rect_laplace_sg`].
///
/// Numerics: as of [`rect_laplace_fast`]. The bound is 1e-4 of the result in the median, 1e-3 for nine in ten of what is
/// lit.
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(
        rect_laplace_difficulty(rectangle, receiver)
            * (1e-3 * result + 1e-5 * rect_laplace_ceiling(rectangle, reflector, receiver))
            + 2.0 * rect_laplace_fast_jump_sg(rectangle, reflector, receiver) * result
            + 1e-30
    ),
    measured
)]
pub fn rect_laplace_fast_sg(rectangle: Rectangle, reflector: Reflector, receiver: GlossyReceiver) -> f32 {
    let bitangent = rect_laplace_bitangent(rectangle);
    let reflector_in_frame = rect_laplace_reflector(rectangle, bitangent, reflector);
    let receiver_in_frame = rect_laplace_receiver(rectangle, bitangent, receiver);
    rect_laplace_scale(reflector, receiver)
        * rect_laplace_fast_integral_sg(reflector_in_frame, receiver_in_frame).value
}
