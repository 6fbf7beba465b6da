//! The rectangle of least area around points of a plane: one of its sides lies on their convex hull.

use super::moments::Plane;
use lobe_codegen::glam::{DVec2, DVec3};

/// A rectangle in a plane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rectangle {
    pub(super) middle: DVec3,
    /// Unit direction of its first sides.
    pub(super) tangent: DVec3,
    /// Half the lengths of its sides, m.
    pub(super) half: [f64; 2],
}

impl Rectangle {
    /// m².
    pub(super) fn area(&self) -> f64 {
        4.0 * self.half[0] * self.half[1]
    }
}

/// The rectangle around the projections of `points`, its longer sides first.
pub(super) fn around(points: &[DVec3], plane: &Plane) -> Rectangle {
    let (x, y) = plane.normal.any_orthonormal_pair();
    // So that x × y is the normal.
    let y = if x.cross(y).dot(plane.normal) < 0.0 { -y } else { y };
    let flat = points.iter().map(|&point| point - plane.point).map(|p| DVec2::new(p.dot(x), p.dot(y)));
    let [middle, along, half] = least(&hull(flat.collect()));
    let lift = |v: DVec2| x * v.x + y * v.y;
    let middle = plane.point + lift(middle);
    match half.x >= half.y {
        true => Rectangle { middle, tangent: lift(along), half: [half.x, half.y] },
        false => Rectangle { middle, tangent: lift(along.perp()), half: [half.y, half.x] },
    }
}

/// The points of a set that are extreme when it is seen along the normal.
pub(super) fn extremes(points: &[DVec3], plane: &Plane) -> Vec<DVec3> {
    let (x, y) = plane.normal.any_orthonormal_pair();
    let flat = |p: DVec3| DVec2::new((p - plane.point).dot(x), (p - plane.point).dot(y));
    hull(points.iter().map(|&p| flat(p)).collect())
        .into_iter()
        .map(|p| plane.point + x * p.x + y * p.y)
        .collect()
}

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let mut lower = chain(points.iter().copied());
    let mut upper = chain(points.iter().rev().copied());
    lower.pop();
    upper.pop();
    lower.append(&mut upper);
    if lower.is_empty() { points } else { lower }
}

fn chain(points: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let mut chain: Vec<DVec2> = Vec::new();
    for point in points {
        while let [.., a, b] = chain[..] {
            if (b - a).perp_dot(point - a) > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(point);
    }
    chain
}

/// Middle, direction and half sizes of the rectangle of least area around a convex polygon. Three corners, the farthest along,
/// across and back, go round with the side that lies on it (rotating calipers).
fn least(hull: &[DVec2]) -> [DVec2; 3] {
    let n = hull.len();
    let mut best = [hull.first().copied().unwrap_or_default(), DVec2::X, DVec2::ZERO];
    let (mut least, mut calipers) = (f64::INFINITY, [1, 1, 1]);
    for i in 0..n {
        let Some(along) = (hull[(i + 1) % n] - hull[i]).try_normalize() else { continue };
        let across = along.perp();
        let mut from = i + 1;
        for (caliper, axis) in calipers.iter_mut().zip([along, across, -along]) {
            *caliper = (*caliper).max(from);
            while (hull[(*caliper + 1) % n] - hull[*caliper % n]).dot(axis) > 0.0 {
                *caliper += 1;
            }
            from = *caliper;
        }
        let [right, top, left] = calipers.map(|caliper| hull[caliper % n] - hull[i]);
        let (low, high, height) = (left.dot(along), right.dot(along), top.dot(across));
        if (high - low) * height < least {
            least = (high - low) * height;
            let middle = hull[i] + along * (0.5 * (low + high)) + across * (0.5 * height);
            best = [middle, along, DVec2::new(0.5 * (high - low), 0.5 * height)];
        }
    }
    best
}
