//! The radiance that a pixel sends to the viewer.

use crate::rect::laplace::budget::{
    rect_laplace_ceiling, rect_laplace_difficulty, rect_laplace_fast_jump, rect_laplace_fast_jump_sg,
    rect_laplace_hardness, rect_laplace_hardness_sg, rect_laplace_threshold,
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
/// their denominator is of one sign; the edges are exact where the spot is clamped to them; how far a spot is below the
/// horizon is measured at the spot, not as a difference of two heights of the corner. f32 differs from f64 by 3e-7 in
/// the median. The derived bound is 1.8e-5 of the result in the median of what is lit, 3e-4 for 99 in 100. The budget is
/// 1e-4 of the result and 1e-6 of [`rect_laplace_ceiling`], times [`rect_laplace_hardness`]: 5 for a round lobe seen
/// straight on, more for grazing pixels, for rectangles small in the distance, and for a long thin lobe that lies
/// askew. 1 in 20 000 inputs has no bound: degenerate ones, such as a pixel that faces away and catches a grazing rest.
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(
        rect_laplace_hardness(rectangle, reflector, receiver)
            * (1e-4 * result + 1e-6 * rect_laplace_ceiling(rectangle, reflector, receiver))
            + 2.0 * rect_laplace_threshold(rectangle, reflector, receiver) * result
            + 1e-30
    ),
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
/// Numerics: as of [`rect_laplace`]. `1 - cos` is written by the tangent, so that it does not cancel.
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(
        rect_laplace_hardness_sg(rectangle, reflector, receiver)
            * (1e-4 * result + 1e-6 * rect_laplace_ceiling(rectangle, reflector, receiver))
            + 2.0 * rect_laplace_threshold(rectangle, reflector, receiver) * result
            + 1e-30
    ),
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
/// Numerics: the result jumps by up to some percent where the order changes. The budget is 1e-4 of the result and 1e-6
/// of [`rect_laplace_ceiling`], times [`rect_laplace_difficulty`], 4 straight on; the bound itself is 1.7e-5 of the
/// result in the median of what is lit, 3e-5 for nine in ten.
#[kernel(
    family = "rect",
    cite = "[Lobe] rect::laplace",
    budget(
        rect_laplace_difficulty(rectangle, receiver)
            * (1e-4 * result + 1e-6 * rect_laplace_ceiling(rectangle, reflector, receiver))
            + 2.0
                * max(
                    rect_laplace_fast_jump(rectangle, reflector, receiver),
                    rect_laplace_threshold(rectangle, reflector, receiver)
                )
                * result
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
            * (1e-4 * result + 1e-6 * rect_laplace_ceiling(rectangle, reflector, receiver))
            + 2.0
                * max(
                    rect_laplace_fast_jump_sg(rectangle, reflector, receiver),
                    rect_laplace_threshold(rectangle, reflector, receiver)
                )
                * result
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
