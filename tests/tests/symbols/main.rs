//! Declared names are emitted names, read out of each output by a tool of its own language: naga for WGSL, DXC and
//! slang for HLSL, glslang for GLSL, and SPIR-V's own names.
//!
//! MSL has no such tool outside of Apple's systems; `codegen/tests/emit/names.rs` looks through its text.

#[path = "../common/mod.rs"]
mod common;
mod described;
mod slang;
mod words;

use lobe_backends::executor::Program;
use lobe_backends::translate::{Dxc, DxcOutput, Glslang, TranslateError, spirv_words};
use lobe_codegen::ValidModule;
use lobe_codegen::emit::{Content, EntryLayout, Options, Reflection, Target, emit, reflect, with_entries};
use lobe_codegen::validate::from_wgsl;
use lobe_kernels::registry::KERNELS;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;
use words::{Symbols, symbols};

fn library() -> ValidModule {
    lobe_codegen::lower(KERNELS).unwrap_or_else(|e| panic!("{e}"))
}

fn programs() -> impl Iterator<Item = Program> {
    KERNELS.iter().map(|kernel| Program::new(*kernel).unwrap_or_else(|e| panic!("{e}")))
}

fn text(module: &ValidModule, target: Target) -> String {
    let options = Options { docs: false, ..Options::default() };
    let artifact = emit(module, target, &options).unwrap_or_else(|e| panic!("{e}"));
    artifact.content.text().expect("text").to_owned()
}

/// One line for each public name, sorted.
fn table(reflection: &Reflection) -> String {
    let mut lines = BTreeSet::new();
    for constant in &reflection.constants {
        lines.insert(format!("const {}: {}", constant.name, constant.ty));
    }
    for function in &reflection.functions {
        let parameters: Vec<String> =
            function.parameters.iter().map(|p| format!("{}: {}", p.name, p.ty)).collect();
        let returns = function.returns.as_ref().map(|ty| format!(" -> {ty}")).unwrap_or_default();
        lines.insert(format!("fn {}({}){returns}", function.name, parameters.join(", ")));
    }
    for structure in &reflection.structs {
        let members: Vec<String> =
            structure.members.iter().map(|m| format!("{}: {} @{}", m.name, m.ty, m.offset)).collect();
        let name = &structure.name;
        lines.insert(format!("struct {name} {{ {} }} {} bytes", members.join(", "), structure.size));
    }
    lines.into_iter().fold(String::new(), |text, line| text + &line + "\n")
}

/// `LOBE_BLESS=1` writes the table again; what then differs is a change that users see.
#[test]
fn the_public_names_are_those_of_the_table() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/names.txt");
    let today = table(&reflect(&library()));
    if std::env::var_os("LOBE_BLESS").is_some() {
        std::fs::write(&path, &today).expect("written");
    }
    let accepted = std::fs::read_to_string(&path).expect("the table");
    let difference = difference(&accepted, &today);
    assert!(difference.is_empty(), "names that users rely on change (LOBE_BLESS=1 accepts):\n{difference}");
}

/// The lines that are gone and those that are new.
fn difference(before: &str, after: &str) -> String {
    let (before, after): (BTreeSet<&str>, BTreeSet<&str>) =
        (before.lines().collect(), after.lines().collect());
    let mut text = String::new();
    let all: BTreeSet<&str> = before.union(&after).copied().collect();
    for line in all {
        let _ = match (before.contains(line), after.contains(line)) {
            (true, false) => writeln!(text, "- {line}"),
            (false, true) => writeln!(text, "+ {line}"),
            _ => Ok(()),
        };
    }
    text
}

#[test]
fn what_changes_is_shown_line_by_line() {
    let shown = difference("fn a()\nfn b()\nfn c()\n", "fn a()\nfn b(x: f32)\nfn c()\n");
    assert_eq!(shown, "- fn b()\n+ fn b(x: f32)\n");
}

#[test]
fn wgsl_declares_them_by_naga() {
    let module = library();
    let again = from_wgsl(&text(&module, Target::Wgsl)).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(difference(&table(&reflect(&module)), &table(&reflect(&again))), "");
}

