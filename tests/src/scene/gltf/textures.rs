//! Textures: images with the way in which they are read.

use super::images::Images;
use crate::scene::limits::refused;
use crate::scene::{SceneError, TexelImage};
use gltf::Document;
use gltf::texture::{MagFilter, Texture, TextureTransform, WrappingMode};
use lobe_codegen::glam::{DAffine2, DVec2};
use lobe_kernels::scene::texture::{
    VALUES_LINEAR, VALUES_SIGNED, VALUES_SRGB, WRAP_CLAMP, WRAP_MIRROR, WRAP_REPEAT,
};
use serde::Deserialize;

/// Coefficients of a transform of coordinates.
const LARGEST: f64 = 1e6;

/// No image.
pub(super) const BLANK: TexelImage =
    TexelImage { first: 0, width: 0, height: 0, wrap_x: 0, wrap_y: 0, is_smooth: 0, values: 0 };

/// A texture of a material, in the order of a skin's slots: base colour, roughness and metalness, normals.
pub(super) struct Slot {
    /// Its place in messages: `materials.oak.baseColorTexture`.
    pub(super) at: String,
    /// Index of the texture.
    texture: usize,
    /// Which `TEXCOORD_n` it is read by.
    pub(super) set: u32,
    /// From those coordinates to the image's.
    pub(super) transform: DAffine2,
}

/// The textures of a material that has the name `name`; `None` where there is none.
pub(super) fn slots(name: &str, material: &gltf::Material) -> Result<[Option<Slot>; 3], SceneError> {
    let pbr = material.pbr_metallic_roughness();
    let of_info = |member: &str, info: gltf::texture::Info| {
        let stated = info.texture_transform().map(|transform| Stated::of(&transform));
        slot(format!("materials.{name}.{member}"), &info.texture(), info.tex_coord(), stated)
    };
    let of_normals = |info: gltf::material::NormalTexture| {
        let at = format!("materials.{name}.normalTexture");
        let stated = match info.extension_value("KHR_texture_transform") {
            Some(value) => match Stated::deserialize(value) {
                Ok(stated) => Some(stated),
                Err(error) => return refused(&format!("{at}.KHR_texture_transform"), error.to_string()),
            },
            None => None,
        };
        slot(at, &info.texture(), info.tex_coord(), stated)
    };
    Ok([
        pbr.base_color_texture().map(|info| of_info("baseColorTexture", info)).transpose()?,
        pbr.metallic_roughness_texture().map(|info| of_info("metallicRoughnessTexture", info)).transpose()?,
        material.normal_texture().map(of_normals).transpose()?,
    ])
}

fn slot(at: String, texture: &Texture, set: u32, stated: Option<Stated>) -> Result<Slot, SceneError> {
    let stated = stated.unwrap_or_default();
    let set = stated.tex_coord.unwrap_or(set);
    let transform = stated.transform();
    let is_sound = transform.to_cols_array().iter().all(|x| x.abs() <= LARGEST);
    match is_sound {
        true => Ok(Slot { at, texture: texture.index(), set, transform }),
        false => {
            refused(&format!("{at}.KHR_texture_transform"), format!("its numbers are not below {LARGEST}"))
        }
    }
}

/// What `KHR_texture_transform` states.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct Stated {
    offset: [f64; 2],
    rotation: f64,
    scale: [f64; 2],
    tex_coord: Option<u32>,
}

impl Default for Stated {
    fn default() -> Self {
        Self { offset: [0.0; 2], rotation: 0.0, scale: [1.0; 2], tex_coord: None }
    }
}

impl Stated {
    fn of(transform: &TextureTransform) -> Self {
        Self {
            offset: transform.offset().map(f64::from),
            rotation: transform.rotation().into(),
            scale: transform.scale().map(f64::from),
            tex_coord: transform.tex_coord(),
        }
    }

    /// Scales, turns counter-clockwise as the image is seen, whose second coordinate grows downwards, and moves.
    fn transform(self) -> DAffine2 {
        DAffine2::from_scale_angle_translation(
            DVec2::from_array(self.scale),
            -self.rotation,
            DVec2::from_array(self.offset),
        )
    }
}

/// The images of a material's textures.
pub(super) fn images(
    document: &Document,
    images: &mut Images,
    slots: &[Option<Slot>; 3],
) -> Result<[TexelImage; 3], SceneError> {
    let mut found = [BLANK; 3];
    for ((slot, image), values) in
        slots.iter().zip(&mut found).zip([VALUES_SRGB, VALUES_LINEAR, VALUES_SIGNED])
    {
        if let Some(slot) = slot {
            *image = TexelImage { values, ..self::image(document, images, slot)? };
        }
    }
    Ok(found)
}

fn image(document: &Document, images: &mut Images, slot: &Slot) -> Result<TexelImage, SceneError> {
    let Some(texture) = document.textures().nth(slot.texture) else {
        return refused(&slot.at, format!("there is no texture {}", slot.texture));
    };
    let Some(source) = document.as_json().textures.get(slot.texture).map(|texture| texture.source.value())
    else {
        return refused(&slot.at, "its texture has no image");
    };
    let placed = images.get(source)?;
    let sampler = texture.sampler();
    let wrap = |mode: WrappingMode| match mode {
        WrappingMode::Repeat => WRAP_REPEAT,
        WrappingMode::MirroredRepeat => WRAP_MIRROR,
        WrappingMode::ClampToEdge => WRAP_CLAMP,
    };
    Ok(TexelImage {
        first: placed.first,
        width: placed.size[0],
        height: placed.size[1],
        wrap_x: wrap(sampler.wrap_s()),
        wrap_y: wrap(sampler.wrap_t()),
        is_smooth: u32::from(sampler.mag_filter() != Some(MagFilter::Nearest)),
        values: 0,
    })
}
