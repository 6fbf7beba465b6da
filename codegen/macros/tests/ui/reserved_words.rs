//! Names that some target could not carry, at their definition.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn float4(x: f32) -> f32 {
    x
}

#[kernel]
struct Texture2D {
    sample: f32,
    fine: f32,
}

#[kernel]
const PASS: f32 = 1.0;

#[kernel]
fn parameters(half: f32, target: f32, r#in: f32, fine: f32) -> f32 {
    half + target + r#in + fine
}

fn main() {}
