//! Where the tools lie that no system package brings.

use std::env;
use std::path::{Path, PathBuf};

use super::TranslateError;

const LIBRARY_FOLDERS: [&str; 4] = ["/usr/local/lib", "/usr/lib/x86_64-linux-gnu", "/usr/lib64", "/usr/lib"];

/// The folder into which `tests/setup.sh` puts tools, if there is one.
///
/// `LOBE_TOOLS` names it; else it is the nearest `.tools` folder, going up from the current folder, then from the
/// executable.
#[must_use]
pub fn tools_dir() -> Option<PathBuf> {
    if let Some(named) = env::var_os("LOBE_TOOLS").filter(|value| !value.is_empty()) {
        return Some(PathBuf::from(named)).filter(|path| path.is_dir());
    }
    let from_here = env::current_dir().ok().and_then(|folder| nearest(&folder));
    from_here.or_else(|| env::current_exe().ok().and_then(|program| nearest(&program)))
}

fn nearest(start: &Path) -> Option<PathBuf> {
    start.ancestors().map(|folder| folder.join(".tools")).find(|path| path.is_dir())
}

/// The file of a library: what the environment's `variable` names, else the first of `names` in `lib/` of the tools
/// folder, else where the system keeps libraries.
pub(super) fn library(
    tool: &'static str,
    variable: &str,
    names: &[&str],
    mend: &'static str,
) -> Result<PathBuf, TranslateError> {
    let ours = tools_dir().map(|tools| tools.join("lib"));
    let folders = ours.into_iter().chain(LIBRARY_FOLDERS.map(PathBuf::from));
    let candidates: Vec<PathBuf> =
        folders.flat_map(|folder| names.iter().map(move |name| folder.join(name))).collect();
    let found = named(variable).or_else(|| candidates.iter().find(|path| path.is_file()).cloned());
    found.ok_or_else(|| TranslateError::NotFound {
        tool,
        looked_at: candidates.iter().map(|path| path.display().to_string()).collect(),
        mend,
    })
}

/// The file of a program: what the environment's `variable` names, else the first of `names` in `bin/` of the tools
/// folder, else on the `PATH`.
pub(super) fn program(
    tool: &'static str,
    variable: &str,
    names: &[&str],
    mend: &'static str,
) -> Result<PathBuf, TranslateError> {
    let ours = tools_dir().map(|tools| tools.join("bin"));
    let path = env::var_os("PATH").unwrap_or_default();
    let folders = ours.into_iter().chain(env::split_paths(&path));
    let mut candidates = folders.flat_map(|folder| names.iter().map(move |name| folder.join(name)));
    let found = named(variable).or_else(|| candidates.find(|path| path.is_file()));
    let looked_at = || vec!["the tools folder".to_owned(), "PATH".to_owned()];
    found.ok_or_else(|| TranslateError::NotFound { tool, looked_at: looked_at(), mend })
}

/// A folder: what the environment's `variable` names, else `path` in the tools folder.
pub(super) fn folder(variable: &str, path: &str) -> Option<PathBuf> {
    named(variable).or_else(|| tools_dir().map(|tools| tools.join(path)).filter(|folder| folder.is_dir()))
}

/// The version of the npm package `name`, which lies in the folder `package`.
pub(super) fn npm_version(package: &Path, name: &str) -> Result<String, String> {
    let text =
        std::fs::read_to_string(package.join("package.json")).map_err(|e| format!("package.json: {e}"))?;
    let json: serde_json::Value = serde_json::from_str(&text).map_err(|e| format!("package.json: {e}"))?;
    match (json["name"].as_str(), json["version"].as_str()) {
        (Some(own), Some(version)) if own == name => Ok(version.to_owned()),
        _ => Err(format!("its package.json is not that of the npm package {name}")),
    }
}

fn named(variable: &str) -> Option<PathBuf> {
    env::var_os(variable).filter(|value| !value.is_empty()).map(PathBuf::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_folder_above_is_found() {
        let root = tempfile::tempdir().expect("a folder");
        let inner = root.path().join("a/b");
        std::fs::create_dir_all(root.path().join(".tools")).expect("writable");
        std::fs::create_dir_all(&inner).expect("writable");
        assert_eq!(nearest(&inner), Some(root.path().join(".tools")));
        std::fs::create_dir_all(root.path().join("a/.tools")).expect("writable");
        assert_eq!(nearest(&inner), Some(root.path().join("a/.tools")));
    }
}