/// That SPIR-V made of a kernel's entry point has the declared names: functions, structures and their members,
/// resources and their places.
fn check(program: &Program, layout: &EntryLayout, found: &Symbols, target: Target) {
    let kernel = program.name();
    let (module, _) = program.entry().unwrap_or_else(|e| panic!("{e}"));
    let declared = reflect(module);
    assert_eq!(found.entries, [target.entry_name(&layout.entry_name)], "{kernel}");
    let of_function = |name: &String| name.split('(').next().map(str::to_owned);
    let functions: BTreeSet<String> = found.functions.iter().filter_map(of_function).collect();
    for function in &declared.functions {
        assert!(
            functions.contains(&function.name),
            "{kernel} as {target}: no {} in {functions:?}",
            function.name
        );
    }
    for structure in &declared.structs {
        let own = || structure.members.iter().map(|m| m.name.as_str());
        let same = |members: &Vec<String>| {
            members.iter().map(String::as_str).filter(|name| !name.contains("_pad")).eq(own())
        };
        let of_name: Vec<_> = found.structures.iter().filter(|(name, _)| *name == structure.name).collect();
        let all_same = of_name.iter().all(|(_, members)| same(members));
        assert!(all_same, "{kernel} as {target}: {} is {of_name:?}", structure.name);
    }
    for binding in &declared.entries[0].bindings {
        let place = (binding.group, binding.binding);
        let block = (format!("{}_block", binding.name), vec![binding.name.clone()]);
        let mut names = found.bindings.iter().filter(|(_, at)| *at == place).map(|(name, _)| name);
        let is_there =
            names.any(|name| *name == binding.name || name.is_empty() && found.structures.contains(&block));
        assert!(is_there, "{kernel} as {target}: {} is none of {:?}", binding.name, found.bindings);
    }
}

/// That structures in buffers, and arrays of them, lie as the description says; how many of each were compared.
fn compare_layouts(declared: &Reflection, found: &Symbols, kernel: &str) -> (usize, usize) {
    let (mut structures, mut arrays) = (0, 0);
    for structure in &declared.structs {
        let members: Vec<(String, u32)> =
            structure.members.iter().map(|m| (m.name.clone(), m.offset)).collect();
        for (_, offsets) in found.offsets.iter().filter(|(name, _)| *name == structure.name) {
            assert_eq!(*offsets, members, "{kernel}: {}", structure.name);
            structures += 1;
        }
    }
    for binding in &declared.entries[0].bindings {
        let place = (binding.group, binding.binding);
        for (_, stride) in found.strides.iter().filter(|(at, _)| *at == place) {
            assert_eq!(Some(*stride), binding.stride, "{kernel}: {}", binding.name);
            arrays += 1;
        }
    }
    (structures, arrays)
}

#[test]
fn spirv_has_them_and_lies_as_described() {
    for program in programs() {
        let (module, layout) = program.entry().unwrap_or_else(|e| panic!("{e}"));
        let artifact = program.artifact(Target::Spirv).unwrap_or_else(|e| panic!("{e}"));
        let Content::Words(words) = artifact.content else { panic!("words") };
        let found = symbols(&words);
        check(&program, layout, &found, Target::Spirv);
        let declared = reflect(module);
        let arrays = declared.entries[0].bindings.iter().filter(|b| b.stride.is_some()).count();
        let compared = compare_layouts(&declared, &found, program.name());
        assert_eq!(compared, (declared.structs.len(), arrays), "{}", program.name());
    }
}

#[test]
fn hlsl_declares_them_by_dxc() {
    let dxc = match Dxc::find() {
        Ok(dxc) => dxc,
        Err(error) => return common::skip(&error.to_string(), "run tests/setup.sh"),
    };
    for program in programs() {
        let (_, layout) = program.entry().unwrap_or_else(|e| panic!("{e}"));
        let artifact = program.artifact(Target::Hlsl).unwrap_or_else(|e| panic!("{e}"));
        let text = artifact.content.text().expect("text");
        let object = dxc.compile(text, "cs_6_0", Some(&layout.entry_name), DxcOutput::Spirv);
        let words = spirv_words(&object.unwrap_or_else(|e| panic!("{e}"))).unwrap_or_else(|e| panic!("{e}"));
        check(&program, layout, &symbols(&words), Target::Hlsl);
    }
}

