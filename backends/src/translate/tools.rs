//! Where the tools lie that no system package brings.

use std::env;
use std::path::{Path, PathBuf};

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
