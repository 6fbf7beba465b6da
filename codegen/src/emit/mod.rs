//! From a [`ValidModule`] to what a user gets: WGSL, HLSL, GLSL or MSL text, SPIR-V words.
//!
//! naga's writers do the translation; what is done here is what they leave undone.
//!
//! - **Names.** The writers pass every name through one counter for the whole module: the second
//!   function with an argument `x` gets `x_1`, and `x2` becomes `x2_`.
//!   So a copy of the module is written in which everything has a unique name of ours ([`mark`]),
//!   and the tokens of the text are then renamed, scope by scope, to the declared names ([`rename`]).
//!   The text is cut into tokens once ([`scan`]), its [`words`] are looked up once, and all that follows works on these.
//!   What cannot keep its name is refused beforehand ([`clash`]), never renamed silently.
//! - **Docs.** No writer prints doc comments: [`docs`].
//! - **Ease.** They give each call a variable and each operation parentheses: [`readable`].
//! - **Groups.** They know no blank lines and comments within functions: [`groups`].
//! - **Form.** A header, one blank line between items, no trailing blanks: [`tidy`]; no line too long: [`wrap`].
//! - **Panics.** A writer panics on some inputs; each runs behind [`crate::guard`].
//!
//! The output is a function of the module and the options: no dates, no paths, no hash order.

mod calls;
mod clash;
mod docs;
pub mod entry;
mod glsl;
mod groups;
mod hlsl;
pub mod host;
mod layouts;
mod mark;
mod msl;
mod plain;
mod prefix;
mod readable;
pub mod reflect;
mod rename;
pub(crate) mod scan;
mod scope;
mod slots;
mod spirv;
mod tidy;
mod wgsl;
mod words;
mod wrap;

pub use calls::check_calls;
pub use clash::ClashError;
pub use entry::{EntryLayout, with_entries, with_entry};
pub use host::{Host, host};
pub use plain::{Plain, immediates_in_hlsl, plain};
pub use prefix::prefixed;
pub(crate) use prefix::{spelt, without_last_digits};
pub use reflect::{Reflection, reflect};

use crate::ValidModule;

/// A language or format that modules are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Target {
    /// WGSL text.
    Wgsl,
    /// SPIR-V 1.3 words for Vulkan.
    Spirv,
    /// HLSL text for shader model 6.0.
    Hlsl,
    /// GLSL 4.50 text, for Vulkan and OpenGL.
    Glsl,
    /// GLSL ES 3.10 text.
    Essl,
    /// MSL 2.4 text, for Metal.
    Msl,
}

impl Target {
    /// All targets.
    pub const ALL: [Self; 6] = [Self::Wgsl, Self::Spirv, Self::Hlsl, Self::Glsl, Self::Essl, Self::Msl];

    /// Those that are text, which may be a library of functions to include.
    pub const TEXTS: [Self; 5] = [Self::Wgsl, Self::Hlsl, Self::Glsl, Self::Essl, Self::Msl];

    /// Its name: `wgsl`, `spirv`, `hlsl`, `glsl`, `essl`, `msl`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wgsl => "wgsl",
            Self::Spirv => "spirv",
            Self::Hlsl => "hlsl",
            Self::Glsl => "glsl",
            Self::Essl => "essl",
            Self::Msl => "msl",
        }
    }

    /// Its name as its language is written: `WGSL`, `SPIR-V`, `HLSL`, `GLSL`, `GLSL ES`, `MSL`.
    pub fn title(self) -> &'static str {
        match self {
            Self::Wgsl => "WGSL",
            Self::Spirv => "SPIR-V",
            Self::Hlsl => "HLSL",
            Self::Glsl => "GLSL",
            Self::Essl => "GLSL ES",
            Self::Msl => "MSL",
        }
    }

    /// The extension of its files: `wgsl`, `spv`, `hlsl`, `glsl`, `essl`, `metal`.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Wgsl => "wgsl",
            Self::Spirv => "spv",
            Self::Hlsl => "hlsl",
            Self::Glsl => "glsl",
            Self::Essl => "essl",
            Self::Msl => "metal",
        }
    }

    /// What it calls an entry point that is declared as `name`.
    ///
    /// GLSL has but one a file, `main`.
    pub fn entry_name(self, name: &str) -> &str {
        match self {
            Self::Wgsl | Self::Spirv | Self::Hlsl | Self::Msl => name,
            Self::Glsl | Self::Essl => glsl::ENTRY,
        }
    }
}

