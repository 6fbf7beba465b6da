//! The integrand around one spot of the rectangle.

use crate::rect::laplace::frame::{Gloss, LaplaceReceiver, LaplaceReflector};
use lobe_codegen::prelude::*;

/// A spot of the rectangle, as the pixel sees it.
#[kernel]
pub struct LaplaceSpot {
    /// Where it is on the rectangle, from its middle.
    pub at: Vec2,
    /// The same from the foot of the pixel's perpendicular.
    pub offset: Vec2,
    /// Distance from the pixel.
    pub reach: f32,
    /// Part of the direction to it along the rectangle.
    pub along: Vec2,
    /// Part of the direction to it against the rectangle's normal: the cosine at the rectangle.
    pub down: f32,
    /// Cosine at the pixel.
    pub cosine: f32,
}

/// Slope of a half vector from a normal, and its derivatives as the spot moves.
///
/// The spot's movements are measured in the rectangle's plane, over the distance.
#[kernel]
pub struct LaplaceSlope {
    /// Squared slope, the squared tangent of the angle between half vector and normal.
    pub square: f32,
    /// Half the gradient of the squared slope, over `scale`.
    pub gradient: Vec2,
    /// Products xx, yy, xy of the slope's derivatives, over `scale²`.
    pub products: Vec3,
    /// Inverse of the half vector's component along the normal.
    pub scale: f32,
}

/// How a distribution falls off at a slope.
#[kernel]
pub struct LaplaceFall {
    /// GGX: the root of the distribution over `alpha²/π`, less one; spherical Gaussian: the distribution over
    /// its peak.
    pub value: f32,
    /// Minus the derivative of its logarithm by half the squared slope.
    pub weight: f32,
}

/// Both half vectors at a spot.
#[kernel]
pub struct LaplacePair {
    /// Slope of the reflector's.
    pub reflector: LaplaceSlope,
    /// How the reflector's distribution falls off there.
    pub reflector_fall: LaplaceFall,
    /// Slope of the receiver's.
    pub receiver: LaplaceSlope,
}

/// Minus the logarithm of the integrand around a spot, to second order.
#[kernel]
pub struct LaplaceForm {
    /// Gradient.
    pub gradient: Vec2,
    /// Second derivatives xx, yy, xy.
    pub second: Vec3,
}

/// The spot `at` of the rectangle.
#[kernel]
pub fn rect_laplace_spot(receiver: LaplaceReceiver, at: Vec2) -> LaplaceSpot {
    let offset = at - receiver.offset.xy();
    let reach2 = dot(offset, offset) + receiver.height2;
    let inverse = inverse_sqrt(reach2);
    let along = inverse * offset;
    let down = inverse * receiver.offset.z;
    let cosine = receiver.facing.x * along.x + receiver.facing.y * along.y - receiver.facing.z * down;
    LaplaceSpot { at, offset, reach: reach2 * inverse, along, down, cosine }
}

/// Slope, from the rectangle's normal, of the half vector of the light and the pixel.
#[kernel]
pub fn rect_laplace_reflector_slope(light: Vec3, spot: LaplaceSpot) -> LaplaceSlope {
    let scale = 1.0 / (light.z + spot.down);
    let slope = scale * (light.xy() - spot.along);
    // The slope's derivative is `scale` times the matrix `level along' - 1`.
    let level = light.xy() - light.z * slope;
    let by_x = Vec2::new(level.x * spot.along.x - 1.0, level.y * spot.along.x);
    let by_y = Vec2::new(level.x * spot.along.y, level.y * spot.along.y - 1.0);
    LaplaceSlope {
        square: dot(slope, slope),
        gradient: Vec2::new(dot(by_x, slope), dot(by_y, slope)),
        products: Vec3::new(dot(by_x, by_x), dot(by_y, by_y), dot(by_x, by_y)),
        scale,
    }
}

/// Slope, from the pixel's normal, of the half vector of the spot and the viewer.
#[kernel]
pub fn rect_laplace_receiver_slope(receiver: LaplaceReceiver, spot: LaplaceSpot) -> LaplaceSlope {
    // The floor is below what the view and the lifted spot leave.
    let scale = 1.0 / max(spot.cosine + receiver.cosine, 1e-3);
    let facing = receiver.facing.xy();
    // The direction to the spot, by the two tangents.
    let across = Vec2::new(
        receiver.tangents.x * spot.along.x + receiver.tangents.z * spot.along.y,
        receiver.tangents.z * spot.along.x + receiver.tangents.y * spot.along.y,
    ) - spot.down * facing;
    let slope = scale * (across + receiver.view);
    let rise = facing + receiver.cosine * spot.along;
    let by_x = receiver.tangents.xz() + spot.along.x * receiver.view - rise.x * slope;
    let by_y = receiver.tangents.zy() + spot.along.y * receiver.view - rise.y * slope;
    LaplaceSlope {
        square: dot(slope, slope),
        gradient: Vec2::new(dot(by_x, slope), dot(by_y, slope)),
        products: Vec3::new(dot(by_x, by_x), dot(by_y, by_y), dot(by_x, by_y)),
        scale,
    }
}

/// Fall of the GGX distribution, `D = alpha²/π (1 + value)²`.
#[kernel]
pub fn rect_laplace_fall(square: f32, gloss: Gloss) -> LaplaceFall {
    // (1 + t²)/(alpha² + t²), with t² once.
    let excess = gloss.rest / (gloss.square + square);
    LaplaceFall { value: excess, weight: 4.0 * excess / (1.0 + square) }
}

/// Fall of the spherical Gaussian distribution, `D = value/(π alpha²)`.
#[kernel]
pub fn rect_laplace_fall_sg(square: f32, gloss: Gloss) -> LaplaceFall {
    let secant2 = 1.0 + square;
    let secant = sqrt(secant2);
    // 2/alpha² (1 - cos) = 2 t²/(alpha² (secant² + secant))
    LaplaceFall {
        value: exp(-2.0 * square / (gloss.square * (secant2 + secant))),
        weight: 2.0 / (gloss.square * (secant2 * secant)),
    }
}

/// What both distributions depend on at a spot, and how the reflector's falls off there.
#[kernel]
pub fn rect_laplace_pair(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    spot: LaplaceSpot,
) -> LaplacePair {
    let slope = rect_laplace_reflector_slope(reflector.light, spot);
    LaplacePair {
        reflector: slope,
        reflector_fall: rect_laplace_fall(slope.square, reflector.gloss),
        receiver: rect_laplace_receiver_slope(receiver, spot),
    }
}

/// The second-order form out of its three factors: both distributions and the pixel's cosine.
#[kernel]
pub fn rect_laplace_form(
    receiver: LaplaceReceiver,
    spot: LaplaceSpot,
    pair: LaplacePair,
    receiver_weight: f32,
) -> LaplaceForm {
    let k = pair.reflector_fall.weight * pair.reflector.scale;
    let l = receiver_weight * pair.receiver.scale;
    let horizon = receiver.facing.xy() / max(spot.cosine, 0.05);
    LaplaceForm {
        gradient: k * pair.reflector.gradient + l * pair.receiver.gradient - horizon,
        second: (k * pair.reflector.scale) * pair.reflector.products
            + (l * pair.receiver.scale) * pair.receiver.products
            + Vec3::new(horizon.x * horizon.x, horizon.y * horizon.y, horizon.x * horizon.y),
    }
}
