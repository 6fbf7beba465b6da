//! HLSL for DXC on its way to SPIR-V: what naga's text leaves to a host of D3D12 is said in the text itself.

use crate::ValidModule;
use crate::emit::{EmitError, Target, hlsl};
use crate::validate::{self, ValidateError};
use naga::back::hlsl::{BindTarget, Options};
use naga::{AddressSpace, ResourceBinding, StorageAccess, TypeInner};

/// A space that no other resource is in.
const SPACE: u8 = 254;

/// The module with its indices kept inside their arrays, and the names of its entry points; it is run by so many
/// `workgroups`.
pub(super) fn write(module: &ValidModule, workgroups: [u32; 3]) -> Result<(String, Vec<String>), EmitError> {
    check_arrays(module.module())?;
    let module = &without_uniforms(module)?;
    let target = BindTarget { space: SPACE, ..BindTarget::default() };
    let settings =
        Options { restrict_indexing: true, special_constants_binding: Some(target), ..hlsl::settings() };
    let (text, names) = hlsl::translate(module.module(), module.info(), &settings)?;
    let formats = texel_formats(module.module());
    let mend = |line: &str| {
        with_count(line, workgroups).or_else(|| sampler(line)).or_else(|| with_format(line, &formats))
    };
    let lines = text.lines().map(|line| mend(line).unwrap_or_else(|| line.to_owned()));
    Ok((lines.fold(String::new(), |text, line| text + &line + "\n"), names))
}

/// Refuses binding arrays that naga does not write for Vulkan: it knows no arrays of buffers in HLSL, and takes samplers out
/// of a heap.
fn check_arrays(module: &naga::Module) -> Result<(), EmitError> {
    for (_, variable) in module.global_variables.iter() {
        let TypeInner::BindingArray { base, .. } = module.types[variable.ty].inner else { continue };
        let what = match module.types[base].inner {
            TypeInner::Image { .. } => continue,
            TypeInner::Sampler { .. } => "samplers, which naga takes out of a heap that Vulkan has not",
            _ => "buffers, which naga has no HLSL for",
        };
        let name = variable.name.as_deref().unwrap_or_default();
        let message = format!("`{name}` is a binding array of {what}");
        return Err(EmitError::Writer { target: Target::Hlsl, message });
    }
    Ok(())
}

/// Group and binding of the buffer that a module's immediates are in HLSL: the first that is free behind those of
/// group 0.
#[must_use]
pub fn immediates_place(module: &naga::Module) -> (u32, u32) {
    let places = module.global_variables.iter().filter_map(|(_, variable)| variable.binding);
    (0, places.filter(|place| place.group == 0).map(|place| place.binding + 1).max().unwrap_or(0))
}

/// Uniform buffers and immediates become storage buffers that are only read: naga pads the structures of constant buffers for D3D's
/// packing, and DXC lays them out by Vulkan's.
fn without_uniforms(module: &ValidModule) -> Result<ValidModule, EmitError> {
    let mut module = module.module().clone();
    let (group, binding) = immediates_place(&module);
    for (_, variable) in module.global_variables.iter_mut() {
        if variable.space == AddressSpace::Immediate {
            variable.binding = Some(ResourceBinding { group, binding });
        }
        if matches!(variable.space, AddressSpace::Uniform | AddressSpace::Immediate) {
            variable.space = AddressSpace::Storage { access: StorageAccess::LOAD };
        }
    }
    let refused = |e: ValidateError| EmitError::Writer { target: Target::Hlsl, message: e.to_string() };
    validate::foreign(module).map_err(refused)
}

/// The number of workgroups where naga wants it of the host.
fn with_count(line: &str, workgroups: [u32; 3]) -> Option<String> {
    let declared = line.strip_prefix("ConstantBuffer<NagaConstants> ")?;
    let (name, _) = declared.split_once(':')?;
    let [x, y, z] = workgroups;
    Some(format!("static const NagaConstants {name} = {{ {x}, {y}, {z} }};"))
}

/// A sampler that is bound, where naga takes one out of a heap by a table of indices, which the host would bind.
fn sampler(line: &str) -> Option<String> {
    let heaps = ["SamplerState nagaSamplerHeap[", "SamplerComparisonState nagaComparisonSamplerHeap["];
    if heaps.iter().any(|heap| line.starts_with(heap)) || line.starts_with("StructuredBuffer<uint> nagaGroup")
    {
        return Some(String::new());
    }
    let (declared, heap) = line.strip_prefix("static const Sampler")?.split_once(" = naga")?;
    let (_, table) = heap.split_once("[nagaGroup")?;
    let (group, rest) = table.split_once("SamplerIndexArray[")?;
    let (binding, _) = rest.split_once(']')?;
    Some(format!("Sampler{declared} : register(s{binding}, space{group});"))
}

