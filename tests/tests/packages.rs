//! The whole library as a package for each engine compiles with the nearest real tool, among the engine's own names.

mod common;

use common::tool;
use lobe_backends::translate::{Dxc, DxcOutput, Glslang};
use lobe_codegen::package::{Package, PackageFile, package};
use lobe_kernels::registry::KERNELS;
use naga_oil::compose::{ComposableModuleDescriptor, Composer, NagaModuleDescriptor, ShaderType};
use std::collections::BTreeSet;

fn names() -> Vec<String> {
    KERNELS.iter().map(|k| k().name.to_owned()).collect()
}

fn files(kind: Package) -> Vec<PackageFile> {
    let module = lobe_codegen::lower(KERNELS).unwrap_or_else(|e| panic!("{e}"));
    package(&module, &names(), kind, kind.prefix()).unwrap_or_else(|e| panic!("{e}"))
}

#[track_caller]
fn text<'a>(files: &'a [PackageFile], path: &str) -> &'a str {
    let found = files.iter().find(|file| file.path == path);
    found.map(|file| file.text.as_str()).unwrap_or_else(|| panic!("no {path}"))
}

/// The text with each line that includes a file replaced by `of` that file.
fn with_includes(text: &str, of: impl Fn(&str) -> String) -> String {
    let line = |line: &str| match line.strip_prefix("#include \"").and_then(|rest| rest.strip_suffix('"')) {
        Some(path) => of(path),
        None => line.to_owned() + "\n",
    };
    text.lines().map(line).collect()
}

#[test]
fn a_package_says_what_is_in_it() {
    for kind in Package::ALL {
        let files = files(kind);
        let paths: BTreeSet<&str> = files.iter().map(|file| file.path.as_str()).collect();
        assert_eq!(paths.len(), files.len(), "{}", kind.name());
        let readme = text(&files, "README.md");
        for name in names() {
            let name = kind.name_of(kind.prefix(), &name);
            assert!(readme.contains(&format!("- `{name}`\n")), "{}: {name}", kind.name());
        }
        let longest =
            files.iter().filter(|f| f.path.contains("xample")).map(|f| f.text.lines().count()).max();
        assert!(longest.is_none_or(|lines| lines <= 25), "{}: {longest:?}", kind.name());
        assert_eq!(longest.is_none(), kind == Package::Plain, "{}", kind.name());
    }
}

#[test]
fn a_package_speaks_of_the_prefix_that_it_has() {
    let module = lobe_codegen::lower(KERNELS).unwrap_or_else(|e| panic!("{e}"));
    let readme = |kind, prefix| {
        let files = package(&module, &names(), kind, prefix).unwrap_or_else(|e| panic!("{e}"));
        // Below are the names of kernels, of which some have a lobe in them.
        text(&files, "README.md").split("## Kernels").next().unwrap_or_default().to_owned()
    };
    for kind in [Package::Unity, Package::Unreal, Package::Godot, Package::Three] {
        assert!(readme(kind, "lobe_").contains("ames begin with `lobe_`"), "{}", kind.name());
        assert!(readme(kind, "sgl_").contains("ames begin with `sgl_`"), "{}", kind.name());
        assert!(readme(kind, "").contains("ames have no prefix here"), "{}", kind.name());
        assert!(!readme(kind, "sgl_").contains("lobe_"), "{}", kind.name());
        assert!(!readme(kind, "").contains("lobe_"), "{}", kind.name());
    }
}

/// Names that Unity's core library has as macros.
const UNITY: &str = "\
#define PI 3.14159265358979323846
#define TWO_PI 6.28318530717958647693
#define FOUR_PI 12.5663706143591729538
#define INV_PI 0.31830988618379067154
#define HALF_PI 1.57079632679489661923
#define FLT_EPS 5.960464478e-8
#define SHADER_API_D3D11 1
";

#[test]
fn unity_s_include_compiles_beside_its_macros_and_twice() {
    let Some(dxc) = tool(Dxc::find()) else { return };
    let files = files(Package::Unity);
    let library = text(&files, "ShaderLibrary/Lobe.hlsl");
    let whole = format!("{UNITY}{library}{library}");
    let dxil = dxc.compile(&whole, "lib_6_3", None, DxcOutput::Dxil).unwrap_or_else(|e| panic!("{e}"));
    for name in names() {
        let mangled = format!("?lobe_{name}@@Y");
        assert!(dxil.windows(mangled.len()).any(|bytes| bytes == mangled.as_bytes()), "{name}");
    }
    let example = with_includes(text(&files, "Samples~/Example/Example.compute"), |path| {
        assert_eq!(path, "Packages/com.lobe.shaders/ShaderLibrary/Lobe.hlsl");
        format!("{UNITY}{library}")
    });
    let compiled = dxc.compile(&example, "cs_6_0", Some("Example"), DxcOutput::Dxil);
    assert!(compiled.is_ok_and(|object| !object.is_empty()), "{example}");
    let manifest: serde_json::Value =
        serde_json::from_str(text(&files, "package.json")).expect("the manifest is JSON");
    assert_eq!(manifest["name"], "com.lobe.shaders");
}

