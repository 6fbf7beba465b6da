//! The effective width of the integrand along one axis, and both axes together.

use crate::rect::laplace::evaluate::{LaplaceForm, LaplaceSpot};
use crate::rect::laplace::frame::LaplaceReceiver;
use lobe_codegen::prelude::*;

/// Extents of the rectangle around a spot, inverse, in half-angle coordinates: `1/(2 tan(angle/2))` of the angle
/// from the spot to an edge.
#[kernel]
pub struct LaplaceExtent {
    /// To the edges of low and of high x.
    pub x: Vec2,
    /// To the edges of low and of high y.
    pub y: Vec2,
    /// `1/cos` of the angles along x and y at which the spot is seen.
    pub secant: Vec2,
}

/// Inverse half-angle coordinates of two opposite edges, at `ways` from the spot.
#[kernel]
pub fn rect_laplace_edges(
    across2: f32,
    across: f32,
    reach: f32,
    begin: f32,
    edges: Vec2,
    ways: Vec2,
) -> Vec2 {
    let product = (across + reach) * (across + sqrt(across2 + edges * edges));
    let sum = product + begin * edges;
    min(sum / product * (sum / max((4.0 * across) * ways, Vec2::splat(1e-28))), Vec2::splat(1e18))
}

/// Both axes.
#[kernel]
pub fn rect_laplace_extent(receiver: LaplaceReceiver, spot: LaplaceSpot) -> LaplaceExtent {
    let across2 = receiver.height2 + spot.offset.yx() * spot.offset.yx();
    let across = sqrt(across2);
    let low = receiver.extent + spot.at;
    let high = receiver.extent - spot.at;
    let x = Vec2::new(low.x, high.x);
    let y = Vec2::new(low.y, high.y);
    LaplaceExtent {
        x: rect_laplace_edges(across2.x, across.x, spot.reach, spot.offset.x, receiver.edges_x, x),
        y: rect_laplace_edges(across2.y, across.y, spot.reach, spot.offset.y, receiver.edges_y, y),
        secant: spot.reach / across,
    }
}

/// The integrand's logarithm in half-angle coordinates.
#[kernel]
pub struct LaplaceAngles {
    /// Gradient.
    pub gradient: Vec2,
    /// Second derivatives xx and yy.
    pub second: Vec2,
    /// Square of the second derivative xy.
    pub mixed2: f32,
    /// How far the reflector's distribution makes the peak, 0 ..= 1.
    pub share: f32,
}

/// The integrand's logarithm in half-angle coordinates. `own` is the root of the determinant that the
/// reflector's distribution alone would have.
#[kernel]
pub fn rect_laplace_angles(spot: LaplaceSpot, local: LaplaceForm, secant: Vec2, own: f32) -> LaplaceAngles {
    let second = local.second.xy() + 1.0;
    let mixed2 = local.second.z * local.second.z;
    let product = second.x * second.y;
    let determinant = max(product - mixed2, 1e-6 * product);
    let secant2 = secant * secant;
    LaplaceAngles {
        gradient: (local.gradient + spot.along) * secant,
        second: second * secant2 + 0.5,
        mixed2: mixed2 * (secant2.x * secant2.y),
        share: min(own * inverse_sqrt(determinant), 1.0),
    }
}

/// Half of `∫₀^l (1 + S (b x + a x²))^(-3/2) dx`, with `S` sliding from 1 to `most = 1 + more` as the lobe falls.
#[kernel]
pub fn rect_laplace_half_width(a: f32, b: f32, reciprocal: f32, most: f32, more: f32) -> f32 {
    let square = reciprocal * reciprocal;
    let p = b * reciprocal + a;
    let s = most - more * square / (square + max(p, 0.0));
    // `b >= -sqrt(a)`, so that `p >= -square/4`; and `s` is 1 where `p` is negative.
    let r = sqrt(square + s * p);
    1.0 / (r * (2.0 + s * b / (reciprocal + r)))
}

/// Half of both halves.
#[kernel]
pub fn rect_laplace_width(g: f32, second: f32, reciprocal: Vec2, sharpening: Vec2) -> f32 {
    let a = second * (1.0 / 3.0);
    let b = g * (2.0 / 3.0);
    let least = -sqrt(a);
    rect_laplace_half_width(a, max(-b, least), reciprocal.x, sharpening.x, sharpening.y)
        + rect_laplace_half_width(a, max(b, least), reciprocal.y, sharpening.x, sharpening.y)
}

/// `4/l²` of the whole extent `l` along an axis.
#[kernel]
pub fn rect_laplace_whole(reciprocal: Vec2) -> f32 {
    let twice = 2.0 * reciprocal.x * reciprocal.y / (reciprocal.x + reciprocal.y);
    twice * twice
}

/// A quarter of the effective area: the geometric mean of both orders of integration.
#[kernel]
pub fn rect_laplace_area(angles: LaplaceAngles, extent: LaplaceExtent, sharpening: Vec2) -> f32 {
    let g = angles.gradient;
    let truncated =
        angles.second + g * g + Vec2::new(rect_laplace_whole(extent.x), rect_laplace_whole(extent.y));
    let reduced = max(angles.second - angles.mixed2 / truncated.yx(), 1e-4 * angles.second);
    sqrt(
        (rect_laplace_width(g.x, reduced.x, extent.x, sharpening)
            * rect_laplace_width(g.y, angles.second.y, extent.y, sharpening))
            * (rect_laplace_width(g.y, reduced.y, extent.y, sharpening)
                * rect_laplace_width(g.x, angles.second.x, extent.x, sharpening)),
    )
}

/// How much of the lobe each axis shows, to be compared.
#[kernel]
pub fn rect_laplace_shown(angles: LaplaceAngles, extent: LaplaceExtent) -> Vec2 {
    let own = angles.second + angles.gradient * angles.gradient;
    own * Vec2::new(rect_laplace_whole(extent.y), rect_laplace_whole(extent.x))
}

/// A quarter of the effective area: that order alone whose reduced axis shows more of the lobe.
#[kernel]
pub fn rect_laplace_area_fast(angles: LaplaceAngles, extent: LaplaceExtent, sharpening: Vec2) -> f32 {
    let g = angles.gradient;
    let own = angles.second + g * g;
    let whole = Vec2::new(rect_laplace_whole(extent.x), rect_laplace_whole(extent.y));
    let is_x = own.x * whole.y > own.y * whole.x;
    let axis = select(angles.second.y, angles.second.x, is_x);
    let other = select(own.x + whole.x, own.y + whole.y, is_x);
    let reduced = max(axis - angles.mixed2 / other, 1e-4 * axis);
    rect_laplace_width(g.x, select(angles.second.x, reduced, is_x), extent.x, sharpening)
        * rect_laplace_width(g.y, select(reduced, angles.second.y, is_x), extent.y, sharpening)
}
