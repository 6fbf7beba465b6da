//! Properties that the mathematics must have, on random arguments; a file or a folder a family.
//!
//! Each test draws its cases from a seed that it prints; `LOBE_SEED=n` repeats a run.

mod asg;
mod brdf;
mod filter;
mod rect;
mod reference;
mod sg;
mod support;
mod vsgl;