/// Names that Unreal's common include declares.
const UNREAL: &str =
    "static const float PI = 3.1415926535897932;\nstatic const float MaxHalfFloat = 65504.0;\n";

#[test]
fn unreal_s_include_compiles_beside_its_constants() {
    let Some(dxc) = tool(Dxc::find()) else { return };
    let files = files(Package::Unreal);
    let library = text(&files, "Shaders/Lobe.ush").replace("#pragma once\n", "");
    let dxil = dxc.compile(&format!("{UNREAL}{library}"), "lib_6_3", None, DxcOutput::Dxil);
    let dxil = dxil.unwrap_or_else(|e| panic!("{e}"));
    for name in names() {
        let mangled = format!("?lobe_{name}@@Y");
        assert!(dxil.windows(mangled.len()).any(|bytes| bytes == mangled.as_bytes()), "{name}");
    }
    let example = with_includes(text(&files, "Shaders/LobeExample.usf"), |path| match path {
        "/Engine/Public/Platform.ush" => UNREAL.to_owned(),
        "/Lobe/Lobe.ush" => library.clone(),
        other => panic!("{other}"),
    });
    let compiled = dxc.compile(&example, "cs_6_0", Some("Example"), DxcOutput::Dxil);
    assert!(compiled.is_ok_and(|object| !object.is_empty()), "{example}");
}

/// Constants and variables that Godot's language has.
const GODOT: &str = "#version 310 es
precision highp float;
precision highp int;
const float PI = 3.14159265358979;
const float TAU = 6.28318530717959;
const float E = 2.71828182845905;
vec3 EMISSION;
";

#[test]
fn godot_s_include_is_glsl_es_beside_its_constants() {
    let Some(glslang) = tool(Glslang::find()) else { return };
    let files = files(Package::Godot);
    let example = with_includes(text(&files, "lobe/example.gdshader"), |path| {
        assert_eq!(path, "res://lobe/lobe.gdshaderinc");
        text(&files, "lobe/lobe.gdshaderinc").to_owned()
    });
    let own = |line: &&str| !line.starts_with("shader_type") && !line.starts_with("render_mode");
    let body: String = example.lines().filter(own).map(|line| format!("{line}\n")).collect();
    // A uniform of GLSL ES has no value to begin with.
    let body = body.replace("uniform float brightness = 1.0;", "uniform float brightness;");
    let whole = format!("{GODOT}{body}\nlayout(local_size_x = 1) in;\nvoid main() {{ fragment(); }}\n");
    glslang.validate(&whole).unwrap_or_else(|e| panic!("{e}"));
}

#[test]
fn bevy_s_module_is_composed_by_naga_oil() {
    let files = files(Package::Bevy);
    let mut composer = Composer::default();
    let (library, example) =
        (text(&files, "assets/shaders/lobe.wgsl"), text(&files, "assets/shaders/example.wgsl"));
    let added = composer.add_composable_module(ComposableModuleDescriptor {
        source: library,
        file_path: "shaders/lobe.wgsl",
        ..Default::default()
    });
    assert!(added.is_ok(), "{}", added.err().map(|e| e.emit_to_string(&composer)).unwrap_or_default());
    let made = composer.make_naga_module(NagaModuleDescriptor {
        source: example,
        file_path: "shaders/example.wgsl",
        shader_type: ShaderType::Wgsl,
        ..Default::default()
    });
    let module = made.unwrap_or_else(|e| panic!("{}", e.emit_to_string(&composer)));
    let flags = naga::valid::ValidationFlags::all();
    naga::valid::Validator::new(flags, naga::valid::Capabilities::empty())
        .validate(&module)
        .unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(module.entry_points.len(), 1);
}

/// Every function of the library can be imported, not only the one of the example.
#[test]
fn every_kernel_can_be_imported_in_bevy() {
    let files = files(Package::Bevy);
    let mut composer = Composer::default();
    let source = text(&files, "assets/shaders/lobe.wgsl");
    let file_path = "shaders/lobe.wgsl";
    let module = composer
        .add_composable_module(ComposableModuleDescriptor { source, file_path, ..Default::default() })
        .map(|module| module.sanitized_source.clone());
    let text = module.unwrap_or_else(|e| panic!("{e}"));
    for name in names() {
        assert!(text.contains(&format!("fn {}", Package::Bevy.name_of("", &name))), "{name}");
    }
}
