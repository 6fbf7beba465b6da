//! Textures: materials and normals that vary over a triangle.
//!
//! Texels are words in a buffer, so that every executor reads them alike: [`texel_taps`] says which four and how much each
//! counts, [`texel_byte`] takes a word apart, and a table has the value of each byte. Passes fetch, since no function can be
//! given a buffer; [`textured_material`] makes of what they found what a surface is like at a point.

use crate::brdf::Material;
use crate::scene::Surface;
use lobe_codegen::prelude::*;

/// Beyond its edges the image comes again.
#[kernel]
pub const WRAP_REPEAT: u32 = 0;

/// It comes again turned around, every other time.
#[kernel]
pub const WRAP_MIRROR: u32 = 1;

/// Its outermost texels go on.
#[kernel]
pub const WRAP_CLAMP: u32 = 2;

/// Where in the table of values that of byte 0 is: bytes of sRGB, made linear.
#[kernel]
pub const VALUES_SRGB: u32 = 0;

/// The same of bytes for 0 ..= 1.
#[kernel]
pub const VALUES_LINEAR: u32 = 256;

/// The same of bytes for -1 ..= 1; of the two in the middle, both 0, so that there is a flat normal.
#[kernel]
pub const VALUES_SIGNED: u32 = 512;

/// Slots of a skin: base colour, roughness and metalness, normals.
#[kernel]
pub const SKIN_SLOTS: u32 = 3;

/// The narrowest distribution that is shaded.
#[kernel]
pub const LEAST_ALPHA: f32 = 0.02;

/// The least cosine between a shading normal and the direction to the camera.
#[kernel]
pub const LEAST_FACING: f32 = 0.01;

/// Coordinates in texels are held at this size, so that they are integers.
#[kernel]
pub const MOST_TEXELS: f32 = 1e9;

/// An image in the buffer of texels, and how it is read.
#[kernel]
pub struct TexelImage {
    /// Place of its first texel, the upper left one; row by row from there.
    pub first: u32,
    /// Columns; 0 where there is no image.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// What is left and right of it: [`WRAP_REPEAT`], [`WRAP_MIRROR`] or [`WRAP_CLAMP`].
    pub wrap_x: u32,
    /// The same above and below.
    pub wrap_y: u32,
    /// 1 for the mean of four texels by distance, 0 for the nearest one.
    pub is_smooth: u32,
    /// Place of the value of byte 0 in the table of values.
    pub values: u32,
}

/// A material that textures vary: factors, and an image for each slot.
#[kernel]
pub struct Skin {
    /// Base colour, linear RGB; times that of the first image.
    #[domain(0.0..=1.0)]
    pub base: Vec3,
    /// Share of metal; times the blue of the second image.
    #[domain(0.0..=1.0)]
    pub metallic: f32,
    /// Reflectance at normal incidence of what is no metal.
    #[domain(0.0..=1.0)]
    pub dielectric: Vec3,
    /// The same at grazing incidence.
    #[domain(0.0..=1.0)]
    pub dielectric_f90: f32,
    /// Roughness, the root of alpha; times the green of the second image.
    #[domain(0.0..=1.0)]
    pub roughness: f32,
    /// How steep the normals of the third image are, 1 as they stand there.
    #[domain(-100.0..=100.0)]
    pub steepness: f32,
    /// The images: base colour; roughness (green) and metalness (blue); normals.
    pub images: [TexelImage; 3],
}

/// What a corner of a triangle has besides its place.
#[kernel]
pub struct Corner {
    /// Unit normal.
    #[domain(unit)]
    pub normal: Vec3,
    /// 1, or -1 where the image of normals is turned around.
    pub handedness: f32,
    /// Unit vector along which the first coordinate of the image of normals grows; 0 without that image.
    #[domain(unit)]
    pub tangent: Vec3,
    /// Coordinates in each of the skin's images: 0 is the left and upper edge, 1 the right and lower one.
    #[domain(-10.0..=10.0)]
    pub uvs: [Vec2; 3],
}

/// What a surface has besides its plane and material.
#[kernel]
pub struct SurfaceDetail {
    /// Index of the corner to the left of its base, as its rectangle lies.
    pub left: u32,
    /// Of the corner to the right.
    pub right: u32,
    /// Of its apex.
    pub apex: u32,
    /// Index of its skin; [`NOWHERE`](crate::scene::NOWHERE) for a flat surface of one material, which has no corners.
    pub skin: u32,
}

/// What a surface is like at a point.
#[kernel]
pub struct SurfacePoint {
    /// What it is made of.
    pub material: Material,
    /// Unit normal to shade by. It does not say which side reflects.
    #[domain(unit)]
    pub normal: Vec3,
}

