//! Passes of the rectangle method: for each pixel, the sum over all rectangles and lights.
//!
//! Forward shading: nothing of the rectangles is stored for pixels. The passes differ in the function that they sum,
//! of [`super::pixel`].

use crate::brdf::Material;
use crate::rect::Rectangle;
use crate::rect::pixel::{
    RectBounce, RectPixel, rect_pixel, rect_pixel_add, rect_pixel_dark, rect_pixel_laplace,
    rect_pixel_laplace_fast, rect_pixel_laplace_single, rect_pixel_paper, rect_pixel_sg,
};
use crate::scene::light::{Arriving, SceneLight, light_at};
use crate::scene::{NOWHERE, Seen, Surface};
use lobe_codegen::prelude::*;

/// A rectangle that reflects, in place of what it is the rectangle of.
#[kernel]
pub struct RectProxy {
    /// The rectangle.
    pub rectangle: Rectangle,
    /// Index of the material.
    pub material: u32,
    /// Share of its area that reflects.
    #[domain(0.0..=1.0)]
    pub fill: f32,
}

/// What holds for all pixels.
#[kernel]
pub struct RectSettings {
    /// The sampling disk's radius over alpha and distance.
    #[domain(0.1..=10.0)]
    pub radius_factor: f32,
}

/// What arrives at a proxy's middle, lessened by what of it does not reflect.
#[kernel]
pub fn light_share(light: SceneLight, proxy: RectProxy) -> Arriving {
    let arriving = light_at(light, proxy.rectangle.position);
    Arriving { dir: arriving.dir, dist: arriving.dist, irradiance: proxy.fill * arriving.irradiance }
}

/// The corrected method: [`rect_pixel`].
#[kernel(workgroup_size(64))]
pub fn rect_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] settings: &RectSettings,
    #[storage(0, 1)] seen: &[Seen],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] proxies: &[RectProxy],
    #[storage(0, 4)] materials: &[Material],
    #[storage(0, 5)] lights: &[SceneLight],
    #[storage(0, 6)] indirect: &mut [RectPixel],
) {
    let i = id.x;
    if i >= indirect.len() as u32 {
        return;
    }
    let pixel = seen[i as usize];
    let mut sum = rect_pixel_dark();
    if pixel.surface != NOWHERE {
        let receiver = materials[surfaces[pixel.surface as usize].material as usize];
        for k in 0..proxies.len() as u32 {
            let proxy = proxies[k as usize];
            let reflector = materials[proxy.material as usize];
            for l in 0..lights.len() as u32 {
                let arriving = light_share(lights[l as usize], proxy);
                let rectangle = proxy.rectangle;
                let bounce = RectBounce { rectangle, reflector, arriving, seen: pixel, receiver };
                sum = rect_pixel_add(sum, rect_pixel(bounce, settings.radius_factor));
            }
        }
    }
    indirect[i as usize] = sum;
}

/// The method as printed: [`rect_pixel_paper`].
#[kernel(workgroup_size(64))]
pub fn rect_paper_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] settings: &RectSettings,
    #[storage(0, 1)] seen: &[Seen],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] proxies: &[RectProxy],
    #[storage(0, 4)] materials: &[Material],
    #[storage(0, 5)] lights: &[SceneLight],
    #[storage(0, 6)] indirect: &mut [RectPixel],
) {
    let i = id.x;
    if i >= indirect.len() as u32 {
        return;
    }
    let pixel = seen[i as usize];
    let mut sum = rect_pixel_dark();
    if pixel.surface != NOWHERE {
        let receiver = materials[surfaces[pixel.surface as usize].material as usize];
        for k in 0..proxies.len() as u32 {
            let proxy = proxies[k as usize];
            let reflector = materials[proxy.material as usize];
            for l in 0..lights.len() as u32 {
                let arriving = light_share(lights[l as usize], proxy);
                let rectangle = proxy.rectangle;
                let bounce = RectBounce { rectangle, reflector, arriving, seen: pixel, receiver };
                sum = rect_pixel_add(sum, rect_pixel_paper(bounce, settings.radius_factor));
            }
        }
    }
    indirect[i as usize] = sum;
}

