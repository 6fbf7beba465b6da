//! The whole map as two lights, one of its diffuse and one of its glossy reflection.

use crate::brdf::Material;
use crate::brdf::lobe::sg_ndf_warp;
use crate::brdf::model::microfacet_reflectance;
use crate::filter::Moments;
use crate::reference::pass::BounceSample;
use crate::reference::running_mean::luminance;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Tokuyoshi15b;
use crate::rsm::chain::{ChainStep, MapLevel};
use crate::rsm::light::{Receiver, receiver_of_seen};
use crate::rsm::mean::{MapMean, OF_DIFFUSE};
use crate::rsm::shade::{VirtualPixel, parts_add};
use crate::scene::texture::SurfacePoint;
use crate::scene::{NOWHERE, Seen, Surface};
use crate::vsgl::{
    Vsgl, vsgl_diffuse, vsgl_diffuse_paper, vsgl_from_moments, vsgl_incoming, vsgl_specular,
    vsgl_specular_axis,
};
use lobe_codegen::prelude::*;

/// One of the two lights, and its colour.
#[kernel]
pub struct WholeLight {
    /// The light; its intensity is the luminance.
    pub light: Vsgl,
    /// Linear RGB over its luminance.
    #[domain(0.0..=20.0)]
    pub colour: Vec3,
}

/// The light of all texels.
///
/// Source: [Tokuyoshi15b] section 2, with half the trace for the variance.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `mean` | of all texels' diffuse or glossy lobes: the last of a chain | | |
/// | `origin` | where positions are counted from | -1e4 ..= 1e4 | m |
/// | `power` | linear RGB power that they reflect, in W | 0 ..= 1e6 | W |
#[kernel]
pub fn whole_light(mean: MapMean, origin: Vec3, power: Vec3) -> WholeLight {
    let sum = luminance(power);
    let lobes = Moments { weight: sum, ..mean.lobes };
    WholeLight {
        light: vsgl_from_moments(mean.positions, origin, lobes, Vec3::ZERO),
        colour: power / max(sum, 1e-30),
    }
}

/// The light of a chain's last mean: a pass of one invocation, for each of both parts.
#[kernel(workgroup_size(1))]
pub fn whole_light_pass(
    #[uniform(0, 0)] chain_step: &ChainStep,
    #[storage(0, 1)] levels: &[MapLevel],
    #[storage(0, 2)] map_means: &[MapMean],
    #[storage(0, 3)] whole_lights: &mut [WholeLight],
) {
    let level = levels[(levels.len() as u32 - 1) as usize];
    let mean = map_means[level.first as usize];
    let texels = levels[0].width as f32 * levels[0].height as f32;
    let all = texels / max(mean.cover, 1e-20);
    if chain_step.part == OF_DIFFUSE {
        whole_lights[0] = whole_light(mean, chain_step.origin, (crate::constants::PI * all) * mean.diffuse);
    } else {
        whole_lights[1] = whole_light(mean, chain_step.origin, all * mean.specular);
    }
}

/// Radiance that a receiver's glossy lobe reflects of a light.
///
/// Source: [Tokuyoshi15b] section 3.2.
#[kernel]
pub fn whole_glossy(receiver: Receiver, light: Vsgl) -> Vec3 {
    let own = receiver.material;
    let lobe = sg_ndf_warp(receiver.normal, receiver.view, own.alpha);
    let axis = vsgl_specular_axis(vsgl_incoming(light, receiver.position), lobe);
    let peak = microfacet_reflectance(own.f0, own.f90, own.alpha, receiver.normal, axis, receiver.view);
    // The cosine is in the peak.
    vsgl_specular(light, receiver.position, receiver.normal, receiver.view, own.alpha, 1.0) * peak
}

/// A pass that adds both lights to pixels, a diffuse lobe's by `$diffuse`.
macro_rules! whole_pass {
    ($(#[$doc:meta])* $name:ident, $diffuse:ident) => {
        $(#[$doc])*
        ///
        /// Source: [Tokuyoshi15b] section 3.2.
        #[kernel(workgroup_size(64))]
        pub fn $name(
            #[builtin(global_invocation_id)] id: UVec3,
            #[storage(0, 0)] seen: &[Seen],
            #[storage(0, 1)] surfaces: &[Surface],
            #[storage(0, 2)] materials: &[Material],
            #[storage(0, 3)] whole_lights: &[WholeLight],
            #[storage(0, 4)] points: &[SurfacePoint],
            #[storage(0, 5)] virtual_pixels: &mut [VirtualPixel],
        ) {
            let i = id.x;
            if i >= virtual_pixels.len() as u32 {
                return;
            }
            let pixel = seen[i as usize];
            if pixel.surface == NOWHERE {
                return;
            }
            let material = materials[surfaces[pixel.surface as usize].material as usize];
            let mut skin = SurfacePoint { material, normal: pixel.normal };
            if pixel.point_index != NOWHERE {
                skin = points[pixel.point_index as usize];
            }
            let receiver = receiver_of_seen(pixel, skin);
            let albedo = receiver.material.diffuse_albedo;
            let matt = whole_lights[0];
            let shiny = whole_lights[1];
            let of_matt = $diffuse(matt.light, receiver.position, receiver.normal, 1.0);
            let of_shiny = $diffuse(shiny.light, receiver.position, receiver.normal, 1.0);
            let parts = BounceSample {
                diffuse_of_diffuse: albedo * (of_matt * matt.colour),
                diffuse_of_glossy: albedo * (of_shiny * shiny.colour),
                glossy_of_diffuse: matt.colour * whole_glossy(receiver, matt.light),
                glossy_of_glossy: shiny.colour * whole_glossy(receiver, shiny.light),
            };
            let sum = virtual_pixels[i as usize];
            virtual_pixels[i as usize] =
                VirtualPixel { parts: parts_add(sum.parts, parts), smoothed: sum.smoothed };
        }
    };
}

whole_pass!(
    /// Adds both lights, clamped cosines by the hemispherical integral: a pass.
    vsgl_two_pass,
    vsgl_diffuse
);

whole_pass!(
    /// Adds both lights, clamped cosines as printed: a pass.
    vsgl_two_paper_pass,
    vsgl_diffuse_paper
);
