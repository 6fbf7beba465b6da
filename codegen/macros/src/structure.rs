//! `#[kernel] struct`.

use crate::attribute::{self, DomainArgument};
use crate::errors::Errors;
use crate::{names, source, types};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{Fields, ItemStruct};

/// The structure, without the attributes that only this macro knows, and its definition.
pub(crate) fn expand(mut item: ItemStruct, errors: &mut Errors) -> (TokenStream, TokenStream) {
    let source = source::source(&item);
    let span = source::span(&item);
    names::check(&item.ident, errors);
    if !item.generics.params.is_empty() {
        errors.refuse(&item.generics, "a generic structure", "write a structure for each element type");
    }
    let Fields::Named(fields) = &mut item.fields else {
        let at: &dyn ToTokens = if item.fields.is_empty() { &item.ident } else { &item.fields };
        errors.refuse(at, "a structure without named fields", "name each field");
        return (quote!(#item), TokenStream::new());
    };
    let mut definitions = Vec::new();
    let (mut field_names, mut field_types) = (Vec::new(), Vec::new());
    for field in &mut fields.named {
        let span = source::span(field);
        let domain = field_domain(&mut field.attrs, errors);
        let Some(ident) = &field.ident else { continue };
        names::check(ident, errors);
        if types::has_bool(&field.ty) {
            errors.refuse(&field.ty, "a field of `bool`", "it has no layout in a buffer; use `u32`");
        }
        let (name, docs) = (crate::scope::plain(ident), source::docs(&field.attrs));
        let ty = types::type_def(&field.ty, errors);
        definitions.push(quote!(::lobe_codegen::def::FieldDef {
            name: #name, ty: #ty, docs: #docs, domain: #domain, span: #span,
        }));
        field_names.push(ident.clone());
        field_types.push(field.ty.clone());
    }
    if definitions.is_empty() {
        errors.refuse(&item.ident, "an empty structure", "give it a field; shading languages want one");
    }
    let (ident, name, docs) = (&item.ident, item.ident.to_string(), source::docs(&item.attrs));
    let definition = quote! {
        impl ::lobe_codegen::def::KernelType for #ident {
            const TYPE: ::lobe_codegen::def::TypeDef = ::lobe_codegen::def::TypeDef::Struct(|| {
                static DEF: ::lobe_codegen::def::StructDef = ::lobe_codegen::def::StructDef {
                    name: #name,
                    docs: #docs,
                    source: #source,
                    span: #span,
                    fields: &[#(#definitions),*],
                };
                &DEF
            });
        }
        impl ::lobe_codegen::def::KernelValue for #ident {
            fn read(words: &mut ::lobe_codegen::data::WordReader<'_>) -> Self {
                #(let #field_names = <#field_types as ::lobe_codegen::def::KernelValue>::read(words);)*
                Self { #(#field_names),* }
            }
            fn write(&self, words: &mut ::std::vec::Vec<u32>) {
                #(::lobe_codegen::def::KernelValue::write(&self.#field_names, words);)*
            }
        }
    };
    // Shader values are copied; so are these.
    (quote!(#[derive(Debug, Clone, Copy, PartialEq)] #item), definition)
}

/// Takes `#[domain(..)]` away and returns it as an `Option<Domain>` expression.
fn field_domain(attributes: &mut Vec<syn::Attribute>, errors: &mut Errors) -> TokenStream {
    let mut out = quote!(None);
    attributes.retain(|a| {
        if !a.path().is_ident("domain") {
            return true;
        }
        match a.parse_args::<DomainArgument>() {
            Ok(domain) => {
                let domain = attribute::domain(&domain, errors);
                out = quote!(Some(#domain));
            }
            Err(error) => errors.push(error),
        }
        false
    });
    out
}
