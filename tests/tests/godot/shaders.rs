//! Shaders for Godot out of a library, and what Godot makes of them.

use crate::common::site::{Gpu, Site};
use lobe_backends::translate::web;
use lobe_codegen::def::{FunctionDef, Scalar, TypeDef};
use lobe_kernels::registry::KERNELS;
use std::collections::BTreeMap;

const PAGE: &str = "<!DOCTYPE html><canvas id=\"canvas\" width=\"64\" height=\"64\"></canvas><script \
                    src=\"/godot/index.js\"></script><script type=\"module\" src=\"/page.js\"></script>";

/// What Godot says against each of `shaders`, and what it made of them that the driver took.
pub(crate) struct Compiled {
    /// By shader; nothing, unless it is wrong.
    pub(crate) against: BTreeMap<String, Vec<String>>,
    /// By shader, what the driver compiled of it; empty where it calls nothing of the library.
    pub(crate) sources: BTreeMap<String, String>,
    /// What Godot calls itself.
    pub(crate) version: String,
}

/// Has Godot compile `shaders`.
pub(crate) fn compile(godot: &web::Package, shaders: &BTreeMap<&str, String>) -> Compiled {
    let shaders = serde_json::to_string(shaders).expect("JSON");
    let texts = [
        ("/page.html", PAGE),
        ("/page.js", include_str!("page.js")),
        ("/shaders.json", &shaders),
        ("/favicon.ico", ""),
    ];
    let site = Site {
        texts: texts.into_iter().map(|(path, text)| (path.to_owned(), text.to_owned())).collect(),
        folders: vec![("/godot/", godot.folder().join("godot"))],
    };
    let sent = site.visit("/page.html", Gpu::WebGl);
    let against: BTreeMap<String, Vec<String>> = serde_json::from_slice(&sent["done"]).expect("JSON");
    assert!(!against.contains_key("page"), "{against:?}");
    let version = String::from_utf8_lossy(&sent["version"]).into_owned();
    Compiled { against, sources: serde_json::from_slice(&sent["sources"]).expect("JSON"), version }
}

/// A shader that calls every kernel, for Godot writes only what is called.
pub(crate) fn calling_all(library: &str) -> String {
    let calls: String = KERNELS.iter().map(|kernel| format!("    total += {};\n", call(kernel()))).collect();
    format!(
        "shader_type spatial;\n\n{library}\nvoid fragment() {{\n    float total = 0.0;\n{calls}    EMISSION = \
         vec3(total);\n}}\n"
    )
}

fn call(kernel: &FunctionDef) -> String {
    let arguments: Vec<String> = kernel.params.iter().map(|p| value(&p.ty)).collect();
    let first = kernel.ret.as_ref().map(first).unwrap_or_default();
    format!("float(lobe_{}({}){first})", kernel.name, arguments.join(", "))
}

/// A value of a type that is not known before the shader runs.
fn value(ty: &TypeDef) -> String {
    let parts = |name: &str, parts: Vec<String>| format!("{name}({})", parts.join(", "));
    let scalar = |scalar: Scalar| match scalar {
        Scalar::F32 => "UV.x",
        Scalar::I32 => "int(UV.x)",
        Scalar::U32 => "uint(UV.x)",
        Scalar::Bool => "(UV.x > 0.5)",
    };
    match ty {
        TypeDef::Scalar(kind) => scalar(*kind).to_owned(),
        TypeDef::Vector(n, kind) => {
            let letter = match kind {
                Scalar::F32 => "",
                Scalar::I32 => "i",
                Scalar::U32 => "u",
                Scalar::Bool => "b",
            };
            parts(&format!("{letter}vec{n}"), vec![scalar(*kind).to_owned(); usize::from(*n)])
        }
        TypeDef::Matrix(columns, rows) => {
            let column = value(&TypeDef::Vector(*rows, Scalar::F32));
            parts(&format!("mat{columns}"), vec![column; usize::from(*columns)])
        }
        TypeDef::Struct(def) => {
            parts(&format!("lobe_{}", def().name), def().fields.iter().map(|f| value(&f.ty)).collect())
        }
        TypeDef::Array(..) | TypeDef::Slice(_) | TypeDef::Atomic(_) => panic!("no kernel takes {ty}"),
    }
}

/// How a scalar is made of a value of a type.
fn first(ty: &TypeDef) -> String {
    match ty {
        TypeDef::Scalar(_) => String::new(),
        TypeDef::Vector(..) => ".x".to_owned(),
        TypeDef::Matrix(..) => "[0].x".to_owned(),
        TypeDef::Struct(def) => format!(".{}{}", def().fields[0].name, first(&def().fields[0].ty)),
        TypeDef::Array(..) | TypeDef::Slice(_) | TypeDef::Atomic(_) => panic!("no kernel returns {ty}"),
    }
}
