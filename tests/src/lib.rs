//! The harness: inputs out of stated domains, the four questions, oracle tables, reports.
//!
//! ```
//! use lobe_backends::executor::{Interp, Native};
//! use lobe_codegen::accuracy::Model;
//! use lobe_codegen::prelude::*;
//! use lobe_tests::cases::Cases;
//! use lobe_tests::judge::{Plan, judge};
//! use lobe_tests::oracle::Mapping;
//!
//! /// `sqrt(1 - x²)`, in a form that cancels near 1.
//! #[kernel(domain(x = 0.0..=1.0), budget(1e-6 * result))]
//! pub fn sine_of(x: f32) -> f32 {
//!     sqrt(max(1.0 - x * x, 0.0))
//! }
//!
//! let plan = Plan {
//!     inputs: 500,
//!     seed: 7,
//!     cases: Cases::at("tests/cases"),
//!     mapping: Mapping::parse(r#"{"version": 1, "entries": []}"#)?,
//!     sanitize: false,
//!     accuracy: Model::portable(),
//!     drivers: 0,
//!     search: None,
//!     expected: Vec::new(),
//! };
//! let report =
//!     judge(lobe_tests::kernels![sine_of][0], &plan, &mut [Box::new(Native), Box::new(Interp)], &|_| {});
//! // No driver was asked: that the budget cannot hold follows from the rules that drivers keep.
//! let failed: Vec<_> = report.answers.iter().filter(|answer| answer.falls_short()).collect();
//! assert_eq!(failed.len(), 1);
//! assert_eq!(failed[0].question.name(), "robust");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! As tests of a crate of your own: [`check!`].
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
pub mod flicker;
pub mod golden;
pub mod judge;
pub mod measure;
pub mod metrics;
pub mod mutation;
pub mod named;
pub mod operations;
pub mod oracle;
pub mod overhead;
pub mod perturbed;
pub mod proxies;
pub mod question;
pub mod race;
pub mod render;
pub mod report;
pub mod scene;
pub mod search;
pub mod shader;
pub mod subject;
pub mod throughput;
pub mod value;

pub use lobe_codegen::kernels;
