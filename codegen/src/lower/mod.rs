//! From definitions to a naga module.
//!
//! [`lower`] takes kernels, brings along all that they call, and gives a [`ValidModule`] whose
//! names are the declared ones.
//! The rooms, top down: `module` (functions, types, constants, each once), `body` (one function
//! under construction), `stmt`, `branch`, `loops` and `expr` (the language), `operator`, `call` and
//! `method` (typing of operations), `fold` and `hint` (literals), `source` (the way back to Rust lines).
//!
//! naga lets a builder make mistakes that its validator does not see (a value used outside the block
//! that computes it, a path without return).
//! Here they cannot be written down: values are bound to Rust's own lexical scopes, whatever crosses
//! a branch goes through a variable, and [`crate::validate`] checks both once more.

mod body;
mod branch;
mod call;
mod contract;
mod error;
mod expr;
mod fold;
mod hint;
mod layout;
mod loops;
mod method;
mod module;
mod operator;
mod source;
mod stmt;
mod value;

pub use error::LowerError;

use crate::def::{Callable, Callee, FunctionRef};
use crate::module::ValidModule;

/// The definition behind the kernel type `K` (the type of the kernel function's name).
///
/// `None` for intrinsics.
pub fn definition<K: Callable>() -> Option<FunctionRef> {
    match K::CALLEE {
        Callee::Function(f) => Some(f),
        Callee::Intrinsic(_) => None,
    }
}

/// A list of [`FunctionRef`]s from the paths of kernels.
///
/// ```
/// use lobe_codegen::prelude::*;
///
/// /// Squares.
/// #[kernel]
/// pub fn square(x: f32) -> f32 {
///     x * x
/// }
///
/// let module = lobe_codegen::lower::lower(&lobe_codegen::kernels![square]).unwrap();
/// assert!(module.function("square").is_some());
/// ```
#[macro_export]
macro_rules! kernels {
    ($($path:path),* $(,)?) => {
        [$($crate::lower::expect_function(<$path as $crate::def::Callable>::CALLEE)),*]
    };
}

#[doc(hidden)]
pub const fn expect_function(callee: Callee) -> FunctionRef {
    match callee {
        Callee::Function(f) => f,
        Callee::Intrinsic(_) => panic!("an intrinsic is no kernel"),
    }
}

/// Lowers `kernels`, functions and entry points, with everything they use, and validates the module.
///
/// The same kernels in the same order give the same module.
///
/// ```
/// use lobe_codegen::prelude::*;
///
/// /// Squares.
/// #[kernel]
/// pub fn square(x: f32) -> f32 {
///     x * x
/// }
///
/// /// Squares twice.
/// #[kernel]
/// pub fn fourth_power(x: f32) -> f32 {
///     square(square(x))
/// }
///
/// // What a kernel calls comes along.
/// let module = lobe_codegen::lower(&lobe_codegen::kernels![fourth_power])?;
/// assert!(module.function("square").is_some());
/// # Ok::<(), lobe_codegen::lower::LowerError>(())
/// ```
///
/// # Errors
/// With the Rust line and caret, when a kernel's types do not fit, its names clash, it calls itself,
/// or naga refuses the outcome.
pub fn lower(kernels: &[FunctionRef]) -> Result<ValidModule, LowerError> {
    let mut builder = module::ModuleBuilder::default();
    for kernel in kernels {
        builder.add(kernel())?;
    }
    builder.finish()
}
