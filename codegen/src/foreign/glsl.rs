//! What naga's GLSL front end takes for something else, without a word.

use naga::proc::{Layouter, TypeLayout};
use naga::{AddressSpace, Handle, Module, Type, TypeInner};

/// What naga misread of `text`; `None` if nothing.
pub(super) fn misread(module: &Module, text: &str) -> Option<String> {
    if text.contains("std140") {
        return None;
    }
    let mut layouter = Layouter::default();
    layouter.update(module.to_ctx()).ok()?;
    let mut pushed = module.global_variables.iter().filter(|(_, v)| v.space == AddressSpace::Immediate);
    pushed.any(|(_, variable)| !is_natural(module, &layouter, variable.ty)).then(|| {
        "naga lays push constants out by std140, where std430 is the rule; write layout(push_constant, std430)"
            .to_owned()
    })
}

/// Whether the parts of a type follow each other as their alignments have it, which is std430.
fn is_natural(module: &Module, layouter: &Layouter, ty: Handle<Type>) -> bool {
    match &module.types[ty].inner {
        TypeInner::Array { base, stride, .. } => {
            *stride == layouter[*base].to_stride() && is_natural(module, layouter, *base)
        }
        TypeInner::Struct { members, .. } => {
            let mut end = 0;
            members.iter().all(|member| {
                let TypeLayout { size, alignment } = layouter[member.ty];
                let begin = alignment.round_up(end);
                end = begin + size;
                member.offset == begin && is_natural(module, layouter, member.ty)
            })
        }
        // The rest has one layout each.
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use crate::foreign::{ForeignError, Language, Source, read};

    fn outcome(layout: &str, members: &str) -> Result<(), ForeignError> {
        let text = format!(
            "#version 450\nlayout({layout}) uniform Push {{ {members} }} push;\n\
             layout(set = 0, binding = 0) buffer Out {{ uint result; }};\nvoid main() {{ result = push.a; }}"
        );
        let (name, bytes) = ("a.glsl".to_owned(), text.into_bytes());
        read(&Source { name, language: Language::Glsl, bytes }).map(drop)
    }

    #[test]
    fn push_constants_have_the_layout_that_the_language_says() {
        let (plain, list) = ("uint a; vec3 b; float c; mat2x4 d;", "uint a; uint b[3];");
        for (layout, members, is_read) in [
            ("push_constant", plain, true),
            ("push_constant", list, false),
            ("push_constant, std430", list, true),
            ("push_constant, std140", list, true),
        ] {
            let outcome = outcome(layout, members);
            assert_eq!(outcome.is_ok(), is_read, "{layout} {members}: {outcome:?}");
        }
    }
}
