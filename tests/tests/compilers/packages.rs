//! Each package whole, by its engine or the nearest tool.

use crate::common::tool;
use crate::document::{first_line, locked};
use crate::{Row, files, godot, names, three};
use lobe_backends::translate::{Dxc, DxcOutput, Glslang, web};
use lobe_codegen::package::{Package, PackageFile};
use lobe_codegen::validate::from_wgsl;
use naga_oil::compose::{ComposableModuleDescriptor, Composer};
use std::collections::BTreeMap;

/// What stands before GLSL ES that is to be included.
const ES: &str = "#version 310 es\nprecision highp float;\nprecision highp int;\n";

/// A text of a package.
fn text(kind: Package, path: &str) -> String {
    let found = files(kind).into_iter().find(|(name, _)| name == path);
    found.map(|(_, text)| text).unwrap_or_else(|| panic!("no {path}"))
}

/// All kernels, which were judged as one, and which of them `is_there`.
fn whole(
    verdict: Result<(), String>,
    is_there: impl Fn(&str) -> bool,
) -> Vec<(&'static str, Result<(), String>)> {
    let of = |name| match &verdict {
        Ok(()) if is_there(name) => Ok(()),
        Ok(()) => Err("it is not there".to_owned()),
        Err(why) => Err(why.clone()),
    };
    names().map(|name| (name, of(name))).collect()
}

/// A row for each package and compiler; `None` where one is not here.
pub(crate) fn rows() -> Option<Vec<Row>> {
    let mut rows = plain()?;
    rows.push(bevy());
    let dxc = tool(Dxc::find())?;
    rows.push(by_dxc(&dxc, "unity", &text(Package::Unity, "ShaderLibrary/Lobe.hlsl")));
    rows.push(by_dxc(
        &dxc,
        "unreal",
        &text(Package::Unreal, "Shaders/Lobe.ush").replace("#pragma once\n", ""),
    ));
    rows.extend(in_browser()?);
    Some(rows)
}

fn plain() -> Option<Vec<Row>> {
    let glslang = tool(Glslang::find())?;
    let version = glslang.version().unwrap_or_else(|e| panic!("{e}"));
    let wgsl = from_wgsl(&text(Package::Plain, "wgsl/lobe.wgsl"));
    let is_there = |name: &str| wgsl.as_ref().is_ok_and(|module| module.function(name).is_some());
    let naga = whole(wgsl.as_ref().map(|_| ()).map_err(ToString::to_string), is_there);
    let by_glslang = |path: &str, head: &str| {
        let library = text(Package::Plain, path);
        let verdict = glslang.validate(&format!("{head}{library}\nvoid main() {{}}\n"));
        whole(verdict.map_err(|e| e.to_string()), |name| library.contains(&format!(" {name}(")))
    };
    Some(vec![
        Row::new(["plain", "WGSL", "naga"], locked("naga"), naga),
        by_dxc(&tool(Dxc::find())?, "plain", &text(Package::Plain, "hlsl/lobe.hlsl")),
        Row::new(
            ["plain", "GLSL", "glslang"],
            version.clone(),
            by_glslang("glsl/lobe.glsl", "#version 450\n"),
        ),
        Row::new(["plain", "GLSL ES", "glslang"], version, by_glslang("essl/lobe.essl", ES)),
    ])
}

fn bevy() -> Row {
    let source = text(Package::Bevy, "assets/shaders/lobe.wgsl");
    let mut composer = Composer::default();
    let descriptor =
        ComposableModuleDescriptor { source: &source, file_path: "lobe.wgsl", ..Default::default() };
    let composed = composer.add_composable_module(descriptor).map(|module| module.sanitized_source.clone());
    let text = composed.as_deref().unwrap_or_default();
    let is_there = |name: &str| text.contains(&format!("fn {}(", Package::Bevy.name_of("", name)));
    let verdicts = whole(composed.as_ref().map(|_| ()).map_err(ToString::to_string), is_there);
    Row::new(["bevy", "WGSL", "naga_oil"], locked("naga_oil"), verdicts)
}

/// As a library of DXIL, in which an exported function leaves its name.
fn by_dxc(dxc: &Dxc, package: &'static str, hlsl: &str) -> Row {
    let object = dxc.compile(hlsl, "lib_6_3", None, DxcOutput::Dxil);
    let bytes = object.as_deref().unwrap_or_default();
    let prefix = if package == "plain" { "" } else { "lobe_" };
    let is_there = |name: &str| {
        let mangled = format!("?{prefix}{name}@@Y");
        bytes.windows(mangled.len()).any(|window| window == mangled.as_bytes())
    };
    let verdicts = whole(object.as_ref().map(|_| ()).map_err(ToString::to_string), is_there);
    let (major, minor) = dxc.version();
    Row::new([package, "HLSL, to DXIL (lib_6_3)", "DXC"], format!("{major}.{minor}"), verdicts)
}

/// Those whose engines run in a browser.
fn in_browser() -> Option<Vec<Row>> {
    let browser = tool(web::browser())?;
    let engine = tool(web::godot())?;
    let three_js = tool(web::three())?;
    let all = godot::calling_all(&text(Package::Godot, "lobe/lobe.gdshaderinc"));
    let found = godot::compile(&engine, &BTreeMap::from([("all", all)]));
    let against = found.against["all"].join("\n");
    let verdict = if against.is_empty() { Ok(()) } else { Err(against) };
    let is_there = |name: &str| found.sources["all"].contains(&format!("_lobe_{name}("));
    let version = found.version.trim_start_matches("Godot Engine v").to_owned();
    let version = version.split(" - ").next().unwrap_or_default().to_owned();
    let package: Vec<PackageFile> =
        files(Package::Three).into_iter().map(|(path, text)| PackageFile { path, text }).collect();
    let said = three::put_together(&three_js, &package).join("\n");
    let in_three = if said.is_empty() { Ok(()) } else { Err(said) };
    let chromium = format!("{}; {}", three_js.version(), first_line(&browser));
    Some(vec![
        Row::new(["godot", "its language, to WebGL", "Godot"], version, whole(verdict, is_there)),
        Row::new(["three", "WGSL in a material", "three.js, a browser"], chromium, whole(in_three, |_| true)),
    ])
}
