//! Pixels in the maps of lights.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Ritschel08;
use crate::rsm::imperfect::blocker::Blocker;
use crate::rsm::imperfect::fill::MapDepth;
use crate::rsm::imperfect::share::ImperfectSettings;
use crate::rsm::imperfect::splat::{map_texel, parabolic};
use crate::rsm::light::{VirtualLight, apart};
use crate::rsm::point::MapPoint;
use crate::rsm::shade::LightTurn;
use crate::scene::{NOWHERE, Seen};
use lobe_codegen::prelude::*;

/// How far beside a plane something is that counts as on it, over the distance of pixel and light.
#[kernel]
pub const ON_PLANE: f32 = 1e-4;

/// Whether a point hides a light from a pixel in whose texel it is.
///
/// A texel is wide, and so is what a point stands for: how deep either is does not tell which is before the other, least of
/// all for surfaces that slant. Planes do: what hides a pixel is before the pixel's plane, and its own plane has the light
/// on one side and the pixel on the other. So no plane hides itself, nor do the outside and the inside of a convex body,
/// whatever a texel's size, and no bias is needed but for rounding.
/// Source: our own.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `blocker` | the point | | |
/// | `light` | where the light is | -1e4 ..= 1e4 | m |
/// | `pixel` | where the pixel is | -1e4 ..= 1e4 | m |
/// | `normal` | that of its surface | sphere | 1 |
/// | `dist` | from one to the other | 0 ..= 1e5 | m |
#[kernel]
pub fn is_between(blocker: Blocker, light: Vec3, pixel: Vec3, normal: Vec3, dist: f32) -> bool {
    let slack = ON_PLANE * dist;
    let is_before = dot(blocker.position - pixel, normal) > slack;
    let of_light = dot(light - blocker.position, blocker.normal);
    let of_pixel = dot(pixel - blocker.position, blocker.normal);
    let is_first = of_light > slack && of_pixel < -slack;
    let is_second = of_light < -slack && of_pixel > slack;
    is_before && (is_first || is_second)
}

/// Whether each pixel is seen from each of a turn's lights, by their maps, a pixel's together: a pass.
///
/// 1 for a pixel that nothing is before, else 0; 0 where there is no surface. A light is where its texel is; beyond its map
/// it sees all. Each level's point is asked, and that of the hole if the pixel is in one: the nearest may be of the pixel's
/// own plane while one behind it hides.
/// Source: [Ritschel08]; the test is our own ([`is_between`]).
#[kernel(workgroup_size(64))]
pub fn imperfect_shadow_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] imperfect: &ImperfectSettings,
    #[uniform(0, 1)] lights_turn: &LightTurn,
    #[storage(0, 2)] seen: &[Seen],
    #[storage(0, 3)] map_points: &[MapPoint],
    #[storage(0, 4)] virtual_lights: &[VirtualLight],
    #[storage(0, 5)] owners: &[u32],
    #[storage(0, 6)] map_depths: &[MapDepth],
    #[storage(0, 7)] blockers: &[Blocker],
    #[storage(0, 8)] visible: &mut [u32],
) {
    let i = id.x;
    if i >= visible.len() as u32 {
        return;
    }
    let k = i % lights_turn.count;
    let pixel = seen[(i / lights_turn.count) as usize];
    let light = virtual_lights[(lights_turn.first + k) as usize];
    let point = map_points[light.texel as usize];
    let between = apart(point.position, pixel.position);
    let is_asked = pixel.surface != NOWHERE && point.surface != NOWHERE;
    let place = map_texel(parabolic(light.normal, -between.dir), imperfect.side);
    let texel = min(place, imperfect.side * imperfect.side - 1);
    let row = texel / imperfect.side;
    let column = texel % imperfect.side;
    let mut side = imperfect.side;
    let mut first = 0_u32;
    let mut up = 0_u32;
    let mut asked = map_depths[(k * (side * side) + texel) as usize].blocker;
    let mut is_hidden = false;
    let mut is_done = !is_asked || place == NOWHERE;
    while !is_done {
        if asked != NOWHERE {
            let blocker = blockers[asked as usize];
            is_hidden = is_between(blocker, point.position, pixel.position, pixel.normal, between.dist);
        }
        is_done = is_hidden || side == 0;
        if !is_done {
            // An owner is an index and 1.
            let at = first + k * (side * side) + (row >> up) * side + (column >> up);
            asked = owners[at as usize].wrapping_sub(1);
            first += lights_turn.count * (side * side);
            side /= 2;
            up += 1;
        }
    }
    visible[i as usize] = select(0_u32, 1_u32, is_asked && !is_hidden);
}
