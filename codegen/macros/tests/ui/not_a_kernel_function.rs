//! Calls reach kernels and the prelude only.
#![allow(unused)]
use lobe_codegen::prelude::*;

fn helper(x: f32) -> f32 {
    x
}

mod other {
    pub fn deep(x: f32) -> f32 {
        x
    }
}

#[kernel]
fn calls(x: f32) -> f32 {
    helper(x) + other::deep(x) + missing(x)
}

fn main() {}
