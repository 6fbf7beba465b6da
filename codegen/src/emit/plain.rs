//! A module of somebody else's as a driver shall run it: naga's writers, and nothing mended but what is wrong.
//!
//! Names are of no matter here, so none is kept or refused but the entry point's.
//! What lies outside a buffer or an array is nobody's own affair: every access is kept inside.

mod glsl;
mod hlsl;

pub use hlsl::immediates_place as immediates_in_hlsl;

use super::{Content, EmitError, Target, check_calls, guarded, layouts, spirv};
use crate::ValidModule;
use naga::ShaderStage;
use naga::back::wgsl::{WriterFlags, write_string};

/// What WGSL's entry point is called: naga would change some names, and does not say into what.
const ENTRY: &str = "lobe_entry";

/// A module written for running.
///
/// In HLSL its uniform buffers are storage buffers that are only read, as are its immediates, at [`immediates_in_hlsl`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plain {
    /// The text or the words.
    pub content: Content,
    /// What its entry point is called there.
    pub entry: String,
}

/// Writes `module` for `target`, for running its compute entry point `entry` by so many `workgroups`.
///
/// # Errors
/// When there is no such entry point, the target cannot express the module, or nothing here runs it.
pub fn plain(
    module: &ValidModule,
    target: Target,
    entry: &str,
    workgroups: [u32; 3],
) -> Result<Plain, EmitError> {
    let is_meant = |p: &naga::EntryPoint| p.stage == ShaderStage::Compute && p.name == entry;
    let index = module.module().entry_points.iter().position(is_meant).ok_or(EmitError::NoEntry)?;
    match target {
        Target::Spirv => {
            check_calls(module.module())?;
            let words = spirv::plain(module, entry)?;
            Ok(Plain { content: Content::Words(words), entry: entry.to_owned() })
        }
        Target::Hlsl => {
            let (text, mut names) = hlsl::write(module, workgroups)?;
            Ok(Plain { content: Content::Text(text), entry: names.swap_remove(index) })
        }
        Target::Wgsl => {
            // Of WGSL, wgpu makes SPIR-V.
            check_calls(module.module())?;
            let mut renamed = module.module().clone();
            renamed.entry_points[index].name = ENTRY.to_owned();
            let write = || write_string(&renamed, module.info(), WriterFlags::empty());
            let text = guarded(target, write)?;
            guarded(target, || Ok::<_, String>(layouts::check(&renamed, &text)))??;
            Ok(Plain { content: Content::Text(text), entry: ENTRY.to_owned() })
        }
        Target::Glsl => {
            let text = glsl::write(module, index)?;
            Ok(Plain { content: Content::Text(text), entry: super::glsl::ENTRY.to_owned() })
        }
        Target::Essl | Target::Msl => Err(EmitError::NotRun(target)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::foreign::{self, Language, Source};
    use crate::validate::foreign_wgsl;

    const TEXT: &str = "
        @group(0) @binding(0) var<storage, read_write> out: array<u32>;
        fn pass_(x: u32) -> u32 { return x; }
        @compute @workgroup_size(1) fn other() { out[0] = 1u; }
        @compute @workgroup_size(1) fn sampler_2(@builtin(global_invocation_id) id: vec3u) { out[id.x] = pass_(2u); }
    ";

    #[test]
    fn the_entry_point_is_found_under_the_name_given() {
        let module = foreign_wgsl(TEXT).unwrap();
        let written = |target| plain(&module, target, "sampler_2", [1; 3]).unwrap();
        let wgsl = written(Target::Wgsl);
        assert!(wgsl.content.text().is_some_and(|t| t.contains(&format!("fn {}(", wgsl.entry))));
        let hlsl = written(Target::Hlsl);
        assert!(hlsl.content.text().is_some_and(|t| t.contains(&format!("void {}(", hlsl.entry))));
        assert_eq!(written(Target::Spirv).entry, "sampler_2");
    }

    #[test]
    fn an_access_stays_inside_its_buffer() {
        let module = foreign_wgsl(TEXT).unwrap();
        let Content::Words(words) = plain(&module, Target::Spirv, "sampler_2", [1; 3]).unwrap().content
        else {
            panic!("words");
        };
        const OP_ARRAY_LENGTH: u32 = 68;
        assert!(words.iter().any(|w| w & 0xffff == OP_ARRAY_LENGTH && w >> 16 == 5));
    }

    #[test]
    fn a_layout_that_wgsl_has_no_words_for_is_refused() {
        let wgsl = |packing: &str, pushed: &str| {
            let text = format!(
                "#version 450
                layout(local_size_x = 1) in;
                layout({packing}, binding = 0) buffer B {{ float a[4]; }} out_;
                layout(push_constant, {pushed}) uniform P {{ float a[4]; }} in_;
                void main() {{ out_.a[1] = in_.a[2]; }}"
            );
            let (language, name, bytes) = (Language::Glsl, String::new(), text.into_bytes());
            plain(&foreign::read(&Source { name, language, bytes }).unwrap(), Target::Wgsl, "main", [1; 3])
        };
        assert!(wgsl("std430", "std430").is_ok());
        for (packing, pushed, name) in [("std140", "std430", "out_"), ("std430", "std140", "in_")] {
            let refused = wgsl(packing, pushed).unwrap_err().to_string();
            assert!(refused.contains(&format!("no words for the memory layout of `{name}`")), "{refused}");
        }
    }

    #[test]
    fn an_entry_point_that_is_not_there_is_refused() {
        let module = foreign_wgsl(TEXT).unwrap();
        assert!(matches!(plain(&module, Target::Wgsl, "main", [1; 3]), Err(EmitError::NoEntry)));
    }
}
