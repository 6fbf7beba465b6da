//! The tree of boxes, and what rays meet in it.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Ize13, Pharr23};
use crate::scene::triangle::{sheared_ray, triangle_distance};
use crate::scene::{BvhNode, Hit, NOWHERE, SceneRay, Triangle};
use lobe_codegen::prelude::*;

/// Boxes that wait while another is looked into: the length of `waiting` below. A tree of depth `d` needs `d + 1`.
#[kernel]
pub const BVH_DEPTH: u32 = 40;

/// By how much the exit from a box is late: more than the 3.5 ULP by which entry and exit may each be off.
#[kernel]
pub const EXIT_SLACK: f32 = 1.000004;

/// Nearer than this, in m, a ray meets nothing.
#[kernel]
pub const NEAREST: f32 = 1e-5;

/// The inverse of a component of a direction, finite where that is 0.
#[kernel]
pub fn inverse_component(x: f32) -> f32 {
    let size = max(abs(x), 1e-20);
    1.0 / select(size, -size, x < 0.0)
}

/// The inverse of a direction, finite where a component is 0.
#[kernel]
pub fn inverse_direction(dir: Vec3) -> Vec3 {
    Vec3::new(inverse_component(dir.x), inverse_component(dir.y), inverse_component(dir.z))
}

/// Where a ray enters a box.
///
/// The greatest of the three entries into the slabs, if it is not beyond the least of the exits.
/// Source: [Ize13], [Pharr23] section 6.1.2.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `node` | the box | -100 ..= 100 | m |
/// | `origin` | where the ray begins | -100 ..= 100 | m |
/// | `reciprocal` | of its direction: [`inverse_direction`] | 1 ..= 1e20 | 1 |
/// | `reach` | where it ends | 0 ..= 1e30 | m |
///
/// Returns the distance, at least 0; 1e30 for a box that it misses. A ray that meets something in the box does not
/// miss the box.
#[kernel]
pub fn box_distance(node: BvhNode, origin: Vec3, reciprocal: Vec3, reach: f32) -> f32 {
    let one = (node.low - origin) * reciprocal;
    let other = (node.high - origin) * reciprocal;
    let near = min(one, other);
    let far = max(one, other);
    let enter = max(max(near.x, near.y), max(near.z, 0.0));
    let leave = min(min(far.x, far.y), far.z) * EXIT_SLACK;
    select(1e30, enter, enter <= leave && enter <= reach)
}

/// What each ray meets first: a pass.
///
/// Of two triangles at the same distance it is the first in the tree.
#[kernel(workgroup_size(64))]
pub fn nearest_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] nodes: &[BvhNode],
    #[storage(0, 1)] triangles: &[Triangle],
    #[storage(0, 2)] rays: &[SceneRay],
    #[storage(0, 3)] hits: &mut [Hit],
) {
    let i = id.x;
    if i >= rays.len() as u32 {
        return;
    }
    let ray = rays[i as usize];
    let reciprocal = inverse_direction(ray.dir);
    let sheared = sheared_ray(ray.origin, ray.dir);
    let mut best = Hit { dist: ray.reach, surface: NOWHERE };
    let mut waiting = [0_u32; 40];
    let mut count = 1_u32;
    while count > 0 {
        count -= 1;
        let node = nodes[waiting[count as usize] as usize];
        if box_distance(node, ray.origin, reciprocal, best.dist) >= 1e30 {
            continue;
        }
        if node.count == 0 {
            // The nearer child is looked into first.
            let first = box_distance(nodes[node.first as usize], ray.origin, reciprocal, best.dist);
            let second = box_distance(nodes[(node.first + 1) as usize], ray.origin, reciprocal, best.dist);
            let nearer = select(0_u32, 1_u32, second < first);
            waiting[count as usize] = node.first + 1 - nearer;
            waiting[(count + 1) as usize] = node.first + nearer;
            count += 2;
        } else {
            for k in 0..node.count {
                let triangle = triangles[(node.first + k) as usize];
                let dist = triangle_distance(sheared, triangle.a, triangle.b, triangle.c);
                let is_left_out = triangle.surface == ray.leaving || triangle.surface == ray.reaching;
                if dist > NEAREST && dist < best.dist && !is_left_out {
                    best = Hit { dist, surface: triangle.surface };
                }
            }
        }
    }
    hits[i as usize] = best;
}

/// Whether each ray reaches its end: a pass.
///
/// 1 for a ray that nothing is in the way of, else 0; 0 for one that is not asked for.
#[kernel(workgroup_size(64))]
pub fn shadow_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] nodes: &[BvhNode],
    #[storage(0, 1)] triangles: &[Triangle],
    #[storage(0, 2)] shadow_rays: &[SceneRay],
    #[storage(0, 3)] visible: &mut [u32],
) {
    let i = id.x;
    if i >= shadow_rays.len() as u32 {
        return;
    }
    let ray = shadow_rays[i as usize];
    let reciprocal = inverse_direction(ray.dir);
    let sheared = sheared_ray(ray.origin, ray.dir);
    let mut waiting = [0_u32; 40];
    let mut count = select(0_u32, 1_u32, ray.reach > 0.0);
    let mut is_free = ray.reach > 0.0;
    while count > 0 {
        count -= 1;
        let node = nodes[waiting[count as usize] as usize];
        if box_distance(node, ray.origin, reciprocal, ray.reach) >= 1e30 {
            continue;
        }
        if node.count == 0 {
            waiting[count as usize] = node.first + 1;
            waiting[(count + 1) as usize] = node.first;
            count += 2;
        } else {
            for k in 0..node.count {
                let triangle = triangles[(node.first + k) as usize];
                let dist = triangle_distance(sheared, triangle.a, triangle.b, triangle.c);
                let is_left_out = triangle.surface == ray.leaving || triangle.surface == ray.reaching;
                if dist > NEAREST && dist < ray.reach && !is_left_out {
                    is_free = false;
                    count = 0;
                }
            }
        }
    }
    visible[i as usize] = select(0_u32, 1_u32, is_free);
}
