//! Scenes: a camera, lights, materials, and what they light.
//!
//! [`Scene::from_json`] reads the format `glossy-oracle-scene/1`, [`Scene::from_gltf`] glTF 2.0 (`tests/SCENES.md`);
//! [`Scene::open`] either, by a file's ending. A scene that is here is sound: every number is finite and in its range, every
//! direction has length one, every material that is named is there.

mod camera;
mod details;
mod gltf;
mod json;
mod limits;
mod open;

pub use camera::{Camera, Ray};
pub use details::{Detail, Details, texel_values};
pub use gltf::{Choices, Files};
pub use lobe_kernels::brdf::Material;
pub use lobe_kernels::scene::texture::{Corner, Skin, TexelImage};

use lobe_codegen::prelude::Vec3;

/// What is seen, and by which light.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Its name.
    pub name: String,
    /// From where it is seen.
    pub camera: Camera,
    /// At least one; none is seen itself.
    pub lights: Vec<Light>,
    /// By name; one with textures is their mean over the triangles that have it.
    pub materials: Vec<(String, Material)>,
    /// At least one, unless there are triangles.
    pub rectangles: Vec<Surface>,
    /// At least one, unless there are rectangles.
    pub triangles: Vec<Triangle>,
    /// What the triangles' details are made of.
    pub details: Details,
    /// What of the file was passed over or changed, a sentence each.
    pub notes: Vec<String>,
}

/// A light without extent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Light {
    /// One infinitely far away.
    Directional {
        /// Unit direction to the light.
        to_light: Vec3,
        /// Irradiance of a plane that faces it, linear RGB, W/m².
        irradiance: Vec3,
    },
    /// A cone.
    Spot {
        /// Where it is, m.
        position: Vec3,
        /// Unit direction of the middle of the cone, away from the light.
        axis: Vec3,
        /// Half the angle of the cone in which all of its light is, rad.
        inner: f32,
        /// Half the angle beyond which there is none, rad; above [`Light::Spot::inner`].
        outer: f32,
        /// Intensity in the inner cone, linear RGB, W/sr.
        intensity: Vec3,
    },
}

/// A rectangle `center + a half_u + b half_v`, a and b in -1 ..= 1, that reflects on the side of its normal alone, and hides
/// what is behind it from both.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Its name; empty if it has none.
    pub name: String,
    /// Its middle, m.
    pub center: Vec3,
    /// From the middle to the middle of a side, m.
    pub half_u: Vec3,
    /// The same across.
    pub half_v: Vec3,
    /// Unit normal, `half_u × half_v` normalised.
    pub normal: Vec3,
    /// Index into [`Scene::materials`].
    pub material: usize,
}

/// A triangle. It hides what is behind it from both sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Triangle {
    /// Its corners, m, counter-clockwise for who sees its front.
    pub vertices: [Vec3; 3],
    /// Unit normal of its plane, towards its front.
    pub normal: Vec3,
    /// Index into [`Scene::materials`].
    pub material: usize,
    /// Whether it reflects on its back too, as its front does with the normal turned; else on the side of its normal alone.
    pub two_sided: bool,
    /// What it has besides; `None` where it is flat and of one material.
    pub detail: Option<Detail>,
}

/// Why a scene is refused.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SceneError {
    /// The text is no JSON, or lacks something of the format.
    #[error("line {line}, column {column}: {message}")]
    Json {
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What is wrong.
        message: String,
    },
    /// Some other format, or a later one.
    #[error("the format is {found:?}, and this reads {FORMAT:?}", FORMAT = FORMAT)]
    Format {
        /// The text's.
        found: String,
    },
    /// The bytes are no glTF 2.0.
    #[error("glTF: {message}")]
    Gltf {
        /// What is wrong, by the `gltf` crate.
        message: String,
    },
    /// A file, or one that it names, cannot be had.
    #[error("{name}: {message}")]
    File {
        /// Its path, or its URI.
        name: String,
        /// Why not, and what would help.
        message: String,
    },
    /// Something that scenes need is not there.
    #[error("there is no {what}: {add}")]
    Missing {
        /// What it is.
        what: &'static str,
        /// What to add, and where.
        add: &'static str,
    },
    /// Something that is not known here.
    #[error("{at}: {what} is not known here; {instead}")]
    Unsupported {
        /// Where it is, as a path.
        at: String,
        /// What it is.
        what: String,
        /// What is known.
        instead: &'static str,
    },
    /// The `gltf` crate panicked.
    #[error(
        "the glTF reader panicked ({message}); please report the file to the authors of the crate `gltf`"
    )]
    Panicked {
        /// The panic's words.
        message: String,
    },
    /// A number, or what follows from several.
    #[error("{at}: {message}")]
    Value {
        /// What it is, as a path: `rects[3].half_u`.
        at: String,
        /// What is wrong, and what would be right.
        message: String,
    },
}

/// The format that is read.
const FORMAT: &str = "glossy-oracle-scene/1";
