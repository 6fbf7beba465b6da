//! Shadows of the rectangle method: of each lobe's light, one point of the rectangle is asked for.
//!
//! The method's integrals know nothing of what stands between. But the closed form says where on the rectangle most of the
//! light leaves it ([`rect_laplace_split`] and [`rect_laplace_matt`]; of two matt surfaces, the rectangle's middle). A ray
//! from the pixel to that point and one from there to the light say for all of a lobe's light whether it comes: a shadow
//! without penumbra, where the truth has soft ones.
//!
//! One rectangle after the other takes its turn, and of many pixels some after others, for the rays of all together would
//! not fit: [`rect_shadow_ray_pass`] asks, [`crate::scene::bvh::shadow_pass`] answers, [`rect_shadowed_pass`] adds.
//!
//! [`super::soft_shadow`] asks for more points.

use crate::brdf::Material;
use crate::rect::Rectangle;
use crate::rect::laplace::{
    LaplaceIntegral, LaplaceSplit, rect_laplace_bitangent, rect_laplace_matt, rect_laplace_receiver,
    rect_laplace_split,
};
use crate::rect::pass::{RectProxy, light_share};
use crate::rect::pixel::{
    RectBounce, RectPixel, rect_laplace_direction, rect_laplace_lit, rect_pixel_add, rect_pixel_laplace,
    rect_receiver,
};
use crate::scene::light::{SceneLight, light_at};
use crate::scene::{NOWHERE, SceneRay, Seen, Surface};
use lobe_codegen::prelude::*;

/// Rays of a pixel and light: for each of [`RectPixel`]'s parts one to the rectangle and one from there to the light.
#[kernel]
pub const SHADOW_RAYS: u32 = 6;

/// Whose turn it is.
#[kernel]
pub struct ShadowTurn {
    /// The rectangle.
    pub index: u32,
    /// How far the surface may be from its rectangle, in m: nothing so near to it is in the way.
    #[domain(0.0..=100.0)]
    pub slack: f32,
    /// The first of the pixels that are asked for.
    pub first: u32,
    /// How many are asked for.
    pub count: u32,
}

/// Where the light of each of [`RectPixel`]'s parts leaves the rectangle, on the whole: directions from the pixel.
#[kernel]
pub struct ShadowDirections {
    /// Of the glossy lobe: that of the spot with more light.
    pub specular: Vec3,
    /// Of the diffuse lobe.
    pub diffuse: Vec3,
    /// Of the diffuse lobe, by the rectangle's diffuse lobe: to its middle.
    pub diffuse_of_diffuse: Vec3,
}

/// The directions of a pixel, rectangle and light.
#[kernel]
pub fn shadow_directions(bounce: RectBounce) -> ShadowDirections {
    let bitangent = rect_laplace_bitangent(bounce.rectangle);
    let receiver = rect_laplace_receiver(bounce.rectangle, bitangent, rect_receiver(bounce));
    let reflector = rect_laplace_lit(bounce, bitangent);
    let split = rect_laplace_split(reflector, receiver);
    let matt = rect_laplace_matt(reflector, receiver);
    let stronger = shadow_stronger(split);
    ShadowDirections {
        specular: rect_laplace_direction(bounce.rectangle, bitangent, stronger.dir),
        diffuse: rect_laplace_direction(bounce.rectangle, bitangent, matt.dir),
        diffuse_of_diffuse: bounce.rectangle.position - bounce.seen.position,
    }
}

/// The spot with more light.
#[kernel]
pub fn shadow_stronger(split: LaplaceSplit) -> LaplaceIntegral {
    let is_other = split.by_receiver.value > split.by_reflector.value;
    LaplaceIntegral {
        value: max(split.by_reflector.value, split.by_receiver.value),
        dir: select(split.by_reflector.dir, split.by_receiver.dir, is_other),
    }
}

/// The ray from a pixel against a rectangle, which ends `slack` before it; not asked for where `dir` misses its plane.
#[kernel]
pub fn shadow_ray_to_rectangle(
    seen: Seen,
    shape: u32,
    rectangle: Rectangle,
    towards: Vec3,
    slack: f32,
) -> SceneRay {
    let length = max(sqrt(dot(towards, towards)), 1e-12);
    let dir = towards / length;
    let falling = max(-dot(dir, rectangle.normal), 0.0);
    let height = dot(seen.position - rectangle.position, rectangle.normal);
    let is_asked = falling > 1e-6 && height > slack;
    let dist = max(0.999 * height - slack, 0.0) / max(falling, 1e-6);
    SceneRay {
        origin: seen.position,
        reach: select(0.0, min(dist, 1e4), is_asked),
        dir,
        leaving: shape,
        reaching: NOWHERE,
    }
}

