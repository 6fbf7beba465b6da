//! The emitted text of every kernel, as reviewers accepted it.
//!
//! A difference fails and leaves a pending `.snap.new` beside the accepted snapshot; `cargo insta review`
//! accepts or rejects. CI never writes (`INSTA_UPDATE=no`).

use lobe_backends::executor::Program;
use lobe_codegen::emit::{Options, Target, emit};
use lobe_kernels::registry::KERNELS;

/// The functions of a kernel's library, without the comments, which the kernel's own file holds.
fn snapshot(target: Target) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let options = Options { docs: false, header: false, ..Options::default() };
    settings.bind(|| {
        for kernel in KERNELS {
            let program = Program::new(*kernel).unwrap_or_else(|e| panic!("{e}"));
            let artifact = emit(program.module(), target, &options).unwrap_or_else(|e| panic!("{e}"));
            let text = artifact.content.text().expect("text").to_owned();
            insta::assert_snapshot!(format!("{}.{}", program.name(), target.extension()), text);
        }
    });
}

#[test]
fn wgsl() {
    snapshot(Target::Wgsl);
}

#[test]
fn hlsl() {
    snapshot(Target::Hlsl);
}

/// Kernels whose complete compute shaders are kept too.
const ENTRIES: [&str; 2] = ["sg_eval", "sg_product"];

#[test]
fn every_snapshot_has_its_kernel() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots");
    for file in std::fs::read_dir(folder).expect("the snapshots").flatten() {
        let name = file.file_name().to_string_lossy().into_owned();
        let Some((stem, _)) = name.split_once('.') else { panic!("{name}: not a snapshot") };
        let kernel = stem.strip_suffix("_entry").filter(|k| ENTRIES.contains(k)).unwrap_or(stem);
        assert!(KERNELS.iter().any(|k| k().name == kernel), "{name} outlived its kernel");
    }
}

#[test]
fn entry_points() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| {
        for name in ENTRIES {
            let kernel = KERNELS.iter().find(|k| k().name == name).expect("a kernel of this name");
            let program = Program::new(*kernel).unwrap_or_else(|e| panic!("{e}"));
            for target in [Target::Wgsl, Target::Hlsl] {
                let artifact = program.artifact(target).unwrap_or_else(|e| panic!("{e}"));
                let text = artifact.content.text().expect("text").to_owned();
                insta::assert_snapshot!(format!("{name}_entry.{}", target.extension()), text);
            }
        }
    });
}
