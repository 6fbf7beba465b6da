//! Google's Dawn, whose WGSL compiler is Tint: as the npm package `webgpu`, in a node process of its own.
//!
//! A browser that is not Firefox compiles WGSL with it.
//! The process ([`process`]) stays for as long as it is used; what crashes or hangs in it costs a process, not ours.

pub(crate) mod process;
pub mod tint;

use std::env;
use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::{TranslateError, tools, tools_dir};
use process::Process;

const DAWN: &str = "Dawn";
const NODE: &str = "node";

/// The oldest node that loads it.
const NODE_MINIMUM: u32 = 20;

/// The files of Dawn, and of the node that loads it. Finding them starts nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dawn {
    node: PathBuf,
    package: PathBuf,
    version: String,
}

impl Dawn {
    /// Finds node by `LOBE_NODE`, in `node/bin/` of the [tools folder](tools_dir), or on the `PATH`, and the package by
    /// `LOBE_DAWN`, or in `dawn/node_modules/webgpu/` of the tools folder.
    ///
    /// # Errors
    ///
    /// [`TranslateError::NotFound`], or [`TranslateError::Unusable`] where a package has another form.
    pub fn find() -> Result<Self, TranslateError> {
        Self::at(find_node()?, find_package()?)
    }

    /// The package in the folder `package`, to be loaded by `node`.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Unusable`] if that is no npm package of Dawn's.
    pub fn at(node: PathBuf, package: PathBuf) -> Result<Self, TranslateError> {
        match tools::npm_version(&package, "webgpu") {
            Ok(version) => Ok(Self { node, package, version }),
            Err(reason) => Err(TranslateError::Unusable { tool: DAWN, path: package, reason }),
        }
    }

    /// The folder of the package.
    #[must_use]
    pub fn package(&self) -> &Path {
        &self.package
    }

    /// The package's version; Dawn's own is the day that it was built from.
    #[must_use]
    pub fn version(&self) -> &str {
        &self.version
    }

    /// Node's file.
    #[must_use]
    pub fn node(&self) -> &Path {
        &self.node
    }

    /// Node's version, as it states it.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Unusable`] if it does not start, or is too old.
    pub fn node_version(&self) -> Result<String, TranslateError> {
        node_version(&self.node).map_err(|reason| TranslateError::Unusable {
            tool: NODE,
            path: self.node.clone(),
            reason,
        })
    }

    /// Starts a process with Dawn's `options`, that sees the driver of `icd` alone if there is one.
    pub(crate) fn start(&self, options: &[String], icd: Option<&Path>) -> io::Result<Process> {
        let options: Vec<OsString> = options.iter().map(OsString::from).collect();
        // Node takes a module's path as a URL, and a path from the root is one.
        let main = self.package.join("index.js").canonicalize()?;
        Process::start(&self.node, &main, &options, icd)
    }
}

fn named(variable: &str) -> Option<PathBuf> {
    env::var_os(variable).filter(|value| !value.is_empty()).map(PathBuf::from)
}

pub(super) fn find_node() -> Result<PathBuf, TranslateError> {
    if let Some(named) = named("LOBE_NODE") {
        return Ok(named);
    }
    let ours = tools_dir().map(|tools| tools.join("node/bin"));
    let path = env::var_os("PATH").unwrap_or_default();
    let candidates = ours.into_iter().chain(env::split_paths(&path)).map(|folder| folder.join(NODE));
    candidates.into_iter().find(|candidate| candidate.is_file()).ok_or_else(|| TranslateError::NotFound {
        tool: NODE,
        looked_at: vec!["node/bin in the tools folder".to_owned(), "PATH".to_owned()],
        mend: "run tests/setup.sh, or set LOBE_NODE to the path of node, version 20 or newer",
    })
}

fn find_package() -> Result<PathBuf, TranslateError> {
    tools::folder("LOBE_DAWN", "dawn/node_modules/webgpu").ok_or_else(|| TranslateError::NotFound {
        tool: DAWN,
        looked_at: vec!["dawn/node_modules/webgpu in the tools folder".to_owned()],
        mend: "run tests/setup.sh, or set LOBE_DAWN to the folder of the npm package webgpu",
    })
}

fn node_version(node: &Path) -> Result<String, String> {
    let output = Command::new(node).arg("--version").output().map_err(|e| e.to_string())?;
    let text = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    let major = text.strip_prefix('v').and_then(|rest| rest.split('.').next()?.parse::<u32>().ok());
    match major {
        Some(NODE_MINIMUM..) => Ok(text),
        Some(_) => Err(format!("it is {text}; Dawn needs {NODE_MINIMUM} or newer")),
        None => Err(format!("it states no version but {text:?}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_that_is_not_the_package_is_named() {
        let folder = tempfile::tempdir().expect("a folder");
        for (text, part) in
            [(None, "package.json: "), (Some("{"), "package.json: "), (Some("{}"), "is not that of")]
        {
            if let Some(text) = text {
                std::fs::write(folder.path().join("package.json"), text).expect("writable");
            }
            let error = Dawn::at("node".into(), folder.path().to_owned()).expect_err("should be refused");
            assert!(error.to_string().contains(part), "{error}");
        }
    }

    #[test]
    fn what_is_not_node_is_refused() {
        assert!(node_version(Path::new("/bin/true")).is_err_and(|why| why.contains("states no version")));
    }
}
