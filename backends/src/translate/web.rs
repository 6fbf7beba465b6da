//! What shows pages: a browser without a window, and three.js, which packages for it are held to.

use std::path::{Path, PathBuf};

use super::{TranslateError, tools};

const BROWSER: &str = "browser";
const THREE: &str = "three.js";

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

/// three.js as an npm package, beside the packages that its use in TypeScript is checked by.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Three {
    modules: PathBuf,
    version: String,
}

impl Three {
    /// Finds it in the folder `node_modules` that `LOBE_THREE` names, or in `three/node_modules/` of the
    /// [tools folder](super::tools_dir).
    ///
    /// # Errors
    ///
    /// [`TranslateError::NotFound`], or [`TranslateError::Unusable`] where the package has another form.
    pub fn find() -> Result<Self, TranslateError> {
        let modules = tools::folder("LOBE_THREE", "three/node_modules").ok_or_else(|| TranslateError::NotFound {
            tool: THREE,
            looked_at: vec!["three/node_modules in the tools folder".to_owned()],
            mend: "run tests/setup.sh, or set LOBE_THREE to a folder node_modules with the npm packages three, \
                   @types/three and typescript",
        })?;
        match tools::npm_version(&modules.join("three"), "three") {
            Ok(version) => Ok(Self { modules, version }),
            Err(reason) => Err(TranslateError::Unusable { tool: THREE, path: modules, reason }),
        }
    }

    /// The folder `node_modules`.
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
