//! Layouts of buffers that WGSL has no words for: naga's writer leaves them out.

use super::{EmitError, Target};
use naga::{AddressSpace, Handle, Module, Type, TypeInner};

/// Checks that the buffers and immediates of `text`, which was written from `module`, lie in memory as those of `module` do.
pub(super) fn check(module: &Module, text: &str) -> Result<(), EmitError> {
    let refused = |message| EmitError::Writer { target: Target::Wgsl, message };
    let written = naga::front::wgsl::parse_str(text)
        .map_err(|e| refused(format!("it does not read what it wrote: {}", e.message())))?;
    let is_laid_out = |v: &naga::GlobalVariable| v.binding.is_some() || v.space == AddressSpace::Immediate;
    for (_, variable) in module.global_variables.iter().filter(|(_, v)| is_laid_out(v)) {
        let is_twin = |v: &&naga::GlobalVariable| v.binding == variable.binding && v.space == variable.space;
        let twin = written.global_variables.iter().map(|(_, v)| v).find(is_twin);
        if twin.is_none_or(|twin| !is_same((module, variable.ty), (&written, twin.ty))) {
            let name = variable.name.as_deref().unwrap_or_default();
            return Err(refused(format!("WGSL has no words for the memory layout of `{name}`")));
        }
    }
    Ok(())
}

/// Whether two types lie in memory alike.
fn is_same((a, left): (&Module, Handle<Type>), (b, right): (&Module, Handle<Type>)) -> bool {
    match (&a.types[left].inner, &b.types[right].inner) {
        (
            TypeInner::Struct { members: left, span: left_span },
            TypeInner::Struct { members: right, span: right_span },
        ) => {
            let both = || left.iter().zip(right);
            // What follows a runtime array is nothing.
            let is_open = |m: &Module, ty| {
                matches!(m.types[ty].inner, TypeInner::Array { size: naga::ArraySize::Dynamic, .. })
            };
            left.len() == right.len()
                && (left_span == right_span || left.last().is_some_and(|last| is_open(a, last.ty)))
                && both().all(|(l, r)| l.offset == r.offset && is_same((a, l.ty), (b, r.ty)))
        }
        (
            TypeInner::Array { base: left, stride: left_stride, .. },
            TypeInner::Array { base: right, stride: right_stride, .. },
        ) => left_stride == right_stride && is_same((a, *left), (b, *right)),
        (TypeInner::BindingArray { base: left, .. }, TypeInner::BindingArray { base: right, .. }) => {
            is_same((a, *left), (b, *right))
        }
        // The rest has one layout each.
        _ => true,
    }
}
