//! HLSL for Unity and Unreal Engine.

use super::example::{self, Example};
use super::{Contents, PackageFile, file};
use crate::emit::{EmitError, Target};

/// A package of Unity's package manager.
pub(super) fn unity(contents: &Contents<'_>) -> Result<Vec<PackageFile>, EmitError> {
    let library = contents.library(Target::Hlsl)?;
    let guarded =
        format!("#ifndef LOBE_INCLUDED\n#define LOBE_INCLUDED\n\n{library}\n#endif // LOBE_INCLUDED\n");
    let mut files = vec![file("package.json", unity_manifest()), file("ShaderLibrary/Lobe.hlsl", guarded)];
    if let Some(example) = example::of(contents) {
        let include = "#include \"Packages/com.lobe.shaders/ShaderLibrary/Lobe.hlsl\"";
        let head = format!("#pragma kernel Example\n{include}\n");
        files.push(file("Samples~/Example/Example.compute", head + &compute(&example)));
    }
    files.push(contents.readme("Lobe's kernels for Unity", UNITY));
    Ok(files)
}

fn unity_manifest() -> String {
    format!(
        "{{\n  \"name\": \"com.lobe.shaders\",\n  \"version\": \"{}\",\n  \"displayName\": \"Lobe\",\n  \"description\": \
         \"Spherical-Gaussian lighting as tested shader source\",\n  \"unity\": \"2021.3\",\n  \"samples\": [\n    {{ \
         \"displayName\": \"Example\", \"description\": \"A kernel applied to rows of buffers\", \"path\": \
         \"Samples~/Example\" }}\n  ]\n}}\n",
        env!("CARGO_PKG_VERSION")
    )
}

const UNITY: &str = "\
Copy the folder into your project's `Packages/` as `com.lobe.shaders`, then, in a shader:

```hlsl
#include \"Packages/com.lobe.shaders/ShaderLibrary/Lobe.hlsl\"
```

Names begin with `lobe_`, since Unity's own includes define `PI`, `TWO_PI` and others as macros.
A structured buffer of a structure has the layout of `lobe emit --host`'s structures.
";

/// A folder of shaders for Unreal Engine.
pub(super) fn unreal(contents: &Contents<'_>) -> Result<Vec<PackageFile>, EmitError> {
    let library = contents.library(Target::Hlsl)?;
    let mut files = vec![file("Shaders/Lobe.ush", format!("#pragma once\n\n{library}"))];
    if let Some(example) = example::of(contents) {
        let head = "#include \"/Engine/Public/Platform.ush\"\n#include \"/Lobe/Lobe.ush\"\n";
        files.push(file("Shaders/LobeExample.usf", head.to_owned() + &compute(&example)));
    }
    files.push(contents.readme("Lobe's kernels for Unreal Engine", UNREAL));
    Ok(files)
}

const UNREAL: &str = "\
Copy `Shaders/` into your plugin and map it when the plugin's module starts up:

```cpp
AddShaderSourceDirectoryMapping(TEXT(\"/Lobe\"), FPaths::Combine(Plugin->GetBaseDir(), TEXT(\"Shaders\")));
```

Then, in a `.usf` or a custom material node:

```hlsl
#include \"/Lobe/Lobe.ush\"
```

Names begin with `lobe_`, since the engine's own includes declare `PI` and others.
";

/// A compute shader that applies a kernel to rows of structured buffers.
fn compute(example: &Example) -> String {
    let function = &example.function;
    let spell = |ty: &str| Example::spelled(ty, Target::Hlsl);
    let mut text = "\n".to_owned();
    for parameter in &function.parameters {
        text += &format!("StructuredBuffer<{}> {}_values;\n", spell(&parameter.ty), parameter.name);
    }
    let returns = function.returns.as_deref().map(spell).unwrap_or_default();
    let arguments: Vec<String> =
        function.parameters.iter().map(|p| format!("{}_values[id.x]", p.name)).collect();
    text + &format!(
        "RWStructuredBuffer<{returns}> results;\nuint row_count;\n\n[numthreads(64, 1, 1)]\nvoid Example(uint3 id : \
         SV_DispatchThreadID)\n{{\n    if (id.x < row_count) {{\n        results[id.x] = {}({});\n    }}\n}}\n",
        function.name,
        arguments.join(", ")
    )
}
