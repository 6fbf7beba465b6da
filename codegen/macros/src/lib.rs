//! The `#[kernel]` attribute.

use proc_macro::TokenStream;

/// Marks a function, structure or constant as part of the kernel language.
#[proc_macro_attribute]
pub fn kernel(_attribute: TokenStream, item: TokenStream) -> TokenStream {
    item
}
