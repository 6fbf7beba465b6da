//! Where the integrand is largest on the rectangle.

use crate::rect::laplace::evaluate::{LaplaceForm, LaplaceSpot};
use crate::rect::laplace::frame::{LaplaceReceiver, LaplaceReflector};
use lobe_codegen::prelude::*;

/// Where the search begins: the sum of both mirror directions, weighted, met with the rectangle and lifted above the
/// pixel's horizon.
#[kernel]
pub fn rect_laplace_start(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> Vec2 {
    let weight = receiver.pull;
    let aim = weight * reflector.light.xy() + reflector.pull * receiver.mirror.xy();
    let depth = weight * reflector.light.z - reflector.pull * receiver.mirror.z;
    let scale = receiver.offset.z / max(depth, 0.05 * (weight + reflector.pull));
    let met = clamp(receiver.offset.xy() + scale * aim, -receiver.extent, receiver.extent);
    rect_laplace_lift(receiver, met, 0.1)
}

/// Moves a spot that is below the pixel's horizon, or within `margin` of it, towards the highest corner.
#[kernel]
pub fn rect_laplace_lift(receiver: LaplaceReceiver, at: Vec2, margin: f32) -> Vec2 {
    let offset = at - receiver.offset.xy();
    let reach = sqrt(dot(offset, offset) + receiver.height2);
    let above = dot(receiver.facing.xy(), offset) - receiver.facing.z * receiver.offset.z;
    let way = receiver.corner - at;
    // The corner is `above + rise` above the horizon. Never lift by more than half of the way.
    let rise = max(dot(receiver.facing.xy(), way), 1e-20);
    let missing = min(margin * reach - above, 0.5 * (rise - above));
    at + max(missing / rise, 0.0) * way
}

/// One Gauss-Newton step inside the rectangle: Newton in x, then y, x and y in turn at the others' value.
#[kernel]
pub fn rect_laplace_step(receiver: LaplaceReceiver, spot: LaplaceSpot, local: LaplaceForm) -> Vec2 {
    let a = local.second.x + 4.0;
    let c = local.second.y + 4.0;
    let b = local.second.z;
    let g = spot.reach * local.gradient + 4.0 * spot.offset;
    let product = a * c;
    let determinant = max(product - b * b, 1e-5 * product);
    let limit = receiver.extent;
    let x0 = clamp(spot.at.x + (b * g.y - c * g.x) / determinant, -limit.x, limit.x);
    let y0 = clamp(spot.at.y - (g.y + b * (x0 - spot.at.x)) / c, -limit.y, limit.y);
    let x = clamp(spot.at.x - (g.x + b * (y0 - spot.at.y)) / a, -limit.x, limit.x);
    let y = clamp(spot.at.y - (g.y + b * (x - spot.at.x)) / c, -limit.y, limit.y);
    Vec2::new(x, y)
}
