//! Points on the surfaces of a scene.

use crate::reference::random::uniform_of_bits;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Ritschel08, Roberts18};
use crate::rsm::draw::drawn_share;
use crate::rsm::scan::SCAN_BLOCK;
use crate::scene::Triangle;
use lobe_codegen::prelude::*;

/// A point on a surface, which hides what is behind it from both sides.
#[kernel]
pub struct Blocker {
    /// Where it is.
    pub position: Vec3,
    /// How much of the surfaces it stands for if it is the only one, in m².
    #[domain(0.0..=1e10)]
    pub area: f32,
    /// Unit normal of its triangle.
    #[domain(unit)]
    pub normal: Vec3,
    /// Index that its surface's triangles have.
    pub shape: u32,
}

/// Share of the points of which triangles have as many each; the others are by area.
#[kernel]
pub const EVEN_BLOCKERS: f32 = 0.5;

/// A triangle's area, in m², and its normal.
#[kernel]
pub struct TriangleSide {
    /// The area.
    pub area: f32,
    /// Unit normal.
    pub normal: Vec3,
}

/// A triangle's area and its normal.
#[kernel]
pub fn triangle_side(corners: Triangle) -> TriangleSide {
    let across = cross(corners.b - corners.a, corners.c - corners.a);
    let square = max(dot(across, across), 1e-30);
    let reciprocal = inverse_sqrt(square);
    TriangleSide { area: 0.5 * (square * reciprocal), normal: across * reciprocal }
}

/// Three uniform numbers of a sequence of which every run is spread evenly.
///
/// `frac(1/2 + i/gᵏ)` with `g⁴ = g + 1`, in whole numbers of 2^-32.
/// Source: [Roberts18], for three dimensions.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `index` | `i` | 32 bits | 1 |
///
/// Returns three multiples of 2^-24 in 0 ..= 1 - 2^-24; exact.
#[kernel]
pub fn spread_triple(index: u32) -> Vec3 {
    let x = index.wrapping_mul(3518319155).wrapping_add(2147483648);
    let y = index.wrapping_mul(2882110345).wrapping_add(2147483648);
    let z = index.wrapping_mul(2360945575).wrapping_add(2147483648);
    Vec3::new(uniform_of_bits(x), uniform_of_bits(y), uniform_of_bits(z))
}

/// A triangle's point, areas in proportion: what is beyond the diagonal of the square is turned back.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `a`, `b`, `c` | corners | -1e4 ..= 1e4 | m |
/// | `u` | two uniform numbers | 0 ..= 1 - 2^-24 | 1 |
#[kernel]
pub fn triangle_point(a: Vec3, b: Vec3, c: Vec3, u: Vec2) -> Vec3 {
    let is_beyond = u.x + u.y > 1.0;
    let along = select(u, Vec2::ONE - u, is_beyond);
    a + (along.x * (b - a) + along.y * (c - a))
}

/// The areas of triangles, in m², and a count of them: a pass, whose sums are those of [`crate::rsm::scan`].
#[kernel(workgroup_size(64))]
pub fn triangle_area_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] triangles: &[Triangle],
    #[storage(0, 1)] estimates: &mut [Vec2],
) {
    let i = id.x;
    if i < estimates.len() as u32 {
        estimates[i as usize] = Vec2::new(triangle_side(triangles[i as usize]).area, 1.0);
    }
}

/// Points on all triangles, half of them by area and half as many on each: a pass.
///
/// By area alone small things in large rooms would have hardly any.
/// Source: [Ritschel08]; the half is our own.
#[kernel(workgroup_size(64))]
pub fn blocker_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] triangles: &[Triangle],
    #[storage(0, 1)] estimates: &[Vec2],
    #[storage(0, 2)] sums: &[Vec2],
    #[storage(0, 3)] block_sums: &[Vec2],
    #[storage(0, 4)] blockers: &mut [Blocker],
) {
    let i = id.x;
    if i >= blockers.len() as u32 {
        return;
    }
    let u = spread_triple(i);
    let total = block_sums[(block_sums.len() as u32 - 1) as usize];
    // The first triangle whose share of all points, with those before it, is above the first number.
    let mut low = 0_u32;
    let mut high = triangles.len() as u32 - 1;
    while low < high {
        let middle = (low + high) / 2;
        let block = middle / SCAN_BLOCK;
        let before = select(Vec2::ZERO, block_sums[(max(block, 1) - 1) as usize], block > 0);
        if drawn_share(before + sums[middle as usize], total, EVEN_BLOCKERS) > u.x {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    let triangle = triangles[low as usize];
    let side = triangle_side(triangle);
    blockers[i as usize] = Blocker {
        position: triangle_point(triangle.a, triangle.b, triangle.c, Vec2::new(u.y, u.z)),
        area: side.area / max(drawn_share(estimates[low as usize], total, EVEN_BLOCKERS), 1e-9),
        normal: side.normal,
        shape: triangle.surface,
    };
}
