//! A lobe about a place of the rectangle, and the lines and places where it is looked at.

use crate::rect::laplace::{LaplaceReceiver, rect_laplace_gloss};
use crate::rect::quadrature::view::{
    QuadraturePlace, QuadratureView, rect_quadrature_inner, rect_quadrature_met, rect_quadrature_outer,
};
use crate::rect::quadrature::warp::{
    QuadratureLine, QuadratureWarp, rect_quadrature_line, rect_quadrature_warp, rect_quadrature_ways,
};
use lobe_codegen::prelude::*;

/// The slope of a half vector from its surface's normal, and how it changes with the place.
///
/// The distribution is `∝ (square + |slope|²)^-2`, but for a factor that changes slowly.
#[kernel]
pub struct QuadratureLobe {
    /// The slope.
    pub slope: Vec2,
    /// Its derivative along x; by the way over the distance, or by the half-angle coordinate.
    pub by_x: Vec2,
    /// Its derivative along y.
    pub by_y: Vec2,
    /// `α²` of the distribution.
    pub square: f32,
}

/// The lobe of the rectangle's distribution.
#[kernel]
pub fn rect_quadrature_reflector_lobe(view: QuadratureView, place: QuadraturePlace) -> QuadratureLobe {
    let light = view.light;
    let along = place.along;
    let scale = 1.0 / (light.z + place.down);
    let slope = scale * (light.xy() - along);
    let level = light.xy() - light.z * slope;
    QuadratureLobe {
        slope,
        by_x: scale * Vec2::new(level.x * along.x - 1.0, level.y * along.x),
        by_y: scale * Vec2::new(level.x * along.y, level.y * along.y - 1.0),
        square: view.reflector.square,
    }
}

/// The lobe of the pixel's distribution, by the two tangents of its surface.
#[kernel]
pub fn rect_quadrature_receiver_lobe(receiver: LaplaceReceiver, place: QuadraturePlace) -> QuadratureLobe {
    let facing = receiver.facing.xy();
    let tangents = receiver.tangents;
    let along = place.along;
    // The floor is below what the view and a place above the horizon leave.
    let scale = 1.0 / max(place.cosine + receiver.cosine, 1e-3);
    let across = along.x * tangents.xz() + along.y * tangents.zy() - place.down * facing;
    let slope = scale * (across + receiver.view);
    let rise = facing + receiver.cosine * along;
    QuadratureLobe {
        slope,
        by_x: scale * (tangents.xz() + along.x * receiver.view - rise.x * slope),
        by_y: scale * (tangents.zy() + along.y * receiver.view - rise.y * slope),
        square: receiver.gloss.square,
    }
}

/// The pixel, looked at along its normal and of `alpha` 1: its lobe is about the same in all directions.
#[kernel]
pub fn rect_quadrature_upright(receiver: LaplaceReceiver) -> LaplaceReceiver {
    LaplaceReceiver {
        offset: receiver.offset,
        height2: receiver.height2,
        facing: receiver.facing,
        mirror: receiver.facing,
        cosine: 1.0,
        view: Vec2::ZERO,
        tangents: receiver.tangents,
        pull: 1.0,
        gloss: rect_laplace_gloss(1.0),
        extent: receiver.extent,
        edges_x: receiver.edges_x,
        edges_y: receiver.edges_y,
        corner: receiver.corner,
        top: receiver.top,
    }
}

/// Where a lobe is mirrored to, as far as the rectangle goes, and the lobe there.
#[kernel]
pub struct QuadratureStart {
    /// The place.
    pub place: QuadraturePlace,
    /// The lobe about it.
    pub lobe: QuadratureLobe,
}

/// The start for the rectangle's lobe, if `side` is 0, or for the pixel's.
#[kernel]
pub fn rect_quadrature_start(view: QuadratureView, receiver: LaplaceReceiver, side: u32) -> QuadratureStart {
    if side == 0 {
        let image = Vec3::new(view.light.x, view.light.y, -view.light.z);
        let place = rect_quadrature_met(view, image);
        return QuadratureStart { place, lobe: rect_quadrature_reflector_lobe(view, place) };
    }
    let place = rect_quadrature_met(view, receiver.mirror);
    QuadratureStart { place, lobe: rect_quadrature_receiver_lobe(receiver, place) }
}

