//! Scalars that no shader promises.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn twice(x: f64) -> f64 {
    let y: f64 = x;
    y
}

#[kernel]
fn suffixes(x: f32) -> f32 {
    x + 1.0f64 as f32 + 1u8 as f32 + 2i64 as f32
}

fn main() {}
