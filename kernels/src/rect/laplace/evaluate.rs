//! The integrand around one spot of the rectangle.

use crate::rect::laplace::frame::{Gloss, LaplaceReceiver, LaplaceReflector};
use lobe_codegen::prelude::*;

/// A spot of the rectangle as the pixel sees it.
#[kernel]
pub struct LaplaceSpot {
    /// Where it is on the rectangle.
    pub at: Vec2,
    /// Part of the direction to it along the rectangle.
    pub along: Vec2,
    /// Part of it against the rectangle's normal: the cosine at the rectangle.
    pub down: f32,
    /// Distance.
    pub reach: f32,
    /// Cosine at the pixel.
    pub cosine: f32,
}

/// Slope of a half vector from a normal, at a spot, and how it changes as the spot moves.
///
/// Movements are measured as angles seen from the pixel: in the rectangle's plane, over the distance.
#[kernel]
pub struct LaplaceSlope {
    /// `|slope|²`, the squared tangent of the angle.
    pub square: f32,
    /// Half the gradient of `square`, over `scale`.
    pub gradient: Vec2,
    /// Products of the slope's derivatives, over `scale²`: xx, yy, xy.
    pub products: Vec3,
    /// See above.
    pub scale: f32,
}

/// How a distribution falls off.
#[kernel]
pub struct LaplaceFall {
    /// The distribution over its peak; for GGX the root of it.
    pub value: f32,
    /// Minus its logarithm's slope by half the squared slope.
    pub weight: f32,
}

/// Minus the logarithm of the integrand to second order.
#[kernel]
pub struct LaplaceForm {
    /// Gradient.
    pub gradient: Vec2,
    /// The form's xx, yy, xy.
    pub form: Vec3,
}

/// The spot `at` of the rectangle as the pixel sees it.
#[kernel]
pub fn rect_laplace_spot(receiver: LaplaceReceiver, at: Vec2) -> LaplaceSpot {
    let offset = at - receiver.offset.xy();
    let square = dot(offset, offset) + receiver.offset.z * receiver.offset.z;
    let inverse = inverse_sqrt(square);
    let along = inverse * offset;
    let down = inverse * receiver.offset.z;
    LaplaceSpot {
        at,
        along,
        down,
        reach: square * inverse,
        cosine: receiver.facing.x * along.x + receiver.facing.y * along.y - receiver.facing.z * down,
    }
}

/// Slope of the half vector of the light and the pixel from the rectangle's normal.
#[kernel]
pub fn rect_laplace_reflector_slope(light: Vec3, spot: LaplaceSpot) -> LaplaceSlope {
    let scale = 1.0 / (light.z + spot.down);
    let slope = scale * (light.xy() - spot.along);
    let a = light.xy() - light.z * slope;
    // The slope's derivative is `scale` times this matrix.
    let column_x = Vec2::new(a.x * spot.along.x - 1.0, a.y * spot.along.x);
    let column_y = Vec2::new(a.x * spot.along.y, a.y * spot.along.y - 1.0);
    LaplaceSlope {
        square: dot(slope, slope),
        gradient: Vec2::new(dot(column_x, slope), dot(column_y, slope)),
        products: Vec3::new(dot(column_x, column_x), dot(column_y, column_y), dot(column_x, column_y)),
        scale,
    }
}

/// Slope of the half vector of the spot and the viewer from the pixel's normal.
#[kernel]
pub fn rect_laplace_receiver_slope(receiver: LaplaceReceiver, spot: LaplaceSpot) -> LaplaceSlope {
    let scale = 1.0 / max(spot.cosine + receiver.cosine, 1e-3);
    let half_vector = scale * Vec3::new(
        spot.along.x + receiver.view.x,
        spot.along.y + receiver.view.y,
        receiver.view.z - spot.down,
    );
    let slope = half_vector - receiver.facing;
    let rise_x = receiver.facing.x + receiver.cosine * spot.along.x;
    let rise_y = receiver.facing.y + receiver.cosine * spot.along.y;
    let column_x = Vec3::new(1.0, 0.0, 0.0) + spot.along.x * receiver.view - rise_x * half_vector;
    let column_y = Vec3::new(0.0, 1.0, 0.0) + spot.along.y * receiver.view - rise_y * half_vector;
    LaplaceSlope {
        square: dot(slope, slope),
        gradient: Vec2::new(dot(column_x, slope), dot(column_y, slope)),
        products: Vec3::new(dot(column_x, column_x), dot(column_y, column_y), dot(column_x, column_y)),
        scale,
    }
}

