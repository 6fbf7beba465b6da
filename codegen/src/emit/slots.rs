//! Binding numbers for languages that have no groups.

use super::{EmitError, Target};
use naga::{AddressSpace, GlobalVariable, Handle, Module, ResourceBinding, TypeInner};
use std::collections::HashMap;

/// The kinds of resources that are numbered apart from each other: in GLSL, buffers of either kind and textures of
/// either, in MSL buffers, textures and samplers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    /// A storage buffer.
    Storage,
    /// A uniform buffer.
    Uniform,
    /// A texture that is sampled or loaded from.
    Texture,
    /// A texture that is stored to.
    StorageTexture,
    /// A sampler.
    Sampler,
}

/// A resource and its number.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slot {
    /// Where the module binds it.
    pub(super) place: ResourceBinding,
    /// What it is.
    pub(super) kind: Kind,
    /// Its binding's number, which is its own.
    pub(super) number: u8,
    /// Whether the shader writes to it.
    pub(super) is_written: bool,
}

/// The number of every bound resource that `is_used`: that of its binding, without the group.
///
/// # Errors
/// When a number does not fit, or when two resources of kinds that `are_together` differ in their group alone.
pub(super) fn slots(
    module: &Module,
    target: Target,
    is_used: impl Fn(Handle<GlobalVariable>) -> bool,
    are_together: fn(Kind, Kind) -> bool,
) -> Result<Vec<Slot>, EmitError> {
    let mut taken: HashMap<u32, Vec<(Kind, String)>> = HashMap::new();
    let mut slots = Vec::new();
    for (_, global) in module.global_variables.iter().filter(|&(handle, _)| is_used(handle)) {
        let Some(place) = global.binding else { continue };
        let (kind, is_written) = kind(module, global);
        let name = global.name.clone().unwrap_or_default();
        let others = taken.entry(place.binding).or_default();
        if let Some((_, first)) = others.iter().find(|(other, _)| are_together(kind, *other)) {
            let first = first.clone();
            return Err(EmitError::Groups { first, second: name, binding: place.binding, target });
        }
        let number = u8::try_from(place.binding).ok();
        let number = number.ok_or_else(|| EmitError::Binding {
            name: name.clone(),
            binding: place.binding,
            target,
        })?;
        others.push((kind, name));
        slots.push(Slot { place, kind, number, is_written });
    }
    Ok(slots)
}

fn kind(module: &Module, global: &GlobalVariable) -> (Kind, bool) {
    let stores = |access: naga::StorageAccess| access.contains(naga::StorageAccess::STORE);
    match (global.space, &module.types[global.ty].inner) {
        (AddressSpace::Storage { access }, _) => (Kind::Storage, stores(access)),
        (_, TypeInner::Image { class: naga::ImageClass::Storage { access, .. }, .. }) => {
            (Kind::StorageTexture, stores(*access))
        }
        (_, TypeInner::Image { .. }) => (Kind::Texture, false),
        (_, TypeInner::Sampler { .. }) => (Kind::Sampler, false),
        _ => (Kind::Uniform, false),
    }
}

#[cfg(test)]
mod tests {
    use crate::emit::{Options, Target, emit};
    use crate::validate::foreign_wgsl;

    fn error(text: &str, target: Target) -> Option<String> {
        emit(&foreign_wgsl(text).unwrap(), target, &Options::default()).err().map(|e| e.to_string())
    }

    #[test]
    fn resources_that_differ_in_their_group_alone_are_refused_where_there_are_no_groups() {
        let text = "
            @group(0) @binding(1) var<storage, read_write> first_values: array<f32>;
            @group(1) @binding(1) var<storage, read_write> second_values: array<f32>;
            @compute @workgroup_size(1) fn first() { first_values[0] = 1.0; }
            @compute @workgroup_size(1) fn second() { first_values[0] = second_values[0]; }";
        let refused = error(text, Target::Msl).unwrap();
        assert!(refused.contains("`first_values` and `second_values` both have binding 1"), "{refused}");
        let apart = text.replace("first_values[0] = second_values[0]", "second_values[0] = 1.0");
        assert_eq!(error(&apart, Target::Msl), None, "no entry point uses both");
        for target in [Target::Wgsl, Target::Spirv, Target::Hlsl] {
            assert_eq!(error(text, target), None);
        }
        for target in [Target::Glsl, Target::Essl] {
            let refused = error(&apart, target).unwrap();
            assert!(
                refused.contains("one entry point a file") && refused.contains("first, second"),
                "{refused}"
            );
        }
    }
}
