//! A light-field texture: for each texel of each surface, the few rectangles that send most light there.
//!
//! A pixel then shades those alone, so that its cost does not grow with the number of rectangles. A texel has two lists:
//! one of rectangles that stand still, which is kept, and one of those that move, which is made again for each frame.

use crate::brdf::Material;
use crate::rect::diffuse::rect_form_factor;
use crate::rect::laplace::{
    Reflector, rect_laplace_bitangent, rect_laplace_matt, rect_laplace_receiver, rect_laplace_reflector,
};
use crate::rect::pass::{RectProxy, light_share};
use crate::rect::pixel::{
    RectBounce, RectPixel, rect_pixel_add, rect_pixel_dark, rect_pixel_laplace, rect_pixel_quadrature,
};
use crate::rect::{GlossyReceiver, Rectangle};
use crate::reference::rectangle::rectangle_point;
use crate::reference::running_mean::luminance;
use crate::scene::light::{Arriving, SceneLight};
use crate::scene::{NOWHERE, Seen, Surface};
use lobe_codegen::prelude::*;

/// Rectangles of a list.
#[kernel]
pub const FIELD_LIST: u32 = 8;

/// Rectangles of a texel: both lists.
#[kernel]
pub const FIELD_TEXEL: u32 = 16;

/// A list in the making, the brightest first; [`NOWHERE`] where there is no rectangle.
#[kernel]
pub struct FieldRanks {
    /// What each sends; -1 where there is none.
    pub weights: [f32; 8],
    /// Their indices.
    pub ids: [u32; 8],
}

/// The texture, and which list is made.
#[kernel]
pub struct FieldSettings {
    /// Texels along a side of a surface.
    #[domain(1.0..=1024.0)]
    pub side: u32,
    /// How many rectangles a list holds.
    #[domain(1.0..=8.0)]
    pub most: u32,
    /// Where the list begins in its texel: 0 or 8.
    pub list: u32,
    /// The first rectangle of those that may be listed.
    pub first: u32,
    /// How many may be listed.
    pub count: u32,
    /// The first texel whose list is made.
    pub texel: u32,
}

/// The place of a rectangle's texel that holds a point.
#[kernel]
pub fn field_texel(settings: FieldSettings, index: u32, surface: Surface, position: Vec3) -> u32 {
    let rectangle = surface.rectangle;
    let offset = position - rectangle.position;
    let across = cross(rectangle.normal, rectangle.tangent);
    let side = settings.side as f32;
    let x = saturate(0.5 + 0.5 * dot(offset, rectangle.tangent) / rectangle.half_x) * side;
    let y = saturate(0.5 + 0.5 * dot(offset, across) / rectangle.half_y) * side;
    let column = min(x as u32, settings.side - 1);
    let row = min(y as u32, settings.side - 1);
    (index * settings.side + row) * settings.side + column
}

/// The middle of a texel, one of `side` by `side` on each rectangle.
#[kernel]
pub fn field_middle(side: u32, texel: u32, rectangle: Rectangle) -> Vec3 {
    let column = (texel % side) as f32;
    let row = (texel / side % side) as f32;
    let middle = Vec2::new((column + 0.5) / side as f32, (row + 0.5) / side as f32);
    rectangle_point(rectangle, middle)
}

/// What a rectangle in a light sends to a matt white surface: the luminance of its radiosity, of both lobes.
///
/// By [`rect_laplace_matt`] and [`rect_form_factor`], with a reflectance of the facets at normal incidence.
#[kernel]
pub fn field_weight(
    proxy: RectProxy,
    material: Material,
    arriving: Arriving,
    position: Vec3,
    normal: Vec3,
) -> f32 {
    let receiver = GlossyReceiver { position, normal, view: normal, alpha: 1.0, reflectance: 1.0 };
    let reflector =
        Reflector { alpha: material.alpha, reflectance: 1.0, light: arriving.dir, irradiance: 1.0 };
    let bitangent = rect_laplace_bitangent(proxy.rectangle);
    let lit = rect_laplace_reflector(proxy.rectangle, bitangent, reflector);
    let seen = rect_laplace_receiver(proxy.rectangle, bitangent, receiver);
    let glossy = rect_laplace_matt(lit, seen).value * luminance(material.f0 * arriving.irradiance);
    let incidence = max(dot(proxy.rectangle.normal, arriving.dir), 0.0);
    let diffuse = rect_form_factor(proxy.rectangle, position, normal) * incidence;
    glossy + diffuse * luminance(material.diffuse_albedo * arriving.irradiance)
}

