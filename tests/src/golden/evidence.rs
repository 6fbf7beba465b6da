//! Pictures of a check as files, for those who review.

use super::cases::Case;
use crate::files;
use lobe_golden::Golden;
use lobe_golden::image::{Picture, write_golden, write_picture};
use std::path::{Path, PathBuf};

/// A folder of pictures.
#[derive(Debug, Clone)]
pub(super) struct Evidence(pub(super) PathBuf);

impl Evidence {
    /// Writes a golden, and says where, within the folder.
    pub(super) fn golden(&self, case: &Case, name: &str, golden: &Golden) -> Result<String, String> {
        self.put(case, name, write_golden(golden).map_err(|error| error.to_string())?)
    }

    /// Writes what a route returned.
    pub(super) fn picture(&self, case: &Case, route: &str, picture: &Picture) -> Result<String, String> {
        let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '-' };
        let name: String = route.chars().map(plain).collect();
        self.put(case, &name, write_picture(picture).map_err(|error| error.to_string())?)
    }

    fn put(&self, case: &Case, name: &str, bytes: Vec<u8>) -> Result<String, String> {
        let within = format!("{}/{name}.exr", case.name);
        let path = self.0.join(&within);
        let told = |cause: std::io::Error| format!("{}: cannot be written: {cause}", path.display());
        std::fs::create_dir_all(path.parent().unwrap_or(Path::new("."))).map_err(told)?;
        files::write(&path, &bytes).map_err(told)?;
        Ok(within)
    }
}
