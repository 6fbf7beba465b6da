//! Scenes as files.

use super::{Choices, Scene, SceneError};
use std::fs;
use std::path::Path;

impl Scene {
    /// Reads a scene from a file: glTF if it ends in `.gltf` or `.glb`, else JSON, to which `choices` do not apply.
    ///
    /// # Errors
    /// When the file cannot be read, or [`Scene::from_gltf`] or [`Scene::from_json`] refuse it.
    pub fn open(path: &Path, choices: &Choices) -> Result<Self, SceneError> {
        let bytes = read(path).map_err(|message| file(path, message))?;
        if is_gltf(path) {
            let folder = path.parent().unwrap_or(Path::new(""));
            return Self::from_gltf(&bytes, &|name| read(&folder.join(name)), choices);
        }
        let text = String::from_utf8(bytes).map_err(|error| file(path, format!("it is no text: {error}")))?;
        Self::from_json(&text)
    }
}

fn file(path: &Path, message: String) -> SceneError {
    SceneError::File { name: path.display().to_string(), message }
}

fn is_gltf(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    matches!(ending.as_deref(), Some("gltf" | "glb"))
}

/// A file that has an end: no device, no pipe.
fn read(path: &Path) -> Result<Vec<u8>, String> {
    let told = |cause: std::io::Error| format!("it cannot be read: {cause}");
    match fs::metadata(path).map_err(told)?.is_file() {
        true => fs::read(path).map_err(told),
        false => Err("it cannot be read: it is no file".to_owned()),
    }
}
