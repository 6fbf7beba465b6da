//! Rays between pixels and virtual lights.

use crate::rsm::light::{VirtualLight, apart};
use crate::rsm::point::MapPoint;
use crate::rsm::shade::LightTurn;
use crate::scene::{NOWHERE, SceneRay, Seen, Surface};
use lobe_codegen::prelude::*;

/// The rays from each pixel to the texels of a turn's lights, a pixel's together: a pass.
#[kernel(workgroup_size(64))]
pub fn virtual_ray_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] lights_turn: &LightTurn,
    #[storage(0, 1)] seen: &[Seen],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] map_points: &[MapPoint],
    #[storage(0, 4)] virtual_lights: &[VirtualLight],
    #[storage(0, 5)] shadow_rays: &mut [SceneRay],
) {
    let i = id.x;
    if i >= shadow_rays.len() as u32 {
        return;
    }
    let pixel = seen[(i / lights_turn.count) as usize];
    let light = virtual_lights[(lights_turn.first + i % lights_turn.count) as usize];
    let point = map_points[light.texel as usize];
    let last = surfaces.len() as u32 - 1;
    let between = apart(point.position, pixel.position);
    let is_asked = pixel.surface != NOWHERE && point.surface != NOWHERE;
    shadow_rays[i as usize] = SceneRay {
        origin: pixel.position,
        reach: select(0.0, between.dist, is_asked),
        dir: between.dir,
        leaving: surfaces[min(pixel.surface, last) as usize].shape,
        reaching: surfaces[min(point.surface, last) as usize].shape,
    };
}
