//! Which kind of item stands under the attribute.

use crate::errors::Errors;
use crate::{attribute, constant, function, structure};
use proc_macro2::TokenStream;
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