/// The texels around a point of an image.
#[kernel]
pub struct TexelTaps {
    /// Their places in the buffer.
    pub places: [u32; 4],
    /// How much each counts, 1 together.
    pub weights: [f32; 4],
}

/// The column or row of an image that stands for one beyond its edges.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `index` | the column or row | -2^30 ..= 2^30 | 1 |
/// | `size` | how many there are | 1 ..= 2^20 | 1 |
/// | `wrap` | [`WRAP_REPEAT`], [`WRAP_MIRROR`] or [`WRAP_CLAMP`] | | 1 |
///
/// Returns one that is there.
#[kernel]
pub fn texel_wrapped(index: i32, size: u32, wrap: u32) -> u32 {
    let count = max(size, 1) as i32;
    let period = select(count, 2 * count, wrap == WRAP_MIRROR);
    let rest = index % period;
    let turned = select(rest, rest + period, rest < 0);
    let repeated = select(turned, period - 1 - turned, turned >= count);
    select(repeated, clamp(index, 0, count - 1), wrap == WRAP_CLAMP) as u32
}

/// The texels around a point, and how much each counts.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `image` | the image | not empty | |
/// | `uv` | the point, 0 ..= 1 from edge to edge | any finite | 1 |
///
/// Returns the four whose middles are around it, by [`texel_wrapped`], with the weights of a linear mean; where the image
/// is not smooth, the one that it lies in, with weight 1.
///
/// Numerics: continuous, but for images that are not smooth; which four is decided by rounding where the point is in line
/// with middles of texels.
#[kernel]
pub fn texel_taps(image: TexelImage, uv: Vec2) -> TexelTaps {
    let is_smooth = image.is_smooth == 1;
    let shift = select(0.0, 0.5, is_smooth);
    let x = clamp(uv.x * image.width as f32 - shift, -MOST_TEXELS, MOST_TEXELS);
    let y = clamp(uv.y * image.height as f32 - shift, -MOST_TEXELS, MOST_TEXELS);
    let column = floor(x);
    let row = floor(y);
    let across = select(0.0, saturate(x - column), is_smooth);
    let down = select(0.0, saturate(y - row), is_smooth);
    let left = texel_wrapped(column as i32, image.width, image.wrap_x);
    let right = texel_wrapped(column as i32 + 1, image.width, image.wrap_x);
    let upper = image.first + image.width * texel_wrapped(row as i32, image.height, image.wrap_y);
    let lower = image.first + image.width * texel_wrapped(row as i32 + 1, image.height, image.wrap_y);
    TexelTaps {
        places: [upper + left, upper + right, lower + left, lower + right],
        weights: [(1.0 - across) * (1.0 - down), across * (1.0 - down), (1.0 - across) * down, across * down],
    }
}

/// A channel of a texel: 0 red, 1 green, 2 blue, 3 alpha.
#[kernel]
pub fn texel_byte(texel: u32, channel: u32) -> u32 {
    (texel >> (8 * channel)) & 255
}

/// How much each corner of a triangle counts at a point of it: left and right of the base, apex.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `apex` | where the apex is along the upper side of the rectangle around the triangle | -1 ..= 1 | 1 |
/// | `place` | the point, -1 ..= 1 from side to side of that rectangle | -1 ..= 1 | 1 |
///
/// Returns the barycentric coordinates, each at least 0, 1 together; of a point beside the triangle, those of one on it.
#[kernel]
pub fn corner_weights(apex: f32, place: Vec2) -> Vec3 {
    let top = saturate(0.5 * (place.y + 1.0));
    let reach = 0.5 * (1.0 - top);
    let along = clamp(0.5 * (place.x - top * apex), -reach, reach);
    Vec3::new(reach - along, reach + along, top)
}

/// The same of a point of a surface in space.
#[kernel]
pub fn surface_weights(surface: Surface, position: Vec3) -> Vec3 {
    let rectangle = surface.rectangle;
    let offset = position - rectangle.position;
    let across = cross(rectangle.normal, rectangle.tangent);
    let x = dot(offset, rectangle.tangent) / rectangle.half_x;
    let y = dot(offset, across) / rectangle.half_y;
    corner_weights(surface.apex, Vec2::new(x, y))
}

/// The mean of a triangle's corners. Its normal and tangent are no unit vectors; its handedness is the first one's.
#[kernel]
pub fn corner_between(left: Corner, right: Corner, apex: Corner, weights: Vec3) -> Corner {
    let mut uvs = left.uvs;
    for slot in 0..SKIN_SLOTS {
        let of_left = left.uvs[slot as usize];
        let of_right = right.uvs[slot as usize];
        let of_apex = apex.uvs[slot as usize];
        uvs[slot as usize] = weights.x * of_left + weights.y * of_right + weights.z * of_apex;
    }
    Corner {
        normal: weights.x * left.normal + weights.y * right.normal + weights.z * apex.normal,
        handedness: left.handedness,
        tangent: weights.x * left.tangent + weights.y * right.tangent + weights.z * apex.tangent,
        uvs,
    }
}