impl std::fmt::Display for Target {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl std::str::FromStr for Target {
    type Err = EmitError;

    fn from_str(text: &str) -> Result<Self, EmitError> {
        let is_meant =
            |t: &Self| t.name().eq_ignore_ascii_case(text) || t.extension().eq_ignore_ascii_case(text);
        Self::ALL.into_iter().find(is_meant).ok_or_else(|| EmitError::UnknownTarget(text.to_owned()))
    }
}

/// What a target consists of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Content {
    /// Source text.
    Text(String),
    /// SPIR-V words.
    Words(Vec<u32>),
}

impl Content {
    /// The bytes of a file with this content; words are little-endian.
    pub fn bytes(&self) -> Vec<u8> {
        match self {
            Self::Text(text) => text.as_bytes().to_vec(),
            Self::Words(words) => words.iter().flat_map(|word| word.to_le_bytes()).collect(),
        }
    }

    /// The text, when it is one.
    pub fn text(&self) -> Option<&str> {
        match self {
            Self::Text(text) => Some(text),
            Self::Words(_) => None,
        }
    }
}

/// An entry point of an artifact.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EntryInfo {
    /// Its name in this target ([`Target::entry_name`]).
    pub name: String,
    /// Invocations in a workgroup.
    pub workgroup_size: [u32; 3],
}

/// An emitted module.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Artifact {
    /// What it is written in.
    pub target: Target,
    /// The text or the words.
    pub content: Content,
    /// Its entry points, in the module's order; none in a library.
    pub entries: Vec<EntryInfo>,
    /// Names of its functions, in the module's order.
    pub functions: Vec<String>,
}

/// How to write.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    /// Write doc comments.
    pub docs: bool,
    /// Begin the text with a comment that names its maker, its kernels and how to write it again.
    pub header: bool,
    /// Kernels that the header names; when empty, the entry points, or the functions that no other calls.
    pub kernels: Vec<String>,
    /// Command that the header gives for writing the file again; by default `lobe emit ..`.
    pub command: Option<String>,
}

impl Default for Options {
    fn default() -> Self {
        Self { docs: true, header: true, kernels: Vec::new(), command: None }
    }
}

/// Why a module cannot be emitted.
#[derive(Debug, thiserror::Error)]
pub enum EmitError {
    /// No such target.
    #[error("there is no target `{0}`; the targets are wgsl, spirv, hlsl, glsl, essl and msl")]
    UnknownTarget(String),
    /// A name is refused, missing, or taken by something else.
    #[error(transparent)]
    Name(#[from] ClashError),
    /// A target that no route takes.
    #[error("nothing here runs {0}: it can be emitted, but not executed")]
    NotRun(Target),
    /// SPIR-V of a library.
    #[error(
        "the module has no entry point, and Vulkan takes no SPIR-V without one; emit the entry form \
         (`--form entry`), or a text target"
    )]
    NoEntry,
    /// A language whose files have one entry point each.
    #[error(
        "{target} has one entry point a file, a compute shader's; the module has {}: emit them one by one",
        names.join(", ")
    )]
    ManyEntries {
        /// The entry points.
        names: Vec<String>,
        /// The target.
        target: Target,
    },
    /// Two resources that differ in their group alone, in a language without groups.
    #[error(
        "`{first}` and `{second}` both have binding {binding}, and {target} has no groups that tell them apart; give \
         one of them another number"
    )]
    Groups {
        /// The first.
        first: String,
        /// The second.
        second: String,
        /// The number of both.
        binding: u32,
        /// The target.
        target: Target,
    },
    /// A number that the writer has no room for.
    #[error("`{name}` has binding {binding}; in {target} numbers go to 255, so give it a smaller one")]
    Binding {
        /// The resource.
        name: String,
        /// Its number.
        binding: u32,
        /// The target.
        target: Target,
    },
    /// The writer says no.
    #[error("naga's {target} writer refuses the module: {message}")]
    Writer {
        /// The target.
        target: Target,
        /// Its reason.
        message: String,
    },
    /// The writer panicked.
    #[error("naga's {target} writer panicked ({message}); this is a fault of naga, please report the module")]
    Panicked {
        /// The target.
        target: Target,
        /// The panic's words.
        message: String,
    },
    /// A name that JavaScript has another use for, in a package that is a module of JavaScript.
    #[error(
        "`{0}` cannot be exported from a module of JavaScript, which uses that word itself; choose another name"
    )]
    Export(String),
    /// A matrix that is not square, in a package for Godot.
    #[error(
        "Godot's shading language has square matrices alone, and no `{0}`; use vectors, or another package"
    )]
    Matrix(String),
    /// A function that no entry point can be made for.
    #[error("no entry point can be made for `{function}`: {reason}")]
    Entry {
        /// The function.
        function: String,
        /// Why.
        reason: String,
    },
}

