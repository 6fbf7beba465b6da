//! The `#[kernel]` attribute: parse, check, expand.
//!
//! An item under `#[kernel]` stays what it is in Rust; beside it the expansion puts a definition
//! (`lobe_codegen::def`): the same item as constant data.
//! For a function `f` the definition hangs on an uninhabited type `f` of the type namespace, which
//! functions leave free, so that `use` brings both and a call `path::f(x)` can name `path::f`'s
//! definition without this macro knowing what `path` is.
//!
//! The way of an item: [`item`] dispatches; [`attribute`] reads the contract; [`function`],
//! [`structure`] and [`constant`] expand; [`stmt`], [`expr`], [`branch`], [`call`]
//! and [`types`] translate what is inside.
//! All mistakes of an item are gathered in [`errors`] and shown at once.

mod attribute;
mod branch;
mod call;
mod constant;
mod errors;
mod expr;
mod function;
mod item;
mod method;
mod names;
mod parameter;
mod scope;
mod source;
mod stmt;
mod structure;
mod types;

use proc_macro::TokenStream;

/// Marks a function, structure or constant as part of the kernel language.
///
/// On functions, the contract is stated in the attribute; every part is optional:
///
/// ```text
/// #[kernel(
///     family = "sg",                                  // subject, for listings
///     cite = "[Wang09] section 3",                    // where the equation stands
///     domain(a.sharpness = 0.0..=1e6, a.axis = unit), // arguments for which the promises hold
///     budget(4e-6 * result),                          // permitted rounding error, or
///     budget(sharpness = 1e-6, axis = 1e-5),          // ... for each field of the result
///     variant_of = path::to::kernel,                  // another form of that kernel
///     not_robust = "why the budget cannot hold",      // an expected failure
///     truth = path::to::function,                     // fn(f64) -> f64 that the body approximates
///     measured,                                       // show src/measured/NAME.md, by `lobe measure --write`
///     workgroup_size(64),                             // an entry point
/// )]
/// ```
///
/// Parameters of entry points are marked `#[builtin(global_invocation_id)]`, `#[storage(0, 1)]`,
/// `#[uniform(0, 2)]` or `#[workgroup]`; fields of structures may state `#[domain(0.0..=1e6)]`.
///
/// Whatever is outside the language is refused here, all of it at once.
/// Two mistakes are rustc's to report, in its own words: "expected type, found function `f`" (or
/// "constant") says that `f` is used in a kernel and not itself under `#[kernel]`.
#[proc_macro_attribute]
pub fn kernel(attribute: TokenStream, item: TokenStream) -> TokenStream {
    item::expand(attribute.into(), item.into()).into()
}