/// GGX: `D = alpha²/π value²`.
#[kernel]
pub fn rect_laplace_fall_ggx(square: f32, gloss: Gloss) -> LaplaceFall {
    let inverse = 1.0 / (gloss.square + square);
    LaplaceFall { value: (1.0 + square) * inverse, weight: gloss.weight * inverse / (1.0 + square) }
}

/// Spherical Gaussian: `D = value/(π alpha²)`.
#[kernel]
pub fn rect_laplace_fall_sg(square: f32, gloss: Gloss) -> LaplaceFall {
    let hypotenuse2 = 1.0 + square;
    let hypotenuse = sqrt(hypotenuse2);
    LaplaceFall {
        value: exp(-2.0 * square / (gloss.square * (hypotenuse2 + hypotenuse))),
        weight: 2.0 / (gloss.square * hypotenuse2 * hypotenuse),
    }
}

/// Minus the logarithm of the integrand without the Jacobian, to second order.
#[kernel]
pub fn rect_laplace_form(
    receiver: LaplaceReceiver,
    spot: LaplaceSpot,
    reflector_slope: LaplaceSlope,
    reflector_fall: LaplaceFall,
    receiver_slope: LaplaceSlope,
    receiver_fall: LaplaceFall,
) -> LaplaceForm {
    let k = reflector_fall.weight * reflector_slope.scale;
    let l = receiver_fall.weight * receiver_slope.scale;
    let horizon = receiver.facing.xy() * (1.0 / max(spot.cosine, 0.05));
    LaplaceForm {
        gradient: k * reflector_slope.gradient + l * receiver_slope.gradient - horizon,
        form: (k * reflector_slope.scale) * reflector_slope.products
            + (l * receiver_slope.scale) * receiver_slope.products
            + Vec3::new(horizon.x * horizon.x, horizon.y * horizon.y, horizon.x * horizon.y),
    }
}

/// Moves a spot that is below the pixel's horizon, or too near to it, towards the highest corner.
#[kernel]
pub fn rect_laplace_lift(receiver: LaplaceReceiver, at: Vec2, margin: f32) -> Vec2 {
    let offset = at - receiver.offset.xy();
    let height = receiver.facing.x * offset.x + receiver.facing.y * offset.y
        - receiver.facing.z * receiver.offset.z;
    let way = receiver.corner - at;
    let rise = max(receiver.facing.x * way.x + receiver.facing.y * way.y, 0.0);
    let reach = sqrt(dot(offset, offset) + receiver.offset.z * receiver.offset.z);
    let wanted = min(margin * reach, 0.5 * (height + rise));
    at + saturate((wanted - height) / max(rise, 1e-20)) * way
}

/// Where the search begins: the product of the two mirror directions.
#[kernel]
pub fn rect_laplace_start(reflector: LaplaceReflector, receiver: LaplaceReceiver) -> Vec2 {
    let k1 = receiver.gloss.square * receiver.cosine;
    let mirror = 2.0 * receiver.cosine * receiver.facing - receiver.view;
    let aim = k1 * reflector.light.xy() + reflector.pull * mirror.xy();
    let depth = max(k1 * reflector.light.z - reflector.pull * mirror.z, 0.05 * (k1 + reflector.pull));
    let at = receiver.offset.xy() + receiver.offset.z * (aim / depth);
    clamp(at, -receiver.extent, receiver.extent)
}

/// One Gauss-Newton step inside the rectangle.
#[kernel]
pub fn rect_laplace_step(receiver: LaplaceReceiver, spot: LaplaceSpot, local: LaplaceForm) -> Vec2 {
    let a = local.form.x + 4.0;
    let c = local.form.y + 4.0;
    let b = local.form.z;
    let g = spot.reach * (local.gradient + 4.0 * spot.along);
    let determinant = max(a * c - b * b, 1e-5 * a * c);
    let limit = receiver.extent;
    let x0 = clamp(spot.at.x - (c * g.x - b * g.y) / determinant, -limit.x, limit.x);
    let y0 = clamp(spot.at.y - (g.y + b * (x0 - spot.at.x)) / c, -limit.y, limit.y);
    let x = clamp(spot.at.x - (g.x + b * (y0 - spot.at.y)) / a, -limit.x, limit.x);
    Vec2::new(x, clamp(spot.at.y - (g.y + b * (x - spot.at.x)) / c, -limit.y, limit.y))
}
