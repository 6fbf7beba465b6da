//! How many points each light's map has.

use crate::constants::PI;
use crate::reference::running_mean::luminance;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Ritschel11;
use crate::rsm::draw::drawn_share;
use crate::rsm::light::VirtualLight;
use crate::rsm::scan::SCAN_BLOCK;
use crate::sg::sg_integral;
use lobe_codegen::prelude::*;

/// How imperfect shadow maps are made.
#[kernel]
pub struct ImperfectSettings {
    /// Points of all lights together.
    #[domain(1.0..=4294967295.0)]
    pub points: u32,
    /// Share of the points of which each light has as many.
    #[domain(0.0..=1.0)]
    pub floor_share: f32,
    /// Texels along a side of a light's map, a power of 2.
    #[domain(1.0..=128.0)]
    pub side: u32,
    /// The first point that is splatted.
    pub first: u32,
    /// Where in the set the first light's run begins.
    pub shift: u32,
}

/// Luminance of the power that a light sends, in W.
#[kernel]
pub fn sent_power(light: VirtualLight) -> f32 {
    PI * luminance(light.diffuse) + sg_integral(light.sharpness) * luminance(light.specular)
}

/// What each light sends, and a count of it: a pass, whose sums are those of [`crate::rsm::scan`].
#[kernel(workgroup_size(64))]
pub fn sent_power_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] virtual_lights: &[VirtualLight],
    #[storage(0, 1)] estimates: &mut [Vec2],
) {
    let i = id.x;
    if i < estimates.len() as u32 {
        estimates[i as usize] = Vec2::new(sent_power(virtual_lights[i as usize]), 1.0);
    }
}

/// Where each light's run of points begins, and the last one's ends: a pass of one invocation more than there are lights.
///
/// Lights have points in proportion to what they send; a share is for all alike.
/// Source: the paper's maps are adaptive ([Ritschel11]); what decides here is our own.
#[kernel(workgroup_size(64))]
pub fn point_run_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] imperfect: &ImperfectSettings,
    #[storage(0, 1)] sums: &[Vec2],
    #[storage(0, 2)] block_sums: &[Vec2],
    #[storage(0, 3)] point_runs: &mut [u32],
) {
    let i = id.x;
    let lights = point_runs.len() as u32 - 1;
    if i > lights {
        return;
    }
    let last = max(i, 1) - 1;
    let block = last / SCAN_BLOCK;
    let total = block_sums[(block_sums.len() as u32 - 1) as usize];
    let before = select(Vec2::ZERO, block_sums[(max(block, 1) - 1) as usize], block > 0);
    let share = drawn_share(before + sums[last as usize], total, imperfect.floor_share);
    let within = min((share * imperfect.points as f32) as u32, imperfect.points);
    let begin = select(within, 0_u32, i == 0);
    point_runs[i as usize] = select(begin, imperfect.points, i == lights);
}
