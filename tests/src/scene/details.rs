//! What triangles have besides their planes and materials: corners, skins, texels.

use super::Material;
use lobe_codegen::glam::Vec3;
use lobe_kernels::scene::texture::{
    Corner, Skin, TexelImage, corner_between, skin_blank, skin_material, texel_byte, texel_taps,
};

/// Corners, skins and texels of triangles that are more than flat and of one material.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Details {
    /// Corners, several triangles' perhaps.
    pub corners: Vec<Corner>,
    /// What textures vary.
    pub skins: Vec<Skin>,
    /// The texels of all images: red in the lowest byte, then green, blue, alpha.
    pub texels: Vec<u32>,
}

/// What a triangle has besides its plane and material.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Detail {
    /// Index into [`Details::corners`] of each of its vertices.
    pub corners: [u32; 3],
    /// Index into [`Details::skins`].
    pub skin: u32,
}

/// The values of bytes of texels: of sRGB as linear ones, as 0 ..= 1, as -1 ..= 1 (of 127 and 128 both 0).
///
/// The three tables are one after the other, where `VALUES_SRGB` and its like of the kernels say.
#[must_use]
pub fn texel_values() -> Vec<f32> {
    let share = |byte: u8| f64::from(byte) / 255.0;
    let linear = |byte: u8| match share(byte) {
        code if code <= 0.040_45 => code / 12.92,
        code => ((code + 0.055) / 1.055).powf(2.4),
    };
    let signed = |byte: u8| if matches!(byte, 127 | 128) { 0.0 } else { 2.0 * share(byte) - 1.0 };
    let table = |value: &dyn Fn(u8) -> f64| (0..=255).map(|byte| value(byte) as f32).collect::<Vec<_>>();
    [table(&linear), table(&share), table(&signed)].concat()
}

impl Details {
    /// What the images of `skin` have at a corner or between three, with the table of [`texel_values`].
    #[must_use]
    pub fn found(&self, values: &[f32], skin: &Skin, at: &Corner) -> [Vec3; 3] {
        [0, 1, 2].map(|slot| match skin.images[slot] {
            TexelImage { width: 0, .. } => skin_blank(slot as u32),
            image => {
                let taps = texel_taps(image, at.uvs[slot]);
                let tap = |(place, weight): (u32, f32)| {
                    let texel = self.texels[place as usize];
                    let value = |channel| values[(image.values + texel_byte(texel, channel)) as usize];
                    weight * Vec3::new(value(0), value(1), value(2))
                };
                taps.places.into_iter().zip(taps.weights).map(tap).sum()
            }
        })
    }

    /// The texels, at least one: no buffer is empty.
    #[must_use]
    pub(crate) fn some_texels(&self) -> &[u32] {
        if self.texels.is_empty() { &[0] } else { &self.texels }
    }

    /// The mean material of triangles with one skin, each with its area; `None` of none.
    pub(super) fn mean(&self, triangles: &[(Detail, f64)]) -> Option<Material> {
        let values = texel_values();
        let side = ((MOST_SAMPLES / triangles.len().max(1)) as f64).sqrt().clamp(1.0, MOST_SIDE) as u32;
        let mut sum = Sum::default();
        for (detail, area) in triangles {
            let skin = self.skins.get(detail.skin as usize)?;
            let [left, right, apex] = detail.corners.map(|corner| self.corners[corner as usize]);
            for place in middles(side) {
                let at = corner_between(left, right, apex, place);
                let [colour, shares, _] = self.found(&values, skin, &at);
                sum.add(skin_material(*skin, colour, shares), *area);
            }
        }
        sum.mean()
    }
}

/// Points at which textures are looked at for a mean, about.
const MOST_SAMPLES: usize = 1 << 20;
/// Parts of a triangle's side, at most.
const MOST_SIDE: f64 = 64.0;

/// Barycentric coordinates of the middles of `side²` equal parts of a triangle.
fn middles(side: u32) -> impl Iterator<Item = Vec3> {
    let third = 1.0 / 3.0;
    let upright = move |row: u32| (0..side - row).map(move |i| [i as f32 + third, row as f32 + third]);
    let turned = move |row: u32| {
        (0..(side - row).saturating_sub(1)).map(move |i| [i as f32 + 2.0 * third, row as f32 + 2.0 * third])
    };
    let place = move |[across, up]: [f32; 2]| {
        let [across, up] = [across / side as f32, up / side as f32];
        Vec3::new(1.0 - across - up, across, up)
    };
    (0..side).flat_map(move |row| upright(row).chain(turned(row))).map(place)
}

/// A sum of materials by area.
#[derive(Debug, Default)]
struct Sum {
    area: f64,
    parts: [f64; 8],
}

impl Sum {
    fn add(&mut self, material: Material, area: f64) {
        let ([r, g, b], [x, y, z]) = (material.diffuse_albedo.to_array(), material.f0.to_array());
        for (sum, part) in self.parts.iter_mut().zip([r, g, b, x, y, z, material.f90, material.alpha]) {
            *sum += area * f64::from(part);
        }
        self.area += area;
    }

    fn mean(&self) -> Option<Material> {
        let [r, g, b, x, y, z, f90, alpha] = self.parts.map(|part| (part / self.area) as f32);
        let colour = |r, g, b| Vec3::new(r, g, b).clamp(Vec3::ZERO, Vec3::ONE);
        let material = Material {
            diffuse_albedo: colour(r, g, b),
            f0: colour(x, y, z),
            f90: f90.clamp(0.0, 1.0),
            alpha: alpha.clamp(0.02, 1.0),
        };
        (self.area > 0.0 && self.area.is_finite()).then_some(material)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn middles_are_in_the_triangle_and_balance_it() {
        for side in [1, 2, 5] {
            let all: Vec<Vec3> = middles(side).collect();
            assert_eq!(all.len() as u32, side * side);
            assert!(all.iter().all(|place| place.min_element() > 0.0), "{all:?}");
            let mean = all.iter().sum::<Vec3>() / all.len() as f32;
            assert!((mean - Vec3::splat(1.0 / 3.0)).length() < 1e-5, "{mean}");
        }
    }

    #[test]
    fn bytes_have_the_values_of_their_kind() {
        let values = texel_values();
        for (at, value) in [(0, 0.0), (255, 1.0), (188, 0.502_886), (256, 0.0), (511, 1.0), (307, 0.2)] {
            assert!((values[at] - value).abs() < 1e-6, "{at}: {}", values[at]);
        }
        assert_eq!([512, 512 + 127, 512 + 128, 767].map(|at| values[at]), [-1.0, 0.0, 0.0, 1.0]);
    }
}
