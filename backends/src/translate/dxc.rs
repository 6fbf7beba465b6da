//! Microsoft's DirectX shader compiler: HLSL to SPIR-V for Vulkan drivers, or to DXIL.
//!
//! The library is loaded into this process, where a compilation takes some ten milliseconds.
//! Nothing here runs DXIL; that it compiles and validates is what is learned from it.
#![allow(unsafe_code, reason = "DXC is a C++ library that is loaded at run time")]

use std::path::{Path, PathBuf};

use super::com::{Com, Status};
use super::dxc_com::{self, CreateInstance, IID_COMPILER3, IID_VERSION_INFO, Output};
use super::{Compiled, TranslateError, elf, tools};

const TOOL: &str = "DXC";
/// How to get it.
pub(super) const MEND: &str = "run tests/setup.sh, or set LOBE_DXC to the path of a libdxcompiler.so";
const FILE_NAME: &str = "libdxcompiler.so";

/// What DXC is to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DxcOutput {
    /// SPIR-V for Vulkan 1.1; [`spirv_words`](super::spirv_words) makes words of it.
    Spirv,
    /// The same, optimised (`-O3`): as an engine ships it.
    SpirvOptimized,
    /// SPIR-V of HLSL 2018 with 16-bit types, which naga's writer has in mind: there `?:` takes vectors.
    Spirv2018,
    /// A DXIL container, optimised (`-O3`), validated and unsigned.
    Dxil,
}

/// The loaded compiler. It can be shared between threads.
pub struct Dxc {
    path: PathBuf,
    create: CreateInstance,
    version: (u32, u32),
}

impl Dxc {
    /// Loads `libdxcompiler.so` from the file that `LOBE_DXC` names, else from `lib/` in the
    /// [tools folder](super::tools_dir), else from where the system keeps libraries.
    ///
    /// # Errors
    ///
    /// [`TranslateError::NotFound`] if there is none, and what [`Dxc::load`] says of the first that there is.
    pub fn find() -> Result<Self, TranslateError> {
        Self::load(&tools::library(TOOL, "LOBE_DXC", &[FILE_NAME], MEND)?)
    }

    /// Loads the library at `path`.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Unusable`] if the file is missing, damaged, or not DXC.
    pub fn load(path: &Path) -> Result<Self, TranslateError> {
        let unusable =
            |reason: String| TranslateError::Unusable { tool: TOOL, path: path.to_owned(), reason };
        let create = load_library(path).map_err(unusable)?;
        let version = dxc_com::create(create, &IID_VERSION_INFO)
            .and_then(|info| dxc_com::version(&info))
            .map_err(|status| unusable(format!("it does not tell its version ({})", hex(status))))?;
        Ok(Self { path: path.to_owned(), create, version })
    }

    /// Where the library was loaded from.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Major and minor version.
    #[must_use]
    pub fn version(&self) -> (u32, u32) {
        self.version
    }

    /// Compiles `hlsl` for `profile`: `cs_6_0` and a name in `entry` for a compute shader, `lib_6_3` and no entry for a
    /// library, whose functions are all exported.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Rejected`] with DXC's message if the HLSL is wrong.
    pub fn compile(
        &self,
        hlsl: &str,
        profile: &str,
        entry: Option<&str>,
        output: DxcOutput,
    ) -> Result<Vec<u8>, TranslateError> {
        self.compile_with_warnings(hlsl, profile, entry, output).map(|compiled| compiled.object)
    }

    /// [`Dxc::compile`], with the warnings.
    ///
    /// # Errors
    ///
    /// As for [`Dxc::compile`].
    pub fn compile_with_warnings(
        &self,
        hlsl: &str,
        profile: &str,
        entry: Option<&str>,
        output: DxcOutput,
    ) -> Result<Compiled, TranslateError> {
        let arguments = arguments(profile, entry, output)?;
        // A compiler object serves one thread at a time; making one costs microseconds.
        let compiler = dxc_com::create(self.create, &IID_COMPILER3).map_err(went_wrong)?;
        let result = dxc_com::compile(&compiler, hlsl, &arguments).map_err(went_wrong)?;
        let verdict = dxc_com::status(&result).map_err(went_wrong)?;
        judge(&result, verdict)
    }

    /// The text of a DXIL container: LLVM's, with comments.
    ///
    /// # Errors
    ///
    /// [`TranslateError::Rejected`] if `dxil` is none.
    pub fn disassemble(&self, dxil: &[u8]) -> Result<String, TranslateError> {
        let compiler = dxc_com::create(self.create, &IID_COMPILER3).map_err(went_wrong)?;
        let result = dxc_com::disassemble(&compiler, dxil).map_err(went_wrong)?;
        let text = dxc_com::output(&result, Output::Disassembly);
        match dxc_com::status(&result).map_err(went_wrong)? {
            0.. if !text.is_empty() => Ok(String::from_utf8_lossy(&text).trim_end_matches('\0').to_owned()),
            status => Err(TranslateError::Rejected {
                tool: TOOL,
                message: format!("these {} bytes are no DXIL ({})", dxil.len(), hex(status)),
            }),
        }
    }
}

