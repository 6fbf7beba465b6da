//! The kernel language of Lobe and its way to shader source.
//!
//! A kernel is an ordinary Rust function under `#[kernel]`.
//! It stays callable; beside it stands a definition ([`def`]) that [`lower`](mod@lower) turns into a
//! naga module, [`validate`] accepts, and [`emit`] writes as WGSL, SPIR-V, HLSL, GLSL or MSL; [`package`] makes a
//! folder of it that an engine takes.
//!
//! ```
//! use lobe_codegen::emit::{Options, Target, emit};
//! use lobe_codegen::prelude::*;
//!
//! /// Luminance of a colour with the primaries of Rec. 709.
//! #[kernel(budget(1e-6))]
//! pub fn luminance(colour: Vec3) -> f32 {
//!     dot(colour, Vec3::new(0.2126, 0.7152, 0.0722))
//! }
//!
//! // It is a Rust function,
//! assert_eq!(luminance(Vec3::X), 0.2126);
//!
//! // and shader source, under its name and with its comment.
//! let module = lobe_codegen::lower(&lobe_codegen::kernels![luminance])?;
//! let hlsl = emit(&module, Target::Hlsl, &Options::default())?;
//! let text = hlsl.content.text().unwrap_or_default();
//! assert!(text.contains("/// Luminance of a colour with the primaries of Rec. 709.\nfloat luminance(float3 colour)"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | to | take |
//! |---|---|
//! | write a kernel | [`prelude`], `#[kernel]` |
//! | make a module of kernels | [`lower()`], [`kernels!`] |
//! | read somebody else's | [`validate::from_wgsl`], [`foreign`] |
//! | make a compute shader of a function | [`emit::with_entry`] |
//! | write source | [`emit::emit`] |
//! | tell a host what was written | [`emit::reflect()`], [`emit::host()`] |
//! | write a folder for an engine | [`package::package`] |
//!
//! Read first: [`def`] (what the macro writes down), [`intrinsics`] (the one table of operations),
//! [`module`] (what the executors take).

// The macro's expansion names this crate by its own name, here as everywhere.
extern crate self as lobe_codegen;

pub mod accuracy;
pub mod data;
pub mod def;
mod directives;
pub mod emit;
pub mod foreign;
mod guard;
pub mod intrinsics;
pub mod layout;
pub mod lower;
pub mod math;
pub mod module;
pub mod names;
pub mod package;
pub mod prelude;
pub mod scope;
pub mod source;
pub mod trace;
pub mod types;
pub mod validate;

pub use glam;
pub use guard::quietly;
pub use lower::lower;
pub use module::ValidModule;
