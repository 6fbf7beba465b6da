//! Which kind of item stands under the attribute.

use crate::errors::Errors;
use crate::{attribute, constant, function, structure};
use proc_macro2::{TokenStream, TokenTree};
use quote::quote;
use syn::Item;

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
    let (native, definition) = match item {
        Item::Fn(item) => function::expand(item, contract, &mut errors),
        Item::Struct(item) => structure::expand(item, &mut errors),
        Item::Const(item) => constant::expand(item, &mut errors),
        other => {
            let instead = match other {
                Item::Impl(_) => {
                    "write free functions; a method's name alone would not be unique in a shader"
                }
                Item::Enum(_) => "use `u32` constants and `match`",
                Item::Static(_) => "write a `const`",
                Item::Trait(_) | Item::Type(_) => "write out the concrete types",
                _ => "put it on a function, a structure or a constant",
            };
            errors.refuse(&other, "this item", instead);
            (quote!(#other), TokenStream::new())
        }
    };
    if errors.is_empty() {
        quote!(#native #definition)
    } else {
        let errors = errors.into_tokens();
        quote!(#native #errors)
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
