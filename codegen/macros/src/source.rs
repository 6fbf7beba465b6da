//! Source positions and the text they point into.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};

/// First and last token's spans of `tokens`.
fn ends(tokens: &dyn ToTokens) -> (Span, Span) {
    let mut trees = tokens.to_token_stream().into_iter();
    let Some(first) = trees.next() else { return (Span::call_site(), Span::call_site()) };
    let open = |t: &TokenTree| if let TokenTree::Group(g) = t { g.span_open() } else { t.span() };
    let close = |t: &TokenTree| if let TokenTree::Group(g) = t { g.span_close() } else { t.span() };
    let last = trees.last().unwrap_or_else(|| first.clone());
    (open(&first), close(&last))
}

/// A `def::Span` that covers `tokens`.
pub(crate) fn span(tokens: &dyn ToTokens) -> TokenStream {
    let (first, last) = ends(tokens);
    between(first, last)
}

/// A `def::Span` from the begin of `first` to the end of `last`.
pub(crate) fn between(first: Span, last: Span) -> TokenStream {
    let (start, end) = (first.unwrap().start(), last.unwrap().end());
    // rustc counts columns from 1.
    let (l0, c0) = (start.line() as u32, start.column().saturating_sub(1) as u32);
    let (l1, c1) = (end.line() as u32, end.column().saturating_sub(1) as u32);
    quote!(::lobe_codegen::def::Span { start: (#l0, #c0), end: (#l1, #c1) })
}

/// A `def::Source`: the whole lines that `item` covers.
pub(crate) fn source(item: &dyn ToTokens) -> TokenStream {
    let (first, last) = ends(item);
    let (first, last) = (first.unwrap(), last.unwrap());
    let file = first.file();
    let (from, to) = (first_line(first), last.end().line());
    let text = first
        .local_file()
        .and_then(|path| std::fs::read_to_string(path).ok())
        .map(|text| {
            let lines: Vec<&str> = text.lines().skip(from.saturating_sub(1)).take(to + 1 - from).collect();
            lines.join("\n")
        })
        .unwrap_or_default();
    let line = from as u32;
    quote!(::lobe_codegen::def::Source { file: #file, line: #line, text: #text })
}

/// The line at which an item begins, `#[kernel(..)]` included: its arguments have spans too.
fn first_line(first: proc_macro::Span) -> usize {
    let attribute = Span::call_site().unwrap();
    let above = attribute.start().line();
    let line = first.start().line();
    if attribute.file() == first.file() && above > 0 { line.min(above) } else { line }
}

/// The lines of the doc comment among `attributes`, as a slice of strings.
///
/// The value of `#[doc = include_str!(..)]` or another macro is rustc's to compute: it is one string of lines.
pub(crate) fn docs(attributes: &[syn::Attribute]) -> TokenStream {
    let values = attributes.iter().filter_map(|a| match &a.meta {
        syn::Meta::NameValue(meta) if meta.path.is_ident("doc") => Some(&meta.value),
        _ => None,
    });
    let lines = values.flat_map(|value| match value {
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => {
            let lines = text.value();
            lines.split('\n').map(|l| l.strip_prefix(' ').unwrap_or(l).to_token_stream()).collect()
        }
        syn::Expr::Macro(call) => vec![call.to_token_stream()],
        _ => Vec::new(),
    });
    quote!(&[#(#lines),*])
}