/// The list with a rectangle in its place among the first `most`, those behind it one place on.
///
/// Of equal weights the lower index comes first.
#[kernel]
pub fn field_ranked(ranks: FieldRanks, most: u32, index: u32, weight: f32) -> FieldRanks {
    let mut weights = ranks.weights;
    let mut ids = ranks.ids;
    let mut sinking = index;
    let mut own = weight;
    for place in 0..most {
        let other = weights[place as usize];
        let displaced = ids[place as usize];
        if own > other || (own == other && sinking < displaced) {
            weights[place as usize] = own;
            ids[place as usize] = sinking;
            own = other;
            sinking = displaced;
        }
    }
    FieldRanks { weights, ids }
}

/// Lists the rectangles that send most light to each texel, the brightest first: a pass, an invocation a texel.
///
/// Every rectangle is tried; [`field_tree_pass`](super::field_tree::field_tree_pass) gives the same lists. Of two that send as
/// much, that with the lower index is listed first.
/// Where fewer may be listed than there is room for, [`NOWHERE`] is in the places of the others.
#[kernel(workgroup_size(64))]
pub fn field_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[uniform(0, 0)] field_settings: &FieldSettings,
    #[storage(0, 1)] surfaces: &[Surface],
    #[storage(0, 2)] proxies: &[RectProxy],
    #[storage(0, 3)] materials: &[Material],
    #[storage(0, 4)] lights: &[SceneLight],
    #[storage(0, 5)] field: &mut [u32],
) {
    let i = id.x + field_settings.texel;
    if i >= field.len() as u32 / FIELD_TEXEL {
        return;
    }
    let side = field_settings.side;
    let rectangle = surfaces[(i / (side * side)) as usize].rectangle;
    let position = field_middle(side, i, rectangle);
    let mut ranks = FieldRanks { weights: [-1.0_f32; 8], ids: [NOWHERE; 8] };
    for k in field_settings.first..field_settings.first + field_settings.count {
        let proxy = proxies[k as usize];
        let material = materials[proxy.material as usize];
        let mut weight = 0.0;
        for l in 0..lights.len() as u32 {
            let arriving = light_share(lights[l as usize], proxy);
            weight += field_weight(proxy, material, arriving, position, rectangle.normal);
        }
        ranks = field_ranked(ranks, field_settings.most, k, weight);
    }
    let begin = i * FIELD_TEXEL + field_settings.list;
    for place in 0..FIELD_LIST {
        field[(begin + place) as usize] = ranks.ids[place as usize];
    }
}

/// A pass that sums `$pixel` over the rectangles of each pixel's texel.
macro_rules! field_shading {
    ($(#[$doc:meta])* $name:ident, $pixel:ident) => {
        $(#[$doc])*
        #[kernel(workgroup_size(64))]
        pub fn $name(
            #[builtin(global_invocation_id)] id: UVec3,
            #[uniform(0, 0)] field_settings: &FieldSettings,
            #[storage(0, 1)] seen: &[Seen],
            #[storage(0, 2)] surfaces: &[Surface],
            #[storage(0, 3)] proxies: &[RectProxy],
            #[storage(0, 4)] materials: &[Material],
            #[storage(0, 5)] lights: &[SceneLight],
            #[storage(0, 6)] field: &[u32],
            #[storage(0, 7)] indirect: &mut [RectPixel],
        ) {
            let i = id.x;
            if i >= indirect.len() as u32 {
                return;
            }
            let pixel = seen[i as usize];
            let mut sum = rect_pixel_dark();
            if pixel.surface != NOWHERE {
                let surface = surfaces[pixel.surface as usize];
                let receiver = materials[surface.material as usize];
                let texel = field_texel(*field_settings, pixel.surface, surface, pixel.position);
                for place in 0..FIELD_TEXEL {
                    let k = field[(texel * FIELD_TEXEL + place) as usize];
                    if k != NOWHERE {
                        let proxy = proxies[k as usize];
                        let reflector = materials[proxy.material as usize];
                        for l in 0..lights.len() as u32 {
                            let arriving = light_share(lights[l as usize], proxy);
                            let rectangle = proxy.rectangle;
                            let bounce = RectBounce { rectangle, reflector, arriving, seen: pixel, receiver };
                            sum = rect_pixel_add(sum, $pixel(bounce));
                        }
                    }
                }
            }
            indirect[i as usize] = sum;
        }
    };
}

field_shading!(
    /// [`rect_pixel_laplace`] of the rectangles of each pixel's texel: a pass.
    rect_field_pass,
    rect_pixel_laplace
);

field_shading!(
    /// [`rect_pixel_quadrature`] of the rectangles of each pixel's texel: a pass.
    rect_field_quadrature_pass,
    rect_pixel_quadrature
);