/// What a slot of a skin holds that has no image: white, and the flat normal.
#[kernel]
pub fn skin_blank(slot: u32) -> Vec3 {
    select(Vec3::ONE, Vec3::Z, slot == 2)
}

/// What a skin is made of where its images have these values.
///
/// `diffuse = base (1 - metallic)`, `f0 = mix(dielectric, base, metallic)`, `alpha = roughness²`
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `skin` | factors | | |
/// | `colour` | of the first image, linear RGB | 0 ..= 1 | 1 |
/// | `shares` | of the second image: roughness in y, metalness in z | 0 ..= 1 | 1 |
///
/// Returns the material; alpha is at least [`LEAST_ALPHA`].
#[kernel]
pub fn skin_material(skin: Skin, colour: Vec3, shares: Vec3) -> Material {
    let base = skin.base * colour;
    let metallic = skin.metallic * shares.z;
    let roughness = skin.roughness * shares.y;
    Material {
        diffuse_albedo: (1.0 - metallic) * base,
        f0: (1.0 - metallic) * skin.dielectric + metallic * base,
        f90: (1.0 - metallic) * skin.dielectric_f90 + metallic,
        alpha: clamp(roughness * roughness, LEAST_ALPHA, 1.0),
    }
}

/// `v` as a unit vector, or `instead` where it has no length.
#[kernel]
pub fn unit_or(v: Vec3, instead: Vec3) -> Vec3 {
    let square = dot(v, v);
    let has_length = square > 1e-12;
    select(instead, v * inverse_sqrt(select(1.0, square, has_length)), has_length)
}

/// The unit normal by which a skin is shaded from its front.
///
/// `normalize(s x t + s y b + z n)`, `b = h n × t`
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `skin` | its steepness `s` | | |
/// | `at` | normal `n`, tangent `t` and handedness `h`, by [`corner_between`] | | 1 |
/// | `bump` | the image's normal `(x, y, z)`: along, across, out | -1 ..= 1 | 1 |
/// | `normal` | unit normal of the triangle | sphere | 1 |
///
/// Returns the normal; that of the triangle where the sum has no length.
#[kernel]
pub fn skin_normal(skin: Skin, at: Corner, bump: Vec3, normal: Vec3) -> Vec3 {
    let across = at.handedness * cross(at.normal, at.tangent);
    let slant = skin.steepness * (bump.x * at.tangent + bump.y * across);
    unit_or(slant + bump.z * at.normal, normal)
}

/// A unit normal turned towards the viewer as far as it must be to face him: by nothing where its cosine is at least
/// [`LEAST_FACING`].
///
/// Corners' normals and images turn normals away from who still sees the surface; it would be black there.
#[kernel]
pub fn facing_normal(normal: Vec3, view: Vec3) -> Vec3 {
    let turned = normal + max(LEAST_FACING - dot(normal, view), 0.0) * view;
    turned * inverse_sqrt(max(dot(turned, turned), 1e-6))
}

/// Whether the normal to shade by faces a direction that the plane does not: nothing arrives from there, and nothing leaves.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `plane`, `shading` | unit normals of the plane and to shade by | sphere | 1 |
/// | `dir` | unit direction | sphere | 1 |
///
/// Returns `false` where both are one.
#[kernel]
pub fn is_behind_plane(plane: Vec3, shading: Vec3, dir: Vec3) -> bool {
    dot(shading, dir) > 0.0 && dot(plane, dir) <= 0.0
}

/// What a triangle with a skin is like at a point.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `skin` | the factors | | |
/// | `at` | the corners' mean there, by [`corner_between`] | | |
/// | `found` | what the skin's images have there, or [`skin_blank`] | | 1 |
/// | `normal` | unit normal of the triangle, on the side of the viewer | sphere | 1 |
/// | `is_back` | whether that is its back | | |
/// | `view` | unit direction to the viewer | sphere | 1 |
///
/// Returns the material by [`skin_material`], and the normal by [`skin_normal`] and [`facing_normal`].
#[kernel]
pub fn textured_material(
    skin: Skin,
    at: Corner,
    found: [Vec3; 3],
    normal: Vec3,
    is_back: bool,
    view: Vec3,
) -> SurfacePoint {
    let front = select(normal, -normal, is_back);
    let of_front = skin_normal(skin, at, found[2], front);
    let shading = select(of_front, -of_front, is_back);
    SurfacePoint { material: skin_material(skin, found[0], found[1]), normal: facing_normal(shading, view) }
}
