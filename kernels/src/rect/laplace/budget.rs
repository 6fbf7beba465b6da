//! Scales that the budgets are stated in. No kernel computes with them.

use crate::constants::TWO_PI;
use crate::rect::laplace::evaluate::rect_laplace_spot;
use crate::rect::laplace::frame::{
    Reflector, rect_laplace_bitangent, rect_laplace_is_dark, rect_laplace_receiver, rect_laplace_reflector,
};
use crate::rect::laplace::integral::{
    rect_laplace_local, rect_laplace_local_sg, rect_laplace_point, rect_laplace_point_sg,
};
use crate::rect::laplace::radiance::rect_laplace_scale;
use crate::rect::laplace::search::rect_laplace_start;
use crate::rect::laplace::width::{rect_laplace_angles, rect_laplace_extent, rect_laplace_shown};
use crate::rect::{GlossyReceiver, Rectangle};
use lobe_codegen::prelude::*;

/// π², of the peaks of two distributions.
#[kernel]
pub const PI_SQUARE: f32 = 9.8696044010893586188;

/// What the radiance is measured against: both distributions at their peaks over the rectangle's solid angle, as it
/// would be seen straight on from the distance of its middle, 2π at most.
#[kernel]
pub fn rect_laplace_ceiling(rectangle: Rectangle, reflector: Reflector, receiver: GlossyReceiver) -> f32 {
    let way = receiver.position - rectangle.position;
    let solid_angle = min(4.0 * rectangle.half_x * rectangle.half_y / max(dot(way, way), 1e-9), TWO_PI);
    let roughness = reflector.alpha * receiver.alpha;
    rect_laplace_scale(reflector, receiver) * solid_angle / (PI_SQUARE * (roughness * roughness))
}

/// How much harder than straight on the rectangle is to see: what multiplies the budgets.
///
/// With `g`, distance and larger half extent over the pixel's height above the rectangle's plane, `f`, distance over
/// smaller half extent, and `c`, the viewer's cosine at the pixel, `4 + 0.006 g² + 5e-3 f + 0.02/c`: height and extents
/// are differences of positions, of which a grazing pixel, and one far from a small rectangle, leave few digits, and a
/// grazing view makes half vectors steep. Where the pixel's normal is within 2e-4 of being perpendicular to a side,
/// `400 + 80 g` more: there the corner that a spot is lifted to moves from one end of the side to the other.
#[kernel]
pub fn rect_laplace_difficulty(rectangle: Rectangle, receiver: GlossyReceiver) -> f32 {
    let way = receiver.position - rectangle.position;
    let far = length(way);
    let height = max(dot(rectangle.normal, way), 1e-9);
    let g = (far + max(rectangle.half_x, rectangle.half_y)) / height;
    let x = dot(rectangle.tangent, receiver.normal);
    let y = dot(rect_laplace_bitangent(rectangle), receiver.normal);
    let askew = select(0.0, 400.0 + 80.0 * g, min(abs(x), abs(y)) < 2e-4);
    let small = far / min(rectangle.half_x, rectangle.half_y);
    let steep = 1.0 / max(dot(receiver.normal, receiver.view), 1e-3);
    4.0 + 0.006 * (g * g) + 5e-3 * small + 0.02 * steep + askew
}

/// 1 where a cosine of the light or of the view is at 1e-3, below which nothing arrives; else 0.
#[kernel]
pub fn rect_laplace_threshold(rectangle: Rectangle, reflector: Reflector, receiver: GlossyReceiver) -> f32 {
    let least = min(dot(rectangle.normal, reflector.light), dot(receiver.normal, receiver.view));
    select(0.0, 1.0, least < 1.001e-3)
}

/// Product of the diagonal over the determinant of the form that the step solves: 1 for a round lobe, large for a
/// long thin one that lies askew.
#[kernel]
pub fn rect_laplace_form_condition(second: Vec3) -> f32 {
    let product = (second.x + 4.0) * (second.y + 4.0);
    product / max(product - second.z * second.z, 1e-5 * product)
}

