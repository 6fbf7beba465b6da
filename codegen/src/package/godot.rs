//! An include file for Godot 4, whose shading language is a part of GLSL ES 3.0 with names of its own.

use super::example::{self, Example};
use super::{Contents, PackageFile, file};
use crate::emit::{EmitError, Target};

pub(super) fn files(contents: &Contents<'_>) -> Result<Vec<PackageFile>, EmitError> {
    let mut files = vec![file("lobe/lobe.gdshaderinc", contents.library(Target::Essl)?)];
    if let Some(example) = example::of(contents) {
        files.push(file("lobe/example.gdshader", shader(&example)));
    }
    files.push(contents.readme("Lobe's kernels for Godot", USAGE));
    Ok(files)
}

/// A material that shines as a kernel says.
fn shader(example: &Example) -> String {
    let function = &example.function;
    let arguments: Vec<String> = function.parameters.iter().map(|p| example.value(&p.ty)).collect();
    let returns = function.returns.as_deref().unwrap_or_default();
    format!(
        "shader_type spatial;\nrender_mode unshaded;\n\n#include \"res://lobe/lobe.gdshaderinc\"\n\nuniform float \
         brightness = 1.0;\n\nvoid fragment() {{\n    {} result = {}({});\n    EMISSION = vec3(brightness * \
         float(result{}));\n}}\n",
        Example::spelled(returns, Target::Essl),
        function.name,
        arguments.join(", "),
        example.first(returns)
    )
}

const USAGE: &str = "\
Copy `lobe/` into your project, then, in a shader:

```glsl
#include \"res://lobe/lobe.gdshaderinc\"
```

Names begin with `lobe_`, since the language has `PI`, `TAU` and `E` as constants.
Godot itself was not at hand: the text is held to GLSL ES by glslang, not to Godot's parser.
";
