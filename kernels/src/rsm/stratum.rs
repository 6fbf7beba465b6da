//! Lights of all texels of their strata.

use crate::rsm::chain::MapLevel;
use crate::rsm::curve::curve_texel;
use crate::rsm::draw::{DrawSettings, drawn_share};
use crate::rsm::light::{VirtualLight, light_of_mean};
use crate::rsm::mean::{OF_BOTH, map_mean_add, map_mean_nothing, map_mean_of, map_mean_share};
use crate::rsm::point::MapPoint;
use crate::rsm::scan::SCAN_BLOCK;
use crate::scene::NOWHERE;
use lobe_codegen::prelude::*;

/// The lights of all texels of their strata: a pass.
///
/// No texel is left out and none counts twice; one that lies in several strata is shared by them. The light's own texel, from
/// which it has its facets and is hidden or not, is the one that reflects most by facets, or, of matt ones, the middle one.
/// Source: our own.
#[kernel(workgroup_size(64))]
pub fn light_stratum_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] drawing: &DrawSettings,
    #[storage(0, 1)] levels: &[MapLevel],
    #[storage(0, 2)] map_points: &[MapPoint],
    #[storage(0, 3)] sums: &[Vec2],
    #[storage(0, 4)] block_sums: &[Vec2],
    #[storage(0, 5)] light_places: &[u32],
    #[storage(0, 6)] virtual_lights: &mut [VirtualLight],
) {
    let i = id.x;
    if i >= virtual_lights.len() as u32 {
        return;
    }
    let map = levels[0];
    let total = block_sums[(block_sums.len() as u32 - 1) as usize];
    let begin = i as f32 / drawing.count as f32;
    let end = (i as f32 + 1.0) / drawing.count as f32;
    let mut at = light_places[i as usize];
    let mut before = 0.0;
    if at > 0 {
        let block = (at - 1) / SCAN_BLOCK;
        let of_blocks = select(Vec2::ZERO, block_sums[(max(block, 1) - 1) as usize], block > 0);
        before = drawn_share(of_blocks + sums[(at - 1) as usize], total, drawing.floor_share);
    }
    let mut mean = map_mean_nothing();
    let mut glossiest = 0_u32;
    let mut central = 0_u32;
    let mut most = 0.0;
    while at < sums.len() as u32 && before < end {
        let block = at / SCAN_BLOCK;
        let of_blocks = select(Vec2::ZERO, block_sums[(max(block, 1) - 1) as usize], block > 0);
        let after = drawn_share(of_blocks + sums[at as usize], total, drawing.floor_share);
        let within = min(after, end) - max(before, begin);
        let texel = curve_texel(at, map);
        if texel != NOWHERE && within > 0.0 {
            let own = map_mean_of(map_points[texel as usize], drawing.origin, OF_BOTH);
            let part = map_mean_share(own, min(within / (after - before), 1.0));
            central = select(central, texel, before <= 0.5 * (begin + end) || mean.cover == 0.0);
            mean = map_mean_add(mean, part);
            if part.lobes.weight > most {
                most = part.lobes.weight;
                glossiest = texel;
            }
        }
        before = after;
        at += 1;
    }
    virtual_lights[i as usize] =
        light_of_mean(mean, drawing.origin, select(central, glossiest, most > 0.0), mean.cover);
}
