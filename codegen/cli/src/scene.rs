//! Scenes out of files.

use crate::fail::Fail;
use lobe_tests::scene::{Choices, Scene, SceneError};
use std::path::Path;

/// The scene in the file; its notes go to standard error.
pub(crate) fn open(path: &Path, choices: &Choices) -> Result<Scene, Fail> {
    let scene = Scene::open(path, choices).map_err(|cause| refused(path, cause))?;
    for note in &scene.notes {
        eprintln!("lobe: {}: {note}", path.display());
    }
    Ok(scene)
}

/// A scene's name: that of its file.
pub(crate) fn name(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

fn refused(path: &Path, cause: SceneError) -> Fail {
    match cause {
        // It names the file, which may be another.
        SceneError::File { .. } => Fail::Usage(cause.to_string()),
        cause => Fail::Usage(format!("{}: {cause}", path.display())),
    }
}
