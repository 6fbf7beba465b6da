//! Only storage has a length of its own.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn plain(values: &[f32]) -> f32 {
    values[0]
}

#[kernel(workgroup_size(1))]
fn nested(#[storage(0, 0)] values: &mut [[f32]]) {}

fn main() {}
