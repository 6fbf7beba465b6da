//! Other people's compute shaders: run on the interpreter and on every route, and compared.
//!
//! - [`job`] is what a user asks, [`report`] what comes of it, [`run`](mod@run) the way between.
//! - [`resource`] finds what an entry point uses, [`shape`] the scalars in it, [`feed`] makes it [`given`], from files
//!   with [`json`]; [`texture`] says what textures and samplers are like, [`number`] is one scalar.
//! - [`machine`] is the interpreter: results, bounds and findings. [`routes`] are the ways to a driver, [`compare`]
//!   judges what came back.
//! - [`serve`] runs jobs in a process of their own, [`supervise`](mod@supervise) watches over such processes: a shader
//!   that crashes a driver, or never ends, costs one line of the report.

mod agree;
pub mod check;
mod command;
pub mod compare;
mod edges;
mod entry;
pub mod feed;
pub mod given;
pub mod job;
pub mod json;
pub mod machine;
pub mod number;
pub mod report;
pub mod resource;
pub mod routes;
mod run;
pub mod serve;
pub mod shape;
pub mod supervise;
pub mod texture;

pub use entry::READY;
pub use run::{is_shader, run};
