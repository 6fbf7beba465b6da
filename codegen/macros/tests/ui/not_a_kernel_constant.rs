//! Constants are marked too.
#![allow(unused)]
use lobe_codegen::prelude::*;

const LIMIT: f32 = 1.0;

#[kernel]
fn clamped(x: f32) -> f32 {
    min(x, LIMIT) + other::SCALE
}

mod other {
    pub const SCALE: f32 = 2.0;
}

fn main() {}
