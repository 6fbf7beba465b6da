//! Rays and triangles.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Woop13;
use lobe_codegen::prelude::*;

/// A ray as the triangle test wants it: with its steepest axis for `z`, sheared so that it runs along it.
#[kernel]
pub struct ShearedRay {
    /// Where it begins.
    pub origin: Vec3,
    /// Which axis is the steepest: 0, 1 or 2.
    pub axis: u32,
    /// Slopes of the ray along the two others, and the inverse of its own.
    pub shear: Vec3,
}

/// The components of `v` in an order that has `axis` last.
#[kernel]
pub fn axis_last(v: Vec3, axis: u32) -> Vec3 {
    select(select(v, v.zxy(), axis == 1), v.yzx(), axis == 0)
}

/// Makes a ray ready for triangles.
///
/// Source: [Woop13] section 3.1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `origin` | where it begins | -100 ..= 100 | m |
/// | `dir` | its unit direction | sphere | 1 |
///
/// Returns the ray; the divisor is at least 1/√3.
#[kernel]
pub fn sheared_ray(origin: Vec3, dir: Vec3) -> ShearedRay {
    let steep = abs(dir);
    let y_or_z = select(1_u32, 2_u32, steep.z >= steep.y);
    let axis = select(y_or_z, 0_u32, steep.x > max(steep.y, steep.z));
    let turned = axis_last(dir, axis);
    let reciprocal = 1.0 / turned.z;
    ShearedRay { origin, axis, shear: Vec3::new(turned.x * reciprocal, turned.y * reciprocal, reciprocal) }
}

/// A corner as the ray sees it: from its origin, along its direction.
#[kernel]
pub fn sheared_corner(ray: ShearedRay, corner: Vec3) -> Vec3 {
    let from = axis_last(corner - ray.origin, ray.axis);
    Vec3::new(from.x - ray.shear.x * from.z, from.y - ray.shear.y * from.z, from.z)
}

/// Twice the signed area of the triangle of the ray and an edge.
///
/// `p_x q_y - p_y q_x`, evaluated from the lesser end to the greater.
/// Source: [Woop13] section 3.2, with an order of its own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `p`, `q` | ends of the edge, by [`sheared_corner`] | -1e4 ..= 1e4 | m |
///
/// Returns the area; that of the edge turned around is its negative to the last bit, since the same operations are on the
/// same numbers, fused or not: of two triangles with a common edge, one has what the other has not. A driver may still
/// fuse in one place and not in another.
#[kernel]
pub fn edge_area(p: Vec3, q: Vec3) -> f32 {
    let is_turned = p.x > q.x || (p.x == q.x && p.y > q.y);
    let low = select(p, q, is_turned);
    let high = select(q, p, is_turned);
    let area = low.x * high.y - low.y * high.x;
    select(area, -area, is_turned)
}

/// Where a ray meets a triangle, from either side.
///
/// The three [`edge_area`]s have one sign, or are 0; the distance is the mean of the corners' along the ray, weighted by
/// them.
/// Source: [Woop13].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `ray` | the ray, by [`sheared_ray`] | origin -100 ..= 100 | m |
/// | `a`, `b`, `c` | the corners | -100 ..= 100 | m |
///
/// Returns the distance along the ray, negative behind its origin; -1 where it misses, and for a triangle seen edge on.
/// A ray through a common edge or corner of triangles meets at least one of them.
///
/// Numerics: the distance errs by a few units in the last place of the corners' greatest one.
#[kernel]
pub fn triangle_distance(ray: ShearedRay, a: Vec3, b: Vec3, c: Vec3) -> f32 {
    let p = sheared_corner(ray, a);
    let q = sheared_corner(ray, b);
    let r = sheared_corner(ray, c);
    let u = edge_area(q, r);
    let v = edge_area(r, p);
    let w = edge_area(p, q);
    let sum = u + v + w;
    let least = min(u, min(v, w));
    let most = max(u, max(v, w));
    let is_met = (least >= 0.0 || most <= 0.0) && sum != 0.0;
    let along = (u * p.z + v * q.z + w * r.z) / select(1.0, sum, is_met);
    select(-1.0, along * ray.shear.z, is_met)
}
