//! Direct light on pixels.

use crate::brdf::Material;
use crate::brdf::model::{glossy_part, surface_brdf_cosine};
use crate::scene::light::{SceneLight, light_at, ray_to_light};
use crate::scene::texture::{SurfacePoint, is_behind_plane};
use crate::scene::{NOWHERE, SceneRay, Seen, Surface};
use lobe_codegen::prelude::*;

/// Radiance of a pixel, of light that comes straight from the lights.
#[kernel]
pub struct DirectPixel {
    /// With shadows, linear RGB.
    pub shadowed: Vec3,
    /// Without.
    pub unshadowed: Vec3,
    /// Of that, what the glossy lobe reflects.
    pub unshadowed_specular: Vec3,
}

/// The rays from each pixel to each light, a pixel's together: a pass.
#[kernel(workgroup_size(64))]
pub fn light_ray_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] seen: &[Seen],
    #[storage(0, 1)] surfaces: &[Surface],
    #[storage(0, 2)] lights: &[SceneLight],
    #[storage(0, 3)] shadow_rays: &mut [SceneRay],
) {
    let i = id.x;
    if i >= shadow_rays.len() as u32 {
        return;
    }
    let count = lights.len() as u32;
    let pixel = seen[(i / count) as usize];
    let arriving = light_at(lights[(i % count) as usize], pixel.position);
    let last = surfaces.len() as u32 - 1;
    let shape = surfaces[min(pixel.surface, last) as usize].shape;
    let ray = ray_to_light(pixel.position, shape, arriving);
    let is_asked = pixel.surface != NOWHERE && dot(pixel.normal, arriving.dir) > 0.0;
    shadow_rays[i as usize] = SceneRay {
        origin: ray.origin,
        reach: select(0.0, ray.reach, is_asked),
        dir: ray.dir,
        leaving: ray.leaving,
        reaching: ray.reaching,
    };
}

/// The direct light of each pixel: a pass.
#[kernel(workgroup_size(64))]
pub fn direct_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] seen: &[Seen],
    #[storage(0, 1)] surfaces: &[Surface],
    #[storage(0, 2)] materials: &[Material],
    #[storage(0, 3)] points: &[SurfacePoint],
    #[storage(0, 4)] lights: &[SceneLight],
    #[storage(0, 5)] visible: &[u32],
    #[storage(0, 6)] direct: &mut [DirectPixel],
) {
    let i = id.x;
    if i >= direct.len() as u32 {
        return;
    }
    let pixel = seen[i as usize];
    let mut sum =
        DirectPixel { shadowed: Vec3::ZERO, unshadowed: Vec3::ZERO, unshadowed_specular: Vec3::ZERO };
    if pixel.surface != NOWHERE {
        let material = materials[surfaces[pixel.surface as usize].material as usize];
        let mut point = SurfacePoint { material, normal: pixel.normal };
        if pixel.point_index != NOWHERE {
            point = points[pixel.point_index as usize];
        }
        let glossy = glossy_part(point.material);
        let count = lights.len() as u32;
        for k in 0..count {
            let arriving = light_at(lights[k as usize], pixel.position);
            let all = surface_brdf_cosine(point.material, point.normal, arriving.dir, pixel.view);
            let specular = surface_brdf_cosine(glossy, point.normal, arriving.dir, pixel.view);
            let share = visible[(i * count + k) as usize] as f32;
            sum.shadowed += share * (arriving.irradiance * all);
            let is_behind = is_behind_plane(pixel.normal, point.normal, arriving.dir);
            let irradiance = select(arriving.irradiance, Vec3::ZERO, is_behind);
            sum.unshadowed += irradiance * all;
            sum.unshadowed_specular += irradiance * specular;
        }
    }
    direct[i as usize] = sum;
}
