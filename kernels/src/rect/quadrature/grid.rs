//! The nine places at which a lobe is looked at.

use crate::rect::laplace::LaplaceReceiver;
use crate::rect::quadrature::lobe::{
    QuadratureCross, QuadratureLobe, rect_quadrature_by_angle, rect_quadrature_conditional,
    rect_quadrature_cross, rect_quadrature_is_longer, rect_quadrature_marginal, rect_quadrature_start,
    rect_quadrature_turned_lobe,
};
use crate::rect::quadrature::view::{
    QuadraturePlace, QuadratureView, rect_quadrature_inner, rect_quadrature_outer, rect_quadrature_seen,
    rect_quadrature_turned,
};
use crate::rect::quadrature::warp::{
    QuadratureLine, QuadratureWarp, rect_quadrature_abscissa, rect_quadrature_along, rect_quadrature_line,
    rect_quadrature_place, rect_quadrature_weight,
};
use lobe_codegen::prelude::*;

/// A lobe over the rectangle, whose lines are along x.
#[kernel]
pub struct QuadratureGrid {
    /// What the integrand depends on.
    pub view: QuadratureView,
    /// Where the lobe is looked at from.
    pub offset: Vec2,
    /// The lobe, by half-angle coordinates.
    pub lobe: QuadratureLobe,
    /// The lines through the place.
    pub lines: QuadratureCross,
    /// Where the lines along x are.
    pub marginal: QuadratureWarp,
    /// 1 where the rectangle's axes are in each other's place, else 0.
    pub turned: u32,
}

/// A line along x.
#[kernel]
pub struct QuadratureRow {
    /// Where along y it is.
    pub y: f32,
    /// What it stands for of y.
    pub height: f32,
    /// The line as the pixel sees it.
    pub track: QuadratureLine,
    /// What of it is above the pixel's horizon.
    pub inner: Vec2,
    /// Where its places are.
    pub conditional: QuadratureWarp,
}

/// A place of a line.
#[kernel]
pub struct QuadratureSpot {
    /// The place, in the frame of [`QuadratureGrid::view`].
    pub place: QuadraturePlace,
    /// The area that it stands for.
    pub area: f32,
}

/// The grid of the rectangle's lobe, if `side` is 0, or of the pixel's.
#[kernel]
pub fn rect_quadrature_grid(seen: QuadratureView, receiver: LaplaceReceiver, side: u32) -> QuadratureGrid {
    let start = rect_quadrature_start(seen, receiver, side);
    let own_lines = rect_quadrature_cross(seen.height, start.place.offset);
    let own = rect_quadrature_by_angle(start.lobe, start.place, own_lines);
    let is_turned = rect_quadrature_is_longer(seen, own, own_lines);
    let view = rect_quadrature_turned(seen, is_turned);
    let lobe = rect_quadrature_turned_lobe(own, is_turned);
    let offset = select(start.place.offset, start.place.offset.yx(), is_turned);
    let lines = rect_quadrature_cross(view.height, offset);
    let marginal = rect_quadrature_marginal(view, offset, lobe, lines);
    QuadratureGrid { view, offset, lobe, lines, marginal, turned: select(0_u32, 1_u32, is_turned) }
}

/// The `i`-th of three lines.
#[kernel]
pub fn rect_quadrature_row(grid: QuadratureGrid, i: u32) -> QuadratureRow {
    let view = grid.view;
    let way = rect_quadrature_place(grid.marginal, rect_quadrature_abscissa(i));
    let y = rect_quadrature_along(grid.lines.y, way, rect_quadrature_outer(view));
    let inner = rect_quadrature_inner(view, y.place);
    let track = rect_quadrature_line(sqrt(view.height * view.height + y.place * y.place), grid.offset.x);
    QuadratureRow {
        y: y.place,
        height: rect_quadrature_weight(i) * y.rate,
        track,
        inner,
        conditional: rect_quadrature_conditional(grid.lobe, way.place, track, inner),
    }
}

/// The `k`-th of three places of a line.
#[kernel]
pub fn rect_quadrature_spot(grid: QuadratureGrid, row: QuadratureRow, k: u32) -> QuadratureSpot {
    let node = rect_quadrature_place(row.conditional, rect_quadrature_abscissa(k));
    let x = rect_quadrature_along(row.track, node, row.inner);
    QuadratureSpot {
        place: rect_quadrature_seen(grid.view, Vec2::new(x.place, row.y)),
        area: row.height * (rect_quadrature_weight(k) * x.rate),
    }
}

/// The direction to a place, in the rectangle's frame.
#[kernel]
pub fn rect_quadrature_towards(grid: QuadratureGrid, place: QuadraturePlace) -> Vec3 {
    let along = select(place.along, place.along.yx(), grid.turned == 1);
    Vec3::new(along.x, along.y, -place.down)
}
