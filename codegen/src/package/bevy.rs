//! A module for Bevy's shader preprocessor, naga_oil.

use super::example::{self, Example};
use super::{Contents, PackageFile, file};
use crate::emit::{EmitError, Target};

pub(super) fn files(contents: &Contents<'_>) -> Result<Vec<PackageFile>, EmitError> {
    let library = contents.library(Target::Wgsl)?;
    let mut files = vec![file("assets/shaders/lobe.wgsl", format!("#define_import_path lobe\n\n{library}"))];
    if let Some(example) = example::of(contents) {
        files.push(file("assets/shaders/example.wgsl", shader(&example)));
    }
    files.push(contents.readme("Lobe's kernels for Bevy", USAGE));
    Ok(files)
}

/// A compute shader that applies a kernel to rows of buffers.
fn shader(example: &Example) -> String {
    let function = &example.function;
    // Structures of the library are used by the path that they are imported from.
    let spell =
        |ty: &str| if ty.contains('<') || ty.len() == 3 { ty.to_owned() } else { format!("lobe::{ty}") };
    let mut text = "#import lobe\n\n".to_owned();
    for (i, parameter) in function.parameters.iter().enumerate() {
        let ty = spell(&parameter.ty);
        let name = &parameter.name;
        text += &format!("@group(0) @binding({i}) var<storage, read> {name}_values: array<{ty}>;\n");
    }
    let count = function.parameters.len();
    let returns = function.returns.as_deref().map(spell).unwrap_or_default();
    let arguments: Vec<String> =
        function.parameters.iter().map(|p| format!("{}_values[id.x]", p.name)).collect();
    text + &format!(
        "@group(0) @binding({count}) var<storage, read_write> results: array<{returns}>;\n\n@compute \
         @workgroup_size(64)\nfn example(@builtin(global_invocation_id) id: vec3<u32>) {{\n    if id.x < \
         arrayLength(&results) {{\n        results[id.x] = lobe::{}({});\n    }}\n}}\n",
        function.name,
        arguments.join(", ")
    )
}

const USAGE: &str = "\
Copy `assets/` into your app's, load `shaders/lobe.wgsl` once and keep its handle, so that Bevy knows the module:

```rust
#[derive(Resource)]
struct LobeShader(Handle<Shader>);

fn load(mut commands: Commands, assets: Res<AssetServer>) {
    commands.insert_resource(LobeShader(assets.load(\"shaders/lobe.wgsl\")));
}
```

Then, in a shader: `#import lobe` and `lobe::NAME(..)`.

naga_oil refuses names that end in a digit, so that digit is spelt: the member `f0` is `f_zero` here.
";
