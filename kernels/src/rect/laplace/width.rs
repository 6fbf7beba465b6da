//! The effective width of the integrand along one axis, and both axes together.

use crate::rect::laplace::evaluate::{LaplaceForm, LaplaceSpot};
use crate::rect::laplace::frame::LaplaceReceiver;
use lobe_codegen::prelude::*;

/// Extents of the rectangle around a spot, in half-angle coordinates.
#[kernel]
pub struct LaplaceExtent {
    /// To the edges of low and of high x.
    pub x: Vec2,
    /// To the edges of low and of high y.
    pub y: Vec2,
    /// `1/cos` of the angles along x and y at which the spot is seen.
    pub secant: Vec2,
}

/// Half-angle coordinates of two opposite edges, `2 tan(angle/2)` of the angle from the spot to the edge.
#[kernel]
pub fn rect_laplace_edges(across2: f32, across: f32, reach: f32, begin: f32, low: f32, high: f32) -> Vec2 {
    let to = begin + Vec2::new(-low, high);
    let span = across + reach;
    let product = span * (across + sqrt(across2 + to * to));
    let denominator = max(product + begin * to, Vec2::splat(across2));
    Vec2::new(low, high) * (4.0 * across) * (product / denominator) / denominator
}

/// Both axes.
#[kernel]
pub fn rect_laplace_extent(receiver: LaplaceReceiver, spot: LaplaceSpot) -> LaplaceExtent {
    let across2 = receiver.height2 + spot.offset.yx() * spot.offset.yx();
    let across = sqrt(across2);
    let low = max(receiver.extent + spot.at, Vec2::ZERO);
    let high = max(receiver.extent - spot.at, Vec2::ZERO);
    LaplaceExtent {
        x: rect_laplace_edges(across2.x, across.x, spot.reach, spot.offset.x, low.x, high.x),
        y: rect_laplace_edges(across2.y, across.y, spot.reach, spot.offset.y, low.y, high.y),
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

/// `∫₀^l (1 + S (2 b x + a x²))^(-3/2) dx`, with `S` sliding from 1 to `1 + sharpening` as the lobe falls.
#[kernel]
pub fn rect_laplace_half_width(a: f32, b: f32, l: f32, sharpening: f32) -> f32 {
    let q = l * (2.0 * b + a * l);
    let k = max(q, 0.0);
    let s = 1.0 + sharpening * (k / (1.0 + k));
    let r = sqrt(1.0 + s * max(q, -0.25));
    let t = 1.0 + r;
    l * t / (r * max(t + s * b * l, 1.0))
}

/// Both halves, `extent` to the low and to the high edge.
#[kernel]
pub fn rect_laplace_width(g: f32, second: f32, extent: Vec2, sharpening: f32) -> f32 {
    let a = second * (1.0 / 3.0);
    let b = g * (1.0 / 3.0);
    let least = -0.5 * sqrt(a);
    rect_laplace_half_width(a, max(-b, least), extent.x, sharpening)
        + rect_laplace_half_width(a, max(b, least), extent.y, sharpening)
}

/// Effective area: the geometric mean of both orders of integration.
#[kernel]
pub fn rect_laplace_area(angles: LaplaceAngles, extent: LaplaceExtent, sharpening: f32) -> f32 {
    let both = Vec2::new(extent.x.x + extent.x.y, extent.y.x + extent.y.y);
    let g = angles.gradient;
    let length2 = both * both;
    let shown = length2 * (angles.second + g * g) + 4.0;
    let reduced =
        max(angles.second - angles.mixed2 * length2.yx() / shown.yx(), 1e-4 * angles.second);
    sqrt(
        (rect_laplace_width(g.x, reduced.x, extent.x, sharpening)
            * rect_laplace_width(g.y, angles.second.y, extent.y, sharpening))
            * (rect_laplace_width(g.y, reduced.y, extent.y, sharpening)
                * rect_laplace_width(g.x, angles.second.x, extent.x, sharpening)),
    )
}

/// Effective area: that order alone whose reduced axis shows more of the lobe.
#[kernel]
pub fn rect_laplace_area_fast(angles: LaplaceAngles, extent: LaplaceExtent, sharpening: f32) -> f32 {
    let both = Vec2::new(extent.x.x + extent.x.y, extent.y.x + extent.y.y);
    let g = angles.gradient;
    let length2 = both * both;
    let shown = length2 * (angles.second + g * g);
    let is_x = shown.x > shown.y;
    let axis = select(angles.second.y, angles.second.x, is_x);
    let other2 = select(length2.x, length2.y, is_x);
    let reduced = max(axis - angles.mixed2 * other2 / (min(shown.x, shown.y) + 4.0), 1e-4 * axis);
    rect_laplace_width(g.x, select(angles.second.x, reduced, is_x), extent.x, sharpening)
        * rect_laplace_width(g.y, select(reduced, angles.second.y, is_x), extent.y, sharpening)
}
