//! Every kernel in every target is accepted by a tool of that language itself: naga and Tint for WGSL,
//! spirv-val for SPIR-V, DXC for HLSL. A missing tool is a loud skip, and a failure under `LOBE_REQUIRE_TOOLS`.

mod common;

use lobe_backends::executor::Program;
use lobe_backends::translate::dxc::{Dxc, DxcOutput};
use lobe_backends::translate::{Dawn, Tint, TranslateError, spirv_val};
use lobe_codegen::emit::{Content, Options, Target, emit, with_entries};
use lobe_codegen::validate::from_wgsl;
use lobe_kernels::registry::KERNELS;

fn programs() -> impl Iterator<Item = Program> {
    KERNELS.iter().map(|kernel| Program::new(*kernel).unwrap_or_else(|e| panic!("{e}")))
}

fn library(program: &Program, target: Target) -> String {
    let artifact = emit(program.module(), target, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
    artifact.content.text().expect("text").to_owned()
}

fn entry(program: &Program, target: Target) -> (String, Content) {
    let (_, layout) = program.entry().unwrap_or_else(|e| panic!("{e}"));
    let artifact = program.artifact(target).unwrap_or_else(|e| panic!("{e}"));
    (layout.entry_name.clone(), artifact.content)
}

#[test]
fn wgsl_parses_again_under_the_same_names() {
    for program in programs() {
        let name = program.name();
        let again = from_wgsl(&library(&program, Target::Wgsl)).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert!(again.function(name).is_some(), "{name} is gone from its library");
        let (entry_name, content) = entry(&program, Target::Wgsl);
        let again = from_wgsl(content.text().expect("text")).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(again.module().entry_points[0].name, entry_name);
    }
}

#[test]
fn wgsl_is_valid_for_tint_as_library_and_as_compute_shader() {
    let dawn = match Dawn::find() {
        Ok(dawn) => dawn,
        Err(TranslateError::NotFound { tool, mend, .. }) => return common::skip(tool, mend),
        Err(error) => panic!("{error}"),
    };
    let mut tint = Tint::start(&dawn).unwrap_or_else(|e| panic!("{e}"));
    for program in programs() {
        let (_, shader) = entry(&program, Target::Wgsl);
        for text in [library(&program, Target::Wgsl).as_str(), shader.text().expect("text")] {
            tint.validate(text).unwrap_or_else(|e| panic!("{}: {e}", program.name()));
        }
    }
}

#[test]
fn all_kernels_in_one_library_are_valid() {
    let module = lobe_codegen::lower(KERNELS).unwrap_or_else(|e| panic!("{e}"));
    let text = emit(&module, Target::Wgsl, &Options::default()).unwrap_or_else(|e| panic!("{e}"));
    let again = from_wgsl(text.content.text().expect("text")).unwrap_or_else(|e| panic!("{e}"));
    for kernel in KERNELS {
        assert!(again.function(kernel().name).is_some(), "{}", kernel().name);
    }
}

/// One file with a compute shader for every kernel.
#[test]
fn all_kernels_as_entry_points_of_one_file_are_valid() {
    let module = lobe_codegen::lower(KERNELS).unwrap_or_else(|e| panic!("{e}"));
    let functions: Vec<_> = KERNELS.iter().filter_map(|k| module.function(k().name)).collect();
    let (module, layouts) = with_entries(&module, &functions, 64).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(layouts.len(), KERNELS.len());
    let written =
        |target| emit(&module, target, &Options::default()).unwrap_or_else(|e| panic!("{e}")).content;
    let again = from_wgsl(written(Target::Wgsl).text().expect("text")).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(again.module().entry_points.len(), KERNELS.len());
    let Content::Words(words) = written(Target::Spirv) else { panic!("not words") };
    match spirv_val::validate(&words) {
        Ok(()) => {}
        Err(TranslateError::NotFound { .. }) => common::skip("spirv-val", "run tests/setup.sh"),
        Err(error) => panic!("{error}"),
    }
    let hlsl = written(Target::Hlsl);
    match Dxc::find() {
        Err(error) => common::skip(&error.to_string(), "run tests/setup.sh"),
        Ok(dxc) => {
            for layout in &layouts {
                let text = hlsl.text().expect("text");
                let object = dxc.compile(text, "cs_6_0", Some(&layout.entry_name), DxcOutput::Dxil);
                assert!(!object.unwrap_or_else(|e| panic!("{e}")).is_empty());
            }
        }
    }
}

#[test]
fn spirv_is_valid_for_vulkan() {
    for program in programs() {
        let (_, content) = entry(&program, Target::Spirv);
        let Content::Words(words) = content else { panic!("{}: not words", program.name()) };
        match spirv_val::validate(&words) {
            Ok(()) => {}
            Err(TranslateError::NotFound { .. }) => return common::skip("spirv-val", "run tests/setup.sh"),
            Err(error) => panic!("{}: {error}", program.name()),
        }
    }
}

#[test]
fn hlsl_compiles_as_library_and_as_compute_shader() {
    let dxc = match Dxc::find() {
        Ok(dxc) => dxc,
        Err(TranslateError::NotFound { .. }) => return common::skip("DXC", "run tests/setup.sh"),
        Err(error) => panic!("{error}"),
    };
    for program in programs() {
        let name = program.name();
        let text = library(&program, Target::Hlsl);
        let dxil = dxc.compile(&text, "lib_6_3", None, DxcOutput::Dxil);
        let object = dxil.unwrap_or_else(|e| panic!("{name}: {e}"));
        // A function that is not exported is dropped without a word; an exported one leaves its name.
        let is_there = object.windows(name.len()).any(|bytes| bytes == name.as_bytes());
        assert!(is_there, "{name} is not in its DXIL library of {} bytes", object.len());
        let (entry_name, content) = entry(&program, Target::Hlsl);
        let text = content.text().expect("text");
        for output in [DxcOutput::Dxil, DxcOutput::Spirv] {
            let object = dxc.compile(text, "cs_6_0", Some(&entry_name), output);
            let bytes = object.unwrap_or_else(|e| panic!("{name}: {e}"));
            assert!(!bytes.is_empty(), "{name}");
        }
    }
}
