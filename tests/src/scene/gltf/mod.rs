//! glTF 2.0: `.gltf` and `.glb`.
//!
//! `tests/SCENES.md` has the mapping. The crate `gltf` reads the JSON; elements of accessors are read here (`elements.rs`),
//! so that every wrong count, offset and index is an error with its place. No count in a file is believed before the bytes
//! for it were seen.

mod buffers;
mod corners;
mod elements;
mod images;
mod lights;
mod materials;
mod mesh;
mod nodes;
mod notes;
mod textures;
mod view;

use super::limits::refused;
use super::{Details, Light, Material, Scene, SceneError, Triangle};
use buffers::Buffers;
use gltf::{Document, Gltf};
use materials::Materials;
use mesh::Meshes;
use notes::Notes;

/// What a caller adds to a glTF file.
#[derive(Debug, Clone)]
pub struct Choices {
    /// Name of the camera, or of its node; without one the first perspective camera is taken.
    pub camera: Option<String>,
    /// Columns and rows of the picture, 1 ..= 16384 each.
    pub size: [u32; 2],
    /// A light to take where the file has none.
    pub light: Option<Light>,
}

impl Default for Choices {
    /// The first camera, 256 by 256 pixels, the file's own lights.
    fn default() -> Self {
        Self { camera: None, size: [256, 256], light: None }
    }
}

/// Gives the bytes of a file that a buffer or an image names by a relative path, or says why it does not.
pub type Files<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

impl Scene {
    /// Reads the scene of a glTF 2.0 file, text or binary; `files` gives the buffers and images that lie beside it.
    ///
    /// ```
    /// use lobe_tests::scene::{Choices, Scene};
    ///
    /// let nothing = br#"{"asset": {"version": "2.0"}, "scenes": [{"nodes": []}]}"#;
    /// let beside = |name: &str| Err(format!("{name} was not sent"));
    /// let refused = Scene::from_gltf(nothing, &beside, &Choices::default()).unwrap_err();
    /// assert!(refused.to_string().starts_with("there is no triangle"));
    /// ```
    ///
    /// # Errors
    /// When the bytes are no sound glTF 2.0, a buffer is missing or too short, an image is broken, a number is out of its range, or there is no
    /// triangle or no light.
    pub fn from_gltf(bytes: &[u8], files: Files, choices: &Choices) -> Result<Self, SceneError> {
        // Where the crate trusts a file more than it should, it panics.
        lobe_codegen::quietly(|| read(bytes, files, choices))
            .unwrap_or_else(|message| Err(SceneError::Panicked { message }))
    }
}

fn read(bytes: &[u8], files: Files, choices: &Choices) -> Result<Scene, SceneError> {
    let Gltf { document, blob } = sound(bytes)?;
    let scene = chosen(&document)?;
    let mut notes = Notes::default();
    notes.of_document(&document);
    let nodes = nodes::placed(&scene)?;
    let mut materials = Materials::read(&document, &mut notes)?;
    let buffers = Buffers::load(&document, blob, files)?;
    let meshes = Meshes::new((&document, &buffers, files), &mut materials, &mut notes);
    let (triangles, details) = meshes.triangles(&nodes)?;
    means(&mut materials.list, &triangles, &details);
    Ok(Scene {
        name: scene.name().unwrap_or_default().to_owned(),
        camera: view::camera(&nodes, choices, &triangles, &mut notes)?,
        lights: lights::all(&nodes, choices.light, &mut notes)?,
        materials: materials.list,
        rectangles: Vec::new(),
        triangles,
        details,
        notes: notes.sentences(),
    })
}

/// Puts the mean over its triangles in the place of each material with textures.
fn means(materials: &mut [(String, Material)], triangles: &[Triangle], details: &Details) {
    let mut textured = vec![Vec::new(); materials.len()];
    for triangle in triangles {
        let Some(detail) = triangle.detail else { continue };
        let images = details.skins.get(detail.skin as usize).map(|skin| &skin.images);
        if images.is_some_and(|[colour, shares, _]| colour.width + shares.width > 0) {
            let [a, b, c] = triangle.vertices.map(|vertex| vertex.as_dvec3());
            textured[triangle.material].push((detail, (b - a).cross(c - a).length()));
        }
    }
    for ((_, material), found) in materials.iter_mut().zip(textured) {
        *material = details.mean(&found).unwrap_or(*material);
    }
}

/// The document, all its indices inside their lists.
fn sound(bytes: &[u8]) -> Result<Gltf, SceneError> {
    let Gltf { document, blob } = Gltf::from_slice_without_validation(bytes).map_err(malformed)?;
    let root = document.into_json();
    positions(&root)?;
    Ok(Gltf { document: Document::from_json(root).map_err(malformed)?, blob })
}

/// The crate's validation looks up what POSITION names before it asks whether it is there.
fn positions(root: &gltf::json::Root) -> Result<(), SceneError> {
    for (m, mesh) in root.meshes.iter().enumerate() {
        for (p, primitive) in mesh.primitives.iter().enumerate() {
            if let Some(index) =
                primitive.attributes.values().find(|index| index.value() >= root.accessors.len())
            {
                let count = root.accessors.len();
                let message = format!("an attribute is accessor {}, and there are {count}", index.value());
                return refused(&format!("meshes[{m}].primitives[{p}]"), message);
            }
        }
    }
    Ok(())
}

/// The default scene, or the first.
fn chosen(document: &Document) -> Result<gltf::Scene<'_>, SceneError> {
    let found = document.default_scene().or_else(|| document.scenes().next());
    found.ok_or(SceneError::Missing { what: "scene", add: "a member `scenes` says which nodes are seen" })
}

/// Faults that a message lists.
const LISTED: usize = 3;

fn malformed(error: gltf::Error) -> SceneError {
    let message = match error {
        gltf::Error::Validation(faults) => {
            let listed: Vec<String> =
                faults.iter().take(LISTED).map(|(place, fault)| format!("{place}: {fault}")).collect();
            let others = faults.len().saturating_sub(LISTED);
            let more = if others > 0 { format!("; and {others} more") } else { String::new() };
            listed.join("; ") + &more
        }
        other => other.to_string(),
    };
    SceneError::Gltf { message }
}
