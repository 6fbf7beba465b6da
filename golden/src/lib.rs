//! Golden images: true pictures with a permitted error for each value, their store and its decisions.
//!
//! A golden image here is not what some driver once drew: it is the f64 value of the picture, and beside
//! it, for each value, how far a legal driver's result may lie from it.
//! So one golden serves every route, and changes only when the mathematics does.
//!
//! This crate knows no shaders: it takes numbers.
//!
//! - [`Golden`] judges pictures, pixel by pixel.
//! - [`image`] writes and reads them as EXR, and trusts no file.
//! - [`Store`] keeps them: accepted ones, pending ones, and [decisions](Decision) on them, whole or not at all
//!   whatever happens meanwhile ([`files`]).
//! - [`page`] shows a report to people, who decide.
//!
//! ```
//! use lobe_golden::Golden;
//!
//! // Two pixels, the second in a shadow whose edge rounding may move.
//! let golden = Golden::new([2, 1], &[0.25, 0.25, 0.25, 0.5, 0.5, 0.5], &[1e-6, 1e-6, 1e-6, 0.1, 0.1, 0.1])?;
//! let verdict = golden.judge([2, 1], &[0.250_000_5, 0.25, 0.25, 0.58, 0.5, 0.5])?;
//! assert!(verdict.passes());
//! assert_eq!(verdict.worst.map(|worst| worst.x), Some(1));
//! # Ok::<(), lobe_golden::GoldenError>(())
//! ```

mod decision;
pub mod files;
mod golden;
mod hash;
pub mod image;
mod lock;
mod name;
pub mod page;
mod record;
mod store;
mod transaction;
mod verdict;

pub use decision::{Action, Decision, Step};
pub use golden::{Distance, Golden, GoldenError};
pub use hash::{Hash, of_floats};
pub use name::{CaseName, Name, NameError};
pub use record::{Acceptance, Chain, Kernel, Record, RecordError, RouteRecord};
pub use store::{Found, Reviewer, Store, StoreError, Unusable};
pub use verdict::{CHANNELS, Pixels, Verdict, Worst};
