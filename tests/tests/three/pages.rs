//! The pages that the browser is shown.

use crate::common::site::{Gpu, Sent, Site};
use lobe_backends::translate::web;
use lobe_codegen::data::{Columns, leaves};
use lobe_codegen::def::{FunctionDef, FunctionRef, Scalar, TypeDef};
use lobe_codegen::package::PackageFile;
use lobe_kernels::registry::KERNELS;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::Path;

const PRELUDE: &str = include_str!("prelude.js");

/// The package as a folder beside which three.js was installed.
fn site(three: &web::Package, files: &[PackageFile]) -> Site {
    let texts = files.iter().map(|file| (format!("/{}", file.path), file.text.clone()));
    let mut site =
        Site { texts: texts.collect(), folders: vec![("/node_modules/", three.modules().to_owned())] };
    site.texts.insert("/favicon.ico".to_owned(), String::new());
    site
}

/// What the page said of faults and warnings.
fn said(sent: &Sent) -> Vec<String> {
    serde_json::from_slice(&sent["done"]).expect("JSON")
}

/// A page of ours that imports what the example does.
fn page(site: &Site, script: &str) -> String {
    let example = &site.texts["/example.html"];
    let map =
        example.split_once("<script type=\"importmap\">").and_then(|(_, rest)| rest.split_once("</script>"));
    let map = map.expect("an import map").0;
    format!(
        "<!DOCTYPE html><script>{PRELUDE}</script><script type=\"importmap\">{map}</script><script \
         type=\"module\">{script}</script>"
    )
}

/// What each kernel gives for its arguments in the browser, or what is wrong with the page.
pub(crate) fn run(
    three: &web::Package,
    files: &[PackageFile],
    kernels: &[FunctionRef],
    args: &BTreeMap<String, Columns>,
) -> Result<BTreeMap<String, Columns>, Vec<String>> {
    let mut site = site(three, files);
    let kernels: Vec<Value> = kernels.iter().map(|k| kernel(k(), &args[k().name])).collect();
    site.texts.insert("/kernels.json".to_owned(), Value::from(kernels).to_string());
    site.texts.insert("/kernels.html".to_owned(), page(&site, include_str!("kernels.js")));
    let sent = site.visit("/kernels.html", Gpu::WebGpu);
    let said = said(&sent);
    if !said.is_empty() {
        return Err(said);
    }
    let results: BTreeMap<String, Vec<u32>> = serde_json::from_slice(&sent["results"]).expect("JSON");
    Ok(results
        .into_iter()
        .map(|(name, words)| (name.clone(), columns(&name, &words, &args[&name])))
        .collect())
}

/// What is wrong with all kernels in one shader.
pub(crate) fn put_together(three: &web::Package, files: &[PackageFile]) -> Vec<String> {
    let mut site = site(three, files);
    let kernels: Vec<Value> = KERNELS.iter().map(|k| kernel(k(), &Columns::default())).collect();
    site.texts.insert("/kernels.json".to_owned(), Value::from(kernels).to_string());
    site.texts.insert("/together.html".to_owned(), page(&site, include_str!("together.js")));
    said(&site.visit("/together.html", Gpu::WebGpu))
}

fn columns(name: &str, words: &[u32], args: &Columns) -> Columns {
    let width = words.len() / args.rows;
    assert_eq!(width * args.rows, words.len(), "{name}");
    let rows: Vec<Vec<u32>> = words.chunks(width).map(<[u32]>::to_vec).collect();
    Columns::from_rows(width, &rows)
}

/// A kernel and rows of its arguments.
fn kernel(def: &FunctionDef, args: &Columns) -> Value {
    let result = def.ret.as_ref().expect("a kernel returns a value");
    let words: Vec<u32> = (0..args.rows).flat_map(|row| args.row(row)).collect();
    json!({
        "name": def.name,
        "rows": args.rows,
        "parameters": def.params.iter().map(|p| json!([p.name, kind(&p.ty)])).collect::<Vec<_>>(),
        "result": kind(result),
        "width": leaves("", result).len(),
        "words": words,
    })
}

/// A type, as the page reads and writes its values.
fn kind(ty: &TypeDef) -> Value {
    match ty {
        TypeDef::Scalar(scalar) => json!({ "name": scalar_name(*scalar) }),
        TypeDef::Vector(n, scalar) => {
            let prefix = match scalar {
                Scalar::F32 => "",
                Scalar::I32 => "i",
                Scalar::U32 => "u",
                Scalar::Bool => "b",
            };
            json!({ "name": format!("{prefix}vec{n}"), "scalar": scalar_name(*scalar), "size": n })
        }
        TypeDef::Struct(def) => {
            let members: Vec<Value> = def().fields.iter().map(|f| json!([f.name, kind(&f.ty)])).collect();
            json!({ "structure": def().name, "members": members })
        }
        TypeDef::Matrix(n, m) if n == m => {
            let column = kind(&TypeDef::Vector(*n, Scalar::F32));
            json!({ "name": format!("mat{n}"), "column": column, "size": n })
        }
        TypeDef::Matrix(..) | TypeDef::Array(..) | TypeDef::Slice(_) | TypeDef::Atomic(_) => {
            panic!("no kernel has had {ty} as an argument or a result; let the page have it too")
        }
    }
}

fn scalar_name(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::F32 => "float",
        Scalar::I32 => "int",
        Scalar::U32 => "uint",
        Scalar::Bool => "bool",
    }
}

/// The colour in the middle of the example's picture, which is kept as `three.png` in the build's folder for tests.
pub(crate) fn show_example(three: &web::Package, files: &[PackageFile]) -> [u8; 3] {
    let mut site = site(three, files);
    let watch = "let frames = 0;\nrequestAnimationFrame(function watch() {\n    if (drawn.texture && ++frames > 3) \
                 sendPicture(); else requestAnimationFrame(watch);\n});\n";
    let page = site.texts["/example.html"].replacen(
        "<script",
        &format!("<script>{PRELUDE}{watch}</script>\n<script"),
        1,
    );
    site.texts.insert("/example.html".to_owned(), page);
    let sent = site.visit("/example.html", Gpu::WebGpu);
    assert_eq!(said(&sent), Vec::<String>::new());
    let kept = Path::new(env!("CARGO_TARGET_TMPDIR")).join("three.png");
    std::fs::write(kept, &sent["picture.png"]).expect("writable");
    serde_json::from_slice(&sent["middle"]).expect("JSON")
}
