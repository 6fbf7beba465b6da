//! The harness: inputs, questions, oracle tables, reports.
pub mod domain;
pub mod value;
