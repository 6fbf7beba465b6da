//! The kernel language of Lobe and its way to shader source.
//!
//! A kernel is an ordinary Rust function under `#[kernel]`.
//! It stays callable; beside it stands a definition ([`def`]) that [`lower`](mod@lower) turns into a
//! naga module, [`validate`] accepts, and [`emit`] writes as WGSL, SPIR-V, HLSL, GLSL or MSL; [`package`] makes a
//! folder of it that an engine takes.
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
