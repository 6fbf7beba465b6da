//! The only maker of [`ValidModule`]s.

use crate::module::{Meta, ValidModule};
use naga::valid::{Capabilities, ValidationFlags, Validator};

/// Why a module is refused.
#[derive(Debug, thiserror::Error)]
pub enum ValidateError {
    /// naga's validator said no; the text carries its reasons and, where known, the source lines.
    #[error("naga refuses the module: {0}")]
    Invalid(String),
    /// naga's validator panicked.
    #[error("naga's validator panicked ({0}); this is a fault of naga, please report the module")]
    Panicked(String),
}

/// Validates `module`; `meta` travels along.
///
/// # Errors
/// When naga refuses the module, or panics on it.
pub fn validate(
    module: naga::Module,
    meta: Meta,
) -> Result<ValidModule, Box<naga::WithSpan<naga::valid::ValidationError>>> {
    let info =
        Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(&module).map_err(Box::new)?;
    Ok(ValidModule::new(module, info, meta))
}

/// Parses and validates WGSL text; its doc comments (`///`) travel along.
///
/// # Errors
/// When naga's front end or validator refuses the text; the message shows the line and caret.
pub fn from_wgsl(text: &str) -> Result<ValidModule, ValidateError> {
    let options =
        naga::front::wgsl::Options { parse_doc_comments: true, ..naga::front::wgsl::Options::new() };
    let module = naga::front::wgsl::Frontend::new_with_options(options)
        .parse(text)
        .map_err(|e| ValidateError::Invalid(e.emit_to_string(text)))?;
    validate(module, Meta::default()).map_err(|e| ValidateError::Invalid(e.emit_to_string(text)))
}
