//! Khronos' slang: HLSL to SPIR-V for Vulkan drivers.
//!
//! The library is loaded into this process.
//! It unpacks its core library first, which takes some 200 milliseconds, so that waits for the first shader; a kernel
//! then takes some 40.

use std::ffi::{CStr, CString};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::slang_api::{Api, OpenSession, Outcome};
use super::{Compiled, SlangReflection, TranslateError, tools};

const TOOL: &str = "slang";
/// How to get it.
pub(super) const MEND: &str = "run tests/setup.sh, or set LOBE_SLANG to the path of a libslang-compiler.so";
/// The compiler's library, and what releases before 2026 called it.
const FILE_NAMES: [&str; 2] = ["libslang-compiler.so", "libslang.so"];

/// Groups and bindings as registers and spaces say, the names of entry points as they stand, and the text's operations
/// as they stand, as for DXC.
#[rustfmt::skip]
const ARGUMENTS: [&CStr; 20] = [
    c"-target", c"spirv", c"-emit-spirv-directly",
    // SPIR-V 1.3 is Vulkan 1.1's; later shader models ask for a later one.
    c"-profile", c"sm_6_0+spirv_1_3",
    c"-O0", c"-fvk-use-entrypoint-name", c"-matrix-layout-column-major",
    c"-fvk-b-shift", c"0", c"all",
    c"-fvk-t-shift", c"0", c"all",
    c"-fvk-u-shift", c"0", c"all",
    c"-fvk-s-shift", c"0", c"all",
];

/// For what slang says by Direct3D's rules, of which no code is taken.
const ARGUMENTS_OF_DIRECT3D: [&CStr; 6] =
    [c"-target", c"hlsl", c"-profile", c"sm_6_0", c"-O0", c"-matrix-layout-column-major"];

/// Whose rules a layout follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SlangRules {
    /// Those of Vulkan's storage buffers.
    Vulkan,
    /// Those of Direct3D's structured buffers.
    Direct3D,
}

/// The loaded compiler. It can be shared between threads, which take turns.
pub struct Slang {
    path: PathBuf,
    version: String,
    api: Api,
    /// Opened by the first compilation.
    session: Mutex<Option<OpenSession>>,
}

impl Slang {
    /// Loads `libslang-compiler.so` from the file that `LOBE_SLANG` names, else from `lib/` in the
    /// [tools folder](super::tools_dir), else from where the system keeps libraries.
    ///
    /// # Errors
    ///
    /// [`TranslateError::NotFound`] if there is none, and what [`Slang::load`] says of the first that there is.
    pub fn find() -> Result<Self, TranslateError> {
        Self::load(&tools::library(TOOL, "LOBE_SLANG", &FILE_NAMES, MEND)?)
    }

    /// Loads the library at `path`.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Unusable`] if the file is missing, damaged, or not slang.
    pub fn load(path: &Path) -> Result<Self, TranslateError> {
        let unusable = |reason| TranslateError::Unusable { tool: TOOL, path: path.to_owned(), reason };
        let api = Api::load(path).map_err(unusable)?;
        Ok(Self { path: path.to_owned(), version: api.version(), api, session: Mutex::new(None) })
    }

    /// Where the library was loaded from.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The release, as `2026.14.1`.
    #[must_use]
    pub fn version(&self) -> &str {
        &self.version
    }

    /// Compiles the compute shader `entry` of `hlsl` to SPIR-V for Vulkan 1.1, without optimisation;
    /// [`spirv_words`](super::spirv_words) makes words of it.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Rejected`] with slang's message if the HLSL is wrong.
    pub fn compile(&self, hlsl: &str, entry: &str) -> Result<Vec<u8>, TranslateError> {
        self.compile_with_warnings(hlsl, entry).map(|compiled| compiled.object)
    }

    /// [`Slang::compile`], with the warnings.
    ///
    /// # Errors
    ///
    /// As for [`Slang::compile`].
    pub fn compile_with_warnings(&self, hlsl: &str, entry: &str) -> Result<Compiled, TranslateError> {
        let entry = c_name(entry)?;
        judge(self.in_session(|session| session.compile(&ARGUMENTS, hlsl, &entry))?)
    }

