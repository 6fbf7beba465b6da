//! The harness: inputs out of stated domains, the four questions, oracle tables, reports.
//!
//! [`judge::judge`] asks one kernel all questions; [`oracle`] judges by tables of independent values;
//! [`measure`] writes the worst errors down that the documentation shows.

pub mod cases;
pub mod cost;
pub mod domain;
pub mod expectation;
pub mod explain;
pub mod export;
pub mod figures;
pub mod files;
pub mod judge;
pub mod measure;
pub mod mutation;
pub mod named;
pub mod operations;
pub mod oracle;
pub mod overhead;
pub mod perturbed;
pub mod question;
pub mod report;
pub mod search;
pub mod shader;
pub mod subject;
pub mod throughput;
pub mod value;

pub use lobe_codegen::kernels;
