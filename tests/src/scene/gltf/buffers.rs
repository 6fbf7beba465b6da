//! The bytes of buffers: of the file itself, of data URIs, of files beside it.

use super::Files;
use crate::scene::SceneError;
use crate::scene::limits::refused;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use gltf::Document;
use gltf::buffer::{Source, View};
use percent_encoding::percent_decode_str;

/// Every buffer of a document.
pub(super) struct Buffers(Vec<Vec<u8>>);

impl Buffers {
    /// Gets them all; none is shorter than its `byteLength`.
    pub(super) fn load(
        document: &Document,
        mut blob: Option<Vec<u8>>,
        files: Files,
    ) -> Result<Self, SceneError> {
        let load = |buffer: gltf::Buffer| {
            let at = format!("buffers[{}]", buffer.index());
            let bytes = match buffer.source() {
                Source::Bin => blob.take().map_or_else(|| refused(&at, NO_CHUNK), Ok)?,
                Source::Uri(uri) => of_uri(&at, uri, files)?,
            };
            match bytes.len() < buffer.length() {
                true => refused(
                    &at,
                    format!("it has {} bytes, and byteLength is {}", bytes.len(), buffer.length()),
                ),
                false => Ok(bytes),
            }
        };
        document.buffers().map(load).collect::<Result<_, _>>().map(Self)
    }

    /// The bytes of a view.
    pub(super) fn view(&self, view: &View) -> Result<&[u8], SceneError> {
        let bytes = self.0.get(view.buffer().index()).map_or(&[][..], Vec::as_slice);
        let range = view.offset().checked_add(view.length()).and_then(|end| bytes.get(view.offset()..end));
        range.map_or_else(
            || refused(&format!("bufferViews[{}]", view.index()), "it is not inside its buffer"),
            Ok,
        )
    }
}

const NO_CHUNK: &str = "it has no uri, and there is no binary chunk for it; give it one, or the file as .glb";

/// The bytes that a URI names: its own, or those of a file beside the scene.
pub(super) fn of_uri(at: &str, uri: &str, files: Files) -> Result<Vec<u8>, SceneError> {
    if let Some(data) = uri.strip_prefix("data:") {
        return of_data(at, data);
    }
    let path = percent_decode_str(uri).decode_utf8_lossy();
    if !is_beside(&path) {
        let what = format!("the URI {uri:?}");
        let instead = "write a data URI, or name a file in the folder of the glTF file or below";
        return Err(SceneError::Unsupported { at: at.to_owned(), what, instead });
    }
    files(&path).map_err(|message| SceneError::File { name: path.into_owned(), message })
}

/// Whether a path leads neither elsewhere nor upwards: a scene of somebody else's opens nothing but its own files.
fn is_beside(path: &str) -> bool {
    let is_part = |part: &str| !part.is_empty() && part != "..";
    !path.contains([':', '\\', '\0']) && path.split('/').all(is_part)
}

fn of_data(at: &str, data: &str) -> Result<Vec<u8>, SceneError> {
    let Some((_, text)) = data.split_once(";base64,") else {
        return refused(at, "its data URI is not in base64; write `data:TYPE;base64,..`");
    };
    STANDARD.decode(text).or_else(|error| refused(at, format!("its data URI is no base64: {error}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_files_beside_are_opened() {
        for (path, beside) in [
            ("room.bin", true),
            ("parts/room 1.bin", true),
            ("", false),
            ("/etc/passwd", false),
            ("../room.bin", false),
            ("parts/../../room.bin", false),
            ("file:room.bin", false),
            ("C:\\room.bin", false),
        ] {
            assert_eq!(is_beside(path), beside, "{path}");
        }
    }
}
