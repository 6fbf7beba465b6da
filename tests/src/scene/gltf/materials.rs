//! Metallic-roughness materials as ours.

use super::images::Images;
use super::notes::Notes;
use super::textures::{self, BLANK, Slot};
use crate::scene::limits::{ALPHAS, SHARES, number, refused, triple};
use crate::scene::{Material, SceneError, Skin};
use gltf::material::AlphaMode;
use gltf::{Document, Primitive};
use lobe_codegen::glam::{FloatExt, Vec3};
use std::collections::HashSet;
use std::ops::RangeInclusive;

/// Materials of a document, at their indices there.
pub(super) struct Materials {
    /// Under names of which no two are equal.
    pub(super) list: Vec<(String, Material)>,
    /// What is besides, of each.
    others: Vec<Other>,
    /// That of primitives without one.
    default: Option<usize>,
}

/// What a material has besides its factors' lobes.
struct Other {
    two_sided: bool,
    slots: [Option<Slot>; 3],
    /// Its factors, without images.
    factors: Skin,
    /// Index of its skin, once one was asked for.
    skin: Option<u32>,
}

impl Materials {
    /// Reads them all.
    pub(super) fn read(document: &Document, notes: &mut Notes) -> Result<Self, SceneError> {
        let mut all = Self { list: Vec::new(), others: Vec::new(), default: None };
        let mut taken = HashSet::new();
        for (index, found) in document.materials().enumerate() {
            let name = free(&mut taken, found.name().unwrap_or_default(), index);
            all.add(name, &found, notes)?;
        }
        Ok(all)
    }

    fn add(&mut self, name: String, found: &gltf::Material, notes: &mut Notes) -> Result<(), SceneError> {
        remark(&name, found, notes);
        let factors = factors(&name, found)?;
        let slots = textures::slots(&name, found)?;
        self.others.push(Other { two_sided: found.double_sided(), slots, factors, skin: None });
        let material = material(&name, &factors, notes);
        self.list.push((name, material));
        Ok(())
    }

    /// Index of a primitive's, and whether it reflects on both sides.
    pub(super) fn of(
        &mut self,
        primitive: &Primitive,
        notes: &mut Notes,
    ) -> Result<(usize, bool), SceneError> {
        let found = primitive.material();
        let index = match found.index().or(self.default) {
            Some(index) => index,
            None => {
                let mut taken: HashSet<_> = self.list.iter().map(|(name, _)| name.clone()).collect();
                self.default = Some(self.list.len());
                self.add(free(&mut taken, "default", self.list.len()), &found, notes)?;
                self.list.len() - 1
            }
        };
        Ok((index, self.others.get(index).is_some_and(|other| other.two_sided)))
    }
}

impl Materials {
    /// The textures of one of them.
    pub(super) fn slots(&self, material: usize) -> &[Option<Slot>; 3] {
        self.others.get(material).map_or(&NO_SLOTS, |other| &other.slots)
    }

    /// Index among `skins` of the skin of one of them, made when it is first asked for.
    pub(super) fn skin(
        &mut self,
        material: usize,
        document: &Document,
        images: &mut Images,
        skins: &mut Vec<Skin>,
    ) -> Result<u32, SceneError> {
        let Some(other) = self.others.get_mut(material) else {
            return refused("materials", format!("there is no material {material}"));
        };
        if let Some(skin) = other.skin {
            return Ok(skin);
        }
        let images = textures::images(document, images, &other.slots)?;
        let skin = skins.len() as u32;
        skins.push(Skin { images, ..other.factors });
        other.skin = Some(skin);
        Ok(skin)
    }
}

const NO_SLOTS: [Option<Slot>; 3] = [const { None }; 3];

/// A name that no other has: its own, or with its index.
fn free(taken: &mut HashSet<String>, name: &str, index: usize) -> String {
    let numbered = (0..).map(|extra| format!("{name}#{}", index + extra));
    let own = Some(name.to_owned()).filter(|name| !name.is_empty());
    let free = own.into_iter().chain(numbered).find(|name| !taken.contains(name)).unwrap_or_default();
    taken.insert(free.clone());
    free
}

