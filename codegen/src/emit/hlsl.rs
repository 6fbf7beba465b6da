//! HLSL for shader model 6.0 and later.
//!
//! Registers are the bindings and spaces are the groups, for every kind of resource, so that DXC's
//! SPIR-V has the same layout as naga's.
//! Bounds checks and loop bounds are left out, as in the other targets: a kernel's indices are its
//! own affair, and the code stays readable.
//! Workgroup memory starts at zero, since the kernel language says so.

use super::{EmitError, Options, Target, guarded, mark, tidy};
use crate::ValidModule;
use naga::back::hlsl;
use naga::valid::ModuleInfo;

/// Writes the module as HLSL.
pub(super) fn write(module: &ValidModule, options: &Options) -> Result<String, EmitError> {
    refuse_group_count(module)?;
    let marked = mark::mark(module.module());
    let (raw, _) = translate(&marked.module, module.info(), &settings())?;
    tidy::finish(module.module(), &marked.marks, &raw, Target::Hlsl, options)
}

/// The module as naga has it, indices kept inside their arrays, with the names of its entry points.
pub(super) fn plain(module: &ValidModule) -> Result<(String, Vec<String>), EmitError> {
    refuse_group_count(module)?;
    let settings = hlsl::Options { restrict_indexing: true, ..settings() };
    let (text, names) = translate(module.module(), module.info(), &settings)?;
    Ok((with_texel_formats(module.module(), &text), names))
}

fn translate(
    module: &naga::Module,
    info: &ModuleInfo,
    settings: &hlsl::Options,
) -> Result<(String, Vec<String>), EmitError> {
    let (raw, names) = guarded(Target::Hlsl, || {
        let mut raw = String::new();
        let all_entries = hlsl::PipelineOptions { entry_point: None };
        let mut writer = hlsl::Writer::new(&mut raw, settings, &all_entries);
        let written = writer.write(module, info, None).map_err(|e| e.to_string())?;
        let names: Result<Vec<_>, _> = written.entry_point_names.into_iter().collect();
        names.map(|names| (raw, names)).map_err(|e| e.to_string())
    })?;
    Ok((mend_setters(&raw), names))
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
fn mend_setters(raw: &str) -> String {
    let mend = |line: &str| match line.starts_with("void SetMat") {
        true => line.replacen('(', "(inout ", 1),
        false => line.to_owned(),
    };
    raw.lines().map(|line| mend(line) + "\n").collect()
}

/// Says of each storage texture how its texels are laid out, for DXC on its way to SPIR-V.
///
/// HLSL's type does not tell; DXC would take every such texture for one of 32-bit numbers.
fn with_texel_formats(module: &naga::Module, text: &str) -> String {
    let formats = module.global_variables.iter().filter_map(|(_, variable)| {
        let binding = variable.binding?;
        let naga::TypeInner::Image { class: naga::ImageClass::Storage { format, .. }, .. } =
            module.types[variable.ty].inner
        else {
            return None;
        };
        let space = if binding.group == 0 { String::new() } else { format!(", space{}", binding.group) };
        Some((format!("register(u{}{space})", binding.binding), texel_format(format)?))
    });
    let formats: Vec<(String, String)> = formats.collect();
    let told = |line: &str| {
        let known = formats.iter().find(|(register, _)| line.contains(register));
        match known.filter(|_| line.starts_with("RWTexture")) {
            Some((_, format)) => {
                format!("[[vk::image_format(\"{format}\")]] {}\n", with_sign_of(format, line))
            }
            None => format!("{line}\n"),
        }
    };
    text.lines().map(told).collect()
}

/// naga takes `rg32uint` for signed numbers and `rg32sint` for unsigned ones.
fn with_sign_of(format: &str, line: &str) -> String {
    match format {
        "rg32ui" => line.replacen("<int4>", "<uint4>", 1),
        "rg32i" => line.replacen("<uint4>", "<int4>", 1),
        _ => line.to_owned(),
    }
}

/// What DXC calls a format; `None` if SPIR-V has no such format.
fn texel_format(format: naga::StorageFormat) -> Option<String> {
    match format {
        naga::StorageFormat::Bgra8Unorm => None,
        naga::StorageFormat::Rg11b10Ufloat => Some("r11g11b10f".to_owned()),
        other => {
            let name = format!("{other:?}").to_lowercase();
            let name = name.replace("unorm", "").replace("float", "f");
            Some(name.replace("uint", "ui").replace("sint", "i"))
        }
    }
}

fn settings() -> hlsl::Options {
    hlsl::Options {
        shader_model: hlsl::ShaderModel::V6_0,
        fake_missing_bindings: true,
        restrict_indexing: false,
        force_loop_bounding: false,
        zero_initialize_workgroup_memory: true,
        ..hlsl::Options::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validate::foreign_wgsl;

    #[test]
    fn storage_textures_say_how_their_texels_are_laid_out() {
        let text = "
            @group(0) @binding(1) var a: texture_storage_2d<rgba8unorm, write>;
            @group(2) @binding(1) var b: texture_storage_2d<rg32uint, write>;
            @group(0) @binding(11) var c: texture_storage_2d<bgra8unorm, write>;
            @compute @workgroup_size(1) fn main() {
                textureStore(a, vec2u(), vec4f());
                textureStore(b, vec2u(), vec4u());
                textureStore(c, vec2u(), vec4f());
            }";
        let (hlsl, _) = plain(&foreign_wgsl(text).unwrap()).unwrap();
        let declared: Vec<&str> = hlsl.lines().filter(|line| line.contains("RWTexture")).collect();
        let wanted = [
            "[[vk::image_format(\"rgba8\")]] RWTexture2D<unorm float4> a : register(u1);",
            "[[vk::image_format(\"rg32ui\")]] RWTexture2D<uint4> b : register(u1, space2);",
            "RWTexture2D<unorm float4> c : register(u11);",
        ];
        assert_eq!(declared, wanted);
    }
}
