//! Properties that the mathematics must have, on random arguments; a file a family.
//!
//! Each test draws its cases from a seed that it prints; `LOBE_SEED=n` repeats a run.

mod asg;
mod sg;
mod support;
