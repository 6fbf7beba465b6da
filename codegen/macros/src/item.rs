//! Which kind of item stands under the attribute.

use crate::errors::Errors;
use crate::{attribute, constant, function, structure};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;
use syn::{Item, ItemConst, ItemFn, ItemStruct};

/// The item itself and its definition; or, when mistakes were found, the item and those.
pub(crate) fn expand(attribute: TokenStream, tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let contract = attribute::parse(attribute, &mut errors);
    let item = match syn::parse2::<Item>(tokens.clone()) {
        Ok(item) => item,
        Err(error) => {
            errors.push(error);
            let errors = errors.into_tokens();
            return quote!(#tokens #errors);
        }
    };
    refuse_cfg(tokens, &mut errors);
    let stub = stub(&item);
    let (native, definition) = match item {
        Item::Fn(item) => function::expand(item, contract, &mut errors),
        Item::Struct(item) => {
            contract.refuse_arguments("a structure", &mut errors);
            structure::expand(item, &mut errors)
        }
        Item::Const(item) => {
            contract.refuse_arguments("a constant", &mut errors);
            constant::expand(item, &mut errors)
        }
        other => {
            let (what, instead) = refused(&other);
            errors.refuse(&other, what, instead);
            (quote!(#other), TokenStream::new())
        }
    };
    if errors.is_empty() {
        quote!(#native #definition)
    } else {
        let errors = errors.into_tokens();
        quote!(#native #stub #errors)
    }
}

/// Stands for the definition of an item with mistakes, so that those who use it are not at fault too.
fn stub(item: &Item) -> TokenStream {
    let missing = quote!(::core::unreachable!("the definition has mistakes"));
    match item {
        Item::Fn(ItemFn { vis, sig, .. }) => {
            let ident = &sig.ident;
            quote! {
                #[doc(hidden)]
                #[allow(non_camel_case_types, reason = "named as the function it stands for")]
                #vis enum #ident {}
                impl ::lobe_codegen::def::Callable for #ident {
                    const CALLEE: ::lobe_codegen::def::Callee =
                        ::lobe_codegen::def::Callee::Function(|| #missing);
                }
            }
        }
        Item::Const(ItemConst { vis, ident, .. }) => quote! {
            #[doc(hidden)]
            #[allow(non_camel_case_types, clippy::upper_case_acronyms, reason = "named as the constant")]
            #vis enum #ident {}
            impl ::lobe_codegen::def::Constant for #ident {
                const DEF: ::lobe_codegen::def::ConstantRef = || #missing;
            }
        },
        Item::Struct(ItemStruct { ident, generics, .. }) if generics.params.is_empty() => quote! {
            impl ::lobe_codegen::def::KernelType for #ident {
                const TYPE: ::lobe_codegen::def::TypeDef = ::lobe_codegen::def::TypeDef::Struct(|| #missing);
            }
            impl ::lobe_codegen::def::KernelValue for #ident {
                fn read(_: &mut ::lobe_codegen::data::WordReader<'_>) -> Self {
                    #missing
                }
                fn write(&self, _: &mut ::std::vec::Vec<u32>) {}
            }
        },
        _ => TokenStream::new(),
    }
}

/// What an item is called that is no function, structure or constant, and what to write instead.
fn refused(item: &Item) -> (&'static str, &'static str) {
    match item {
        Item::Impl(_) => {
            ("an `impl` block", "write free functions; a method's name alone would not be unique in a shader")
        }
        Item::Enum(_) => ("an enumeration", "use `u32` constants and `match`"),
        Item::Static(_) => ("a static", "write a `const`"),
        Item::Trait(_) => ("a trait", "write a function for each type"),
        Item::Type(_) => ("a type alias", "leave `#[kernel]` out; kernels may use the alias as it is"),
        Item::Mod(_) => ("a module", "put `#[kernel]` on each item inside"),
        Item::Use(_) => ("a `use`", "leave `#[kernel]` out; kernels may use what it brings"),
        Item::Union(_) => ("a union", "use `to_bits` and `f32::from_bits`"),
        _ => ("this item", "put `#[kernel]` on a function, a structure or a constant"),
    }
}

/// rustc has not looked at `#[cfg]` inside the item yet: it would drop code from the Rust form only.
fn refuse_cfg(tokens: TokenStream, errors: &mut Errors) {
    let mut after_hash = false;
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => {
                let first = group.stream().into_iter().next();
                let is_cfg = matches!(&first, Some(TokenTree::Ident(i)) if *i == "cfg" || *i == "cfg_attr");
                if after_hash && is_cfg {
                    let instead = "write two items, each with its `#[cfg]` above `#[kernel]`";
                    errors.refuse(&group.stream(), "`#[cfg]` below `#[kernel]`", instead);
                }
                refuse_cfg(group.stream(), errors);
                after_hash = false;
            }
            TokenTree::Punct(punct) => after_hash = punct.as_char() == '#',
            TokenTree::Ident(_) | TokenTree::Literal(_) => after_hash = false,
        }
    }
}
