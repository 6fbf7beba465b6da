//! rustc's own errors stay where they are.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn types(x: f32, n: u32) -> f32 {
    let y: f32 = n;
    x + y
}

#[kernel]
fn unknown(x: f32) -> f32 {
    y
}

fn main() {}
