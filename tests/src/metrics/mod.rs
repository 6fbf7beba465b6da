//! Metrics of pictures: how far one is from another that is taken for the truth.
//!
//! [`open`] reads a picture out of an EXR or PNG file, a [`Pair`] is two that may be compared, [`compare`] is all that is
//! known of them: [`Radiometry`], which every renderer's tables have, and [FLIP](flip), what somebody sees who looks at one
//! after the other.

mod comparison;
mod file;
pub mod flip;
mod map;
mod pair;
mod radiometry;

pub use comparison::{Comparison, HighRange, Viewing, compare};
pub use file::{Opened, Range, ReadError, open};
pub use map::{Map, Pooled};
pub use pair::{Image, Pair, PairError};
pub use radiometry::{Radiometry, Worst, radiometry};
