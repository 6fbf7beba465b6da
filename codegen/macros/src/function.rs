//! `#[kernel] fn`.

use crate::attribute::{self, Contract};
use crate::errors::Errors;
use crate::expr::Translator;
use crate::parameter::{self, Parameter};
use crate::scope::Scope;
use crate::{names, source, types};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::{ItemFn, ReturnType, Type};

/// The function, without the attributes that only this macro knows, and its definition.
pub(crate) fn expand(
    mut item: ItemFn,
    contract: Contract,
    errors: &mut Errors,
) -> (TokenStream, TokenStream) {
    let source = source::source(&item);
    let span = source::between(item.sig.fn_token.span, last_span(&item.sig));
    names::check(&item.sig.ident, errors);
    refuse_signature(&item, errors);
    let is_entry = contract.workgroup_size.is_some();
    let parameters = parameter::parameters(&mut item.sig.inputs, is_entry, errors);
    let result = match &item.sig.output {
        ReturnType::Default => None,
        ReturnType::Type(_, ty) => Some((**ty).clone()),
    };
    if let (true, Some(ty)) = (is_entry, &result) {
        errors.refuse(
            ty,
            "an entry point with a result",
            "write to a parameter `#[storage(0, 0)] values: &mut [T]`",
        );
    }
    let function = Function { item: &item, source, span, parameters: &parameters, result: result.as_ref() };
    let definition = function.definition(&contract, errors);
    let allowed = allowed_lints();
    if let Some(at) = &contract.measured {
        let text = measured_file(&item.sig.ident, at);
        item.attrs.push(syn::parse_quote!(#[doc = ""]));
        item.attrs.push(syn::parse_quote!(#[doc = #text]));
    }
    (quote!(#allowed #item), definition)
}

/// The text of `src/measured/NAME.md`, which `lobe measure --write` writes.
fn measured_file(name: &Ident, at: &Ident) -> TokenStream {
    let path = format!("/src/measured/{}.md", crate::scope::plain(name));
    quote_spanned!(at.span()=> ::core::include_str!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), #path)))
}

/// Lints whose advice lies outside the kernel language.
fn allowed_lints() -> TokenStream {
    quote!(#[allow(
        clippy::explicit_counter_loop,
        clippy::manual_clamp,
        clippy::manual_div_ceil,
        clippy::manual_is_multiple_of,
        clippy::manual_memcpy,
        clippy::manual_midpoint,
        clippy::manual_range_contains,
        clippy::manual_range_patterns,
        clippy::manual_swap,
        clippy::needless_range_loop,
        clippy::neg_cmp_op_on_partial_ord,
        clippy::too_many_arguments,
        reason = "what these lints advise is not part of the kernel language"
    )])
}

fn last_span(sig: &syn::Signature) -> proc_macro2::Span {
    sig.to_token_stream().into_iter().last().map_or(sig.ident.span(), |t| t.span())
}

fn refuse_signature(item: &ItemFn, errors: &mut Errors) {
    let sig = &item.sig;
    if let Some(token) = &sig.asyncness {
        errors.refuse(token, "an asynchronous function", "a kernel runs from begin to end");
    }
    if let Some(abi) = &sig.abi {
        errors.refuse(abi, "an `extern` function", "leave `extern` out");
    }
    if sig.generics.params.iter().any(|p| !matches!(p, syn::GenericParam::Lifetime(_))) {
        errors.refuse(&sig.generics, "a generic function", "write a function for each type");
    }
    let unsafety = sig.safety.to_token_stream();
    if !unsafety.is_empty() {
        errors.refuse(&unsafety, "an `unsafe` function", "leave `unsafe` out");
    }
}

/// What the definition is made of.
struct Function<'a> {
    item: &'a ItemFn,
    source: TokenStream,
    span: TokenStream,
    parameters: &'a [Parameter],
    result: Option<&'a Type>,
}

impl Function<'_> {
    fn definition(&self, contract: &Contract, errors: &mut Errors) -> TokenStream {
        let ident = &self.item.sig.ident;
        let vis = &self.item.vis;
        let mut translator = Translator { scope: self.scope(), errors, function: crate::scope::plain(ident) };
        let body = translator.block(&self.item.block);
        let locals = translator.scope.tokens();
        let native = if contract.workgroup_size.is_some() {
            quote!(None)
        } else {
            self.native(&quote!(#ident), &self.value_types(), self.result)
        };
        let contract_tokens = self.contract(contract, errors);
        let entry = match contract.workgroup_size {
            Some([x, y, z]) => quote!(Some([#x, #y, #z])),
            None => quote!(None),
        };
        let definition = self.function_def(
            &crate::scope::plain(ident),
            &entry,
            &locals,
            &body,
            &contract_tokens,
            &native,
            errors,
        );
        quote! {
            #[doc(hidden)]
            #[allow(non_camel_case_types, reason = "named as the function it stands for")]
            #[derive(Debug)]
            #vis enum #ident {}
            impl ::lobe_codegen::def::Callable for #ident {
                const CALLEE: ::lobe_codegen::def::Callee = ::lobe_codegen::def::Callee::Function(|| {
                    // The host may know an entry point by its definition alone.
                    let _ = #ident;
                    static DEF: ::lobe_codegen::def::FunctionDef = #definition;
                    &DEF
                });
            }
        }
    }

    fn scope(&self) -> Scope {
        let mut scope = Scope::default();
        for p in self.parameters {
            if p.is_value {
                scope.declare(&p.name, p.mutable)
            } else {
                scope.declare_binding(&p.name)
            };
        }
        scope
    }

    fn value_types(&self) -> Vec<&Type> {
        self.parameters.iter().map(|p| &p.ty).collect()
    }

    #[allow(clippy::too_many_arguments, reason = "the fields of one structure literal")]
    fn function_def(
        &self,
        name: &str,
        entry: &TokenStream,
        locals: &TokenStream,
        body: &TokenStream,
        contract: &TokenStream,
        native: &TokenStream,
        errors: &mut Errors,
    ) -> TokenStream {
        let (source, span, docs) = (&self.source, &self.span, source::docs(&self.item.attrs));
        let params = self.parameters.iter().map(|p| {
            let (name, binding, span) = (crate::scope::plain(&p.name), &p.binding, &p.span);
            let ty =
                if p.is_value { types::type_def(&p.ty, errors) } else { types::memory_def(&p.ty, errors) };
            quote!(::lobe_codegen::def::Param { name: #name, ty: #ty, binding: #binding, span: #span })
        });
        let params: Vec<_> = params.collect();
        let ret = match self.result {
            Some(ty) => {
                let ty = types::type_def(ty, errors);
                quote!(Some(#ty))
            }
            None => quote!(None),
        };
        quote!(::lobe_codegen::def::FunctionDef {
            name: #name,
            module: ::core::module_path!(),
            docs: #docs,
            source: #source,
            span: #span,
            entry: #entry,
            params: &[#(#params),*],
            ret: #ret,
            locals: #locals,
            body: #body,
            contract: #contract,
            native: #native,
        })
    }

    /// Calls `function` with values read from words.
    fn native(&self, function: &TokenStream, types: &[&Type], result: Option<&Type>) -> TokenStream {
        let names: Vec<_> = (0..types.len()).map(|i| format_ident!("argument_{i}")).collect();
        let call = match result {
            Some(_) => quote!(::lobe_codegen::def::KernelValue::write(&#function(#(#names),*), out);),
            None => quote!(#function(#(#names),*);),
        };
        quote!(Some(|words, out| {
            let _ = (&words, &out);
            #(let #names = <#types as ::lobe_codegen::def::KernelValue>::read(words);)*
            #call
        }))
    }

    fn contract(&self, contract: &Contract, errors: &mut Errors) -> TokenStream {
        let text = |t: &Option<syn::LitStr>| t.as_ref().map(syn::LitStr::value).unwrap_or_default();
        let (family, cite) = (text(&contract.family), text(&contract.cite));
        let domain: Vec<_> = contract.domain.iter().map(|row| self.domain(row, errors)).collect();
        let budget: Vec<_> = contract.budget.iter().map(|row| self.budget(row, errors)).collect();
        let variant_of = match &contract.variant_of {
            Some(path) => quote!(match <#path as ::lobe_codegen::def::Callable>::CALLEE {
                ::lobe_codegen::def::Callee::Function(f) => Some(f),
                ::lobe_codegen::def::Callee::Intrinsic(_) => None,
            }),
            None => quote!(None),
        };
        let not_robust = match &contract.not_robust {
            Some(reason) => quote!(Some(#reason)),
            None => quote!(None),
        };
        let truth = match (&contract.truth, self.parameters.len()) {
            (None, _) => quote!(None),
            (Some(path), 1) => quote!(Some(::lobe_codegen::def::Truth::Unary(#path))),
            (Some(path), 2) => quote!(Some(::lobe_codegen::def::Truth::Binary(#path))),
            (Some(path), _) => {
                errors.at(path, "a truth is stated for functions of one or two `f32`");
                quote!(None)
            }
        };
        let measured = match &contract.measured {
            Some(at) => {
                let text = measured_file(&self.item.sig.ident, at);
                quote!(Some(#text))
            }
            None => quote!(None),
        };
        quote!(::lobe_codegen::def::Contract {
            family: #family,
            cite: #cite,
            domain: &[#(#domain),*],
            budget: &[#(#budget),*],
            variant_of: #variant_of,
            not_robust: #not_robust,
            truth: #truth,
            measured: #measured,
        })
    }

    fn domain(&self, row: &attribute::DomainRow, errors: &mut Errors) -> TokenStream {
        let path = row.path.iter().map(ToString::to_string).collect::<Vec<_>>().join(".");
        if let Some(first) = row.path.first()
            && !self.parameters.iter().any(|p| p.name == *first)
        {
            errors.at(first, format!("`{first}` is no parameter of this function"));
        }
        let domain = attribute::domain(&row.domain, errors);
        let span = source::span(&row.path);
        quote!(::lobe_codegen::def::DomainDef { path: #path, domain: #domain, span: #span })
    }

    /// A budget is a function of the parameters and `result`, hidden beside the kernel.
    fn budget(&self, row: &attribute::BudgetRow, errors: &mut Errors) -> TokenStream {
        let Some(result) = self.result else {
            errors.at(&row.value, "a function without a result has no budget");
            return TokenStream::new();
        };
        let path = row.field.as_ref().map(ToString::to_string).unwrap_or_default();
        let value = &row.value;
        let text = value.to_token_stream().to_string();
        let name = format!("{}_budget", self.item.sig.ident);
        let result_name = Ident::new("result", self.item.sig.ident.span());
        let mut parameters: Vec<Parameter> = self
            .parameters
            .iter()
            .map(|p| Parameter {
                name: p.name.clone(),
                mutable: false,
                ty: p.ty.clone(),
                binding: p.binding.clone(),
                is_value: true,
                span: p.span.clone(),
            })
            .collect();
        parameters.push(Parameter {
            name: result_name,
            mutable: false,
            ty: result.clone(),
            binding: quote!(::lobe_codegen::def::Binding::Value),
            is_value: true,
            span: source::span(value),
        });
        let f32_type: Type = syn::parse_quote!(f32);
        let inner = Function {
            item: self.item,
            source: self.source.clone(),
            span: source::span(value),
            parameters: &parameters,
            result: Some(&f32_type),
        };
        let mut translator = Translator { scope: inner.scope(), errors, function: name.clone() };
        let body = translator.expr(value);
        let body = quote!(::lobe_codegen::def::Block { stmts: &[], value: Some(&#body) });
        let locals = translator.scope.tokens();
        let (names, tys): (Vec<_>, Vec<_>) = parameters.iter().map(|p| (&p.name, &p.ty)).unzip();
        let native = inner.native(&quote!(budget), &tys, Some(&f32_type));
        let contract = inner.contract(&Contract::default(), errors);
        let definition = inner.function_def(&name, &quote!(None), &locals, &body, &contract, &native, errors);
        quote!(::lobe_codegen::def::BudgetDef {
            path: #path,
            text: #text,
            function: || {
                #[allow(unused_variables, reason = "a budget need not depend on every argument")]
                #[allow(clippy::too_many_arguments, reason = "those of the kernel, and its result")]
                fn budget(#(#names: #tys),*) -> f32 { #value }
                static DEF: ::lobe_codegen::def::FunctionDef = #definition;
                &DEF
            },
        })
    }
}
