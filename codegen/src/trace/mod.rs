//! Modules that tell what they compute on the way.
//!
//! - [`record`]: a copy of a kernel that writes every number and boolean it computes to a buffer, in the order of
//!   execution. It is emitted like any other module, so every route can say what its operations returned.
//! - [`inject`]: a copy that adds a given error to one value on the way, which shows what that error does to the result.
//! - [`operation`]: one operation of a kernel as a function of its operands, by which it can be judged alone.
//!
//! A [`Site`] is a scalar that is computed somewhere; all three number them alike.

mod handles;
mod inject;
mod operation;
mod pen;
mod record;
mod rewrite;

pub use inject::{Injected, inject};
pub use operation::{Operand, Operation, operation};
pub use record::{Record, Traced, record};

use crate::emit::EmitError;
use crate::validate::ValidateError;
use naga::{Expression, Function, Handle};

/// How a value comes about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// An argument of the function, as it arrived.
    Argument,
    /// An expression, computed.
    Value,
    /// What a called function returned.
    Call,
}

/// A scalar that is computed somewhere in a module.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Site {
    /// The function.
    pub function: Handle<Function>,
    /// The expression, in the function of the module as it was.
    pub expression: Handle<Expression>,
    /// Which scalar of it: component of a vector, column by column of a matrix.
    pub component: u32,
    /// Scalars of the whole expression.
    pub width: u32,
    /// What kind of number it is.
    pub kind: naga::ScalarKind,
    /// How it comes about.
    pub origin: Origin,
}

/// Why no such module can be made.
#[derive(Debug, thiserror::Error)]
pub enum TraceError {
    /// Something that is not rewritten.
    #[error("`{function}` uses {what}, which cannot be traced; only functions of the kernel language can")]
    Unsupported {
        /// The function.
        function: String,
        /// What it uses.
        what: String,
    },
    /// The module with its traces is none.
    #[error("the traced module is not valid ({0}); this is a defect of Lobe")]
    Invalid(#[from] ValidateError),
    /// No entry point can be made.
    #[error(transparent)]
    Entry(#[from] EmitError),
}
