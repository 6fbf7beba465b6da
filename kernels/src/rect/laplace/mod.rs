//! Laplace.

mod evaluate;
mod frame;
mod width;

pub use evaluate::*;
pub use frame::*;
pub use width::*;

use crate::rect::Rectangle;
use lobe_codegen::prelude::*;

/// Integral and representative direction.
#[kernel]
pub struct LaplaceIntegral {
    /// Integral.
    pub value: f32,
    /// Representative direction, in the rectangle's frame.
    pub dir: Vec3,
}

/// Whether nothing can arrive.
#[kernel]
pub fn rect_laplace_is_dark(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> bool {
    let highest = receiver.facing.x * (receiver.corner.x - receiver.offset.x)
        + receiver.facing.y * (receiver.corner.y - receiver.offset.y)
        - receiver.facing.z * receiver.offset.z;
    reflector.light.z <= 1e-3
        || receiver.cosine <= 1e-3
        || receiver.offset.z <= 1e-6 * max(receiver.extent.x, receiver.extent.y)
        || highest <= 0.0
}

/// GGX receiver.
#[kernel]
pub fn rect_laplace_integral(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> LaplaceIntegral {
    if rect_laplace_is_dark(reflector, receiver) {
        return LaplaceIntegral { value: 0.0, dir: Vec3::new(0.0, 0.0, -1.0) };
    }
    let start = rect_laplace_lift(receiver, rect_laplace_start(reflector, receiver), 0.1);
    let first = rect_laplace_spot(receiver, start);
    let first_a = rect_laplace_reflector_slope(reflector.light, first);
    let first_b = rect_laplace_receiver_slope(receiver, first);
    let first_form = rect_laplace_form(
        receiver,
        first,
        first_a,
        rect_laplace_fall_ggx(first_a.square, reflector.gloss),
        first_b,
        rect_laplace_fall_ggx(first_b.square, receiver.gloss),
    );
    let at = rect_laplace_lift(receiver, rect_laplace_step(receiver, first, first_form), 0.03);
    let spot = rect_laplace_spot(receiver, at);
    let slope_a = rect_laplace_reflector_slope(reflector.light, spot);
    let slope_b = rect_laplace_receiver_slope(receiver, spot);
    let fall_a = rect_laplace_fall_ggx(slope_a.square, reflector.gloss);
    let fall_b = rect_laplace_fall_ggx(slope_b.square, receiver.gloss);
    let local = rect_laplace_form(receiver, spot, slope_a, fall_a, slope_b, fall_b);
    let own = 0.5 * reflector.gloss.weight * slope_a.scale * spot.down / (reflector.gloss.square + slope_a.square);
    let extent = rect_laplace_extent(receiver, spot);
    let angles = rect_laplace_angles(spot, local, extent, own);
    let h = angles.share;
    let area = rect_laplace_area_mean(angles, extent, 0.03 + h * (1.24 - 1.29 * h));
    let falls = fall_a.value * fall_b.value;
    let peaks = (reflector.gloss.square * receiver.gloss.square) * (0.10132118364233778 * reflector.light.z);
    let value = peaks * (falls * falls) * (max(spot.cosine, 0.0) * spot.down * extent.secant.x * extent.secant.y) * area;
    LaplaceIntegral { value, dir: Vec3::new(spot.along.x, spot.along.y, -spot.down) }
}

/// Interreflection.
#[kernel(
    family = "rect",
    cite = "own derivation",
    budget(1e-3 * result + 1e-5)
)]
pub fn rect_laplace(rectangle: Rectangle, reflector: Reflector, receiver: Receiver) -> f32 {
    let bitangent = cross(rectangle.normal, rectangle.tangent);
    let a = rect_laplace_reflector(rectangle, bitangent, reflector.alpha, reflector.light_dir);
    let b = rect_laplace_receiver(rectangle, bitangent, receiver);
    reflector.irradiance * reflector.reflectance * receiver.reflectance * rect_laplace_integral(a, b).value
}
