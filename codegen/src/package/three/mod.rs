//! A module of JavaScript for three.js, whose `WebGPURenderer` builds shaders out of nodes.
//!
//! A kernel is a `wgslFn` with what it uses as its includes, a structure is a `struct` of the shading language TSL, so
//! that nodes can make one and ask for its members, and a constant is a piece of WGSL.

mod declarations;
mod example;
mod items;

use super::{Contents, PackageFile, file};
use crate::emit::{EmitError, Target};
use items::{Item, Kind};

/// Words of JavaScript that are free in shading languages, and what the module imports and declares itself.
const TAKEN: [&str; 8] = ["arguments", "eval", "function", "returning", "struct", "using", "wgsl", "wgslFn"];

pub(super) fn files(contents: &Contents<'_>) -> Result<Vec<PackageFile>, EmitError> {
    let library = contents.library(Target::Wgsl)?;
    let items = items::items(&library, contents.prefix);
    if let Some(item) = items.iter().find(|item| TAKEN.contains(&item.exported)) {
        return Err(EmitError::Export(item.exported.to_owned()));
    }
    let mut files = vec![
        file("lobe.js", module(contents, &items)),
        file("lobe.d.ts", declarations::declarations(contents, &items)),
        file("package.json", manifest()),
    ];
    if let Some(page) = example::page(contents) {
        files.push(file("example.html", page));
    }
    files.push(contents.readme("Lobe's kernels for three.js", USAGE));
    Ok(files)
}

/// Whether users of the module see it: kernels, and structures that kernels take and return.
fn is_exported(contents: &Contents<'_>, item: &Item<'_>) -> bool {
    match item.kind {
        Kind::Structure => true,
        Kind::Constant => false,
        Kind::Function { .. } => contents.called.iter().any(|name| name == item.exported),
    }
}

fn module(contents: &Contents<'_>, items: &[Item<'_>]) -> String {
    let functions: Vec<&str> = [
        ("struct", items.iter().any(|item| item.kind == Kind::Structure)),
        ("wgsl", items.iter().any(|item| item.is_code())),
        ("wgslFn", items.iter().any(|item| item.kind == Kind::Function { returns: true })),
    ]
    .into_iter()
    .filter_map(|(name, is_used)| is_used.then_some(name))
    .collect();
    let mut text = format!(
        "// Written by Lobe {}.\n// Do not edit; write it again with: {}\n\nimport {{ {} }} from 'three/tsl';\n{USING}{RETURNING}",
        env!("CARGO_PKG_VERSION"),
        contents.command,
        functions.join(", ")
    );
    for item in items {
        let export = if is_exported(contents, item) { "export " } else { "" };
        let is_line = item.kind == Kind::Constant && item.docs.is_empty();
        let begin = if is_line && text.ends_with("`);\n") { "" } else { "\n" };
        let docs = items::comment(&item.docs, "");
        text += &format!("{begin}{docs}{export}const {} = {};\n", item.exported, value(item, items));
    }
    text
}

/// three.js tells what it has written already by the node's identity. What `struct` and `wgslFn` return passes for the
/// node as an include, but has an identity of its own, so that one item would be declared twice.
const USING: &str = "
/** Structures, kernels and pieces of code as the includes of a `wgslFn` or a `wgsl`. */
export const using = (...items) => items.map((item) => {
    if (typeof item !== 'function') return item;
    const { structTypeNode, functionNode } = item({});
    return structTypeNode ?? functionNode;
});
";

/// three.js looks for a structure's members when it asks for their types, which may be before it has come to the
/// function that brings the structure.
const RETURNING: &str = "
/** A function that returns the first of `structures`; the others are those of its members. */
const returning = (structures, kernel) => {
    const types = using(...structures);
    const { functionNode } = kernel({});
    functionNode.getMemberType = (builder, name) => {
        types.forEach((type) => builder.getStructTypeFromNode(type, type.membersLayout, type.name));
        return types[0].getMemberType(builder, name);
    };
    return kernel;
};
";

/// The node that an item is.
fn value(item: &Item<'_>, items: &[Item<'_>]) -> String {
    let used: Vec<&str> = item.uses.iter().map(|&i| items[i].exported).collect();
    let includes = if used.is_empty() { String::new() } else { format!(", using({})", used.join(", ")) };
    match item.kind {
        Kind::Structure => {
            let member = |m: &items::Member<'_>| {
                format!("{}    {}: '{}',\n", items::comment(&m.docs, "    "), m.name, items::in_tsl(m.ty))
            };
            let members: String = item.members().iter().map(member).collect();
            format!("struct({{\n{members}}}, '{}')", item.name)
        }
        Kind::Function { returns: true } => {
            let function = format!("wgslFn(`{}`{includes})", template(&item.code));
            match items::structures(item.returns(), items) {
                none if none.is_empty() => function,
                names => format!("returning([{}], {function})", names.join(", ")),
            }
        }
        Kind::Constant | Kind::Function { returns: false } => {
            format!("wgsl(`{}`{includes})", template(&item.code))
        }
    }
}

/// Text as it stands in a template literal.
fn template(text: &str) -> String {
    text.replace('\\', "\\\\").replace('`', "\\`").replace("${", "\\${")
}

fn manifest() -> String {
    format!(
        "{{\n  \"name\": \"lobe-shaders\",\n  \"version\": \"{}\",\n  \"description\": \"Spherical-Gaussian lighting as \
         tested shader source\",\n  \"private\": true,\n  \"type\": \"module\",\n  \"main\": \"lobe.js\",\n  \"types\": \
         \"lobe.d.ts\",\n  \"peerDependencies\": {{ \"three\": \">=0.187.0\" }}\n}}\n",
        env!("CARGO_PKG_VERSION")
    )
}

const USAGE: &str = "\
`npm install` beside this file brings three.js; then serve the folder from `localhost` and open `example.html`.

```js
import { vec3, float, normalWorld } from 'three/tsl';
import { Sg, sg_eval } from './lobe.js';

const lobe = Sg({ axis: vec3(0, 0, 1), sharpness: float(8), log_amplitude: float(0) });
material.colorNode = vec3(sg_eval({ dir: normalWorld, sg: lobe }));
```

A kernel takes its arguments by name and returns a node; a structure's members are `node.get('axis')`.
Members of a structure are nodes, as `float(8)`: three.js takes a bare number there for 0.

The functions need `WebGPURenderer` on WebGPU: three.js hands WGSL to no WebGL.

In the WGSL, names begin with `lobe_`: all of three.js' own code and yours lies in one scope there, and three.js gives a
function whose name is taken another one, under which its callers do not find it. A `wgslFn` of your own that calls a
kernel names it so, and includes it by `using`:

```js
const twice = wgslFn('fn twice(x: f32) -> f32 { return 2.0 * lobe_erf(x); }', using(erf));
```
";
