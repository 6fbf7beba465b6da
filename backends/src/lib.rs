//! Executors and translators: everything that runs a kernel, or turns its source into another language first.
//!
//! - [`interp`] runs naga IR on the CPU: strictly, bit for bit like the native functions, or with a bound on what
//!   any driver that keeps the shading languages' accuracy rules may return.
//! - [`gpu`] runs WGSL text and SPIR-V words on any Vulkan driver, lavapipe and SwiftShader included.
//! - [`translate`] holds foreign compilers (DXC, slang, glslang) and validators (`spirv-val`).
//!
//! The latter two take *artifacts*, the very text or words that a user of the emitted code gets, and know nothing of
//! naga modules: what they prove, they prove about the emission too.

pub mod executor;
pub mod gpu;
pub mod interp;
pub mod route;
pub mod routes;
pub mod texture;
pub mod translate;
