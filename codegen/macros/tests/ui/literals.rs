//! Literals of a shader.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn texts(x: f32) -> f32 {
    let a = "text";
    let b = 'c';
    let c = b'd';
    let d = b"bytes";
    x
}

#[kernel]
fn too_large(x: f32) -> f32 {
    x + 1e39 + 99999999999999999999 as f32
}

fn main() {}
