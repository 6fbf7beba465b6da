//! `#[cfg]` inside would change the Rust form only.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn conditional(x: f32) -> f32 {
    #[cfg(debug_assertions)]
    let x = x + 1.0;
    x
}

#[kernel]
struct Parts {
    always: f32,
    #[cfg(debug_assertions)]
    sometimes: f32,
}

#[kernel]
fn arms(n: u32) -> f32 {
    match n {
        #[cfg_attr(debug_assertions, cfg(test))]
        0 => 1.0,
        _ => 2.0,
    }
}

fn main() {}
