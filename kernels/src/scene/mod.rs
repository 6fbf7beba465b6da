//! What a renderer traces: rays of a camera, triangles in a tree of boxes, lights.
//!
//! | file | what |
//! |---|---|
//! | [`camera`] | a ray through the middle of each pixel |
//! | [`triangle`] | where a ray meets a triangle, without gaps between neighbours |
//! | [`bvh`] | whether a ray meets a box; the passes that find what a ray meets |
//! | [`light`] | what arrives of a light at a point |
//! | [`direct`] | the passes that light pixels directly |
//! | [`texture`] | what a surface is like at a point, by textures and corners |
//! | [`point`] | the pass that finds it for points that rays met |
//!
//! All work is in passes: compute entry points over buffers, an invocation a ray or a pixel. A pass's parameters are
//! the names of its buffers, so passes that share a name share the buffer.
//!
//! Conventions: a surface is flat; it reflects on the side of its normal and hides what is behind it from both. A
//! surface hides nothing from itself: a ray leaves out the surface that it comes from, and the one that it goes to.

pub mod bvh;
pub mod camera;
pub mod direct;
pub mod light;
pub mod point;
pub mod texture;
pub mod triangle;

use crate::rect::Rectangle;
use lobe_codegen::prelude::*;

/// No surface: what a ray meets that meets nothing, and what it leaves out that leaves nothing out.
#[kernel]
pub const NOWHERE: u32 = 4294967295;

/// A triangle of a surface.
#[kernel]
pub struct Triangle {
    /// First corner.
    #[domain(-100.0..=100.0)]
    pub a: Vec3,
    /// Index of the surface.
    pub surface: u32,
    /// Second corner.
    #[domain(-100.0..=100.0)]
    pub b: Vec3,
    /// Third corner.
    #[domain(-100.0..=100.0)]
    pub c: Vec3,
}

/// A box of the tree, and what is in it.
#[kernel]
pub struct BvhNode {
    /// Its least corner.
    #[domain(-100.0..=100.0)]
    pub low: Vec3,
    /// The first of its triangles; of an inner node, the first of its two children, which are neighbours.
    pub first: u32,
    /// Its greatest corner.
    #[domain(-100.0..=100.0)]
    pub high: Vec3,
    /// How many triangles; 0 of an inner node.
    pub count: u32,
}

/// A ray, and what it leaves out.
#[kernel]
pub struct SceneRay {
    /// Where it begins.
    #[domain(-100.0..=100.0)]
    pub origin: Vec3,
    /// Where it ends, in lengths of `dir`; 0 or less for a ray that is not asked for.
    #[domain(0.0..=1e4)]
    pub reach: f32,
    /// Its unit direction.
    #[domain(unit)]
    pub dir: Vec3,
    /// The surface that it comes from.
    pub leaving: u32,
    /// The surface that it goes to.
    pub reaching: u32,
}

/// What a ray meets first.
#[kernel]
pub struct Hit {
    /// How far away, in m.
    #[domain(0.0..=1e4)]
    pub dist: f32,
    /// Which surface; [`NOWHERE`] if it meets none.
    pub surface: u32,
}

/// A flat surface: a rectangle, or the triangle over one of its sides.
#[kernel]
pub struct Surface {
    /// The rectangle; of a triangle, the one around it.
    pub rectangle: Rectangle,
    /// Index of the material.
    pub material: u32,
    /// Index that its triangles have: its own, or that of its front.
    pub shape: u32,
    /// The surface that is seen from behind it; [`NOWHERE`] where that is black.
    pub back: u32,
    /// Where along the upper side the apex of the triangle is, -1 ..= 1; 2 for the whole rectangle.
    #[domain(-1.0..=2.0)]
    pub apex: f32,
}

/// A pixel and what the camera sees in it.
#[kernel]
pub struct Seen {
    /// The point.
    pub position: Vec3,
    /// Its surface; [`NOWHERE`] where there is none, or it is seen from behind.
    pub surface: u32,
    /// Unit normal of the surface's plane, on the side that is seen.
    pub normal: Vec3,
    /// Index of what its surface is like there; [`NOWHERE`] where it is as everywhere on it.
    pub point_index: u32,
    /// Unit direction to the camera.
    pub view: Vec3,
}

/// The pixels that rays and what they meet make: a pass.
///
/// A surface that is seen from behind is black, unless another one is its back.
#[kernel(workgroup_size(64))]
pub fn seen_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] rays: &[SceneRay],
    #[storage(0, 1)] hits: &[Hit],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] seen: &mut [Seen],
) {
    let i = id.x;
    if i >= seen.len() as u32 {
        return;
    }
    let ray = rays[i as usize];
    let hit = hits[i as usize];
    let last = surfaces.len() as u32 - 1;
    let front = surfaces[min(hit.surface, last) as usize];
    let facing = dot(front.rectangle.normal, ray.dir);
    let behind = select(NOWHERE, front.back, facing > 0.0);
    let met = select(behind, hit.surface, facing < 0.0);
    let surface = select(NOWHERE, met, hit.surface != NOWHERE);
    seen[i as usize] = Seen {
        position: ray.origin + hit.dist * ray.dir,
        surface,
        normal: select(-front.rectangle.normal, front.rectangle.normal, facing < 0.0),
        point_index: NOWHERE,
        view: -ray.dir,
    };
}