/// How the texels of a storage texture are laid out, by its register.
///
/// HLSL's type does not tell; DXC would take every such texture for one of 32-bit numbers.
fn texel_formats(module: &naga::Module) -> Vec<(String, String)> {
    let formats = module.global_variables.iter().filter_map(|(_, variable)| {
        let binding = variable.binding?;
        let ty = match module.types[variable.ty].inner {
            TypeInner::BindingArray { base, .. } => base,
            _ => variable.ty,
        };
        let TypeInner::Image { class: naga::ImageClass::Storage { format, .. }, .. } = module.types[ty].inner
        else {
            return None;
        };
        let space = if binding.group == 0 { String::new() } else { format!(", space{}", binding.group) };
        Some((format!("register(u{}{space})", binding.binding), texel_format(format)?))
    });
    formats.collect()
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

/// A storage texture that says how its texels are laid out.
fn with_format(line: &str, formats: &[(String, String)]) -> Option<String> {
    let (_, format) = formats.iter().find(|(register, _)| line.contains(register))?;
    let declared = line.strip_prefix("RWTexture").map(|_| with_sign_of(format, line))?;
    Some(format!("[[vk::image_format(\"{format}\")]] {declared}"))
}

/// naga takes `rg32uint` for signed numbers and `rg32sint` for unsigned ones.
fn with_sign_of(format: &str, line: &str) -> String {
    match format {
        "rg32ui" => line.replacen("<int4>", "<uint4>", 1),
        "rg32i" => line.replacen("<uint4>", "<int4>", 1),
        _ => line.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::validate::foreign_wgsl;

    /// The lines of `text` in HLSL that hold `part`.
    fn lines(text: &str, part: &str) -> Vec<String> {
        let (hlsl, _) = write(&foreign_wgsl(text).unwrap(), [3, 2, 1]).unwrap();
        hlsl.lines().filter(|line| line.contains(part)).map(str::to_owned).collect()
    }

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
        let wanted = [
            "[[vk::image_format(\"rgba8\")]] RWTexture2D<unorm float4> a : register(u1);",
            "[[vk::image_format(\"rg32ui\")]] RWTexture2D<uint4> b : register(u1, space2);",
            "RWTexture2D<unorm float4> c : register(u11);",
        ];
        assert_eq!(lines(text, "RWTexture"), wanted);
    }

    #[test]
    fn samplers_are_bound_where_the_module_says() {
        let text = "
            @group(0) @binding(0) var image: texture_2d<f32>;
            @group(0) @binding(1) var near: sampler;
            @group(3) @binding(2) var less: sampler_comparison;
            @group(0) @binding(3) var depth: texture_depth_2d;
            @group(0) @binding(4) var<storage, read_write> out: f32;
            @compute @workgroup_size(1) fn main() {
                out = textureSampleLevel(image, near, vec2f(), 0.0).x
                    + textureSampleCompareLevel(depth, less, vec2f(), 0.5);
            }";
        let wanted = [
            "SamplerState near : register(s1, space0);",
            "SamplerComparisonState less : register(s2, space3);",
        ];
        assert_eq!(lines(text, "State "), wanted);
        assert_eq!(lines(text, "naga"), Vec::<String>::new());
    }

    #[test]
    fn storage_textures_of_an_array_say_it_too() {
        let text = "
            enable wgpu_binding_array;
            @group(0) @binding(1) var a: binding_array<texture_storage_2d<rgba8unorm, write>, 2>;
            @compute @workgroup_size(1) fn main() { textureStore(a[1], vec2u(), vec4f()); }";
        let wanted = "[[vk::image_format(\"rgba8\")]] RWTexture2D<unorm float4> a[2] : register(u1);";
        assert_eq!(lines(text, "RWTexture"), [wanted]);
    }

    #[test]
    fn arrays_that_naga_does_not_write_for_vulkan_are_refused() {
        let refused = |variable: &str, used: &str| {
            let text = format!(
                "enable wgpu_binding_array;
                struct Block {{ value: f32 }}
                @group(0) @binding(0) var image: texture_2d<f32>;
                @group(0) @binding(1) {variable}
                @group(0) @binding(2) var<storage, read_write> out: f32;
                @compute @workgroup_size(1) fn main() {{ out = {used}; }}"
            );
            write(&foreign_wgsl(&text).unwrap(), [1; 3]).unwrap_err().to_string()
        };
        let sample = "textureSampleLevel(image, a[1], vec2f(), 0.0).x";
        for (variable, used, part) in [
            ("var<storage> a: binding_array<Block, 2>;", "a[1].value", "`a` is a binding array of buffers"),
            ("var<uniform> a: binding_array<Block, 2>;", "a[1].value", "`a` is a binding array of buffers"),
            ("var a: binding_array<sampler, 2>;", sample, "`a` is a binding array of samplers"),
        ] {
            let said = refused(variable, used);
            assert!(said.contains(part), "{said}");
        }
    }

    #[test]
    fn immediates_are_a_buffer_behind_the_others() {
        let text = "
            var<immediate> pushed: u32;
            @group(0) @binding(3) var<storage, read_write> out: u32;
            @group(1) @binding(7) var<uniform> other: u32;
            @compute @workgroup_size(1) fn main() { out = pushed + other; }";
        assert_eq!(lines(text, "pushed :"), ["ByteAddressBuffer pushed : register(t4);"]);
    }

    #[test]
    fn the_number_of_workgroups_is_in_the_text() {
        let text = "
            @group(0) @binding(0) var<storage, read_write> out: vec3u;
            @compute @workgroup_size(1) fn main(@builtin(num_workgroups) n: vec3u) { out = n; }";
        assert_eq!(lines(text, "static"), ["static const NagaConstants _NagaConstants = { 3, 2, 1 };"]);
    }
}
