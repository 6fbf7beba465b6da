//! Examples: a shader that applies a kernel to rows of buffers, or to numbers that stand there.

use super::Contents;
use crate::emit::reflect::{FunctionInfo, MemberInfo, Reflection};
use crate::emit::{Target, reflect};

/// A kernel that an example calls.
pub(super) struct Example {
    pub(super) function: FunctionInfo,
    reflection: Reflection,
}

/// The first kernel whose arguments and result are scalars, vectors and structures.
pub(super) fn of(contents: &Contents<'_>) -> Option<Example> {
    such_that(contents, |_| true)
}

/// The first of them for which `is_wanted`.
pub(super) fn such_that(
    contents: &Contents<'_>,
    is_wanted: impl Fn(&FunctionInfo) -> bool,
) -> Option<Example> {
    let reflection = reflect(contents.module);
    let is_simple = |ty: &str| !ty.starts_with("array") && !ty.starts_with("ptr") && ty != "bool";
    let fits = |f: &&FunctionInfo| {
        f.parameters.iter().all(|p| is_simple(&p.ty)) && f.returns.as_deref().is_some_and(is_simple)
    };
    let named =
        |name: &String| reflection.functions.iter().filter(fits).find(|f| f.name == *name && is_wanted(f));
    let function = contents.prefixed.iter().find_map(named).cloned()?;
    Some(Example { function, reflection })
}

impl Example {
    /// A type in a language other than WGSL.
    pub(super) fn spelled(ty: &str, target: Target) -> String {
        let vector = if target == Target::Hlsl { "float" } else { "vec" };
        match ty {
            "f32" => "float".to_owned(),
            "i32" => "int".to_owned(),
            "u32" => "uint".to_owned(),
            "vec2<f32>" | "vec3<f32>" | "vec4<f32>" => format!("{vector}{}", &ty[3..4]),
            other => other.to_owned(),
        }
    }

    /// A value of a type, made of numbers, in GLSL.
    pub(super) fn value(&self, ty: &str) -> String {
        if let Some(structure) = self.reflection.structs.iter().find(|s| s.name == ty) {
            let members: Vec<String> = structure.members.iter().map(|m| self.value(&m.ty)).collect();
            return format!("{ty}({})", members.join(", "));
        }
        match ty {
            "f32" => "0.5".to_owned(),
            "i32" => "1".to_owned(),
            "u32" => "1u".to_owned(),
            "vec2<f32>" => "vec2(0.6, 0.8)".to_owned(),
            "vec3<f32>" => "vec3(0.0, 0.6, 0.8)".to_owned(),
            "vec4<f32>" => "vec4(0.1, 0.2, 0.3, 0.4)".to_owned(),
            other => format!("{other}(0)"),
        }
    }

    /// The members of a structure; `None` for other types.
    pub(super) fn members(&self, ty: &str) -> Option<&[MemberInfo]> {
        self.reflection.structs.iter().find(|s| s.name == ty).map(|s| s.members.as_slice())
    }

    /// How a float is made of the result: its first component or member.
    pub(super) fn first(&self, ty: &str) -> String {
        match self.reflection.structs.iter().find(|s| s.name == ty).and_then(|s| s.members.first()) {
            Some(member) => format!(".{}{}", member.name, self.first(&member.ty)),
            None if ty.starts_with("vec") => ".x".to_owned(),
            None => String::new(),
        }
    }
}
