//! The kernel language, one topic a file: what a kernel computes as Rust, its lowered module
//! computes too, and every writer and `spirv-val` take that module.

#![allow(
    clippy::blocks_in_conditions,
    clippy::bool_comparison,
    clippy::eq_op,
    clippy::if_same_then_else,
    clippy::mut_range_bound,
    clippy::needless_late_init,
    clippy::needless_return,
    clippy::never_loop,
    clippy::nonminimal_bool,
    clippy::reversed_empty_ranges,
    clippy::single_match,
    clippy::unnecessary_cast,
    clippy::wildcard_in_or_patterns,
    reason = "kernels here are written in every way that Rust permits, not in the best one"
)]

mod check;
mod evaluate;
mod generate;
mod operation;

mod calls;
mod constants;
mod control;
mod entry;
mod inference;
mod literals;
mod loops;
mod matches;
mod mistakes;
mod names;
mod operators;
mod order;
#[rustfmt::skip]
#[allow(warnings, clippy::all, reason = "nobody wrote it")]
mod random;
mod structures;
mod vectors;
