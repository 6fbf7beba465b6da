//! Points on a rectangle, and directions that meet it.

use crate::rect::Rectangle;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Pharr23;
use lobe_codegen::prelude::*;

/// A point on a rectangle.
///
/// `c + (2 u.x - 1) half_x t + (2 u.y - 1) half_y (n x t)`
/// Source: [Pharr23] section 6.6.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the rectangle | position -100 ..= 100, half extents 1e-3 ..= 100 | m |
/// | `u` | two numbers, uniform for a uniform point | 0 ..= 1 | 1 |
///
/// Returns the point.
#[kernel(
    family = "reference",
    cite = "[Pharr23] section 6.6",
    domain(u = 0.0..=1.0),
    budget(7e-7 * (length(rectangle.position) + rectangle.half_x + rectangle.half_y)),
    measured
)]
pub fn rectangle_point(rectangle: Rectangle, u: Vec2) -> Vec3 {
    let across = cross(rectangle.normal, rectangle.tangent);
    let x = (2.0 * u.x - 1.0) * rectangle.half_x;
    let y = (2.0 * u.y - 1.0) * rectangle.half_y;
    rectangle.position + x * rectangle.tangent + y * across
}

/// Where a ray from the reflecting side meets a rectangle's plane.
///
/// `t = (o - c)·n / (-d·n)`; `a = (o + t d - c)·t_x / half_x`, `b` likewise.
/// Source: [Pharr23] section 6.6.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `rectangle` | the rectangle | position -100 ..= 100, half extents 1e-3 ..= 100 | m |
/// | `origin` | `o` | -100 ..= 100 | m |
/// | `dir` | unit direction `d` | sphere | 1 |
///
/// Returns `a`, `b` and `t`. The ray meets the rectangle if `a` and `b` are in -1 ..= 1 and `t > 1e-6`
/// ([`rectangle_is_met`]). `t` is at most 0 for an origin that is not in front; for directions that do not
/// approach the plane the cosine is held at 1e-4, so that `t` is far and `a`, `b` are as the direction has it.
#[kernel(
    family = "reference",
    cite = "[Pharr23] section 6.6",
    domain(origin = -100.0..=100.0, dir = unit),
    budget(
        x = 1e-6 * (length(origin - rectangle.position) + abs(result.z)) * (2.0 + 1.0 / max(-dot(dir, rectangle.normal), 1e-4)) / rectangle.half_x
            + 5e-7 * (length(origin) + length(rectangle.position)) / rectangle.half_x + 1e-30,
        y = 1e-6 * (length(origin - rectangle.position) + abs(result.z)) * (2.0 + 1.0 / max(-dot(dir, rectangle.normal), 1e-4)) / rectangle.half_y
            + 5e-7 * (length(origin) + length(rectangle.position)) / rectangle.half_y + 1e-30,
        z = 1e-6 * (length(origin - rectangle.position) + abs(result.z)) / max(-dot(dir, rectangle.normal), 1e-4) + 1e-30
    ),
    measured
)]
pub fn rectangle_intersect(rectangle: Rectangle, origin: Vec3, dir: Vec3) -> Vec3 {
    let from_centre = origin - rectangle.position;
    let t = dot(from_centre, rectangle.normal) / max(-dot(dir, rectangle.normal), 1e-4);
    let place = from_centre + t * dir;
    let across = cross(rectangle.normal, rectangle.tangent);
    Vec3::new(
        dot(place, rectangle.tangent) / rectangle.half_x + 1e-30,
        dot(place, across) / rectangle.half_y + 1e-30,
        t,
    )
}

/// Whether a ray meets a rectangle, by [`rectangle_intersect`].
///
/// `|a| <= 1`, `|b| <= 1`, `t > 1e-6`
/// Source: [Pharr23] section 6.6.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `meeting` | what [`rectangle_intersect`] returned | any | 1, m |
///
/// Returns whether it does.
#[kernel(family = "reference", cite = "[Pharr23] section 6.6", domain(meeting = -2.0..=2.0), budget(0.0), measured)]
pub fn rectangle_is_met(meeting: Vec3) -> bool {
    max(abs(meeting.x), abs(meeting.y)) <= 1.0 && meeting.z > 1e-6
}
