//! Each language in a folder of its own.

use super::{Contents, PackageFile, file};
use crate::emit::{EmitError, Host, Target, host};

pub(super) fn files(contents: &Contents<'_>) -> Result<Vec<PackageFile>, EmitError> {
    let mut files = Vec::new();
    for target in Target::TEXTS {
        let path = format!("{}/lobe.{}", target.name(), target.extension());
        files.push(file(&path, contents.library(target)?));
    }
    for language in Host::ALL {
        files.push(file(&format!("host/lobe.{}", language.extension()), host(contents.module, language)));
    }
    files.push(file("lobe.json", contents.reflection()?));
    files.push(contents.readme("Lobe's kernels", USAGE));
    Ok(files)
}

const USAGE: &str = "\
| folder | language | how it is included |
|---|---|---|
| `wgsl` | WGSL | put its text before your shader's |
| `hlsl` | HLSL, shader model 6 | `#include` |
| `glsl` | GLSL 4.50 | below `#version` |
| `essl` | GLSL ES 3.10 | below `#version` and `precision highp float; precision highp int;` |
| `msl` | MSL 2.4 | `#include`; emitted, and compiled by nobody here |
| `host` | Rust, C and C++ | structures with the layout that WGSL, GLSL (std430) and HLSL (structured buffers) have |

`lobe.json` describes functions, structures and constants.
";
