//! All virtual lights on each pixel.

use crate::brdf::Material;
use crate::reference::pass::{BounceSample, bounce_nothing, bounce_scaled};
use crate::reference::random::random_pair;
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Hasan09, Keller97, Tokuyoshi15};
use crate::rsm::light::{
    VirtualLight, apart, direction_in_cone, light_smoothness, point_parts, receiver_lobe, receiver_of_seen,
    vpl_light, vsgl_light_parts, vsl_smooth_parts,
};
use crate::rsm::point::MapPoint;
use crate::rsm::wide::{WideLight, wide_parts};
use crate::scene::texture::SurfacePoint;
use crate::scene::{NOWHERE, Seen, Surface};
use crate::vsgl::vsl_cone;
use lobe_codegen::prelude::*;

/// Which lights a pass adds, and how.
#[kernel]
pub struct LightTurn {
    /// The first one's index.
    pub first: u32,
    /// How many.
    #[domain(1.0..=65536.0)]
    pub count: u32,
    /// 1 where only those count that `visible` says are seen, else 0.
    pub is_shadowed: u32,
    /// Directions for each virtual spherical light, of [`vsl_pass`].
    #[domain(1.0..=1024.0)]
    pub directions: u32,
    /// Least distance of point lights, in m.
    #[domain(0.0..=1e4)]
    pub least: f32,
    /// Up to which sharpness over its cone a light's reflection counts as smooth: `α` of [Tokuyoshi15] section 3.3.
    #[domain(0.0..=1.0)]
    pub threshold: f32,
}

/// Light of a pixel by way of virtual lights.
#[kernel]
pub struct VirtualPixel {
    /// Radiance by the lobes of both surfaces, linear RGB.
    pub parts: BounceSample,
    /// How many lights were taken for smooth.
    pub smoothed: f32,
}

/// Two sums of a pixel together.
#[kernel]
pub fn parts_add(a: BounceSample, b: BounceSample) -> BounceSample {
    BounceSample {
        diffuse_of_diffuse: a.diffuse_of_diffuse + b.diffuse_of_diffuse,
        diffuse_of_glossy: a.diffuse_of_glossy + b.diffuse_of_glossy,
        glossy_of_diffuse: a.glossy_of_diffuse + b.glossy_of_diffuse,
        glossy_of_glossy: a.glossy_of_glossy + b.glossy_of_glossy,
    }
}

/// A pass that adds lights to pixels: what `$each` gives of a light, a [`VirtualPixel`].
macro_rules! light_pass {
    (
        $(#[$doc:meta])* $name:ident,
        |$receiver:ident, $lobe:ident = $own:expr, $light:ident, [$($points:ident: $point:ty)?], $turn:ident, $i:ident, $k:ident| $each:expr
    ) => {
        $(#[$doc])*
        #[kernel(workgroup_size(64))]
        pub fn $name(
            #[builtin(global_invocation_id)] id: UVec3,
            #[uniform(0, 0)] lights_turn: &LightTurn,
            #[storage(0, 1)] seen: &[Seen],
            #[storage(0, 2)] surfaces: &[Surface],
            #[storage(0, 3)] materials: &[Material],
            $(#[storage(0, 4)] $points: &[$point],)?
            #[storage(0, 5)] virtual_lights: &[VirtualLight],
            #[storage(0, 6)] visible: &[u32],
            #[storage(0, 7)] points: &[SurfacePoint],
            #[storage(0, 8)] virtual_pixels: &mut [VirtualPixel],
        ) {
            let $i = id.x;
            if $i >= virtual_pixels.len() as u32 {
                return;
            }
            let pixel = seen[$i as usize];
            if pixel.surface == NOWHERE {
                return;
            }
            let $turn = *lights_turn;
            let material = materials[surfaces[pixel.surface as usize].material as usize];
            let mut skin = SurfacePoint { material, normal: pixel.normal };
            if pixel.point_index != NOWHERE {
                skin = points[pixel.point_index as usize];
            }
            let $receiver = receiver_of_seen(pixel, skin);
            let $lobe = $own;
            let mut sum = virtual_pixels[$i as usize];
            for $k in 0..$turn.count {
                let is_seen = $turn.is_shadowed == 0 || visible[($i * $turn.count + $k) as usize] == 1;
                if is_seen {
                    let $light = virtual_lights[($turn.first + $k) as usize];
                    let added = $each;
                    sum = VirtualPixel {
                        parts: parts_add(sum.parts, added.parts),
                        smoothed: sum.smoothed + added.smoothed,
                    };
                }
            }
            virtual_pixels[$i as usize] = sum;
        }
    };
}

light_pass!(
    /// Adds virtual point lights: a pass.
    ///
    /// Source: [Keller97].
    vpl_pass,
    |receiver, _lobe = 0_u32, light, [map_points: MapPoint], turn, i, k| VirtualPixel {
        parts: vpl_light(receiver, map_points[light.texel as usize], light.weight, turn.least),
        smoothed: 1.0,
    }
);

light_pass!(
    /// Adds virtual lights with lobes: a pass.
    ///
    /// Source: [Tokuyoshi15] section 3.1.
    vsgl_pass,
    |receiver, lobe = receiver_lobe(receiver), light, [], turn, i, k| VirtualPixel {
        parts: vsgl_light_parts(receiver, lobe, light),
        smoothed: 0.0,
    }
);

light_pass!(
    /// Adds virtual lights with lobes, or without them where the reflection is smooth over the light's cone: a pass.
    ///
    /// Source: [Tokuyoshi15] section 3.3.
    vsgl_reduced_pass,
    |receiver, lobe = receiver_lobe(receiver), light, [map_points: MapPoint], turn, i, k| if light_smoothness(receiver, lobe, light)
        < turn.threshold
    {
        VirtualPixel {
            parts: vsl_smooth_parts(receiver, light, map_points[light.texel as usize]),
            smoothed: 1.0,
        }
    } else {
        VirtualPixel { parts: vsgl_light_parts(receiver, lobe, light), smoothed: 0.0 }
    }
);

light_pass!(
    /// Adds virtual spherical lights, by directions drawn in their cones: a pass.
    ///
    /// Source: [Hasan09] section 4.
    vsl_pass,
    |receiver, _lobe = 0_u32, light, [map_points: MapPoint], turn, i, k| {
        let between = apart(light.position, receiver.position);
        let point = map_points[light.texel as usize];
        let mut parts = bounce_nothing();
        for n in 0..turn.directions {
            let u = random_pair(i, (turn.first + k) * turn.directions + n, 8);
            parts = parts_add(parts, point_parts(receiver, point, direction_in_cone(between, light.radius, u)));
        }
        let scale = light.weight * vsl_cone(between.dist, light.radius).density / turn.directions as f32;
        VirtualPixel { parts: bounce_scaled(parts, Vec3::splat(scale)), smoothed: 0.0 }
    }
);

light_pass!(
    /// Adds virtual spherical lights with GGX lobes: a pass.
    vsl_wide_pass,
    |receiver, _lobe = 0_u32, _light, [wide_lights: WideLight], turn, i, k| VirtualPixel {
        parts: wide_parts(receiver, wide_lights[(turn.first + k) as usize]),
        smoothed: 0.0,
    }
);
