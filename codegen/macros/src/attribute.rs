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
    /// `measured`, where it stands.
    pub(crate) measured: Option<Ident>,
    pub(crate) workgroup_size: Option<[u32; 3]>,
    /// The names of the arguments, in order.
    written: Vec<Ident>,
}

impl Contract {
    /// Notes arguments on an item that has none.
    pub(crate) fn refuse_arguments(&self, what: &str, errors: &mut Errors) {
        for name in &self.written {
            errors.at(name, format!("{what} takes no argument `{name}`; only functions make promises"));
        }
    }
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

/// `lo..=hi`, `unit`, `[a, b, c]`, `normal_to(z)` or `cross(z, x)`.
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
    if contract.written.contains(&name) {
        return Err(syn::Error::new(name.span(), format!("`{name}` is stated twice")));
    }
    contract.written.push(name.clone());
    match name.to_string().as_str() {
        "family" => contract.family = Some(text(input, &name)?),
        "cite" => contract.cite = Some(text(input, &name)?),
        "not_robust" => contract.not_robust = Some(text(input, &name)?),
        "variant_of" => contract.variant_of = Some(assigned(input)?),
        "truth" => contract.truth = Some(assigned(input)?),
        "measured" => contract.measured = Some(name),
        "domain" => contract.domain.extend(listed::<DomainRow>(input)?),
        "budget" => contract.budget.extend(listed::<BudgetRow>(input)?),
        "workgroup_size" => contract.workgroup_size = Some(workgroup_size(input, &name)?),
        other => {
            return Err(syn::Error::new(
                name.span(),
                format!(
                    "`{other}` is no argument of #[kernel]; there are family, cite, domain(..), budget(..), \
                     variant_of, not_robust, truth, measured and workgroup_size(..)"
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

fn text(input: ParseStream<'_>, name: &Ident) -> syn::Result<LitStr> {
    input.parse::<Token![=]>()?;
    input
        .parse()
        .map_err(|e| syn::Error::new(e.span(), format!("`{name}` is a text: write `{name} = \"..\"`")))
}

/// One to three numbers; what is left out is 1.
fn workgroup_size(input: ParseStream<'_>, name: &Ident) -> syn::Result<[u32; 3]> {
    let wrong = |span| syn::Error::new(span, "a workgroup size has one, two or three numbers, as `(8, 8)`");
    let sizes = listed::<LitInt>(input).map_err(|e| wrong(e.span()))?;
    let sizes: Vec<u32> = sizes.iter().map(LitInt::base10_parse).collect::<syn::Result<_>>()?;
    match sizes[..] {
        [x] => Ok([x, 1, 1]),
        [x, y] => Ok([x, y, 1]),
        [x, y, z] => Ok([x, y, z]),
        _ => Err(wrong(name.span())),
    }
}

fn listed<T: Parse>(input: ParseStream<'_>) -> syn::Result<Vec<T>> {
    let inner;
    syn::parenthesized!(inner in input);
    Ok(Punctuated::<T, Token![,]>::parse_terminated(&inner)?.into_iter().collect())
}

/// A `def::Domain` expression.
pub(crate) fn domain(argument: &DomainArgument, errors: &mut Errors) -> TokenStream {
    match plain(&argument.0) {
        Expr::Path(p) if p.path.is_ident("unit") => quote!(::lobe_codegen::def::Domain::Unit),
        Expr::Call(call) => match relation(call) {
            Some(tokens) => tokens,
            None => wrong(call, errors),
        },
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
        other => wrong(other, errors),
    }
}

fn wrong(tokens: &impl quote::ToTokens, errors: &mut Errors) -> TokenStream {
    errors.at(
        tokens,
        "a domain is `lo..=hi`, `[a, b, c]`, `unit` (vectors of length one), or in relation to siblings that are \
         declared before: `normal_to(z)` (unit and perpendicular to z) or `cross(z, x)`",
    );
    quote!(::lobe_codegen::def::Domain::Unit)
}

/// `normal_to(z)` or `cross(z, x)`.
fn relation(call: &syn::ExprCall) -> Option<TokenStream> {
    let ident = |expr: &Expr| match plain(expr) {
        Expr::Path(p) => p.path.get_ident().map(Ident::to_string),
        _ => None,
    };
    let siblings: Vec<String> = call.args.iter().map(ident).collect::<Option<_>>()?;
    match (ident(&call.func)?.as_str(), siblings.as_slice()) {
        ("normal_to", [z]) => Some(quote!(::lobe_codegen::def::Domain::NormalTo(#z))),
        ("cross", [z, x]) => Some(quote!(::lobe_codegen::def::Domain::Cross(#z, #x))),
        _ => None,
    }
}

/// The expression inside the invisible group that `$domain:expr` of a `macro_rules` puts around it.
fn plain(expr: &Expr) -> &Expr {
    match expr {
        Expr::Group(group) => plain(&group.expr),
        other => other,
    }
}
