//! Conditions are booleans.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn matches_option(x: f32, n: u32) -> f32 {
    if let 3 = n {
        return x;
    }
    if x > 0.0 && let 4 = n {
        return -x;
    }
    while let 5 = n {
        return 2.0 * x;
    }
    0.0
}

fn main() {}