/// What of a material is passed over.
fn remark(name: &str, found: &gltf::Material, notes: &mut Notes) {
    let glows = found.emissive_texture().is_some() || found.emissive_factor() != [0.0; 3];
    for (holds, sentence) in [
        (glows, "emitted light is passed over"),
        (found.occlusion_texture().is_some(), "textures of occlusion are passed over"),
        (found.alpha_mode() != AlphaMode::Opaque, "what is transparent in part is opaque here"),
    ] {
        if holds {
            notes.say(sentence, name);
        }
    }
}

/// How steep an image of normals may be made.
const STEEPNESS: RangeInclusive<f64> = -100.0..=100.0;

/// The numbers of a material, each in its range.
fn factors(name: &str, found: &gltf::Material) -> Result<Skin, SceneError> {
    let at = |member: &str| format!("materials.{name}.{member}");
    let pbr = found.pbr_metallic_roughness();
    let share = |member: &str, value: f32| number(&at(member), f64::from(value), &SHARES);
    let [red, green, blue, _] = pbr.base_color_factor().map(f64::from);
    let base = triple(&at("baseColorFactor"), [red, green, blue], &SHARES)?;
    let metallic = share("metallicFactor", pbr.metallic_factor())?;
    let roughness = share("roughnessFactor", pbr.roughness_factor())?;
    let (dielectric, dielectric_f90) = dielectric(name, found)?;
    let steepness = found.normal_texture().map_or(1.0, |texture| f64::from(texture.scale()));
    let steepness = number(&at("normalTexture.scale"), steepness, &STEEPNESS)?;
    Ok(Skin { base, metallic, dielectric, dielectric_f90, roughness, steepness, images: [BLANK; 3] })
}

/// `diffuse = base (1 - metallic)`, `f0 = mix(dielectric, base, metallic)`, `alpha = roughness²`.
fn material(name: &str, factors: &Skin, notes: &mut Notes) -> Material {
    let Skin { base, metallic, .. } = *factors;
    Material {
        diffuse_albedo: base * (1.0 - metallic),
        f0: factors.dielectric.lerp(base, metallic),
        f90: factors.dielectric_f90.lerp(1.0, metallic),
        alpha: alpha(name, factors.roughness, notes),
    }
}

fn alpha(name: &str, roughness: f32, notes: &mut Notes) -> f32 {
    let least = *ALPHAS.start() as f32;
    if roughness * roughness < least {
        notes.say(&format!("a roughness below {:.3} is made that, alpha {least}", least.sqrt()), name);
    }
    (roughness * roughness).max(least)
}

/// Reflectance at normal incidence and at grazing of what is no metal: 0.04 and 1, unless `KHR_materials_ior` or
/// `KHR_materials_specular` say otherwise.
fn dielectric(name: &str, found: &gltf::Material) -> Result<(Vec3, f32), SceneError> {
    let ior = f64::from(found.ior().unwrap_or(1.5));
    if !(ior == 0.0 || (1.0..=1e3).contains(&ior)) {
        return refused(&format!("materials.{name}.ior"), format!("{ior} is neither 0 nor in 1 ..= 1000"));
    }
    let normal = ((ior - 1.0) / (ior + 1.0)).powi(2) as f32;
    let Some(specular) = found.specular() else { return Ok((Vec3::splat(normal), 1.0)) };
    let factor =
        number(&format!("materials.{name}.specularFactor"), f64::from(specular.specular_factor()), &SHARES)?;
    let colour = specular.specular_color_factor().map(f64::from);
    let colour = triple(&format!("materials.{name}.specularColorFactor"), colour, &(0.0..=1e3))?;
    Ok(((normal * colour).min(Vec3::ONE) * factor, factor))
}
