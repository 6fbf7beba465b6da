//! Mistakes of one item, gathered so that a user sees all of them at once.

use proc_macro2::TokenStream;
use quote::ToTokens;

/// A growing list of mistakes.
#[derive(Default)]
pub(crate) struct Errors(Vec<syn::Error>);

impl Errors {
    /// Notes that `what` is outside the language, and what to write instead.
    pub(crate) fn refuse(&mut self, at: &dyn ToTokens, what: &str, instead: &str) {
        self.at(at, format!("{what} is not part of the kernel language: {instead}"));
    }

    /// Notes a mistake at the tokens `at`.
    pub(crate) fn at(&mut self, at: &dyn ToTokens, message: impl std::fmt::Display) {
        let tokens = at.to_token_stream();
        self.0.push(syn::Error::new_spanned(tokens, message));
    }

    /// Notes an error of syn's parser.
    pub(crate) fn push(&mut self, error: syn::Error) {
        self.0.push(error);
    }

    /// How many were noted.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether nothing was noted.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The mistakes as `compile_error!` calls.
    pub(crate) fn into_tokens(self) -> TokenStream {
        self.0.iter().map(syn::Error::to_compile_error).collect()
    }
}
