//! Texels drawn by their density, and the lights that they make out of the squares around them.

use crate::reference::random::random_pair;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{KrivanekColbert08, Ritschel11, Tokuyoshi15};
use crate::rsm::chain::{MapLevel, place_in};
use crate::rsm::curve::curve_texel;
use crate::rsm::light::{VirtualLight, light_of_mean};
use crate::rsm::mean::{MapMean, OF_BOTH, map_mean_add, map_mean_nothing, map_mean_of, map_mean_share};
use crate::rsm::point::MapPoint;
use crate::rsm::scan::SCAN_BLOCK;
use crate::vsgl::{brsm_weight, vsl_mip_level};
use lobe_codegen::prelude::*;

/// How lights are drawn.
#[kernel]
pub struct DrawSettings {
    /// Where positions are counted from.
    #[domain(-1e4..=1e4)]
    pub origin: Vec3,
    /// How many lights, `N`.
    #[domain(1.0..=65536.0)]
    pub count: u32,
    /// How many times the square that a light has on the average it is read from, `k`; 0 reads the texel itself.
    #[domain(0.0..=100.0)]
    pub smoothing: f32,
    /// Share of the lights that are drawn by what texels reflect and not by what of it matters.
    #[domain(1e-3..=1.0)]
    pub floor_share: f32,
    /// What makes one frame's numbers differ from another's.
    pub frame: u32,
    /// 1 where glossy lobes are the mean ones of what is read, 0 where they are the texel's.
    pub are_lobes_filtered: u32,
    /// 1 for numbers by chance within their strata, 0 for the middles.
    pub is_random: u32,
    /// 1 where lights are of whole strata, which are asked for by where they begin.
    pub is_whole: u32,
}

/// Density of what was drawn up to a texel, from the two sums of [`crate::rsm::scan`].
///
/// `(1 - ε) e/E + ε f/F`; without any estimate `f/F`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `sum`, `total` | sums up to a texel, and of all: estimates, reflected power | 0 ..= 1e30 | any |
/// | `floor_share` | `ε` | 1e-3 ..= 1 | 1 |
///
/// Returns the share of all lights, 0 ..= 1.
#[kernel]
pub fn drawn_share(sum: Vec2, total: Vec2, floor_share: f32) -> f32 {
    let by_power = select(1.0, floor_share, total.x > 0.0);
    (1.0 - by_power) * (sum.x / max(total.x, 1e-30)) + by_power * (sum.y / max(total.y, 1e-30))
}

/// Where along the curve lights are drawn: a pass.
///
/// Each light has a stratum of its own: its middle, a place by chance, or where it begins.
#[kernel(workgroup_size(64))]
pub fn light_place_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] drawing: &DrawSettings,
    #[storage(0, 1)] sums: &[Vec2],
    #[storage(0, 2)] block_sums: &[Vec2],
    #[storage(0, 3)] light_places: &mut [u32],
) {
    let i = id.x;
    if i >= light_places.len() as u32 {
        return;
    }
    let total = block_sums[(block_sums.len() as u32 - 1) as usize];
    let chance = random_pair(i, drawing.frame, 7);
    let drawn = select(0.5, chance.x, drawing.is_random == 1);
    let within = select(drawn, 0.0, drawing.is_whole == 1);
    let u = (i as f32 + within) / drawing.count as f32;

    // The first place whose sum is above `u`.
    let mut low = 0_u32;
    let mut high = sums.len() as u32 - 1;
    while low < high {
        let middle = (low + high) / 2;
        let block = middle / SCAN_BLOCK;
        let before = select(Vec2::ZERO, block_sums[(max(block, 1) - 1) as usize], block > 0);
        if drawn_share(before + sums[middle as usize], total, drawing.floor_share) > u {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    light_places[i as usize] = low;
}

/// The lights that are drawn: a pass.
///
/// A texel is read at the level that its density asks for, between four means of each of the two levels next to it.
/// Source: [Ritschel11] section 4, [Tokuyoshi15] section 3.2 ([KrivanekColbert08]).
#[kernel(workgroup_size(64))]
pub fn light_draw_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] drawing: &DrawSettings,
    #[storage(0, 1)] levels: &[MapLevel],
    #[storage(0, 2)] map_points: &[MapPoint],
    #[storage(0, 3)] map_means: &[MapMean],
    #[storage(0, 4)] estimates: &[Vec2],
    #[storage(0, 5)] block_sums: &[Vec2],
    #[storage(0, 6)] light_places: &[u32],
    #[storage(0, 7)] virtual_lights: &mut [VirtualLight],
) {
    let i = id.x;
    if i >= virtual_lights.len() as u32 {
        return;
    }
    let map = levels[0];
    let total = block_sums[(block_sums.len() as u32 - 1) as usize];
    // Where there is no density, it may lead beside the map.
    let texel = min(curve_texel(light_places[i as usize], map), map.width * map.height - 1);
    let all = map.width as f32 * map.height as f32;
    let pdf = all * drawn_share(estimates[texel as usize], total, drawing.floor_share);
    let weight = select(0.0, all * brsm_weight(pdf, drawing.count as f32), pdf > 1e-9);

    let point = map_points[texel as usize];
    let own = map_mean_of(point, drawing.origin, OF_BOTH);
    let mut mean = own;
    if drawing.smoothing > 0.0 {
        let last = (levels.len() as u32 - 1) as f32;
        let level = vsl_mip_level(last, drawing.count as f32, drawing.smoothing, pdf);
        let lower = min(level as u32, levels.len() as u32 - 1);
        mean = map_mean_nothing();
        for step in 0_u32..2 {
            let at = min(lower + step, levels.len() as u32 - 1);
            let blend = level - lower as f32;
            let of_level = select(1.0 - blend, blend, step == 1);
            let size = (1_u32 << at) as f32;
            let x = ((texel % map.width) as f32 + 0.5) / size - 0.5;
            let y = ((texel / map.width) as f32 + 0.5) / size - 0.5;
            for corner in 0_u32..4 {
                let left = floor(x) + (corner % 2) as f32;
                let top = floor(y) + (corner / 2) as f32;
                let share = of_level * ((1.0 - abs(x - left)) * (1.0 - abs(y - top)));
                if share > 0.0 {
                    let place = place_in(levels[at as usize], max(left, 0.0) as u32, max(top, 0.0) as u32);
                    let part = if at == 0 {
                        map_mean_of(map_points[place as usize], drawing.origin, OF_BOTH)
                    } else {
                        map_means[place as usize]
                    };
                    mean = map_mean_add(mean, map_mean_share(part, share));
                }
            }
        }
    }
    if drawing.are_lobes_filtered == 0 {
        mean = MapMean { lobes: own.lobes, ..mean };
    }
    virtual_lights[i as usize] = light_of_mean(mean, drawing.origin, texel, weight);
}
