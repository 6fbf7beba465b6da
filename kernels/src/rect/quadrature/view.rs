//! The pixel, the rectangle and the light for the integral, and what of the rectangle is above the pixel's horizon.

use crate::rect::laplace::{Gloss, LaplaceReceiver, LaplaceReflector, rect_laplace_masked_root};
use lobe_codegen::prelude::*;

/// What the integrand depends on, in the rectangle's frame.
#[kernel]
pub struct QuadratureView {
    /// Unit direction to the light.
    pub light: Vec3,
    /// The pixel's unit normal.
    pub facing: Vec3,
    /// Unit direction from the pixel to the viewer.
    pub view: Vec3,
    /// Cosine of the view.
    pub cosine: f32,
    /// Height of the pixel above the rectangle's plane.
    pub height: f32,
    /// Where the edges of low and high x are, from the foot of the pixel's perpendicular.
    pub edges_x: Vec2,
    /// Where the edges of low and high y are.
    pub edges_y: Vec2,
    /// The rectangle's distribution.
    pub reflector: Gloss,
    /// The pixel's.
    pub receiver: Gloss,
    /// `√(α² + (1 - α²) c²)` of the rectangle, `c` being the light's cosine.
    pub light_root: f32,
    /// The same of the pixel, `c` being the view's cosine.
    pub view_root: f32,
}

/// A place of the rectangle, as the pixel sees it.
#[kernel]
pub struct QuadraturePlace {
    /// Where it is, from the foot of the pixel's perpendicular.
    pub offset: Vec2,
    /// Inverse of its distance from the pixel.
    pub nearness: f32,
    /// Part of the direction to it along the rectangle.
    pub along: Vec2,
    /// Part of the direction to it against the rectangle's normal: the cosine at the rectangle.
    pub down: f32,
    /// Cosine at the pixel.
    pub cosine: f32,
}

/// What the integrand depends on; `view` is the direction to the viewer in the rectangle's frame.
#[kernel]
pub fn rect_quadrature_view(
    reflector: LaplaceReflector,
    receiver: LaplaceReceiver,
    view: Vec3,
) -> QuadratureView {
    let own = reflector.gloss;
    let other = receiver.gloss;
    QuadratureView {
        light: reflector.light,
        facing: receiver.facing,
        view,
        cosine: receiver.cosine,
        height: receiver.offset.z,
        edges_x: receiver.edges_x,
        edges_y: receiver.edges_y,
        reflector: own,
        receiver: other,
        light_root: rect_laplace_masked_root(own.square, own.rest, reflector.light.z),
        view_root: rect_laplace_masked_root(other.square, other.rest, receiver.cosine),
    }
}

/// The same with the rectangle's two axes in each other's place, if `is_turned`.
#[kernel]
pub fn rect_quadrature_turned(view: QuadratureView, is_turned: bool) -> QuadratureView {
    QuadratureView {
        light: select(view.light, view.light.yxz(), is_turned),
        facing: select(view.facing, view.facing.yxz(), is_turned),
        view: select(view.view, view.view.yxz(), is_turned),
        cosine: view.cosine,
        height: view.height,
        edges_x: select(view.edges_x, view.edges_y, is_turned),
        edges_y: select(view.edges_y, view.edges_x, is_turned),
        reflector: view.reflector,
        receiver: view.receiver,
        light_root: view.light_root,
        view_root: view.view_root,
    }
}

/// The part of a range in which `slope` times the coordinate is above `level`; without extent if there is none.
#[kernel]
pub fn rect_quadrature_clip(slope: f32, level: f32, range: Vec2) -> Vec2 {
    let is_rising = slope > 0.0;
    let horizon = select(-level, level, is_rising) / max(abs(slope), 1e-6);
    let met = clamp(horizon, range.x, range.y);
    Vec2::new(select(range.x, met, is_rising), select(met, range.y, is_rising))
}

/// The range of y in which some of the rectangle is above the pixel's horizon.
#[kernel]
pub fn rect_quadrature_outer(view: QuadratureView) -> Vec2 {
    let facing = view.facing;
    let best = max(facing.x * view.edges_x.x, facing.x * view.edges_x.y);
    rect_quadrature_clip(facing.y, facing.z * view.height - best, view.edges_y)
}

/// The range of x that is above the pixel's horizon at `y`.
#[kernel]
pub fn rect_quadrature_inner(view: QuadratureView, y: f32) -> Vec2 {
    let facing = view.facing;
    rect_quadrature_clip(facing.x, facing.z * view.height - facing.y * y, view.edges_x)
}

/// A place of the rectangle.
#[kernel]
pub fn rect_quadrature_seen(view: QuadratureView, offset: Vec2) -> QuadraturePlace {
    let nearness = inverse_sqrt(dot(offset, offset) + view.height * view.height);
    let along = nearness * offset;
    let down = nearness * view.height;
    let cosine = view.facing.x * along.x + view.facing.y * along.y - view.facing.z * down;
    QuadraturePlace { offset, nearness, along, down, cosine }
}

/// Where a direction from the pixel meets the rectangle's plane, clamped to what of it is above the horizon.
#[kernel]
pub fn rect_quadrature_met(view: QuadratureView, dir: Vec3) -> QuadraturePlace {
    let met = view.height / max(-dir.z, 0.05) * dir.xy();
    let outer = rect_quadrature_outer(view);
    let y = clamp(met.y, outer.x, outer.y);
    let inner = rect_quadrature_inner(view, y);
    rect_quadrature_seen(view, Vec2::new(clamp(met.x, inner.x, inner.y), y))
}
