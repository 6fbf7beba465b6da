//! Khronos' reference compiler of GLSL: to SPIR-V for Vulkan drivers, and as a judge of OpenGL ES's.
//!
//! It is a child process for each shader, of some 100 milliseconds, most of which it spends on what is built in.

use std::path::{Path, PathBuf};
use std::process::Output;

use super::process::feed;
use super::{TranslateError, spirv_words, tools};

const TOOL: &str = "glslang";
/// How to get it.
pub(super) const MEND: &str = "run tests/setup.sh, install your system's glslang-tools package, or set LOBE_GLSLANG to \
                               the path of a glslangValidator";
/// Its name since release 14, and before.
const FILE_NAMES: [&str; 2] = ["glslang", "glslangValidator"];

/// Words to its standard output, where else the name of the file would stand before them.
const TO_SPIRV: [&str; 8] =
    ["--quiet", "--stdin", "-S", "comp", "--target-env", "vulkan1.1", "-o", "/dev/stdout"];

/// What SPIR-V begins with.
const MAGIC: u32 = 0x0723_0203;

/// The compiler's program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Glslang {
    path: PathBuf,
}

impl Glslang {
    /// The program that `LOBE_GLSLANG` names, else `glslang` or `glslangValidator` in `bin/` of the
    /// [tools folder](super::tools_dir), else on the `PATH`.
    ///
    /// # Errors
    ///
    /// [`TranslateError::NotFound`], or [`TranslateError::Unusable`] if the environment names what is not there.
    pub fn find() -> Result<Self, TranslateError> {
        let path = tools::program(TOOL, "LOBE_GLSLANG", &FILE_NAMES, MEND)?;
        if path.is_file() {
            return Ok(Self { path });
        }
        // Only a name that the environment gives was not looked at.
        let reason = "there is no such file".to_owned();
        Err(TranslateError::Unusable { tool: TOOL, path, reason })
    }

    /// The program's file.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The release, as `11:12.0.0`.
    ///
    /// # Errors
    ///
    /// When the program does not run, or tells none.
    pub fn version(&self) -> Result<String, TranslateError> {
        let output = self.run(&["--version"], "")?;
        let text = String::from_utf8_lossy(&output.stdout);
        let version = text.lines().find_map(|line| line.strip_prefix("Glslang Version: "));
        let reason = || format!("it does not tell its version: {}", text.trim());
        version
            .map(|version| version.trim().to_owned())
            .ok_or_else(|| TranslateError::BadOutput { tool: TOOL, reason: reason() })
    }

    /// Compiles the compute shader `glsl`, whose entry point is `main`, to the words of SPIR-V for Vulkan 1.1.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Rejected`] with glslang's message if the GLSL is wrong.
    pub fn compile(&self, glsl: &str) -> Result<Vec<u32>, TranslateError> {
        let output = self.run(&TO_SPIRV, glsl)?;
        words(&output.stdout)
    }

    /// Holds the compute shader `glsl` to the rules of OpenGL and OpenGL ES, whichever its first line names.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Rejected`] with glslang's message if it breaks them.
    pub fn validate(&self, glsl: &str) -> Result<(), TranslateError> {
        self.run(&["--stdin", "-S", "comp"], glsl).map(|_| ())
    }

    fn run(&self, arguments: &[&str], glsl: &str) -> Result<Output, TranslateError> {
        let output = feed(&self.path, arguments, glsl.as_bytes().to_vec()).map_err(|error| {
            TranslateError::Unusable { tool: TOOL, path: self.path.clone(), reason: error.to_string() }
        })?;
        if output.status.success() {
            return Ok(output);
        }
        let message =
            String::from_utf8_lossy(&[&output.stdout[..], &output.stderr].concat()).trim().to_owned();
        match output.status.code() {
            Some(_) if !message.is_empty() => Err(TranslateError::Rejected { tool: TOOL, message }),
            _ => {
                Err(TranslateError::BadOutput { tool: TOOL, reason: format!("{} {message}", output.status) })
            }
        }
    }
}

fn words(bytes: &[u8]) -> Result<Vec<u32>, TranslateError> {
    let words = spirv_words(bytes)?;
    if words.first() == Some(&MAGIC) {
        return Ok(words);
    }
    let seen = String::from_utf8_lossy(&bytes[..bytes.len().min(200)]).into_owned();
    Err(TranslateError::BadOutput { tool: TOOL, reason: format!("it wrote no SPIR-V but {seen:?}") })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_spirv_is_refused() {
        for bytes in [&b""[..], b"ERROR: a", b"stdin"] {
            let error = words(bytes).expect_err("should be refused");
            assert!(matches!(error, TranslateError::BadOutput { .. }), "{error}");
        }
        assert_eq!(words(&MAGIC.to_le_bytes()), Ok(vec![MAGIC]));
    }
}
