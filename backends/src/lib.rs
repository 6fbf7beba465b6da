//! Executors and translators: everything that runs a kernel, or turns its source into another language first.
//!
//! - [`interp`] runs naga IR on the CPU: strictly, bit for bit like the native functions, or with a bound on what
//!   any driver that keeps the shading languages' accuracy rules may return.
//! - [`gpu`] runs WGSL text and SPIR-V words on any Vulkan driver, lavapipe and SwiftShader included.
//! - [`translate`] holds foreign compilers (DXC, slang, glslang) and validators (`spirv-val`).
//!
//! ```
//! use lobe_backends::executor::{Executor, Interp, Native, Program};
//! use lobe_codegen::data::Columns;
//! use lobe_codegen::prelude::*;
//!
//! /// Falls off with the square of the distance.
//! #[kernel]
//! pub fn falloff(dist: f32) -> f32 {
//!     1.0 / max(dist * dist, 1e-4)
//! }
//!
//! let program = Program::new(lobe_codegen::kernels![falloff][0])?;
//! let distances = Columns { columns: vec![[0.0_f32, 0.3, 7.0].map(f32::to_bits).to_vec()], rows: 3 };
//! // The Rust function and the naga module give the same bits.
//! assert_eq!(Native.run(&program, &distances)?, Interp.run(&program, &distances)?);
//! # Ok::<(), lobe_backends::executor::ExecError>(())
//! ```
//!
//! [`executor::Executor`] is the one face of all of them; [`routes::Machine`] opens the one that a
//! [`Route`](route::Route) names; [`pipeline`] runs lists of entry points over buffers.
//!
//! The latter two take *artifacts*, the very text or words that a user of the emitted code gets, and know nothing of
//! naga modules: what they prove, they prove about the emission too.

pub mod executor;
pub mod gpu;
pub mod interp;
pub mod pipeline;
pub mod route;
pub mod routes;
pub mod texture;
pub mod translate;
