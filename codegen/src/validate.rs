//! The only maker of [`ValidModule`]s.
//!
//! naga's validator is asked first; two things that it does not see are then checked here: whether
//! each operand is computed on every way to its use ([`crate::scope`]), and whether each path of a
//! function returns its value.

use crate::directives;
use crate::module::{Meta, ValidModule};
use crate::scope;
use naga::valid::{Capabilities, ModuleInfo, ValidationError, ValidationFlags, Validator};

/// Why a module is refused.
#[derive(Debug, thiserror::Error)]
pub enum ValidateError {
    /// The text does not parse; the message shows the line and caret.
    #[error("{0}")]
    Parse(String),
    /// naga's validator said no.
    #[error("naga refuses the module: {}", chain(.0.as_inner()))]
    Invalid(Box<naga::WithSpan<ValidationError>>),
    /// naga accepts the module, but it has no meaning.
    #[error("{0}")]
    Scope(#[from] scope::ScopeError),
    /// naga panicked.
    #[error(
        "naga's {stage} panicked ({message}); this is a fault of naga, please report the module to its authors"
    )]
    Panicked {
        /// Front end or validator.
        stage: &'static str,
        /// The panic's words.
        message: String,
    },
}

/// An error and its causes in one line.
fn chain(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    let mut source = error.source();
    while let Some(cause) = source {
        text = format!("{text}: {cause}");
        source = cause.source();
    }
    text
}

impl ValidateError {
    /// The function or entry point that is at fault, if one is.
    pub(crate) fn function(&self) -> Option<&str> {
        match self {
            Self::Invalid(error) => match error.as_inner() {
                ValidationError::Function { name, .. } | ValidationError::EntryPoint { name, .. } => {
                    Some(name)
                }
                _ => None,
            },
            Self::Scope(error) => Some(error.function()),
            Self::Parse(_) | Self::Panicked { .. } => None,
        }
    }

    /// Where in the source the error lies, outermost first, with a label each.
    pub(crate) fn spans(&self) -> Vec<(naga::Span, String)> {
        match self {
            Self::Invalid(error) => error.spans().cloned().collect(),
            Self::Scope(error) => vec![(error.span(), error.to_string())],
            Self::Parse(_) | Self::Panicked { .. } => Vec::new(),
        }
    }
}

/// Validates `module`, which needs nothing beyond what every device has; `meta` travels along.
///
/// # Errors
/// When the module is refused, or naga panics on it.
pub fn validate(module: naga::Module, meta: Meta) -> Result<ValidModule, ValidateError> {
    with(module, meta, Capabilities::empty())
}

/// Validates a module of somebody else's, which may use whatever naga knows: wide and narrow numbers, subgroups, ...
///
/// # Errors
/// When the module is refused, or naga panics on it.
pub fn foreign(module: naga::Module) -> Result<ValidModule, ValidateError> {
    with(module, Meta::default(), Capabilities::all())
}

/// Why a device of these capabilities does not take a module; `None` if it does.
#[must_use]
pub fn lacking(module: &ValidModule, capabilities: Capabilities) -> Option<ValidateError> {
    checked(module.module(), capabilities).err()
}

/// What naga's validator learns of `module`.
fn checked(module: &naga::Module, capabilities: Capabilities) -> Result<ModuleInfo, ValidateError> {
    guarded("validator", || {
        Validator::new(ValidationFlags::all(), capabilities).validate(module).map_err(Box::new)
    })?
    .map_err(ValidateError::Invalid)
}

fn with(module: naga::Module, meta: Meta, capabilities: Capabilities) -> Result<ValidModule, ValidateError> {
    let info = checked(&module, capabilities)?;
    scope::check(&module)?;
    Ok(ValidModule::new(module, info, meta))
}

/// Parses and [validates](validate) WGSL text; its doc comments (`///`) travel along.
///
/// ```
/// use lobe_codegen::validate::from_wgsl;
///
/// let module = from_wgsl("fn twice(x: f32) -> f32 { return 2.0 * x; }")?;
/// assert!(module.function("twice").is_some());
/// let error = from_wgsl("fn twice(x: f32) -> f32 { return 2.0 * y; }").expect_err("there is no y");
/// assert!(error.to_string().contains("return 2.0 * y;"));
/// # Ok::<(), lobe_codegen::validate::ValidateError>(())
/// ```
///
/// # Errors
/// When naga's front end or validator refuses the text; the message shows the line and caret.
pub fn from_wgsl(text: &str) -> Result<ValidModule, ValidateError> {
    validate(parsed(text)?, Meta::default())
}

/// Parses WGSL text of somebody else's and validates it as [`foreign`].
///
/// # Errors
/// When naga's front end or validator refuses the text; the message shows the line and caret.
pub fn foreign_wgsl(text: &str) -> Result<ValidModule, ValidateError> {
    foreign(parsed(&directives::blanked(text))?)
}

fn parsed(text: &str) -> Result<naga::Module, ValidateError> {
    let options =
        naga::front::wgsl::Options { parse_doc_comments: true, ..naga::front::wgsl::Options::new() };
    guarded("WGSL front end", || naga::front::wgsl::Frontend::new_with_options(options).parse(text))?
        .map_err(|e| ValidateError::Parse(e.emit_to_string(text)))
}

/// A panic of naga as an error.
fn guarded<T>(stage: &'static str, work: impl FnOnce() -> T) -> Result<T, ValidateError> {
    crate::guard::quietly(work).map_err(|message| ValidateError::Panicked { stage, message })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_of_naga_is_an_error_that_says_whose_fault_it_is() {
        let error = guarded("validator", || -> u32 { panic!("index {} out of bounds", 7) }).unwrap_err();
        let text = error.to_string();
        assert!(text.starts_with("naga's validator panicked (index 7 out of bounds)"), "{text}");
        assert!(text.contains("fault of naga"), "{text}");
    }
}
