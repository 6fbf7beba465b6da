//! Kernels as a folder that an engine takes as it is: the shader in the engine's language, under names that do not
//! clash with the engine's, with an example and the way to use it.
//!
//! | package | engine | file | names |
//! |---|---|---|---|
//! | `plain` | any | each language in a folder of its own, structures for hosts | as declared |
//! | `bevy` | Bevy | WGSL, a module of naga_oil | as declared, within `lobe::`; a last digit is spelt, `f0` as `f_zero` |
//! | `unity` | Unity | HLSL with an include guard | `lobe_..` |
//! | `unreal` | Unreal Engine | HLSL (`.ush`) | `lobe_..` |
//! | `godot` | Godot 4 | its shading language (`.gdshaderinc`) | `lobe_..` |
//! | `three` | three.js, `WebGPURenderer` | WGSL in functions of TSL, a module of JavaScript (`lobe.js`) | exported as declared; `lobe_..` in the WGSL |
//!
//! Engines define `PI`, `TWO_PI` and their like as macros or constants for every shader; hence the prefix.
//! three.js declares nothing with it either, and gives a function whose name is taken another one, under which the
//! functions that call it do not look for it.

mod bevy;
mod example;
mod godot;
mod hlsl;
mod plain;
mod three;

use crate::ValidModule;
use crate::emit::{EmitError, Options, Target, emit, prefixed, reflect, spelt, without_last_digits};

/// An engine's way to take shaders.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Package {
    /// Folders by language.
    Plain,
    /// A module for Bevy's preprocessor, naga_oil.
    Bevy,
    /// A package of Unity's package manager.
    Unity,
    /// A folder of shaders for Unreal Engine.
    Unreal,
    /// An include file for Godot 4.
    Godot,
    /// A module of functions for three.js.
    Three,
}

impl Package {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Plain, Self::Bevy, Self::Unity, Self::Unreal, Self::Godot, Self::Three];

    /// Its name: `plain`, `bevy`, `unity`, `unreal`, `godot`, `three`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Bevy => "bevy",
            Self::Unity => "unity",
            Self::Unreal => "unreal",
            Self::Godot => "godot",
            Self::Three => "three",
        }
    }

    /// What its users call the kernel `name`, when names begin with `prefix`.
    pub fn name_of(self, prefix: &str, name: &str) -> String {
        match self {
            Self::Bevy => spelt(&format!("{prefix}{name}")),
            Self::Plain | Self::Unity | Self::Unreal | Self::Godot => format!("{prefix}{name}"),
            Self::Three => name.to_owned(),
        }
    }

    /// What stands before its names unless something else is asked for.
    pub fn prefix(self) -> &'static str {
        match self {
            Self::Plain | Self::Bevy => "",
            Self::Unity | Self::Unreal | Self::Godot | Self::Three => "lobe_",
        }
    }
}

/// A file of a package.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PackageFile {
    /// Where it lies, with `/` between folders.
    pub path: String,
    /// Its text.
    pub text: String,
}

/// The package of the library `module`, whose kernels are called `kernels`; every name of it begins with `prefix`.
///
/// ```
/// use lobe_codegen::package::{Package, package};
/// use lobe_codegen::prelude::*;
///
/// /// Brightens.
/// #[kernel]
/// pub fn brighten(colour: Vec3, factor: f32) -> Vec3 {
///     factor * colour
/// }
///
/// let module = lobe_codegen::lower(&lobe_codegen::kernels![brighten])?;
/// let files = package(&module, &["brighten".to_owned()], Package::Unity, Package::Unity.prefix())?;
/// assert!(files.iter().any(|file| file.path == "package.json"));
/// assert!(files.iter().any(|file| file.text.contains("float3 lobe_brighten(float3 colour, float factor)")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// When a name is not portable, or a language cannot express the module.
pub fn package(
    module: &ValidModule,
    kernels: &[String],
    package: Package,
    prefix: &str,
) -> Result<Vec<PackageFile>, EmitError> {
    let module = if prefix.is_empty() { module.clone() } else { prefixed(module, prefix)? };
    let module = if package == Package::Bevy { without_last_digits(&module)? } else { module };
    let spell = |name: &String| match package {
        Package::Bevy => package.name_of(prefix, name),
        Package::Plain | Package::Unity | Package::Unreal | Package::Godot | Package::Three => {
            format!("{prefix}{name}")
        }
    };
    let contents = Contents {
        module: &module,
        prefix,
        prefixed: kernels.iter().map(spell).collect(),
        called: kernels.iter().map(|name| package.name_of(prefix, name)).collect(),
        command: command(kernels, package, prefix),
    };
    match package {
        Package::Plain => plain::files(&contents),
        Package::Bevy => bevy::files(&contents),
        Package::Unity => hlsl::unity(&contents),
        Package::Unreal => hlsl::unreal(&contents),
        Package::Godot => godot::files(&contents),
        Package::Three => three::files(&contents),
    }
}

/// The command that writes a package again.
fn command(kernels: &[String], package: Package, prefix: &str) -> String {
    let prefix = match prefix {
        usual if usual == package.prefix() => String::new(),
        "" => " --prefix ''".to_owned(),
        other => format!(" --prefix {other}"),
    };
    match kernels {
        few if few.len() <= 4 => {
            format!("lobe emit --package {}{prefix} {}", package.name(), few.join(" "))
        }
        _ => format!("lobe emit --package {}{prefix} ..", package.name()),
    }
}

/// What goes into a package.
struct Contents<'a> {
    /// The library, under the package's names.
    module: &'a ValidModule,
    /// What every name of it begins with.
    prefix: &'a str,
    /// The names of its kernels there.
    prefixed: Vec<String>,
    /// What users call them.
    called: Vec<String>,
    /// The command that writes it.
    command: String,
}

impl Contents<'_> {
    /// The library in a language.
    fn library(&self, target: Target) -> Result<String, EmitError> {
        let options = Options {
            kernels: self.prefixed.clone(),
            command: Some(self.command.clone()),
            ..Options::default()
        };
        Ok(emit(self.module, target, &options)?.content.text().unwrap_or_default().to_owned())
    }

    /// Its description.
    fn reflection(&self) -> Result<String, EmitError> {
        let json = reflect(self.module).to_json();
        json.map_err(|e| EmitError::Entry { function: "the description".to_owned(), reason: e.to_string() })
    }

    /// A page that says what lies here and how it is used; `usage` speaks of `lobe_` as the prefix.
    fn readme(&self, title: &str, usage: &str) -> PackageFile {
        let usage = match self.prefix {
            "" => usage
                .replace("ames begin with `lobe_`, since", "ames have no prefix here, although")
                .replace("ames begin with `lobe_`", "ames have no prefix here"),
            _ => usage.to_owned(),
        };
        let usage = usage.replace("lobe_", self.prefix);
        let kernels: String = self.called.iter().map(|name| format!("- `{name}`\n")).collect();
        let text = format!(
            "# {title}\n\nWritten by Lobe {}; write it again with `{}`.\n\n{usage}\n## Kernels\n\n{kernels}\nEach \
             function's comment states its source, its arguments, and by how much it may err.\n",
            env!("CARGO_PKG_VERSION"),
            self.command
        );
        file("README.md", text)
    }
}

fn file(path: &str, text: impl Into<String>) -> PackageFile {
    PackageFile { path: path.to_owned(), text: text.into() }
}
