//! `#[kernel] const`.

use crate::errors::Errors;
use crate::{names, source, types};
use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, ItemConst, Lit, Type};

/// The constant and its definition.
pub(crate) fn expand(item: ItemConst, errors: &mut Errors) -> (TokenStream, TokenStream) {
    names::check(&item.ident, errors);
    let ItemConst { ident, vis, ty, expr, attrs, .. } = &item;
    let (name, docs) = (ident.to_string(), source::docs(attrs));
    let (source, span) = (source::source(&item), source::span(&item));
    let before = errors.len();
    let type_def = types::type_def(ty, errors);
    // One mistake about the type is enough.
    let value = if errors.len() == before { value(ty, &quote!(#ident), errors) } else { TokenStream::new() };
    let exact = match float_literal(expr) {
        Some(value) => quote!(Some(#value)),
        None => quote!(None),
    };
    let definition = quote! {
        #[doc(hidden)]
        #[allow(non_camel_case_types, clippy::upper_case_acronyms, reason = "named as the constant it stands for")]
        #vis enum #ident {}
        impl ::lobe_codegen::def::Constant for #ident {
            const DEF: ::lobe_codegen::def::ConstantRef = || {
                static DEF: ::lobe_codegen::def::ConstantDef = ::lobe_codegen::def::ConstantDef {
                    name: #name,
                    docs: #docs,
                    source: #source,
                    span: #span,
                    ty: #type_def,
                    value: #value,
                    exact: #exact,
                };
                &DEF
            };
        }
    };
    (quote!(#item), definition)
}

/// What constants can be.
const INSTEAD: &str = "use numbers, vectors or arrays of them; build structures in a function";

/// A `ConstantValue` expression for the Rust constant expression `path` of type `ty`.
fn value(ty: &Type, path: &TokenStream, errors: &mut Errors) -> TokenStream {
    let composite =
        |parts: Vec<TokenStream>| quote!(::lobe_codegen::def::ConstantValue::Composite(&[#(#parts),*]));
    match ty {
        Type::Array(array) => {
            let Some(n) = length(&array.len) else {
                errors.at(&array.len, "the length of a kernel constant's array must be an integer literal");
                return composite(Vec::new());
            };
            composite((0..n).map(|i| value(&array.elem, &quote!(#path[#i]), errors)).collect())
        }
        Type::Path(p) => {
            let name = p.path.segments.last().map(|s| s.ident.to_string()).unwrap_or_default();
            match (scalar_variant(&name), vector(&name)) {
                (Some(variant), _) => quote!(::lobe_codegen::def::ConstantValue::#variant(#path)),
                (None, Some((variant, components))) => composite(
                    components
                        .chars()
                        .map(|c| {
                            // glam's vectors have no const accessors but `to_array`.
                            let i = "xyzw".find(c).unwrap_or(0);
                            quote!(::lobe_codegen::def::ConstantValue::#variant(#path.to_array()[#i]))
                        })
                        .collect(),
                ),
                (None, None) => {
                    errors.refuse(ty, "a constant of this type", INSTEAD);
                    composite(Vec::new())
                }
            }
        }
        other => {
            errors.refuse(other, "a constant of this type", INSTEAD);
            composite(Vec::new())
        }
    }
}

fn scalar_variant(name: &str) -> Option<TokenStream> {
    Some(match name {
        "f32" => quote!(F32),
        "i32" => quote!(I32),
        "u32" => quote!(U32),
        "bool" => quote!(Bool),
        _ => return None,
    })
}

fn vector(name: &str) -> Option<(TokenStream, &'static str)> {
    let (kind, n) = name.split_at_checked(name.len().checked_sub(1)?)?;
    let components = match n {
        "2" => "xy",
        "3" => "xyz",
        "4" => "xyzw",
        _ => return None,
    };
    Some(match kind {
        "Vec" => (quote!(F32), components),
        "IVec" => (quote!(I32), components),
        "UVec" => (quote!(U32), components),
        _ => return None,
    })
}

fn length(len: &Expr) -> Option<usize> {
    match len {
        Expr::Lit(syn::ExprLit { lit: Lit::Int(n), .. }) => n.base10_parse().ok(),
        _ => None,
    }
}

/// The value of a float literal, possibly negated.
fn float_literal(e: &Expr) -> Option<f64> {
    match e {
        Expr::Lit(syn::ExprLit { lit: Lit::Float(f), .. }) => f.base10_digits().parse().ok(),
        Expr::Unary(syn::ExprUnary { op: syn::UnOp::Neg(_), expr, .. }) => float_literal(expr).map(|x| -x),
        _ => None,
    }
}
