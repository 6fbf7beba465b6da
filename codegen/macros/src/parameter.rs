//! Parameters, and where those of entry points come from.

use crate::errors::Errors;
use crate::{names, source};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};
use syn::punctuated::Punctuated;
use syn::{Attribute, FnArg, Pat, Token, Type};

/// A parameter after the checks.
pub(crate) struct Parameter {
    pub(crate) name: Ident,
    pub(crate) mutable: bool,
    /// For memory, the type behind the reference.
    pub(crate) ty: Type,
    pub(crate) binding: TokenStream,
    pub(crate) is_value: bool,
    pub(crate) span: TokenStream,
}

/// Where a parameter of an entry point comes from.
enum Source {
    Builtin(TokenStream),
    Storage(u32, u32),
    Uniform(u32, u32),
    Workgroup,
    /// An attribute that does not parse; its error says enough.
    Mistaken,
}

/// Reads the parameters and takes the attributes away that only this macro knows.
pub(crate) fn parameters(
    inputs: &mut Punctuated<FnArg, Token![,]>,
    is_entry: bool,
    errors: &mut Errors,
) -> Vec<Parameter> {
    let mut out = Vec::new();
    for input in inputs {
        let span = source::span(input);
        let FnArg::Typed(input) = input else {
            errors.refuse(input, "a method", "write a free function that takes the value");
            continue;
        };
        let from = take_source(&mut input.attrs, errors);
        check_source(from.as_ref(), &input.ty, is_entry, errors);
        let Some((name, mutable)) = name(&input.pat, errors) else { continue };
        let is_memory = from.is_some() && matches!(&*input.ty, Type::Reference(_));
        let writable = matches!(&*input.ty, Type::Reference(r) if r.mutability.is_some());
        let ty = match &*input.ty {
            Type::Reference(r) if is_memory => (*r.elem).clone(),
            other => other.clone(),
        };
        let binding = binding(from.as_ref(), writable);
        out.push(Parameter { name, mutable, ty, binding, is_value: !is_memory, span });
    }
    out
}

/// The name that the parameter binds, and whether it is `mut`.
fn name(pattern: &Pat, errors: &mut Errors) -> Option<(Ident, bool)> {
    match pattern {
        Pat::Ident(p) if p.by_ref.is_none() && p.subpat.is_none() => {
            names::check(&p.ident, errors);
            Some((p.ident.clone(), p.mutability.is_some()))
        }
        Pat::Ident(p) if p.by_ref.is_some() => {
            errors.refuse(pattern, "a `ref` parameter", "kernel values are copied; leave `ref` out");
            None
        }
        Pat::Wild(_) => {
            errors.refuse(pattern, "a parameter without a name", "name it; its name is emitted");
            None
        }
        other => {
            errors.refuse(other, "a destructuring parameter", "bind one name and take its fields with `.`");
            None
        }
    }
}

fn take_source(attributes: &mut Vec<Attribute>, errors: &mut Errors) -> Option<Source> {
    let mut found = None;
    attributes.retain(|a| {
        let parsed = match a.path().to_token_stream().to_string().as_str() {
            "builtin" => builtin(a).map(Source::Builtin),
            "storage" => numbers(a).map(|(g, b)| Source::Storage(g, b)),
            "uniform" => numbers(a).map(|(g, b)| Source::Uniform(g, b)),
            "workgroup" => Ok(Source::Workgroup),
            _ => return true,
        };
        match parsed {
            Ok(_) if found.is_some() => errors.at(a, "a parameter comes from one place only"),
            Ok(source) => found = Some(source),
            Err(error) => {
                errors.push(error);
                found.get_or_insert(Source::Mistaken);
            }
        }
        false
    });
    found
}

fn check_source(from: Option<&Source>, ty: &Type, is_entry: bool, errors: &mut Errors) {
    let reference = match ty {
        Type::Reference(r) => Some(r.mutability.is_some()),
        _ => None,
    };
    let message = match (from, is_entry, reference) {
        (None, true, _) => {
            "a parameter of an entry point says where it comes from: \
             #[builtin(..)], #[storage(group, binding)], #[uniform(group, binding)] or #[workgroup]"
        }
        (Some(_), false, _) => "only entry points have bindings: add `workgroup_size(..)` to #[kernel]",
        (Some(Source::Builtin(_)), true, Some(_)) => "a built-in input is a value: leave the `&` out",
        (Some(Source::Storage(..)), true, None) => {
            "a storage binding is memory: take it as `&T`, or as `&mut T` to write"
        }
        (Some(Source::Uniform(..)), true, None | Some(true)) => {
            "a uniform binding is memory that no shader writes: take it as `&T`"
        }
        (Some(Source::Workgroup), true, None | Some(false)) => {
            "workgroup memory is shared and written: take it as `&mut T`"
        }
        (None, false, _) | (Some(_), true, _) => return,
    };
    errors.at(ty, message);
}

fn binding(from: Option<&Source>, writable: bool) -> TokenStream {
    match from {
        None | Some(Source::Mistaken) => quote!(::lobe_codegen::def::Binding::Value),
        Some(Source::Builtin(variant)) => {
            quote!(::lobe_codegen::def::Binding::Builtin(::lobe_codegen::def::Builtin::#variant))
        }
        Some(Source::Storage(group, binding)) => quote!(::lobe_codegen::def::Binding::Storage {
            group: #group, binding: #binding, writable: #writable,
        }),
        Some(Source::Uniform(group, binding)) => {
            quote!(::lobe_codegen::def::Binding::Uniform { group: #group, binding: #binding })
        }
        Some(Source::Workgroup) => quote!(::lobe_codegen::def::Binding::Workgroup),
    }
}

fn builtin(a: &Attribute) -> syn::Result<TokenStream> {
    let name: Ident = a.parse_args()?;
    Ok(match name.to_string().as_str() {
        "global_invocation_id" => quote!(GlobalInvocationId),
        "local_invocation_id" => quote!(LocalInvocationId),
        "local_invocation_index" => quote!(LocalInvocationIndex),
        "workgroup_id" => quote!(WorkgroupId),
        "num_workgroups" => quote!(NumWorkgroups),
        other => {
            return Err(syn::Error::new(
                name.span(),
                format!(
                    "`{other}` is no built-in input of a compute entry point; there are global_invocation_id, \
                     local_invocation_id, local_invocation_index, workgroup_id and num_workgroups"
                ),
            ));
        }
    })
}

fn numbers(a: &Attribute) -> syn::Result<(u32, u32)> {
    let wanted = || syn::Error::new_spanned(a, "write the group and the binding, as `(0, 1)`");
    let list =
        a.parse_args_with(Punctuated::<syn::LitInt, Token![,]>::parse_terminated).map_err(|_| wanted())?;
    match list.iter().map(syn::LitInt::base10_parse).collect::<syn::Result<Vec<u32>>>()?[..] {
        [group, binding] => Ok((group, binding)),
        _ => Err(wanted()),
    }
}
