//! Points in the maps of lights.

use crate::brdf::sampling::{frame_to_local, orthonormal_frame};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{HeidrichSeidel98, Ritschel08};
use crate::rsm::imperfect::blocker::Blocker;
use crate::rsm::imperfect::share::ImperfectSettings;
use crate::rsm::light::{VirtualLight, apart};
use crate::rsm::point::MapPoint;
use crate::rsm::shade::LightTurn;
use crate::scene::{NOWHERE, Surface};
use lobe_codegen::prelude::*;

/// A direction's place in a map about a normal.
///
/// `m = (w·x, w·y)/(1 + w·n)`: the hemisphere fills the unit disk, and what is below it the corners of the square.
/// Source: [HeidrichSeidel98].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `normal` | the map's middle | sphere | 1 |
/// | `dir` | unit direction away from the light | sphere | 1 |
///
/// Returns the place. Angles are those on the sphere, lengths there `2/(1 + |m|²)` times as long.
#[kernel]
pub fn parabolic(normal: Vec3, dir: Vec3) -> Vec2 {
    let local = frame_to_local(orthonormal_frame(normal), dir);
    Vec2::new(local.x, local.y) / max(1.0 + local.z, 0.01)
}

/// The texel of a place in a map; [`NOWHERE`] beyond the map.
#[kernel]
pub fn map_texel(place: Vec2, side: u32) -> u32 {
    let scaled = (0.5 * side as f32) * (place + Vec2::ONE);
    let is_within = max(abs(place.x), abs(place.y)) < 1.0;
    let column = min(max(scaled.x, 0.0) as u32, side - 1);
    let row = min(max(scaled.y, 0.0) as u32, side - 1);
    select(NOWHERE, row * side + column, is_within)
}

/// The level of a map at which a point is a texel large.
///
/// Level `l` has squares of `2^l` texels along a side; a texel in the middle is twice as wide as on the sphere, and one at
/// the hemisphere's rim as wide.
/// Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `solid_angle` | what the point fills | 0 ..= 1e10 | sr |
/// | `place` | where it is | -1 ..= 1 | 1 |
/// | `side` | texels along the map's side | 1 ..= 128 | 1 |
///
/// Returns the level whose squares are nearest in size to the point's.
#[kernel]
pub fn splat_level(solid_angle: f32, place: Vec2, side: u32) -> u32 {
    let shrunk = 0.5 * (1.0 + dot(place, place));
    let width = 0.5 * side as f32;
    // Twice the squared width in texels is above 4^l where the width is above 2^l over the root of 2.
    let doubled = 2.0 * (solid_angle * (width * width)) * (shrunk * shrunk);
    let mut level = 0_u32;
    let mut bar = 4.0;
    while doubled > bar && (side >> level) > 1 {
        level += 1;
        bar *= 4.0;
    }
    level
}

/// A point in a map.
#[kernel]
pub struct Splat {
    /// Its place in `codes`; [`NOWHERE`] of a point that is in no map.
    pub texel: u32,
    /// How far it is from the light, in m.
    #[domain(0.0..=1e5)]
    pub depth: f32,
    /// Its index in the set.
    pub blocker: u32,
}

/// Where points are in their lights' maps: a pass of an invocation each.
///
/// A point covers a square of about its area, in the level of the map that has such. A light's own surface hides nothing of
/// it.
/// Source: [Ritschel08]; levels in place of larger splats are our own.
#[kernel(workgroup_size(64))]
pub fn splat_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] imperfect: &ImperfectSettings,
    #[uniform(0, 1)] lights_turn: &LightTurn,
    #[storage(0, 2)] point_runs: &[u32],
    #[storage(0, 3)] virtual_lights: &[VirtualLight],
    #[storage(0, 4)] map_points: &[MapPoint],
    #[storage(0, 5)] surfaces: &[Surface],
    #[storage(0, 6)] blockers: &[Blocker],
    #[storage(0, 7)] splats: &mut [Splat],
) {
    let i = id.x;
    if i >= splats.len() as u32 {
        return;
    }
    let at = imperfect.first + i;
    // The turn's last light whose run begins no later.
    let mut low = 0_u32;
    let mut high = lights_turn.count - 1;
    while low < high {
        let middle = (low + high + 1) / 2;
        if point_runs[(lights_turn.first + middle) as usize] <= at {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    let index = lights_turn.first + low;
    let light = virtual_lights[index as usize];
    let origin = map_points[light.texel as usize];
    let member = at.wrapping_add(imperfect.shift) % blockers.len() as u32;
    let blocker = blockers[member as usize];
    let between = apart(blocker.position, origin.position);
    let own = surfaces[min(origin.surface, surfaces.len() as u32 - 1) as usize].shape;
    let place = parabolic(light.normal, between.dir);

    let run =
        max(point_runs[(index + 1) as usize], point_runs[index as usize] + 1) - point_runs[index as usize];
    let across = (blocker.area / run as f32) * abs(dot(blocker.normal, between.dir));
    let level = splat_level(across / max(between.dist * between.dist, 1e-12), place, imperfect.side);
    let mut side = imperfect.side;
    let mut first = 0_u32;
    for _ in 0..level {
        first += lights_turn.count * (side * side);
        side /= 2;
    }
    let texel = map_texel(place, side);
    let is_out = origin.surface == NOWHERE || blocker.shape == own || texel == NOWHERE;
    let code = first + low * (side * side) + texel;
    splats[i as usize] = Splat { texel: select(code, NOWHERE, is_out), depth: between.dist, blocker: member };
}

/// The nearest point of each texel: a pass of an invocation for each point.
///
/// `codes` has level after level, of each all maps. A code is 4294967295 less the bits of the depth, so 0 is a texel without a
/// point, and the nearest has the largest.
/// Source: [Ritschel08].
#[kernel(workgroup_size(64))]
pub fn splat_nearest_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] splats: &[Splat],
    #[storage(0, 1)] codes: &[AtomicU32],
) {
    let i = id.x;
    if i < splats.len() as u32 {
        let splat = splats[i as usize];
        if splat.texel < codes.len() as u32 {
            atomic_max(&codes[splat.texel as usize], NOWHERE - splat.depth.to_bits());
        }
    }
}

/// Which point is the nearest of each texel: a pass of an invocation for each point, when all depths are there.
///
/// `owners` is an index and 1, so 0 is a texel without a point; of points at the same depth it is the last.
/// Source: our own.
#[kernel(workgroup_size(64))]
pub fn splat_owner_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] splats: &[Splat],
    #[storage(0, 1)] codes: &[u32],
    #[storage(0, 2)] owners: &[AtomicU32],
) {
    let i = id.x;
    if i < splats.len() as u32 {
        let splat = splats[i as usize];
        let last = codes.len() as u32 - 1;
        let code = codes[min(splat.texel, last) as usize];
        if splat.texel <= last && code == NOWHERE - splat.depth.to_bits() {
            atomic_max(&owners[splat.texel as usize], splat.blocker + 1);
        }
    }
}
