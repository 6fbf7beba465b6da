//! Foreign compilers and validators, each found where `tests/setup.sh` puts it or where the system has it.
//!
//! - [`dxc`]: Microsoft's HLSL compiler, loaded into this process.
//! - [`dawn`]: Google's WebGPU, whose WGSL compiler is Tint, in a process that stays.
//! - [`spirv_val`]: Khronos' SPIR-V validator, run as a child process.
//!
//! A tool that is not there gives [`TranslateError::NotFound`], which says how to get it.

pub mod dawn;
pub mod dxc;
mod dxc_com;
pub(crate) mod elf;
mod error;
pub mod spirv_val;
mod tools;

pub use dawn::Dawn;
pub use dawn::tint::Tint;
pub use dxc::{Compiled, Dxc, DxcOutput};
pub use error::TranslateError;
pub use tools::tools_dir;

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
