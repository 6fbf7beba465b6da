//! Shaders of somebody else's: read by naga, validated, and cut down to one entry point.
//!
//! Nothing here trusts its input: what naga refuses, and what makes it panic, is an error that names the file.

mod barrier;
mod component;
mod elements;
mod entry;
mod glsl;
mod read;
mod spirv;
mod workgroup;

pub use elements::with_elements;
pub use entry::{Override, choose, isolate};
pub use read::read;

use crate::directives;
use std::borrow::Cow;
use std::path::Path;

/// What a shader is written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Language {
    /// WGSL text.
    Wgsl,
    /// SPIR-V, little-endian words.
    Spirv,
    /// GLSL text of a compute shader.
    Glsl,
}

impl Language {
    /// The language of a file, by its extension: `wgsl`, `spv`, `glsl` or `comp`.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "wgsl" => Some(Self::Wgsl),
            "spv" => Some(Self::Spirv),
            "glsl" | "comp" => Some(Self::Glsl),
            _ => None,
        }
    }
}

/// A shader as it came.
#[derive(Debug, Clone)]
pub struct Source {
    /// Its name in messages, as a path.
    pub name: String,
    /// What it is written in.
    pub language: Language,
    /// The file.
    pub bytes: Vec<u8>,
}

impl Source {
    /// The text, if it is one.
    #[must_use]
    pub fn text(&self) -> Option<&str> {
        match self.language {
            Language::Wgsl | Language::Glsl => std::str::from_utf8(&self.bytes).ok(),
            Language::Spirv => None,
        }
    }

    /// WGSL as naga takes it: without directives that it does not know and does not need, everything in its place.
    #[must_use]
    pub fn wgsl(&self) -> Option<Cow<'_, str>> {
        self.text().filter(|_| self.language == Language::Wgsl).map(directives::blanked)
    }
}

/// Why a shader cannot be taken.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ForeignError {
    /// Text that is none.
    #[error("{name}: byte {at} is not UTF-8; WGSL and GLSL are text")]
    Encoding {
        /// The file.
        name: String,
        /// Bytes before it.
        at: usize,
    },
    /// naga's front end says no.
    #[error("{message}")]
    Parse {
        /// Its message, with file, line and column where it has them.
        message: String,
    },
    /// naga says yes, but means something else, or something that no compute shader has.
    #[error("{name}: unsupported: {what}")]
    Unsupported {
        /// The file.
        name: String,
        /// What it is.
        what: String,
    },
    /// naga's validator says no.
    #[error("{message}")]
    Invalid {
        /// Its message, with file, line and column where it has them.
        message: String,
    },
    /// naga panicked.
    #[error(
        "{name}: naga's {stage} panicked ({message}); this is a fault of naga, please report the file to its authors"
    )]
    Panicked {
        /// The file.
        name: String,
        /// Front end, validator or what else.
        stage: &'static str,
        /// The panic's words.
        message: String,
    },
    /// Nothing to run.
    #[error("{name}: there is no compute entry point{}", listed(", only ", others))]
    NoEntry {
        /// The file.
        name: String,
        /// Entry points of other stages.
        others: Vec<String>,
    },
    /// Several to choose from.
    #[error(
        "{name}: there are several compute entry points{}; choose one with --entry",
        listed(": ", entries)
    )]
    SeveralEntries {
        /// The file.
        name: String,
        /// Their names.
        entries: Vec<String>,
    },
    /// None of this name.
    #[error("{name}: there is no compute entry point `{wanted}`{}", listed("; there is ", entries))]
    UnknownEntry {
        /// The file.
        name: String,
        /// The name.
        wanted: String,
        /// The names that there are.
        entries: Vec<String>,
    },
    /// Overrides that cannot be resolved.
    #[error("{name}: {reason}{}", listed("; its overrides are ", overrides))]
    Override {
        /// The file.
        name: String,
        /// What naga says of it.
        reason: String,
        /// The overrides that there are.
        overrides: Vec<String>,
    },
}

/// `before` and the names in quotes; nothing if there are none.
fn listed(before: &str, names: &[String]) -> String {
    let names: Vec<String> = names.iter().map(|n| format!("`{n}`")).collect();
    if names.is_empty() { String::new() } else { format!("{before}{}", names.join(", ")) }
}

/// A panic of naga as an error.
fn guarded<T>(source: &Source, stage: &'static str, work: impl FnOnce() -> T) -> Result<T, ForeignError> {
    let name = || source.name.clone();
    crate::quietly(work).map_err(|message| ForeignError::Panicked { name: name(), stage, message })
}
