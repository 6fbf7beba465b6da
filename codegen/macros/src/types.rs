//! Types: what is refused here, and how the rest names its `TypeDef`.

use crate::errors::Errors;
use proc_macro2::TokenStream;
use quote::quote;
use syn::{Type, TypePath};

/// A `TypeDef` expression for `ty`; refused types are noted and come out as `f32`.
pub(crate) fn type_def(ty: &Type, errors: &mut Errors) -> TokenStream {
    check(ty, errors);
    quote!(<#ty as ::lobe_codegen::def::KernelType>::TYPE)
}

/// A `TypeDef` for the memory behind a binding, which may be a slice.
pub(crate) fn memory_def(ty: &Type, errors: &mut Errors) -> TokenStream {
    match ty {
        Type::Slice(slice) => check(&slice.elem, errors),
        other => check(other, errors),
    }
    quote!(<#ty as ::lobe_codegen::def::KernelType>::TYPE)
}

/// Whether booleans are inside.
pub(crate) fn has_bool(ty: &Type) -> bool {
    match ty {
        Type::Array(array) => has_bool(&array.elem),
        other => matches!(last_name(other).as_str(), "bool" | "BVec2" | "BVec3" | "BVec4"),
    }
}

/// A `TypeDef` for the target of `as`, where `usize` is allowed since Rust's indices need it.
pub(crate) fn cast_target(ty: &Type, errors: &mut Errors) -> TokenStream {
    if is_ident(ty, "usize") {
        return quote!(<u32 as ::lobe_codegen::def::KernelType>::TYPE);
    }
    type_def(ty, errors)
}

/// Whether `ty` is the plain name `name`.
pub(crate) fn is_ident(ty: &Type, name: &str) -> bool {
    matches!(ty, Type::Path(TypePath { qself: None, path, .. }) if path.is_ident(name))
}

fn check(ty: &Type, errors: &mut Errors) {
    match ty {
        Type::Path(path) => check_path(path, errors),
        Type::Array(array) => check(&array.elem, errors),
        Type::Slice(_) => errors.refuse(
            ty,
            "a slice",
            "use an array `[T; N]`; only storage parameters of entry points have a length of their own",
        ),
        Type::Paren(inner) => check(&inner.elem, errors),
        Type::Group(inner) => check(&inner.elem, errors),
        Type::Reference(_) => errors.refuse(
            ty,
            "a reference",
            "pass the value; only storage, uniform and workgroup parameters of entry points are references",
        ),
        Type::Tuple(_) => errors.refuse(ty, "a tuple", "declare a `#[kernel] struct` with named fields"),
        Type::ImplTrait(_) | Type::TraitObject(_) => {
            errors.refuse(ty, "a trait type", "name the concrete type");
        }
        Type::FnPtr(_) => errors.refuse(ty, "a function pointer", "call the function by its name"),
        Type::Ptr(_) => errors.refuse(ty, "a raw pointer", "pass the value"),
        Type::Infer(_) => errors.refuse(ty, "`_`", "write the type, or leave the annotation out"),
        _ => errors.refuse(ty, "this type", "use f32, i32, u32, bool, glam's types, arrays and structures"),
    }
}

fn check_path(ty: &TypePath, errors: &mut Errors) {
    let Some(last) = ty.path.segments.last() else { return };
    if !matches!(last.arguments, syn::PathArguments::None) {
        let (what, instead) = generic(&last.ident.to_string());
        errors.refuse(ty, what, instead);
        return;
    }
    let name = last.ident.to_string();
    let instead = match name.as_str() {
        "f64" => "shading languages promise no 64-bit functions; use `f32`",
        "f16" | "half" => "use `f32`",
        "i8" | "i16" | "i64" | "i128" | "isize" => "use `i32`",
        "u8" | "u16" | "u64" | "u128" | "usize" => {
            "use `u32` (an index is cast where it is used: `a[i as usize]`)"
        }
        "char" | "str" | "String" => "shaders have no text; use `u32`",
        "Vec3A" => "its fourth lane has no place in a buffer; use `Vec3`",
        "DVec2" | "DVec3" | "DVec4" => "use `Vec2`, `Vec3`, `Vec4`",
        "Self" => "name the type",
        _ => return,
    };
    errors.refuse(ty, &format!("`{name}`"), instead);
}

/// What a type with arguments is called, and what to write instead.
fn generic(name: &str) -> (&'static str, &'static str) {
    match name {
        "Option" | "Result" => {
            ("an `Option` or `Result`", "return a value that stands for none, or a structure with a flag")
        }
        "Vec" => ("a growing vector", "use an array `[T; N]`, or storage of an entry point"),
        "Box" | "Rc" | "Arc" => ("memory on a heap", "use the value itself"),
        _ => ("a generic type", "write a structure for each element type"),
    }
}

/// The last name of a type's path.
pub(crate) fn last_name(ty: &Type) -> String {
    match ty {
        Type::Path(path) => path.path.segments.last().map(|s| s.ident.to_string()).unwrap_or_default(),
        _ => String::new(),
    }
}

/// Tokens as a user would write a path.
pub(crate) fn text(tokens: &dyn quote::ToTokens) -> String {
    tokens.to_token_stream().to_string().replace(' ', "")
}
