//! The kernel language on the interpreter: the topics of `codegen/tests/language`, with this crate's
//! `check` in place of the evaluator there. `native` and `interp` agree bit for bit.

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

#[path = "../../../codegen/tests/language/calls.rs"]
mod calls;
#[path = "../../../codegen/tests/language/constants.rs"]
mod constants;
#[path = "../../../codegen/tests/language/control.rs"]
mod control;
#[path = "../../../codegen/tests/language/inference.rs"]
mod inference;
#[path = "../../../codegen/tests/language/literals.rs"]
mod literals;
#[path = "../../../codegen/tests/language/loops.rs"]
mod loops;
#[path = "../../../codegen/tests/language/matches.rs"]
mod matches;
#[path = "../../../codegen/tests/language/operators.rs"]
mod operators;
#[path = "../../../codegen/tests/language/order.rs"]
mod order;
#[rustfmt::skip]
#[path = "../../../codegen/tests/language/random.rs"]
#[allow(warnings, clippy::all, reason = "nobody wrote it")]
mod random;
#[path = "../../../codegen/tests/language/structures.rs"]
mod structures;
#[path = "../../../codegen/tests/language/vectors.rs"]
mod vectors;
