//! The effective width of the integrand along one axis, and both axes together.

use crate::rect::laplace::evaluate::{LaplaceForm, LaplaceSpot};
use crate::rect::laplace::frame::LaplaceReceiver;
use lobe_codegen::prelude::*;

/// Extents from a spot to the edges, in half-angle coordinates.
#[kernel]
pub struct LaplaceExtent {
    /// To the edges of negative x and y.
    pub low: Vec2,
    /// To the edges of positive x and y.
    pub high: Vec2,
    /// `1/cos` of the angles along x and y.
    pub secant: Vec2,
}

/// Half-angle coordinate of an edge: `2 tan(angle/2)`.
#[kernel]
pub fn rect_laplace_edge(across: f32, reach: f32, begin: f32, way: f32, step_to: f32) -> f32 {
    let to = begin + step_to;
    let product = (across + reach) * (across + sqrt(across * across + to * to));
    let denominator = max(product + begin * to, across * across);
    4.0 * across * way * (product / denominator) / denominator
}

/// All four edges.
#[kernel]
pub fn rect_laplace_extent(receiver: LaplaceReceiver, spot: LaplaceSpot) -> LaplaceExtent {
    let offset = spot.at - receiver.offset.xy();
    let square = receiver.offset.z * receiver.offset.z;
    let mx = sqrt(square + offset.y * offset.y);
    let my = sqrt(square + offset.x * offset.x);
    let high = receiver.extent - spot.at;
    let low = receiver.extent + spot.at;
    LaplaceExtent {
        low: Vec2::new(
            rect_laplace_edge(mx, spot.reach, offset.x, low.x, -low.x),
            rect_laplace_edge(my, spot.reach, offset.y, low.y, -low.y),
        ),
        high: Vec2::new(
            rect_laplace_edge(mx, spot.reach, offset.x, high.x, high.x),
            rect_laplace_edge(my, spot.reach, offset.y, high.y, high.y),
        ),
        secant: Vec2::new(spot.reach / mx, spot.reach / my),
    }
}

/// `∫₀^l (1 + S (2 b x + a x²))^(-3/2) dx`, with `S` sliding from 1 to `1 + sharpening`.
#[kernel]
pub fn rect_laplace_half_width(a: f32, b: f32, l: f32, sharpening: f32) -> f32 {
    let q = l * (2.0 * b + a * l);
    let k = max(q, 0.0);
    let s = 1.0 + sharpening * (k / (1.0 + k));
    let r = sqrt(1.0 + s * max(q, -0.25));
    l * (1.0 + r) / (r * (1.0 + r + s * b * l))
}

/// Both halves.
#[kernel]
pub fn rect_laplace_width(g: f32, curvature: f32, low: f32, high: f32, sharpening: f32) -> f32 {
    let a = curvature * (1.0 / 3.0);
    let least = -0.5 * sqrt(a);
    let b = g * (1.0 / 3.0);
    rect_laplace_half_width(a, max(b, least), high, sharpening)
        + rect_laplace_half_width(a, max(-b, least), low, sharpening)
}

/// The form in half-angle coordinates.
#[kernel]
pub struct LaplaceAngles {
    /// Gradient.
    pub gradient: Vec2,
    /// Curvature along x.
    pub a: f32,
    /// Curvature along y.
    pub c: f32,
    /// Square of the mixed one.
    pub b2: f32,
    /// Share of the reflector.
    pub share: f32,
}

/// The form in half-angle coordinates.
#[kernel]
pub fn rect_laplace_angles(spot: LaplaceSpot, local: LaplaceForm, extent: LaplaceExtent, own: f32) -> LaplaceAngles {
    let a = local.form.x + 1.0;
    let c = local.form.y + 1.0;
    let b = local.form.z;
    let g = local.gradient + spot.along;
    let determinant = max(a * c - b * b, 1e-6 * a * c);
    let secant2 = extent.secant * extent.secant;
    LaplaceAngles {
        gradient: g * extent.secant,
        a: a * secant2.x + 0.5,
        c: c * secant2.y + 0.5,
        b2: b * b * secant2.x * secant2.y,
        share: min(own * inverse_sqrt(determinant), 1.0),
    }
}

/// Curvature along an axis, the other integrated out over its truncated extent.
#[kernel]
pub fn rect_laplace_reduced(a: f32, b2: f32, c: f32, g: f32, length2: f32) -> f32 {
    max(a - b2 * length2 / (length2 * (c + g * g) + 4.0), 1e-4 * a)
}

/// Effective area: the mean of both orders.
#[kernel]
pub fn rect_laplace_area_mean(angles: LaplaceAngles, extent: LaplaceExtent, sharpening: f32) -> f32 {
    let both = extent.low + extent.high;
    let g = angles.gradient;
    let x = rect_laplace_reduced(angles.a, angles.b2, angles.c, g.y, both.y * both.y);
    let y = rect_laplace_reduced(angles.c, angles.b2, angles.a, g.x, both.x * both.x);
    let wx = rect_laplace_width(g.x, x, extent.low.x, extent.high.x, sharpening)
        * rect_laplace_width(g.x, angles.a, extent.low.x, extent.high.x, sharpening);
    let wy = rect_laplace_width(g.y, y, extent.low.y, extent.high.y, sharpening)
        * rect_laplace_width(g.y, angles.c, extent.low.y, extent.high.y, sharpening);
    sqrt(wx * wy)
}

/// Effective area: the order whose reduced axis shows more of the lobe.
#[kernel]
pub fn rect_laplace_area_adapt(angles: LaplaceAngles, extent: LaplaceExtent, sharpening: f32) -> f32 {
    let both = extent.low + extent.high;
    let g = angles.gradient;
    let length2 = both * both;
    let order = length2.x * (angles.a + g.x * g.x) > length2.y * (angles.c + g.y * g.y);
    let x = rect_laplace_reduced(angles.a, angles.b2, angles.c, g.y, length2.y);
    let y = rect_laplace_reduced(angles.c, angles.b2, angles.a, g.x, length2.x);
    rect_laplace_width(g.x, select(angles.a, x, order), extent.low.x, extent.high.x, sharpening)
        * rect_laplace_width(g.y, select(y, angles.c, order), extent.low.y, extent.high.y, sharpening)
}