/// Writes `module` for `target`.
///
/// ```
/// use lobe_codegen::emit::{Options, Target, emit};
/// use lobe_codegen::prelude::*;
///
/// /// Keeps `x` at 0 and above.
/// #[kernel]
/// pub fn positive(x: f32) -> f32 {
///     max(x, 0.0)
/// }
///
/// let module = lobe_codegen::lower(&lobe_codegen::kernels![positive])?;
/// let plain = Options { docs: false, header: false, ..Options::default() };
/// let wgsl = emit(&module, Target::Wgsl, &plain)?;
/// assert_eq!(wgsl.content.text(), Some("fn positive(x: f32) -> f32 {\n    return max(x, 0f);\n}\n"));
/// // Vulkan takes no SPIR-V without an entry point.
/// assert!(emit(&module, Target::Spirv, &plain).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When a name is not portable or two names clash, when the target cannot express the module, and
/// when SPIR-V is asked of a module without entry points.
pub fn emit(module: &ValidModule, target: Target, options: &Options) -> Result<Artifact, EmitError> {
    clash::check(module.module())?;
    let content = match target {
        Target::Wgsl => Content::Text(wgsl::write(module, options)?),
        Target::Hlsl => Content::Text(hlsl::write(module, options)?),
        Target::Glsl | Target::Essl => Content::Text(glsl::write(module, target, options)?),
        Target::Msl => Content::Text(msl::write(module, options)?),
        Target::Spirv => Content::Words(spirv::write(module)?),
    };
    let entry = |e: &naga::EntryPoint| EntryInfo {
        name: target.entry_name(&e.name).to_owned(),
        workgroup_size: e.workgroup_size,
    };
    Ok(Artifact {
        target,
        content,
        entries: module.module().entry_points.iter().map(entry).collect(),
        functions: module.module().functions.iter().filter_map(|(_, f)| f.name.clone()).collect(),
    })
}

/// Bytes that a writer's text has room for at once; kernels with all that they call need about as many.
const SIZE: usize = 1 << 14;

/// Runs a writer; its error and its panic become ours.
fn guarded<T, E: std::fmt::Display>(
    target: Target,
    work: impl FnOnce() -> Result<T, E>,
) -> Result<T, EmitError> {
    match crate::guard::quietly(work) {
        Ok(Ok(done)) => Ok(done),
        Ok(Err(error)) => Err(EmitError::Writer { target, message: error.to_string() }),
        Err(message) => Err(EmitError::Panicked { target, message }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_found_by_name_and_by_extension() {
        for target in Target::ALL {
            assert_eq!(target.name().parse::<Target>().unwrap(), target);
            assert_eq!(target.extension().to_uppercase().parse::<Target>().unwrap(), target);
        }
        assert!("metal-ir".parse::<Target>().unwrap_err().to_string().contains("the targets are"));
    }

    #[test]
    fn a_panic_of_a_writer_is_an_error_that_says_whose_fault_it_is() {
        let error = guarded(Target::Hlsl, || -> Result<(), String> { panic!("no {}", "f64") }).unwrap_err();
        assert!(error.to_string().starts_with("naga's hlsl writer panicked (no f64)"), "{error}");
    }
}