/// Of a library's functions DXIL keeps the mangled names.
#[test]
fn every_function_of_the_hlsl_library_is_exported_by_dxc() {
    let dxc = match Dxc::find() {
        Ok(dxc) => dxc,
        Err(error) => return common::skip(&error.to_string(), "run tests/setup.sh"),
    };
    let module = library();
    let dxil = dxc.compile(&text(&module, Target::Hlsl), "lib_6_3", None, DxcOutput::Dxil);
    let dxil = dxil.unwrap_or_else(|e| panic!("{e}"));
    for function in reflect(&module).functions {
        let mangled = format!("?{}@@Y", function.name);
        let is_there = dxil.windows(mangled.len()).any(|bytes| bytes == mangled.as_bytes());
        assert!(is_there, "{} is not exported", function.name);
    }
}

fn glslang() -> Option<Glslang> {
    match Glslang::find() {
        Ok(found) => Some(found),
        Err(TranslateError::NotFound { .. }) => {
            common::skip("glslang", "run tests/setup.sh");
            None
        }
        Err(error) => panic!("{error}"),
    }
}

/// Offsets are those that glslang gives buffers, by std430, which is to be the module's layout.
#[test]
fn glsl_declares_them_by_glslang_and_lays_buffers_out_as_the_module_does() {
    let Some(glslang) = glslang() else { return };
    for program in programs() {
        let artifact = program.artifact(Target::Glsl).unwrap_or_else(|e| panic!("{e}"));
        let (module, layout) = program.entry().unwrap_or_else(|e| panic!("{e}"));
        let words = glslang.compile(artifact.content.text().expect("text")).unwrap_or_else(|e| panic!("{e}"));
        let found = symbols(&words);
        check(&program, layout, &found, Target::Glsl);
        let (_, arrays) = compare_layouts(&reflect(module), &found, program.name());
        assert!(arrays > 0, "{}: no array was compared", program.name());
    }
}

/// Every kernel as GLSL ES, and the whole library in both versions.
#[test]
fn glslang_accepts_every_kernel_as_glsl_es_and_the_libraries() {
    let Some(glslang) = glslang() else { return };
    let whole = library();
    for (target, head) in [
        (Target::Glsl, "#version 450\n"),
        (Target::Essl, "#version 310 es\nprecision highp float;\nprecision highp int;\n"),
    ] {
        let library = format!("{head}{}\nvoid main() {{}}\n", text(&whole, target));
        glslang.validate(&library).unwrap_or_else(|e| panic!("{target} library: {e}"));
    }
    for program in programs() {
        let artifact = program.artifact(Target::Essl).unwrap_or_else(|e| panic!("{e}"));
        let shader = artifact.content.text().expect("text");
        glslang.validate(shader).unwrap_or_else(|e| panic!("{}: {e}", program.name()));
    }
}

/// One module with an entry point for each kernel goes into every target that has more than one a file.
#[test]
fn many_entry_points_are_one_file_where_the_language_has_that() {
    let module = library();
    let functions: Vec<_> = KERNELS.iter().filter_map(|k| module.function(k().name)).collect();
    let (module, _) = with_entries(&module, &functions, 64).unwrap_or_else(|e| panic!("{e}"));
    for target in [Target::Wgsl, Target::Spirv, Target::Hlsl, Target::Msl] {
        let artifact = emit(&module, target, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(artifact.entries.len(), KERNELS.len(), "{target}");
    }
    for target in [Target::Glsl, Target::Essl] {
        let error = emit(&module, target, &Options::default()).expect_err("refused");
        assert!(error.to_string().contains("one by one"), "{error}");
    }
}
