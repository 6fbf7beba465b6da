//! Binding arrays that leave their length to what is bound: in text and words for a driver they say it.
//!
//! naga can keep an index inside an array of known length only, and refuses to write SPIR-V for any other.

use crate::ValidModule;
use crate::validate::{self, ValidateError};
use naga::{ArraySize, Type, TypeInner};
use std::num::NonZeroU32;

/// The module with the lengths of such arrays, by group and binding; `None` if it has none of them.
///
/// # Errors
/// When naga refuses the module with them.
pub fn with_elements(
    module: &ValidModule,
    counts: &[((u32, u32), u32)],
) -> Result<Option<ValidModule>, ValidateError> {
    let mut sized = module.module().clone();
    let mut changes = Vec::new();
    for (handle, variable) in sized.global_variables.iter() {
        let TypeInner::BindingArray { base, size: ArraySize::Dynamic } = sized.types[variable.ty].inner
        else {
            continue;
        };
        let place = variable.binding.map(|b| (b.group, b.binding));
        let count = counts.iter().find(|(at, _)| Some(*at) == place).and_then(|(_, n)| NonZeroU32::new(*n));
        changes.extend(count.map(|count| (handle, base, ArraySize::Constant(count))));
    }
    if changes.is_empty() {
        return Ok(None);
    }
    for (handle, base, size) in changes {
        let ty = Type { name: None, inner: TypeInner::BindingArray { base, size } };
        sized.global_variables[handle].ty = sized.types.insert(ty, naga::Span::UNDEFINED);
    }
    validate::foreign(sized).map(Some)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emit::{Target, plain};

    #[test]
    fn spirv_is_written_once_the_length_is_known() {
        let text = "
            enable wgpu_binding_array;
            struct Block { value: u32 }
            @group(0) @binding(1) var<storage, read_write> blocks: binding_array<Block>;
            @compute @workgroup_size(1) fn main(@builtin(global_invocation_id) id: vec3u) {
                blocks[id.x].value = 1u;
            }";
        let module = validate::foreign_wgsl(text).unwrap();
        let write = |module: &ValidModule| plain(module, Target::Spirv, "main", [1; 3]);
        assert!(write(&module).is_err(), "naga writes it without, so this is not needed any more");
        let sized = with_elements(&module, &[((0, 1), 3)]).unwrap().expect("an array without length");
        assert!(write(&sized).is_ok());
        assert!(with_elements(&sized, &[((0, 1), 5)]).unwrap().is_none(), "it has a length");
        assert!(with_elements(&module, &[((0, 2), 5)]).unwrap().is_none(), "another place");
    }
}
