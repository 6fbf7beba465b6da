//! What operations on numbers mean, one number at a time.
//!
//! Every executor of programs calls these functions, so that they agree to the last bit:
//! `fast` makes loops over lanes of them, others go through [`eval`].
//!
//! - [`float`] holds the float operations of each width, [`half`] what 16 bits can hold.
//! - [`integer`] holds the integer operations of each width, [`atomic`] the updates of a word.
//! - [`convert`] goes from type to type.

pub(crate) mod atomic;
pub(crate) mod convert;
pub(crate) mod eval;
pub(crate) mod float;
pub(crate) mod half;
pub(crate) mod integer;
