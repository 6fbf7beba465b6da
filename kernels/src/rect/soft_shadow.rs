//! Soft shadows of the rectangle method: each place of [`quadrature`](super::quadrature) is asked for.
//!
//! A place counts where nothing is between it and the pixel, nor between it and the light: nine places a lobe, and for two
//! diffuse lobes nine about the pixel's normal, which say what share of the form factor is left. [`super::shadow`] asks for
//! one point of each lobe.
//!
//! Turns and bands of pixels are as there: [`rect_soft_ray_pass`] asks, [`crate::scene::bvh::shadow_pass`] answers,
//! [`rect_soft_pass`] adds.

use crate::brdf::Material;
use crate::rect::laplace::{
    LaplaceReceiver, rect_laplace_bitangent, rect_laplace_is_dark, rect_laplace_receiver, rect_laplace_turn,
};
use crate::rect::pass::{RectProxy, light_share};
use crate::rect::pixel::{
    RectBounce, RectPixel, rect_laplace_direction, rect_laplace_lit, rect_pixel_add, rect_pixel_of_free,
    rect_receiver,
};
use crate::rect::quadrature::{
    QuadratureFree, rect_quadrature_grid, rect_quadrature_row, rect_quadrature_spot, rect_quadrature_towards,
    rect_quadrature_upright, rect_quadrature_view,
};
use crate::rect::shadow::{ShadowTurn, shadow_ray_if, shadow_ray_to_light, shadow_ray_to_rectangle};
use crate::scene::light::SceneLight;
use crate::scene::{NOWHERE, SceneRay, Seen, Surface};
use lobe_codegen::prelude::*;

/// Parts of [`QuadratureFree`], each with nine places.
#[kernel]
pub const SOFT_PARTS: u32 = 3;

/// Rays of a pixel, light and part: for each place one to the rectangle and one from there to the light.
#[kernel]
pub const SOFT_RAYS: u32 = 18;

/// The pixel whose lobe a part's places are of: itself, but of the last part [`rect_quadrature_upright`].
#[kernel]
pub fn soft_receiver(receiver: LaplaceReceiver, part: u32) -> LaplaceReceiver {
    if part == 2 {
        return rect_quadrature_upright(receiver);
    }
    receiver
}

/// Rays of the turn's pixels, all lights and all parts to its rectangle, and on to the lights: a pass, an invocation a pixel,
/// light and part.
#[kernel(workgroup_size(64))]
pub fn rect_soft_ray_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] turn: &ShadowTurn,
    #[storage(0, 1)] seen: &[Seen],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] proxies: &[RectProxy],
    #[storage(0, 4)] materials: &[Material],
    #[storage(0, 5)] lights: &[SceneLight],
    #[storage(0, 6)] shadow_rays: &mut [SceneRay],
) {
    let invocation = id.x;
    if SOFT_RAYS * invocation >= shadow_rays.len() as u32 {
        return;
    }
    let part = invocation % SOFT_PARTS;
    let i = invocation / SOFT_PARTS;
    let count = lights.len() as u32;
    let pixel = seen[(turn.first + i / count) as usize];
    let last = surfaces.len() as u32 - 1;
    let surface = surfaces[min(pixel.surface, last) as usize];
    let proxy = proxies[turn.index as usize];
    let rectangle = proxy.rectangle;
    let light = lights[(i % count) as usize];
    let bounce = RectBounce {
        rectangle,
        reflector: materials[proxy.material as usize],
        arriving: light_share(light, proxy),
        seen: pixel,
        receiver: materials[surface.material as usize],
    };
    let bitangent = rect_laplace_bitangent(rectangle);
    let reflector = rect_laplace_lit(bounce, bitangent);
    let receiver = soft_receiver(rect_laplace_receiver(rectangle, bitangent, rect_receiver(bounce)), part);
    let is_asked = pixel.surface != NOWHERE && !rect_laplace_is_dark(reflector, receiver);
    let view = rect_laplace_turn(rectangle, bitangent, pixel.view);
    let grid = rect_quadrature_grid(rect_quadrature_view(reflector, receiver, view), receiver, min(part, 1));
    for row_index in 0..3_u32 {
        let row = rect_quadrature_row(grid, row_index);
        for k in 0..3_u32 {
            let place = rect_quadrature_spot(grid, row, k).place;
            let towards = rect_laplace_direction(rectangle, bitangent, rect_quadrature_towards(grid, place));
            let to = shadow_ray_to_rectangle(pixel, surface.shape, rectangle, towards, turn.slack);
            let asked = shadow_ray_if(to, is_asked);
            let at = SOFT_RAYS * invocation + 2 * (3 * row_index + k);
            shadow_rays[at as usize] = asked;
            shadow_rays[(at + 1) as usize] = shadow_ray_to_light(asked, rectangle, light, turn.slack);
        }
    }
}

/// Adds to each of the turn's pixels what its rectangle sends from places that see the light and are seen: a pass.
///
/// `visible` is the answer to the rays of [`rect_soft_ray_pass`].
#[kernel(workgroup_size(64))]
pub fn rect_soft_pass(
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
            let mut free = [0_u32; 3];
            for part in 0..SOFT_PARTS {
                let begin = SOFT_RAYS * (SOFT_PARTS * (id.x * lights.len() as u32 + l) + part);
                let mut bits = 0_u32;
                for k in 0..9_u32 {
                    let at = begin + 2 * k;
                    bits += (visible[at as usize] * visible[(at + 1) as usize]) << k;
                }
                free[part as usize] = bits;
            }
            let arriving = light_share(lights[l as usize], proxy);
            let bounce = RectBounce { rectangle, reflector, arriving, seen: pixel, receiver };
            let counting = QuadratureFree { by_reflector: free[0], by_receiver: free[1], by_normal: free[2] };
            sum = rect_pixel_add(sum, rect_pixel_of_free(bounce, counting));
        }
    }
    indirect[i as usize] = sum;
}
