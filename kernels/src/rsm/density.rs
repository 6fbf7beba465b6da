//! How much each texel of a light's map matters to what the camera sees.
//!
//! A map of the camera is reduced to some tens of virtual lights, and the light's texels are lit by these.

use crate::constants::PI;
use crate::reference::pass::BounceSample;
use crate::reference::running_mean::luminance;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Ritschel11, Tokuyoshi15};
use crate::rsm::chain::{ChainStep, MapLevel};
use crate::rsm::light::{Receiver, VirtualLight, light_of_mean, receiver_lobe, vpl_light, vsgl_light_parts};
use crate::rsm::mean::{MapMean, OF_BOTH, map_mean_of};
use crate::rsm::point::MapPoint;
use crate::scene::NOWHERE;
use lobe_codegen::prelude::*;

/// The luminance of all parts.
#[kernel]
pub fn parts_luminance(parts: BounceSample) -> f32 {
    luminance(
        (parts.diffuse_of_diffuse + parts.diffuse_of_glossy)
            + (parts.glossy_of_diffuse + parts.glossy_of_glossy),
    )
}

/// The lights that the means of a level of the camera's map make: a pass.
#[kernel(workgroup_size(64))]
pub fn view_light_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] chain_step: &ChainStep,
    #[storage(0, 1)] levels: &[MapLevel],
    #[storage(0, 2)] map_means: &[MapMean],
    #[storage(0, 3)] view_lights: &mut [VirtualLight],
) {
    let i = id.x;
    if i >= view_lights.len() as u32 {
        return;
    }
    let mean = map_means[(levels[chain_step.level as usize].first + i) as usize];
    view_lights[i as usize] = light_of_mean(mean, chain_step.origin, i, mean.cover);
}

/// The points in the middle of what the means of a level of the camera's map are of: a pass.
#[kernel(workgroup_size(64))]
pub fn view_point_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] chain_step: &ChainStep,
    #[storage(0, 1)] levels: &[MapLevel],
    #[storage(0, 2)] map_points: &[MapPoint],
    #[storage(0, 3)] view_points: &mut [MapPoint],
) {
    let i = id.x;
    if i >= view_points.len() as u32 {
        return;
    }
    let level = levels[chain_step.level as usize];
    let map = levels[0];
    let half = (1_u32 << chain_step.level) / 2;
    let column = min(((i % level.width) << chain_step.level) + half, map.width - 1);
    let row = min(((i / level.width) << chain_step.level) + half, map.height - 1);
    view_points[i as usize] = map_points[(row * map.width + column) as usize];
}

/// What a point of a light's map receives of the camera's lights.
#[kernel]
pub fn receiver_of_point(vpl: MapPoint) -> Receiver {
    Receiver { position: vpl.position, normal: vpl.normal, view: vpl.dir, material: vpl.material }
}

/// Luminance of the power that a point's texel reflects, about: what every texel counts for at least.
#[kernel]
pub fn point_power(vpl: MapPoint) -> f32 {
    let mean = map_mean_of(vpl, vpl.position, OF_BOTH);
    PI * luminance(mean.diffuse) + luminance(mean.specular)
}

/// A pass that weighs texels by `$view`: what `$each` gives of one of them, lit and seen as `$receiver`.
macro_rules! density_pass {
    (
        $(#[$doc:meta])* $name:ident, $view:ident: $light:ty,
        |$receiver:ident, $lobe:ident = $own:expr, $k:ident| $each:expr
    ) => {
        $(#[$doc])*
        #[kernel(workgroup_size(64))]
        pub fn $name(
            #[builtin(global_invocation_id)] id: UVec3,
            #[storage(0, 0)] map_points: &[MapPoint],
            #[storage(0, 1)] $view: &[$light],
            #[storage(0, 2)] estimates: &mut [Vec2],
        ) {
            let i = id.x;
            if i >= estimates.len() as u32 {
                return;
            }
            let texel = map_points[i as usize];
            let mut sum = 0.0;
            let mut power = 0.0;
            if texel.surface != NOWHERE {
                let $receiver = receiver_of_point(texel);
                let $lobe = $own;
                power = point_power(texel);
                if power > 0.0 {
                    for $k in 0..$view.len() as u32 {
                        sum += parts_luminance($each);
                    }
                }
            }
            estimates[i as usize] = Vec2::new(sum * luminance(texel.flux), power);
        }
    };
}

density_pass!(
    /// How much each texel matters, by lights with extent, and what it reflects: a pass.
    ///
    /// Source: [Tokuyoshi15] section 3: virtual spherical-Gaussian lights out of the camera's map, without shadows.
    density_pass,
    view_lights: VirtualLight,
    |receiver, lobe = receiver_lobe(receiver), k| vsgl_light_parts(receiver, lobe, view_lights[k as usize])
);

density_pass!(
    /// How much each texel matters, by points, and what it reflects: a pass.
    ///
    /// Source: [Ritschel11] section 4.
    density_point_pass,
    view_points: MapPoint,
    |receiver, _lobe = 0_u32, k| vpl_light(receiver, view_points[k as usize], 1.0, 0.0)
);
