//! Passes of the rectangle method: for each pixel, the sum over all rectangles and lights.
//!
//! Forward shading: nothing of the rectangles is stored for pixels. The passes differ in the function that they sum,
//! of [`super::pixel`]; each is a shader of its own, so that none pays for what another needs.

use crate::brdf::Material;
use crate::rect::Rectangle;
use crate::rect::pixel::{
    RectBounce, RectPixel, rect_pixel, rect_pixel_add, rect_pixel_dark, rect_pixel_laplace,
    rect_pixel_laplace_fast, rect_pixel_laplace_single, rect_pixel_paper, rect_pixel_quadrature,
    rect_pixel_sg,
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

/// A pass that sums `$pixel` over all rectangles and lights; those of the disk take `$settings` besides.
macro_rules! rect_pass {
    ($(#[$doc:meta])* $name:ident, $pixel:ident $(, $settings:ident)?) => {
        $(#[$doc])*
        #[kernel(workgroup_size(64))]
        pub fn $name(
            #[builtin(global_invocation_id)] id: UVec3,
            #[storage(0, 0)] seen: &[Seen],
            #[storage(0, 1)] surfaces: &[Surface],
            #[storage(0, 2)] proxies: &[RectProxy],
            #[storage(0, 3)] materials: &[Material],
            #[storage(0, 4)] lights: &[SceneLight],
            #[storage(0, 5)] indirect: &mut [RectPixel],
            $(#[uniform(0, 6)] $settings: &RectSettings,)?
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
                        sum = rect_pixel_add(sum, $pixel(bounce $(, $settings.radius_factor)?));
                    }
                }
            }
            indirect[i as usize] = sum;
        }
    };
}

rect_pass!(
    /// The corrected method: [`rect_pixel`].
    rect_pass,
    rect_pixel,
    settings
);

rect_pass!(
    /// The method as printed: [`rect_pixel_paper`].
    rect_paper_pass,
    rect_pixel_paper,
    settings
);

rect_pass!(
    /// The method with isotropic lobes: [`rect_pixel_sg`].
    rect_sg_pass,
    rect_pixel_sg,
    settings
);

rect_pass!(
    /// The closed form: [`rect_pixel_laplace`].
    rect_laplace_pass,
    rect_pixel_laplace
);

rect_pass!(
    /// The closed form with one spot: [`rect_pixel_laplace_single`].
    rect_laplace_single_pass,
    rect_pixel_laplace_single
);

rect_pass!(
    /// The closed form with one evaluation: [`rect_pixel_laplace_fast`].
    rect_laplace_fast_pass,
    rect_pixel_laplace_fast
);

rect_pass!(
    /// By nine places for each lobe: [`rect_pixel_quadrature`].
    rect_quadrature_pass,
    rect_pixel_quadrature
);