fn went_wrong(status: Status) -> TranslateError {
    TranslateError::BadOutput { tool: TOOL, reason: format!("a call failed ({})", hex(status)) }
}

impl std::fmt::Debug for Dxc {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Dxc")
            .field("path", &self.path)
            .field("version", &self.version)
            .finish_non_exhaustive()
    }
}

fn load_library(path: &Path) -> Result<CreateInstance, String> {
    elf::check_complete(path)?;
    // SAFETY: loading runs the library's initialisers; the user or setup chose this file as DXC.
    let library = unsafe { libloading::Library::new(path) }.map_err(|error| elf::explain(&error))?;
    // SAFETY: the name and type are those of DXC's one entry point.
    let create = unsafe { library.get::<CreateInstance>(b"DxcCreateInstance\0") }
        .map(|symbol| *symbol)
        .map_err(|error| format!("it is not DXC: {}", elf::explain(&error)))?;
    // The function pointer outlives this function, and DXC registers thread-local state that must not be unmapped.
    std::mem::forget(library);
    Ok(create)
}

fn arguments(profile: &str, entry: Option<&str>, output: DxcOutput) -> Result<Vec<String>, TranslateError> {
    let mut arguments = vec!["-T", profile, "-Wno-parentheses-equality"];
    match entry {
        Some(entry) => arguments.extend(["-E", entry]),
        // Without it DXC drops every function of a library, and calls that a success.
        None => arguments.extend(["-default-linkage", "external"]),
    }
    if output == DxcOutput::Spirv2018 {
        arguments.extend(["-HV", "2018", "-enable-16bit-types"]);
    }
    // The text's operations as they stand, where it is to be run: DXC's optimiser makes `a / b` of `a * (1 / b)`, and what is
    // asked of a driver would be asked of the optimiser.
    arguments.extend(match output {
        // Even without its optimiser, what it does to make shaders legal folds constants so: for 1 word of 200 of the passes
        // of rectangles other bits than by every other road. Kernels are legal as they stand.
        DxcOutput::Spirv => &["-O0", "-fcgl"][..],
        DxcOutput::Spirv2018 => &["-O0"],
        DxcOutput::SpirvOptimized | DxcOutput::Dxil => &["-O3"],
    });
    if output != DxcOutput::Dxil {
        // KHR's, and the one that binding arrays need: this DXC would else declare an NVIDIA extension for every subgroup
        // operation.
        arguments.extend(["-spirv", "-fspv-target-env=vulkan1.1", "-fspv-extension=KHR"]);
        arguments.push("-fspv-extension=SPV_EXT_descriptor_indexing");
    }
    if let Some(bad) = arguments.iter().find(|argument| argument.is_empty() || argument.contains('\0')) {
        return Err(TranslateError::BadInput {
            tool: TOOL,
            reason: format!("{bad:?} is no profile or entry point"),
        });
    }
    Ok(arguments.into_iter().map(str::to_owned).collect())
}

fn judge(result: &Com, verdict: Status) -> Result<Compiled, TranslateError> {
    let messages = dxc_com::output(result, Output::Errors);
    let messages = String::from_utf8_lossy(&messages).trim_end_matches('\0').to_owned();
    if verdict < 0 {
        let message =
            if messages.trim().is_empty() { format!("(no message; {})", hex(verdict)) } else { messages };
        return Err(TranslateError::Rejected { tool: TOOL, message });
    }
    let object = dxc_com::output(result, Output::Object);
    if object.is_empty() {
        let reason = format!("it reports success but wrote nothing; {}", messages.trim());
        return Err(TranslateError::BadOutput { tool: TOOL, reason });
    }
    Ok(Compiled { object, warnings: warnings(&messages) })
}

/// DXC's messages less the one about signing, which is true of every DXIL container made outside Windows.
fn warnings(messages: &str) -> String {
    let lines = messages.lines().filter(|line| !line.contains("DXIL signing library"));
    lines.collect::<Vec<_>>().join("\n").trim().to_owned()
}

fn hex(status: Status) -> String {
    format!("HRESULT {status:#010x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_library_exports_all_and_a_shader_its_entry() {
        let shader = arguments("cs_6_0", Some("main"), DxcOutput::Spirv).expect("sound");
        assert!(shader.windows(2).any(|pair| pair == ["-E", "main"]));
        assert!(shader.contains(&"-spirv".to_owned()));
        let library = arguments("lib_6_3", None, DxcOutput::Dxil).expect("sound");
        assert!(library.windows(2).any(|pair| pair == ["-default-linkage", "external"]));
        assert!(!library.contains(&"-spirv".to_owned()));
    }

    #[test]
    fn arguments_that_cannot_be_handed_over_are_refused() {
        let error = arguments("cs_6_0", Some("ma\0in"), DxcOutput::Spirv).expect_err("should be refused");
        assert!(error.to_string().contains("no profile or entry point"), "{error}");
    }

    #[test]
    fn the_signing_note_is_no_warning() {
        assert_eq!(warnings("warning: DXIL signing library (dxil.dll,libdxil.so) not found.\n"), "");
        assert_eq!(warnings("a.hlsl:1: warning: x\n"), "a.hlsl:1: warning: x");
    }
}
