//! Foreign compilers and validators, each found where `tests/setup.sh` puts it or where the system has it.
//!
//! - [`dxc`]: Microsoft's HLSL compiler, loaded into this process.
//! - [`slang`]: Khronos' compiler of HLSL and a language of its own, loaded into this process.
//! - [`glslang`]: Khronos' GLSL compiler, run as a child process.
//! - [`dawn`]: Google's WebGPU, whose WGSL compiler is Tint, in a process that stays.
//! - [`spirv_val`]: Khronos' SPIR-V validator, run as a child process.
//! - [`web`]: a browser, and the engines three.js and Godot, which run in it.
//!
//! ```
//! use lobe_backends::translate::{Slang, spirv_words};
//!
//! if let Ok(slang) = Slang::find() {
//!     let object = slang.compile("[numthreads(1, 1, 1)] void nothing() {}", "nothing")?;
//!     assert_eq!(spirv_words(&object)?[0], 0x0723_0203);
//! }
//! # Ok::<(), lobe_backends::translate::TranslateError>(())
//! ```
//!
//! A tool that is not there gives [`TranslateError::NotFound`], which says how to get it.

mod com;
pub mod dawn;
pub mod dxc;
mod dxc_com;
pub(crate) mod elf;
mod error;
pub mod glslang;
mod process;
pub mod slang;
mod slang_api;
mod slang_reflection;
pub mod spirv_val;
mod tools;
mod translators;
pub mod web;

pub use dawn::Dawn;
pub use dawn::tint::Tint;
pub use dxc::{Dxc, DxcOutput};
pub use error::TranslateError;
pub use glslang::Glslang;
pub use slang::{Slang, SlangRules};
pub use slang_reflection::{
    SlangEntry, SlangFunction, SlangMember, SlangReflection, SlangResource, SlangStructure,
};
pub use tools::tools_dir;
pub use translators::Translators;

/// The result of a compilation that went well.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Compiled {
    /// The SPIR-V or DXIL.
    pub object: Vec<u8>,
    /// The compiler's warnings; empty if there are none.
    pub warnings: String,
}

/// SPIR-V words out of the bytes that a compiler wrote.
///
/// # Errors
///
/// [`TranslateError::BadOutput`] if the bytes are no whole number of words.
pub fn spirv_words(bytes: &[u8]) -> Result<Vec<u32>, TranslateError> {
    let (words, rest) = bytes.as_chunks::<4>();
    if !rest.is_empty() {
        let reason = format!("{} bytes are no whole number of SPIR-V words", bytes.len());
        return Err(TranslateError::BadOutput { tool: "the compiler", reason });
    }
    Ok(words.iter().map(|&word| u32::from_le_bytes(word)).collect())
}
