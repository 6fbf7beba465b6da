//! Executors and translators: everything that runs an emitted shader, or turns it into another language first.
//!
//! - [`gpu`] runs WGSL text and SPIR-V words on any Vulkan driver, lavapipe and SwiftShader included.
//! - [`translate`] holds foreign compilers (DXC) and validators (`spirv-val`).
//!
//! Both take *artifacts*, the very text or words that a user of the emitted code gets, and know nothing of naga modules:
//! what they prove, they prove about the emission too.

pub mod gpu;
pub mod interp;
pub mod translate;
