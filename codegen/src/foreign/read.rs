//! Bytes to modules.

use super::{ForeignError, Language, Source, guarded};
use crate::ValidModule;
use crate::validate::{self, ValidateError};
use naga::ShaderStage;
use naga::front::{glsl, spv, wgsl};

/// Parses and validates `source`, with all that naga knows allowed.
///
/// # Errors
/// When naga refuses it, or panics on it.
pub fn read(source: &Source) -> Result<ValidModule, ForeignError> {
    let module = parse(source)?;
    validated(source, module)
}

fn parse(source: &Source) -> Result<naga::Module, ForeignError> {
    match source.language {
        Language::Wgsl => {
            let text = decoded(source)?;
            let parsed = guarded(source, "WGSL front end", || wgsl::parse_str(text))?;
            parsed.map_err(|e| refused(e.emit_to_string_with_path(text, &source.name)))
        }
        Language::Glsl => {
            let text = decoded(source)?;
            let options = glsl::Options::from(ShaderStage::Compute);
            let parsed =
                guarded(source, "GLSL front end", || glsl::Frontend::default().parse(&options, text))?;
            parsed.map_err(|e| refused(e.emit_to_string_with_path(text, &source.name)))
        }
        Language::Spirv => {
            let options = spv::Options { adjust_coordinate_space: false, ..spv::Options::default() };
            let parsed =
                guarded(source, "SPIR-V front end", || spv::parse_u8_slice(&source.bytes, &options))?;
            parsed.map_err(|e| refused(format!("{}: {e}", source.name)))
        }
    }
}

fn refused(message: String) -> ForeignError {
    ForeignError::Parse { message: message.trim_end().to_owned() }
}

fn decoded(source: &Source) -> Result<&str, ForeignError> {
    let fail =
        |e: std::str::Utf8Error| ForeignError::Encoding { name: source.name.clone(), at: e.valid_up_to() };
    std::str::from_utf8(&source.bytes).map_err(fail)
}

/// Validates a module that came, by whatever ways, from `source`.
pub(super) fn validated(source: &Source, module: naga::Module) -> Result<ValidModule, ForeignError> {
    validate::foreign(module).map_err(|error| match error {
        ValidateError::Invalid(error) => {
            let message = match source.text() {
                Some(text) => error.emit_to_string_with_path(text, &source.name).trim_end().to_owned(),
                None => format!("{}: {}", source.name, ValidateError::Invalid(error)),
            };
            ForeignError::Invalid { message }
        }
        ValidateError::Panicked { stage, message } => {
            ForeignError::Panicked { name: source.name.clone(), stage, message }
        }
        ValidateError::Parse(message) => ForeignError::Parse { message },
        ValidateError::Scope(error) => ForeignError::Invalid { message: format!("{}: {error}", source.name) },
    })
}