/// What multiplies the budget of [`rect_laplace`](crate::rect::laplace::rect_laplace): `c` above the difficulty, `c`
/// being the condition of its step.
#[kernel]
pub fn rect_laplace_hardness(rectangle: Rectangle, reflector: Reflector, receiver: GlossyReceiver) -> f32 {
    let difficulty = rect_laplace_difficulty(rectangle, receiver);
    let bitangent = rect_laplace_bitangent(rectangle);
    let reflector_in_frame = rect_laplace_reflector(rectangle, bitangent, reflector);
    let receiver_in_frame = rect_laplace_receiver(rectangle, bitangent, receiver);
    if rect_laplace_is_dark(reflector_in_frame, receiver_in_frame) {
        return difficulty;
    }
    let spot =
        rect_laplace_spot(receiver_in_frame, rect_laplace_start(reflector_in_frame, receiver_in_frame));
    let local = rect_laplace_local(reflector_in_frame, receiver_in_frame, spot);
    difficulty + rect_laplace_form_condition(local.second)
}

/// What multiplies the budget of [`rect_laplace_sg`](crate::rect::laplace::rect_laplace_sg): `c` above the difficulty, `c`
/// being the condition of its step.
#[kernel]
pub fn rect_laplace_hardness_sg(rectangle: Rectangle, reflector: Reflector, receiver: GlossyReceiver) -> f32 {
    let difficulty = rect_laplace_difficulty(rectangle, receiver);
    let bitangent = rect_laplace_bitangent(rectangle);
    let reflector_in_frame = rect_laplace_reflector(rectangle, bitangent, reflector);
    let receiver_in_frame = rect_laplace_receiver(rectangle, bitangent, receiver);
    if rect_laplace_is_dark(reflector_in_frame, receiver_in_frame) {
        return difficulty;
    }
    let spot =
        rect_laplace_spot(receiver_in_frame, rect_laplace_start(reflector_in_frame, receiver_in_frame));
    let local = rect_laplace_local_sg(reflector_in_frame, receiver_in_frame, spot);
    difficulty + rect_laplace_form_condition(local.second)
}

/// 1 where [`rect_laplace_fast`](crate::rect::laplace::rect_laplace_fast) may jump, else 0: where both axes show as
/// much of the lobe (to within 0.4 % straight on, more where the rectangle is hard to see), so that a rounding error decides about the
/// order.
#[kernel]
pub fn rect_laplace_fast_jump(rectangle: Rectangle, reflector: Reflector, receiver: GlossyReceiver) -> f32 {
    let bitangent = rect_laplace_bitangent(rectangle);
    let reflector_in_frame = rect_laplace_reflector(rectangle, bitangent, reflector);
    let receiver_in_frame = rect_laplace_receiver(rectangle, bitangent, receiver);
    if rect_laplace_is_dark(reflector_in_frame, receiver_in_frame) {
        return 0.0;
    }
    let start = rect_laplace_start(reflector_in_frame, receiver_in_frame);
    let peak = rect_laplace_point(reflector_in_frame, receiver_in_frame, start);
    let extent = rect_laplace_extent(receiver_in_frame, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let shown = rect_laplace_shown(angles, extent);
    let near = 0.001 * rect_laplace_difficulty(rectangle, receiver);
    let is_even = abs(shown.x - shown.y) < near * (shown.x + shown.y);
    select(0.0, 1.0, is_even)
}

/// The same of [`rect_laplace_fast_sg`](crate::rect::laplace::rect_laplace_fast_sg).
#[kernel]
pub fn rect_laplace_fast_jump_sg(
    rectangle: Rectangle,
    reflector: Reflector,
    receiver: GlossyReceiver,
) -> f32 {
    let bitangent = rect_laplace_bitangent(rectangle);
    let reflector_in_frame = rect_laplace_reflector(rectangle, bitangent, reflector);
    let receiver_in_frame = rect_laplace_receiver(rectangle, bitangent, receiver);
    if rect_laplace_is_dark(reflector_in_frame, receiver_in_frame) {
        return 0.0;
    }
    let start = rect_laplace_start(reflector_in_frame, receiver_in_frame);
    let peak = rect_laplace_point_sg(reflector_in_frame, receiver_in_frame, start);
    let extent = rect_laplace_extent(receiver_in_frame, peak.spot);
    let angles = rect_laplace_angles(peak.spot, peak.local, extent.secant, peak.own);
    let shown = rect_laplace_shown(angles, extent);
    let near = 0.001 * rect_laplace_difficulty(rectangle, receiver);
    let is_even = abs(shown.x - shown.y) < near * (shown.x + shown.y);
    select(0.0, 1.0, is_even)
}
