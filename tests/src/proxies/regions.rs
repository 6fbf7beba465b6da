//! Regions of triangles that are nearly in a plane.

use super::Limits;
use super::adjacency::Neighbours;
use super::moments::{Moments, area};
use crate::scene::Triangle;
use std::collections::VecDeque;

/// Not in a region yet.
const FREE: u32 = u32::MAX;

/// The region of each triangle, numbered from 0. Regions begin with the largest triangle that is left.
pub(super) fn grow(triangles: &[Triangle], neighbours: &Neighbours, limits: &Limits) -> Vec<u32> {
    let mut region_of = vec![FREE; triangles.len()];
    let mut regions = 0;
    for seed in largest_first(triangles) {
        if region_of[seed] == FREE {
            fill(seed, regions, triangles, neighbours, limits, &mut region_of);
            regions += 1;
        }
    }
    region_of
}

fn largest_first(triangles: &[Triangle]) -> Vec<usize> {
    let areas: Vec<f64> = triangles.iter().map(area).collect();
    let mut order: Vec<usize> = (0..triangles.len()).collect();
    order.sort_by(|&a, &b| areas[b].total_cmp(&areas[a]));
    order
}

/// Grows one region in rings around its seed.
fn fill(
    seed: usize,
    region: u32,
    triangles: &[Triangle],
    neighbours: &Neighbours,
    limits: &Limits,
    region_of: &mut [u32],
) {
    let mut moments = Moments::of(&triangles[seed]);
    region_of[seed] = region;
    let mut waiting = VecDeque::from([seed]);
    while let Some(triangle) = waiting.pop_front() {
        for &next in neighbours.of(triangle) {
            let next = next as usize;
            let found = &triangles[next];
            if region_of[next] == FREE
                && kind(found) == kind(&triangles[seed])
                && fits(found, &moments, limits)
            {
                region_of[next] = region;
                moments = moments + Moments::of(found);
                waiting.push_back(next);
            }
        }
    }
}

/// What the triangles of a region have in common.
pub(super) fn kind(triangle: &Triangle) -> (usize, bool) {
    (triangle.material, triangle.two_sided)
}

fn fits(triangle: &Triangle, moments: &Moments, limits: &Limits) -> bool {
    let plane = moments.plane();
    triangle.normal.as_dvec3().dot(plane.normal) >= limits.least_cosine
        && triangle.vertices.iter().all(|vertex| plane.height(vertex.as_dvec3()).abs() <= limits.distance)
}