/// The method with isotropic lobes: [`rect_pixel_sg`].
#[kernel(workgroup_size(64))]
pub fn rect_sg_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] settings: &RectSettings,
    #[storage(0, 1)] seen: &[Seen],
    #[storage(0, 2)] surfaces: &[Surface],
    #[storage(0, 3)] proxies: &[RectProxy],
    #[storage(0, 4)] materials: &[Material],
    #[storage(0, 5)] lights: &[SceneLight],
    #[storage(0, 6)] indirect: &mut [RectPixel],
) {
    let i = id.x;
    if i >= indirect.len() as u32 {
        return;
    }
    let pixel = seen[i as usize];
    let mut sum = rect_pixel_dark();
    if pixel.surface != NOWHERE {
        let receiver = materials[surfaces[pixel.surface as usize].material as usize];
        for k in 0..proxies.len() as u32 {
            let proxy = proxies[k as usize];
            let reflector = materials[proxy.material as usize];
            for l in 0..lights.len() as u32 {
                let arriving = light_share(lights[l as usize], proxy);
                let rectangle = proxy.rectangle;
                let bounce = RectBounce { rectangle, reflector, arriving, seen: pixel, receiver };
                sum = rect_pixel_add(sum, rect_pixel_sg(bounce, settings.radius_factor));
            }
        }
    }
    indirect[i as usize] = sum;
}

/// The closed form: [`rect_pixel_laplace`].
#[kernel(workgroup_size(64))]
pub fn rect_laplace_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] seen: &[Seen],
    #[storage(0, 1)] surfaces: &[Surface],
    #[storage(0, 2)] proxies: &[RectProxy],
    #[storage(0, 3)] materials: &[Material],
    #[storage(0, 4)] lights: &[SceneLight],
    #[storage(0, 5)] indirect: &mut [RectPixel],
) {
    let i = id.x;
    if i >= indirect.len() as u32 {
        return;
    }
    let pixel = seen[i as usize];
    let mut sum = rect_pixel_dark();
    if pixel.surface != NOWHERE {
        let receiver = materials[surfaces[pixel.surface as usize].material as usize];
        for k in 0..proxies.len() as u32 {
            let proxy = proxies[k as usize];
            let reflector = materials[proxy.material as usize];
            for l in 0..lights.len() as u32 {
                let arriving = light_share(lights[l as usize], proxy);
                let rectangle = proxy.rectangle;
                let bounce = RectBounce { rectangle, reflector, arriving, seen: pixel, receiver };
                sum = rect_pixel_add(sum, rect_pixel_laplace(bounce));
            }
        }
    }
    indirect[i as usize] = sum;
}

/// The closed form with one spot: [`rect_pixel_laplace_single`].
#[kernel(workgroup_size(64))]
pub fn rect_laplace_single_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] seen: &[Seen],
    #[storage(0, 1)] surfaces: &[Surface],
    #[storage(0, 2)] proxies: &[RectProxy],
    #[storage(0, 3)] materials: &[Material],
    #[storage(0, 4)] lights: &[SceneLight],
    #[storage(0, 5)] indirect: &mut [RectPixel],
) {
    let i = id.x;
    if i >= indirect.len() as u32 {
        return;
    }
    let pixel = seen[i as usize];
    let mut sum = rect_pixel_dark();
    if pixel.surface != NOWHERE {
        let receiver = materials[surfaces[pixel.surface as usize].material as usize];
        for k in 0..proxies.len() as u32 {
            let proxy = proxies[k as usize];
            let reflector = materials[proxy.material as usize];
            for l in 0..lights.len() as u32 {
                let arriving = light_share(lights[l as usize], proxy);
                let rectangle = proxy.rectangle;
                let bounce = RectBounce { rectangle, reflector, arriving, seen: pixel, receiver };
                sum = rect_pixel_add(sum, rect_pixel_laplace_single(bounce));
            }
        }
    }
    indirect[i as usize] = sum;
}

/// The closed form with one evaluation: [`rect_pixel_laplace_fast`].
#[kernel(workgroup_size(64))]
pub fn rect_laplace_fast_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] seen: &[Seen],
    #[storage(0, 1)] surfaces: &[Surface],
    #[storage(0, 2)] proxies: &[RectProxy],
    #[storage(0, 3)] materials: &[Material],
    #[storage(0, 4)] lights: &[SceneLight],
    #[storage(0, 5)] indirect: &mut [RectPixel],
) {
    let i = id.x;
    if i >= indirect.len() as u32 {
        return;
    }
    let pixel = seen[i as usize];
    let mut sum = rect_pixel_dark();
    if pixel.surface != NOWHERE {
        let receiver = materials[surfaces[pixel.surface as usize].material as usize];
        for k in 0..proxies.len() as u32 {
            let proxy = proxies[k as usize];
            let reflector = materials[proxy.material as usize];
            for l in 0..lights.len() as u32 {
                let arriving = light_share(lights[l as usize], proxy);
                let rectangle = proxy.rectangle;
                let bounce = RectBounce { rectangle, reflector, arriving, seen: pixel, receiver };
                sum = rect_pixel_add(sum, rect_pixel_laplace_fast(bounce));
            }
        }
    }
    indirect[i as usize] = sum;
}
