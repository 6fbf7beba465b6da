//! Along one axis: half-angle coordinates, and the places where a lobe is looked at.

use lobe_codegen::prelude::*;

/// A line of the rectangle as the pixel sees it, and a place on it from which half angles are measured.
#[kernel]
pub struct QuadratureLine {
    /// Distance of the line from the pixel.
    pub across: f32,
    /// Tangent of half the angle from the foot of the pixel's perpendicular to the place.
    pub angle: f32,
}

/// A density `∝ ((v + shift)² + width²)^(-3/2)` over a range of `v`.
///
/// Its integral to infinity is `tail = 1 - z/√(z² + width²)`, `z = v + shift`, which is taken for the coordinate. The range
/// is mirrored where most of it is below the peak, so that no tail is a difference of near values.
#[kernel]
pub struct QuadratureWarp {
    /// How far the peak is below `v = 0`.
    pub shift: f32,
    /// Width of the peak.
    pub width: f32,
    /// -1 where the range is mirrored, else 1.
    pub mirror: f32,
    /// Tail at the range's beginning.
    pub low: f32,
    /// Tail at its end.
    pub high: f32,
}

/// A place of a range, and how fast it moves.
#[kernel]
pub struct QuadratureNode {
    /// The coordinate.
    pub place: f32,
    /// Its derivative by the share of the density that is below.
    pub rate: f32,
}

/// Tangent of half the angle of a place at `along` on a line that is `across` away.
#[kernel]
pub fn rect_quadrature_half(across: f32, along: f32) -> f32 {
    along / (across + sqrt(across * across + along * along))
}

/// A line through a place at `along`.
#[kernel]
pub fn rect_quadrature_line(across: f32, along: f32) -> QuadratureLine {
    QuadratureLine { across, angle: rect_quadrature_half(across, along) }
}

/// Twice the tangent of half the angle from the line's place to one at `along`.
#[kernel]
pub fn rect_quadrature_way(row: QuadratureLine, along: f32) -> f32 {
    let angle = rect_quadrature_half(row.across, along);
    2.0 * (angle - row.angle) / max(1.0 + angle * row.angle, 1e-6)
}

/// The same of both ends of a range.
#[kernel]
pub fn rect_quadrature_ways(row: QuadratureLine, range: Vec2) -> Vec2 {
    Vec2::new(rect_quadrature_way(row, range.x), rect_quadrature_way(row, range.y))
}

/// The place that [`rect_quadrature_way`] is of, inside a range, and its derivative by the share of the density.
#[kernel]
pub fn rect_quadrature_along(row: QuadratureLine, node: QuadratureNode, range: Vec2) -> QuadratureNode {
    let way = 0.5 * node.place;
    let angle = (way + row.angle) / max(1.0 - way * row.angle, 1e-6);
    let across = row.across;
    let place = clamp(2.0 * across * angle / max(1.0 - angle * angle, 1e-12), range.x, range.y);
    let rate = (across * across + place * place) / (across * (1.0 + way * way)) * node.rate;
    QuadratureNode { place, rate }
}

/// `1 - z/√(z² + square)`.
#[kernel]
pub fn rect_quadrature_tail(z: f32, square: f32) -> f32 {
    let root = sqrt(z * z + square);
    select(1.0 - z / root, square / (root * (root + abs(z))), z > 0.0)
}

/// A density over a range; `square` is its width's.
#[kernel]
pub fn rect_quadrature_warp(shift: f32, square: f32, range: Vec2) -> QuadratureWarp {
    let low = range.x + shift;
    let high = range.y + shift;
    let is_mirrored = low + high < 0.0;
    QuadratureWarp {
        shift,
        width: sqrt(square),
        mirror: select(1.0, -1.0, is_mirrored),
        low: rect_quadrature_tail(select(low, -high, is_mirrored), square),
        high: rect_quadrature_tail(select(high, -low, is_mirrored), square),
    }
}

/// The place below which there is the share `u` of a density.
#[kernel]
pub fn rect_quadrature_place(warp: QuadratureWarp, u: f32) -> QuadratureNode {
    let range = warp.low - warp.high;
    let tail = warp.low - range * u;
    let square = max(tail * (2.0 - tail), 1e-20);
    let scale = warp.width * inverse_sqrt(square);
    QuadratureNode { place: warp.mirror * (scale * (1.0 - tail)) - warp.shift, rate: range * scale / square }
}

/// Where Gauss and Legendre's three nodes are on 0 ..= 1.
#[kernel]
pub fn rect_quadrature_abscissa(k: u32) -> f32 {
    0.5 + 0.38729833462074168852 * (k as f32 - 1.0)
}

/// Their weights.
#[kernel]
pub fn rect_quadrature_weight(k: u32) -> f32 {
    select(0.27777777777777777778, 0.44444444444444444444, k == 1)
}