/// The ray, not asked for if not `is_asked`.
#[kernel]
pub fn shadow_ray_if(ray: SceneRay, is_asked: bool) -> SceneRay {
    SceneRay {
        origin: ray.origin,
        reach: select(0.0, ray.reach, is_asked),
        dir: ray.dir,
        leaving: ray.leaving,
        reaching: ray.reaching,
    }
}

/// The ray from where another meets a rectangle to the light; begins `slack` before the rectangle.
#[kernel]
pub fn shadow_ray_to_light(to: SceneRay, rectangle: Rectangle, light: SceneLight, slack: f32) -> SceneRay {
    let lift = slack + 1e-4 * (rectangle.half_x + rectangle.half_y);
    let origin = to.origin + to.reach * to.dir + lift * rectangle.normal;
    let arriving = light_at(light, origin);
    let is_asked = to.reach > 0.0 && dot(arriving.dir, rectangle.normal) > 0.0;
    SceneRay {
        origin,
        reach: select(0.0, arriving.dist, is_asked),
        dir: arriving.dir,
        leaving: NOWHERE,
        reaching: NOWHERE,
    }
}

/// Rays of the turn's pixels and all lights to its rectangle, and on to the lights: a pass, an invocation a pixel and light.
#[kernel(workgroup_size(64))]
pub fn rect_shadow_ray_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] turn: &ShadowTurn,
    #[storage(0, 1)] seen: &[Seen],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] proxies: &[RectProxy],
    #[storage(0, 4)] materials: &[Material],
    #[storage(0, 5)] lights: &[SceneLight],
    #[storage(0, 6)] shadow_rays: &mut [SceneRay],
) {
    let i = id.x;
    if SHADOW_RAYS * i >= shadow_rays.len() as u32 {
        return;
    }
    let count = lights.len() as u32;
    let pixel = seen[(turn.first + i / count) as usize];
    let last = surfaces.len() as u32 - 1;
    let surface = surfaces[min(pixel.surface, last) as usize];
    let proxy = proxies[turn.index as usize];
    let rectangle = proxy.rectangle;
    let light = lights[(i % count) as usize];
    let arriving = light_share(light, proxy);
    let reflector = materials[proxy.material as usize];
    let receiver = materials[surface.material as usize];
    let dirs = shadow_directions(RectBounce { rectangle, reflector, arriving, seen: pixel, receiver });
    for part in 0..3_u32 {
        let other = select(dirs.diffuse, dirs.diffuse_of_diffuse, part == 2);
        let towards = select(other, dirs.specular, part == 0);
        let to = shadow_ray_to_rectangle(pixel, surface.shape, rectangle, towards, turn.slack);
        let is_asked = pixel.surface != NOWHERE;
        let at = SHADOW_RAYS * i + 2 * part;
        let asked = shadow_ray_if(to, is_asked);
        shadow_rays[at as usize] = asked;
        shadow_rays[(at + 1) as usize] = shadow_ray_to_light(asked, rectangle, light, turn.slack);
    }
}

/// Adds to each of the turn's pixels what the rectangle whose turn it is sends of the lights that reach it: a pass.
///
/// `visible` is the answer to the rays of [`rect_shadow_ray_pass`].
#[kernel(workgroup_size(64))]
pub fn rect_shadowed_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] turn: &ShadowTurn,
    #[storage(0, 1)] seen: &[Seen],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] proxies: &[RectProxy],
    #[storage(0, 4)] materials: &[Material],
    #[storage(0, 5)] lights: &[SceneLight],
    #[storage(0, 6)] visible: &[u32],
    #[storage(0, 7)] indirect: &mut [RectPixel],
) {
    let i = turn.first + id.x;
    if id.x >= turn.count || i >= indirect.len() as u32 {
        return;
    }
    let pixel = seen[i as usize];
    let mut sum = indirect[i as usize];
    if pixel.surface != NOWHERE {
        let receiver = materials[surfaces[pixel.surface as usize].material as usize];
        let proxy = proxies[turn.index as usize];
        let rectangle = proxy.rectangle;
        let reflector = materials[proxy.material as usize];
        for l in 0..lights.len() as u32 {
            let arriving = light_share(lights[l as usize], proxy);
            let found =
                rect_pixel_laplace(RectBounce { rectangle, reflector, arriving, seen: pixel, receiver });
            let at = SHADOW_RAYS * (id.x * lights.len() as u32 + l);
            let specular = visible[at as usize] * visible[(at + 1) as usize];
            let diffuse = visible[(at + 2) as usize] * visible[(at + 3) as usize];
            let matt = visible[(at + 4) as usize] * visible[(at + 5) as usize];
            let kept = RectPixel {
                specular: specular as f32 * found.specular,
                diffuse: diffuse as f32 * found.diffuse,
                diffuse_of_diffuse: matt as f32 * found.diffuse_of_diffuse,
                specular_of_diffuse: Vec3::ZERO,
            };
            sum = rect_pixel_add(sum, kept);
        }
    }
    indirect[i as usize] = sum;
}