/// The line along x through a place, and that along y, as [`rect_quadrature_line`] has them.
#[kernel]
pub struct QuadratureCross {
    /// Along x.
    pub x: QuadratureLine,
    /// Along y.
    pub y: QuadratureLine,
}

/// Both lines through a place.
#[kernel]
pub fn rect_quadrature_cross(height: f32, offset: Vec2) -> QuadratureCross {
    let square = height * height;
    QuadratureCross {
        x: rect_quadrature_line(sqrt(square + offset.y * offset.y), offset.x),
        y: rect_quadrature_line(sqrt(square + offset.x * offset.x), offset.y),
    }
}

/// The lobe by half-angle coordinates.
#[kernel]
pub fn rect_quadrature_by_angle(
    lobe: QuadratureLobe,
    place: QuadraturePlace,
    lines: QuadratureCross,
) -> QuadratureLobe {
    QuadratureLobe {
        slope: lobe.slope,
        by_x: lobe.by_x / (place.nearness * lines.x.across),
        by_y: lobe.by_y / (place.nearness * lines.y.across),
        square: lobe.square,
    }
}

/// The lobe with its two axes in each other's place, if `is_turned`.
#[kernel]
pub fn rect_quadrature_turned_lobe(lobe: QuadratureLobe, is_turned: bool) -> QuadratureLobe {
    QuadratureLobe {
        slope: lobe.slope,
        by_x: select(lobe.by_x, lobe.by_y, is_turned),
        by_y: select(lobe.by_y, lobe.by_x, is_turned),
        square: lobe.square,
    }
}

/// Whether the rectangle is more of the lobe's widths long along x than along y.
#[kernel]
pub fn rect_quadrature_is_longer(view: QuadratureView, lobe: QuadratureLobe, lines: QuadratureCross) -> bool {
    let x = rect_quadrature_ways(lines.x, view.edges_x);
    let y = rect_quadrature_ways(lines.y, view.edges_y);
    let by_x = (x.y - x.x) * lobe.by_x;
    let by_y = (y.y - y.x) * lobe.by_y;
    dot(by_x, by_x) > dot(by_y, by_y)
}

/// Where y is looked at: by the lobe's marginal density, as far as x can follow the lobe within the rectangle.
#[kernel]
pub fn rect_quadrature_marginal(
    view: QuadratureView,
    offset: Vec2,
    lobe: QuadratureLobe,
    lines: QuadratureCross,
) -> QuadratureWarp {
    let inner = rect_quadrature_ways(lines.x, rect_quadrature_inner(view, offset.y));
    let stretch2 = max(dot(lobe.by_x, lobe.by_x), 1e-6);
    let stretch = sqrt(stretch2);
    // Slope and derivative along what x changes of the slope, and across it.
    let level = lobe.by_x / stretch;
    let across = Vec2::new(-level.y, level.x);
    let own = dot(lobe.slope, across);
    let own_rate = dot(lobe.by_y, across);
    let other_rate = dot(lobe.by_y, level);
    let other = dot(lobe.slope, level);
    // What is left of the slope where x has done what it can.
    let left = other + stretch * clamp(-other / stretch, inner.x, inner.y);
    let core = lobe.square + left * left;
    let extent = 0.5 * (inner.y - inner.x);
    let stiffness = core / (core + stretch2 * (extent * extent));
    let second = max(own_rate * own_rate + stiffness * (other_rate * other_rate), 1e-6);
    let skew = (own * other_rate - left * own_rate) / second;
    let width2 = (lobe.square + (1.0 - stiffness) * (left * left)) / second + stiffness * (skew * skew);
    let shift = (own * own_rate + stiffness * left * other_rate) / second;
    let outer = rect_quadrature_ways(lines.y, rect_quadrature_outer(view));
    rect_quadrature_warp(shift, max(width2, 1e-12), outer)
}

/// Where x is looked at, `way` along y from the place in half angles: by the lobe's density on the line `row`.
#[kernel]
pub fn rect_quadrature_conditional(
    lobe: QuadratureLobe,
    way: f32,
    row: QuadratureLine,
    range: Vec2,
) -> QuadratureWarp {
    let slope = lobe.slope + way * lobe.by_y;
    let along = lobe.by_x;
    let second = max(dot(along, along), 1e-6);
    let area = slope.x * along.y - slope.y * along.x;
    let width2 = (lobe.square + area * area / second) / second;
    rect_quadrature_warp(dot(slope, along) / second, max(width2, 1e-12), rect_quadrature_ways(row, range))
}
