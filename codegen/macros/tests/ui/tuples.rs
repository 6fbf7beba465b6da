//! No tuples.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn two(x: f32) -> (f32, f32) {
    (x, x)
}

#[kernel]
struct Wrapped(f32);

#[kernel]
fn first(pair: (f32, f32)) -> f32 {
    pair.0
}

fn main() {}
