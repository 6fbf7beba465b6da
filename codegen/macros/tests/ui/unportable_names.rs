//! Names that writers would change.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn _private(x: f32) -> f32 {
    x
}

#[kernel]
fn double__score(x: f32) -> f32 {
    x
}

#[kernel]
fn trailing_(x: f32) -> f32 {
    x
}

#[kernel]
fn größe(x: f32) -> f32 {
    x
}

#[kernel]
const λ: f32 = 1.0;

#[kernel]
struct GlThing {
    gl_position: f32,
    naga_field: f32,
    β: f32,
}

fn main() {}
