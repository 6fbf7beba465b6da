//! HLSL for shader model 6.0 and later.
//!
//! Registers are the bindings and spaces are the groups, for every kind of resource, so that DXC's
//! SPIR-V has the same layout as naga's.
//! Bounds checks and loop bounds are left out, as in the other targets: a kernel's indices are its
//! own affair, and the code stays readable.
//! Workgroup memory starts at zero, since the kernel language says so.

mod mend;
mod structured;

use super::tidy::{self, Text};
use super::{EmitError, Options, Target, guarded, mark};
use crate::ValidModule;
use mend::mended;
use naga::back::hlsl;
use naga::valid::ModuleInfo;

/// Writes the module as HLSL.
pub(super) fn write(module: &ValidModule, options: &Options) -> Result<String, EmitError> {
    refuse_group_count(module)?;
    let (copy, structured) = match structured::of(module.module()) {
        Some((copy, structured)) => (copy, Some(structured)),
        None => (mark::copy(module.module()), None),
    };
    let marked = mark::mark(copy);
    let info = structured.as_ref().map_or(module.info(), |structured| &structured.info);
    let (raw, _) = translate(&marked.module, info, &settings())?;
    let mut text = Text::new(&raw);
    text.pieces = mended(&text.pieces, structured.as_ref(), &marked.marks);
    let original = (module.module(), &module.meta().definitions);
    tidy::finish(original, &marked.marks, text, Target::Hlsl, options)
}

/// The module as naga writes it, and what its entry points are called there.
pub(super) fn translate(
    module: &naga::Module,
    info: &ModuleInfo,
    settings: &hlsl::Options,
) -> Result<(String, Vec<String>), EmitError> {
    let (raw, names) = guarded(Target::Hlsl, || {
        let mut raw = String::with_capacity(super::SIZE);
        let all_entries = hlsl::PipelineOptions { entry_point: None };
        let mut writer = hlsl::Writer::new(&mut raw, settings, &all_entries);
        let written = writer.write(module, info, None).map_err(|e| e.to_string())?;
        let names: Result<Vec<_>, _> = written.entry_point_names.into_iter().collect();
        names.map(|names| (raw, names)).map_err(|e| e.to_string())
    })?;
    Ok((mend_setters(raw), names))
}

/// HLSL has no input for the number of workgroups; naga reads it from a constant buffer that the host must
/// fill, and without one it would be 0.
fn refuse_group_count(module: &ValidModule) -> Result<(), EmitError> {
    let wanted = Some(naga::Binding::BuiltIn(naga::BuiltIn::NumWorkGroups));
    let reads = |e: &&naga::EntryPoint| e.function.arguments.iter().any(|a| a.binding == wanted);
    match module.module().entry_points.iter().find(reads) {
        None => Ok(()),
        Some(entry) => Err(EmitError::Entry {
            function: entry.name.clone(),
            reason: "HLSL has no input for the number of workgroups; pass it in a uniform".to_owned(),
        }),
    }
}

/// Passes the structure to `SetMat..On..` by reference.
///
/// naga writes these helpers for matrices with two rows inside structures, and passes the structure
/// by value: what they store would be lost.
fn mend_setters(raw: String) -> String {
    if !raw.contains("void SetMat") {
        return raw;
    }
    let mend = |line: &str| match line.starts_with("void SetMat") {
        true => line.replacen('(', "(inout ", 1),
        false => line.to_owned(),
    };
    raw.lines().map(|line| mend(line) + "\n").collect()
}

pub(super) fn settings() -> hlsl::Options {
    hlsl::Options {
        shader_model: hlsl::ShaderModel::V6_0,
        fake_missing_bindings: true,
        restrict_indexing: false,
        force_loop_bounding: false,
        zero_initialize_workgroup_memory: true,
        ..hlsl::Options::default()
    }
}
