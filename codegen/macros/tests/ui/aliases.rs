//! Memory has one name.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel(workgroup_size(1))]
fn renames(
    #[storage(0, 0)] a: &mut [f32; 4],
    #[storage(0, 1)] b: &mut [f32; 4],
    #[storage(0, 2)] n: &u32,
) {
    let first = a;
    let chosen = if *n > 1 { b } else { first };
    chosen[0] = 1.0;
    let copy = *n;
}

fn main() {}
