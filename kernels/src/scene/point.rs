//! What surfaces are like at the points that rays met.
//!
//! Most surfaces are everywhere alike: shading passes take the surface's material and the plane's normal. For points of those
//! with a skin [`textured_point_pass`] writes a [`SurfacePoint`], and into [`Seen::point_index`] where it is; it is left out where
//! no surface has a skin.

use crate::scene::texture::{
    Corner, SKIN_SLOTS, Skin, SurfaceDetail, SurfacePoint, corner_between, skin_blank, surface_weights,
    texel_byte, texel_taps, textured_material,
};
use crate::scene::{NOWHERE, Seen, Surface};
use lobe_codegen::prelude::*;

/// What surfaces with a skin are like at each point, by its images and their corners: a pass, after
/// [`seen_pass`](super::seen_pass).
///
/// `details` has one for each surface, `texel_values` the tables of [`texture`](super::texture), `points` room for one of
/// each point.
#[kernel(workgroup_size(64))]
pub fn textured_point_pass(
    #[builtin(global_invocation_id)] id: UVec3,
    #[storage(0, 0)] seen: &mut [Seen],
    #[storage(0, 1)] surfaces: &[Surface],
    #[storage(0, 2)] details: &[SurfaceDetail],
    #[storage(0, 3)] corners: &[Corner],
    #[storage(0, 4)] skins: &[Skin],
    #[storage(0, 5)] texels: &[u32],
    #[storage(0, 6)] texel_values: &[f32],
    #[storage(0, 7)] points: &mut [SurfacePoint],
) {
    let i = id.x;
    if i >= points.len() as u32 {
        return;
    }
    let pixel = seen[i as usize];
    if pixel.surface == NOWHERE {
        return;
    }
    let detail = details[pixel.surface as usize];
    if detail.skin == NOWHERE {
        return;
    }
    let surface = surfaces[pixel.surface as usize];
    let skin = skins[detail.skin as usize];
    let left = corners[detail.left as usize];
    let right = corners[detail.right as usize];
    let apex = corners[detail.apex as usize];
    let at = corner_between(left, right, apex, surface_weights(surface, pixel.position));
    let mut found = [Vec3::ZERO; 3];
    for slot in 0..SKIN_SLOTS {
        let image = skin.images[slot as usize];
        let mut sum = skin_blank(slot);
        if image.width > 0 {
            let taps = texel_taps(image, at.uvs[slot as usize]);
            sum = Vec3::ZERO;
            for tap in 0..4 {
                let texel = texels[taps.places[tap as usize] as usize];
                let red = texel_values[(image.values + texel_byte(texel, 0)) as usize];
                let green = texel_values[(image.values + texel_byte(texel, 1)) as usize];
                let blue = texel_values[(image.values + texel_byte(texel, 2)) as usize];
                sum += taps.weights[tap as usize] * Vec3::new(red, green, blue);
            }
        }
        found[slot as usize] = sum;
    }
    let is_back = surface.shape != pixel.surface;
    points[i as usize] = textured_material(skin, at, found, pixel.normal, is_back, pixel.view);
    seen[i as usize].point_index = i;
}
