//! Bytes to modules.

use super::{ForeignError, Language, Source, barrier, component, guarded, spirv};
use crate::ValidModule;
use crate::directives;
use crate::validate::{self, ValidateError};
use naga::ShaderStage;
use naga::front::{glsl, spv, wgsl};

/// Lines of a message that are shown: a front end may complain of each character.
const LINES: usize = 60;

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
            let accepted = directives::blanked(text);
            let parsed = guarded(source, "WGSL front end", || wgsl::parse_str(&accepted))?;
            parsed.map_err(|e| refused(source, &e.emit_to_string_with_path(text, &source.name)))
        }
        Language::Glsl => {
            let text = &directives::versioned(decoded(source)?);
            let options = glsl::Options::from(ShaderStage::Compute);
            let parsed =
                guarded(source, "GLSL front end", || glsl::Frontend::default().parse(&options, text))?;
            let mut module =
                parsed.map_err(|e| refused(source, &e.emit_to_string_with_path(text, &source.name)))?;
            barrier::settle(&mut module);
            match super::glsl::misread(&module, text) {
                Some(what) => Err(ForeignError::Unsupported { name: source.name.clone(), what }),
                None => Ok(module),
            }
        }
        Language::Spirv => {
            if let Some(what) = spirv::misread(&source.bytes) {
                return Err(ForeignError::Unsupported { name: source.name.clone(), what });
            }
            let options = spv::Options { adjust_coordinate_space: false, ..spv::Options::default() };
            let parsed =
                guarded(source, "SPIR-V front end", || spv::parse_u8_slice(&source.bytes, &options))?;
            let mut module = parsed.map_err(|e| refused(source, &e.to_string()))?;
            component::settle(&mut module);
            Ok(module)
        }
    }
}

fn refused(source: &Source, message: &str) -> ForeignError {
    ForeignError::Parse { message: told(source, message) }
}

/// A message of naga, which may be long, and may lack the file's name.
fn told(source: &Source, message: &str) -> String {
    let lines: Vec<&str> = message.lines().filter(|l| !l.trim().is_empty()).collect();
    let name = if message.contains(&source.name) { String::new() } else { format!("{}: ", source.name) };
    let shown = &lines[..lines.len().min(LINES)];
    let more = lines.len() - shown.len();
    let more = if more > 0 { format!("\n.. and {more} lines more") } else { String::new() };
    format!("{name}{}{more}", shown.join("\n"))
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
                Some(text) => error.emit_to_string_with_path(text, &source.name),
                None => ValidateError::Invalid(error).to_string(),
            };
            ForeignError::Invalid { message: told(source, &message) }
        }
        ValidateError::Panicked { stage, message } => {
            ForeignError::Panicked { name: source.name.clone(), stage, message }
        }
        ValidateError::Parse(message) => ForeignError::Parse { message },
        ValidateError::Scope(error) => ForeignError::Invalid { message: format!("{}: {error}", source.name) },
    })
}
