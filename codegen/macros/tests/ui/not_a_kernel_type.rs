//! Structures are marked too.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[derive(Debug, Clone, Copy, PartialEq)]
struct Lobe {
    sharpness: f32,
}

#[kernel]
fn takes(lobe: Lobe) -> f32 {
    lobe.sharpness
}

#[kernel]
struct Outer {
    lobe: Lobe,
}

fn main() {}
