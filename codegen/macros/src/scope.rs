//! Names of local variables, as Rust scopes them.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// The locals of one function: each declaration has a number of its own, so that shadowing and
/// scopes are settled here and nothing after the macro thinks about them.
#[derive(Default)]
pub(crate) struct Scope {
    declared: Vec<TokenStream>,
    visible: Vec<(String, u32)>,
    bindings: Vec<u32>,
}

impl Scope {
    /// Declares a local; it is visible from now on.
    pub(crate) fn declare(&mut self, name: &Ident, mutable: bool) -> u32 {
        let number = self.declared.len() as u32;
        let text = plain(name);
        let span = crate::source::span(name);
        self.declared
            .push(quote!(::lobe_codegen::def::LocalDef { name: #text, mutable: #mutable, span: #span }));
        self.visible.push((text, number));
        number
    }

    /// Declares `_`, which nothing can name.
    pub(crate) fn declare_unnamed(&mut self, at: &Ident) -> u32 {
        let number = self.declare(at, false);
        self.visible.pop();
        number
    }

    /// Declares a parameter that stands for memory (`&T` or `&mut T`), so that `*name` is that memory.
    pub(crate) fn declare_binding(&mut self, name: &Ident) -> u32 {
        let number = self.declare(name, false);
        self.bindings.push(number);
        number
    }

    /// The local that `name` means here.
    pub(crate) fn find(&self, name: &Ident) -> Option<u32> {
        let text = plain(name);
        self.visible.iter().rev().find(|(n, _)| *n == text).map(|(_, number)| *number)
    }

    /// Whether the local stands for memory.
    pub(crate) fn is_binding(&self, local: u32) -> bool {
        self.bindings.contains(&local)
    }

    /// To be given to [`Scope::leave`] at the end of a block.
    pub(crate) fn enter(&self) -> usize {
        self.visible.len()
    }

    /// Forgets the names declared since the matching [`Scope::enter`].
    pub(crate) fn leave(&mut self, mark: usize) {
        self.visible.truncate(mark);
    }

    /// All declarations as a slice of `LocalDef`.
    pub(crate) fn tokens(&self) -> TokenStream {
        let declared = &self.declared;
        quote!(&[#(#declared),*])
    }
}

/// The identifier without `r#`.
pub(crate) fn plain(name: &Ident) -> String {
    let text = name.to_string();
    text.strip_prefix("r#").map(str::to_owned).unwrap_or(text)
}
