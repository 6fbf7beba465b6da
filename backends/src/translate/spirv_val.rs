//! Khronos' SPIR-V validator, run as a child process on a module's words.

use std::path::{Path, PathBuf};

use super::process::feed;
use super::{TranslateError, tools};

const TOOL: &str = "spirv-val";

/// The rules a module is held to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rules {
    /// SPIR-V 1.3 alone: right for a module without entry points.
    Spirv13,
    /// Vulkan 1.1 and its SPIR-V 1.3: right for a shader.
    Vulkan11,
}

impl Rules {
    fn argument(self) -> &'static str {
        match self {
            Self::Spirv13 => "spv1.3",
            Self::Vulkan11 => "vulkan1.1",
        }
    }
}

/// The validator's file: what `LOBE_SPIRV_VAL` names, else `bin/` in the [tools folder](super::tools_dir), then the
/// `PATH`.
///
/// # Errors
///
/// [`TranslateError::NotFound`].
pub fn find() -> Result<PathBuf, TranslateError> {
    let mend = "run tests/setup.sh, or install your system's spirv-tools package";
    tools::program(TOOL, "LOBE_SPIRV_VAL", &[TOOL], mend)
}

/// Validates `words` by the rules of Vulkan 1.1.
///
/// # Errors
///
/// [`TranslateError::Rejected`] with the validator's message, or what kept it from running.
pub fn validate(words: &[u32]) -> Result<(), TranslateError> {
    validate_by(Rules::Vulkan11, words)
}

/// Validates `words` by `rules`.
///
/// # Errors
///
/// As for [`validate`].
pub fn validate_by(rules: Rules, words: &[u32]) -> Result<(), TranslateError> {
    run(&find()?, rules, words)
}

fn run(tool: &Path, rules: Rules, words: &[u32]) -> Result<(), TranslateError> {
    let arguments = ["--target-env", rules.argument(), "-"];
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let output = feed(tool, &arguments, bytes).map_err(|error| TranslateError::Unusable {
        tool: TOOL,
        path: tool.to_owned(),
        reason: error.to_string(),
    })?;
    if output.status.success() {
        return Ok(());
    }
    let message = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).trim().to_owned();
    match output.status.code() {
        Some(_) if !message.is_empty() => Err(TranslateError::Rejected { tool: TOOL, message }),
        _ => Err(TranslateError::BadOutput { tool: TOOL, reason: format!("{} {message}", output.status) }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tool_that_does_not_start_is_named() {
        let folder = tempfile::tempdir().expect("a folder");
        let error = run(&folder.path().join(TOOL), Rules::Vulkan11, &[]).expect_err("should be refused");
        assert!(matches!(error, TranslateError::Unusable { .. }), "{error}");
        assert!(error.to_string().contains("spirv-val"), "{error}");
    }
}
