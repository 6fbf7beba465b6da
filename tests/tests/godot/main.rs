//! The package for Godot, compiled by Godot: its build for pages, on WebGL in a browser.

#[path = "../common/mod.rs"]
mod common;
mod shaders;

use common::tool;
use lobe_backends::translate::web;
use lobe_codegen::package::{Package, package};
use lobe_kernels::registry::KERNELS;
use shaders::{Compiled, calling_all, compile};
use std::collections::{BTreeMap, BTreeSet};

/// The floats that a text has outside of comments, by their bits.
fn floats(text: &str) -> BTreeSet<u32> {
    let code: String =
        text.lines().map(|line| line.split("//").next().unwrap_or_default().to_owned() + "\n").collect();
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    let exponents = code.replace("e-", "e_").replace("e+", "e");
    let words =
        exponents.split(|c| !is_part(c)).filter(|word| word.starts_with(|c: char| c.is_ascii_digit()));
    words
        .filter(|word| word.contains(['.', 'e']) && !word.starts_with("0x"))
        .filter_map(|word| word.replace("e_", "e-").trim_end_matches('f').parse().ok().map(f32::to_bits))
        .collect()
}

#[test]
fn godot_compiles_the_library_its_example_and_no_fault() {
    let (Some(_), Some(godot)) = (tool(web::browser()), tool(web::godot())) else { return };
    let module = lobe_codegen::lower(KERNELS).unwrap_or_else(|e| panic!("{e}"));
    let names: Vec<String> = KERNELS.iter().map(|k| k().name.to_owned()).collect();
    let files = package(&module, &names, Package::Godot, "lobe_").unwrap_or_else(|e| panic!("{e}"));
    let text = |path: &str| &files.iter().find(|f| f.path == path).expect("a file").text;
    let library = text("lobe/lobe.gdshaderinc");
    let example = text("lobe/example.gdshader");
    let whole = example.replace("#include \"res://lobe/lobe.gdshaderinc\"", library);
    assert_ne!(&whole, example);
    let all = calling_all(library);
    let shaders = BTreeMap::from([
        ("all", all.clone()),
        ("example", whole),
        ("fault of a name", all.replacen("lobe_PI", "PI", 1)),
        ("fault of a type", all.replacen("mat3 ", "mat3x3 ", 1)),
        ("fault of a call", all.replacen("float(lobe_erf(", "float(lobe_erf(UV.y, ", 1)),
    ]);
    let Compiled { against, sources, version } = compile(&godot, &shaders);
    assert!(version.starts_with("Godot Engine v4."), "{version}");
    for (name, against) in against {
        let is_fault = name.starts_with("fault");
        assert!(!is_fault || shaders[name.as_str()] != all, "{name}: nothing was replaced");
        let is_refused = against.iter().any(|line| line.contains("SHADER ERROR"));
        assert!(is_refused == is_fault && (is_fault || against.is_empty()), "{name}: {against:#?}");
    }
    // Godot prints numbers anew.
    let lost: Vec<f32> =
        floats(library).difference(&floats(&sources["all"])).map(|&bits| f32::from_bits(bits)).collect();
    assert!(lost.is_empty(), "numbers of the library that the driver was not given: {lost:?}");
    for name in names {
        assert!(sources["all"].contains(&format!("_lobe_{name}(")), "{name} did not reach the driver");
    }
}