    /// Compiles likewise, and says what slang sees in the shader: its entry point, its resources, and of its structures,
    /// laid out by `rules`, and functions those that `names` names; what is not there is left out.
    ///
    /// # Errors
    ///
    /// As for [`Slang::compile`], and [`TranslateError::BadOutput`] if this release of slang does not tell.
    pub fn reflect(
        &self,
        hlsl: &str,
        entry: &str,
        names: &[&str],
        rules: SlangRules,
    ) -> Result<SlangReflection, TranslateError> {
        let entry = c_name(entry)?;
        let names = names.iter().map(|name| c_name(name)).collect::<Result<Vec<_>, _>>()?;
        let names: Vec<&CStr> = names.iter().map(CString::as_c_str).collect();
        let arguments = match rules {
            SlangRules::Vulkan => &ARGUMENTS[..],
            SlangRules::Direct3D => &ARGUMENTS_OF_DIRECT3D,
        };
        let outcome = self.in_session(|session| session.reflect(arguments, hlsl, &entry, &names))?;
        found(outcome).map(|(reflection, _)| reflection)
    }

    fn in_session<T>(&self, work: impl FnOnce(&mut OpenSession) -> T) -> Result<T, TranslateError> {
        // A panic while it was locked says nothing of the session, which is slang's own.
        let mut session = self.session.lock().unwrap_or_else(PoisonError::into_inner);
        let session = match session.as_mut() {
            Some(session) => session,
            None => session.insert(OpenSession::new(self.api).ok_or_else(|| self.opens_not())?),
        };
        Ok(work(session))
    }

    fn opens_not(&self) -> TranslateError {
        let reason = "it opens no session; install it again".to_owned();
        TranslateError::Unusable { tool: TOOL, path: self.path.clone(), reason }
    }
}

impl std::fmt::Debug for Slang {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Slang")
            .field("path", &self.path)
            .field("version", &self.version)
            .finish_non_exhaustive()
    }
}

fn c_name(name: &str) -> Result<CString, TranslateError> {
    let reason = || format!("{name:?} is no name of HLSL");
    match CString::new(name) {
        Ok(name) if !name.is_empty() => Ok(name),
        _ => Err(TranslateError::BadInput { tool: TOOL, reason: reason() }),
    }
}

fn judge(outcome: Outcome<Vec<u8>>) -> Result<Compiled, TranslateError> {
    let (object, warnings) = found(outcome)?;
    if object.is_empty() {
        let reason = format!("it wrote nothing; {warnings}");
        return Err(TranslateError::BadOutput { tool: TOOL, reason });
    }
    Ok(Compiled { object, warnings })
}

/// What came of a compilation, and the warnings.
fn found<T>(Outcome { found, messages }: Outcome<T>) -> Result<(T, String), TranslateError> {
    let messages = messages.trim().to_owned();
    match found {
        Some(found) => Ok((found, messages)),
        None if !messages.is_empty() => Err(TranslateError::Rejected { tool: TOOL, message: messages }),
        None => Err(TranslateError::BadOutput { tool: TOOL, reason: "it wrote nothing".to_owned() }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_cannot_be_handed_over_are_refused() {
        for name in ["", "ma\0in"] {
            let error = c_name(name).expect_err("should be refused");
            assert!(error.to_string().contains("is no name"), "{error}");
        }
    }

    #[test]
    fn nothing_is_no_success() {
        let outcome = |code, messages: &str| judge(Outcome { found: code, messages: messages.to_owned() });
        assert!(matches!(outcome(None, "error"), Err(TranslateError::Rejected { .. })));
        assert!(matches!(outcome(None, ""), Err(TranslateError::BadOutput { .. })));
        assert!(matches!(outcome(Some(Vec::new()), ""), Err(TranslateError::BadOutput { .. })));
        assert_eq!(outcome(Some(vec![1]), "").map(|compiled| compiled.warnings), Ok(String::new()));
    }
}
