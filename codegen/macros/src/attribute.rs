//! The contract in the attribute's arguments.

use crate::errors::Errors;
use proc_macro2::TokenStream;
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Expr, Ident, LitInt, LitStr, Path, Token};

/// What `#[kernel(..)]` states.
#[derive(Default)]
pub(crate) struct Contract {
    pub(crate) family: Option<LitStr>,
    pub(crate) cite: Option<LitStr>,
    pub(crate) domain: Vec<DomainRow>,
    pub(crate) budget: Vec<BudgetRow>,
    pub(crate) variant_of: Option<Path>,
    pub(crate) not_robust: Option<LitStr>,
    pub(crate) truth: Option<Path>,
    pub(crate) workgroup_size: Option<Vec<u32>>,
}

/// `path = domain`
pub(crate) struct DomainRow {
    pub(crate) path: Punctuated<Ident, Token![.]>,
    pub(crate) domain: DomainArgument,
}

/// `expression`, or `field = expression`
pub(crate) struct BudgetRow {
    pub(crate) field: Option<Ident>,
    pub(crate) value: Expr,
}

/// `lo..=hi`, `unit`, or `[a, b, c]`.
pub(crate) struct DomainArgument(Expr);

impl Parse for DomainArgument {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        input.parse().map(Self)
    }
}

impl Parse for DomainRow {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let path = Punctuated::parse_separated_nonempty(input)?;
        input.parse::<Token![=]>()?;
        Ok(Self { path, domain: input.parse()? })
    }
}

impl Parse for BudgetRow {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let field = if input.peek(Ident) && input.peek2(Token![=]) && !input.peek2(Token![==]) {
            let name = input.parse()?;
            input.parse::<Token![=]>()?;
            Some(name)
        } else {
            None
        };
        Ok(Self { field, value: input.parse()? })
    }
}

/// Reads the attribute's arguments; mistakes are noted.
pub(crate) fn parse(tokens: TokenStream, errors: &mut Errors) -> Contract {
    let mut contract = Contract::default();
    let parser = |input: ParseStream<'_>| {
        while !input.is_empty() {
            argument(input, &mut contract)?;
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        Ok(())
    };
    if let Err(error) = syn::parse::Parser::parse2(parser, tokens) {
        errors.push(error);
    }
    contract
}

fn argument(input: ParseStream<'_>, contract: &mut Contract) -> syn::Result<()> {
    let name: Ident = input.parse()?;
    match name.to_string().as_str() {
        "family" => contract.family = Some(assigned(input)?),
        "cite" => contract.cite = Some(assigned(input)?),
        "not_robust" => contract.not_robust = Some(assigned(input)?),
        "variant_of" => contract.variant_of = Some(assigned(input)?),
        "truth" => contract.truth = Some(assigned(input)?),
        "domain" => contract.domain.extend(listed::<DomainRow>(input)?),
        "budget" => contract.budget.extend(listed::<BudgetRow>(input)?),
        "workgroup_size" => {
            let sizes = listed::<LitInt>(input)?;
            contract.workgroup_size =
                Some(sizes.iter().map(LitInt::base10_parse).collect::<syn::Result<_>>()?);
        }
        other => {
            return Err(syn::Error::new(
                name.span(),
                format!(
                    "`{other}` is no argument of #[kernel]: family, cite, domain(..), budget(..), variant_of, \
                     not_robust, truth, workgroup_size(..)"
                ),
            ));
        }
    }
    Ok(())
}

fn assigned<T: Parse>(input: ParseStream<'_>) -> syn::Result<T> {
    input.parse::<Token![=]>()?;
    input.parse()
}

fn listed<T: Parse>(input: ParseStream<'_>) -> syn::Result<Vec<T>> {
    let inner;
    syn::parenthesized!(inner in input);
    Ok(Punctuated::<T, Token![,]>::parse_terminated(&inner)?.into_iter().collect())
}

/// A `def::Domain` expression.
pub(crate) fn domain(argument: &DomainArgument, errors: &mut Errors) -> TokenStream {
    match &argument.0 {
        Expr::Path(p) if p.path.is_ident("unit") => quote!(::lobe_codegen::def::Domain::Unit),
        Expr::Range(syn::ExprRange {
            start: Some(lo),
            end: Some(hi),
            limits: syn::RangeLimits::Closed(_),
            ..
        }) => quote!(::lobe_codegen::def::Domain::Range((#lo) as f64, (#hi) as f64)),
        Expr::Array(list) => {
            let values = list.elems.iter();
            quote!(::lobe_codegen::def::Domain::Values(&[#((#values) as f64),*]))
        }
        other => {
            errors.at(other, "a domain is `lo..=hi`, `unit` (vectors of length one) or `[a, b, c]`");
            quote!(::lobe_codegen::def::Domain::Unit)
        }
    }
}
