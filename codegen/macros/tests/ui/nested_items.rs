//! Items stand outside.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn nested(x: f32) -> f32 {
    const TWO: f32 = 2.0;
    use std::f32::consts::PI;
    fn helper(x: f32) -> f32 {
        x
    }
    struct Inner;
    helper(x) * TWO * PI
}

fn main() {}
