//! No generics.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn generic<T: Copy>(x: T) -> T {
    x
}

#[kernel]
fn sized<const N: usize>(x: [f32; N]) -> f32 {
    x[0]
}

#[kernel]
fn opaque(x: impl Copy) -> f32 {
    1.0
}

#[kernel]
struct Holder<T> {
    value: T,
}

#[kernel]
fn turbofish(x: f32) -> f32 {
    sqrt::<f32>(x)
}

#[kernel]
fn containers(x: Vec<f32>) -> f32 {
    x[0]
}

fn main() {}
