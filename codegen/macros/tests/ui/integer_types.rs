//! Only 32-bit integers.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn widths(a: usize, b: u64, c: i16, d: isize) -> u32 {
    a as u32 + b as u32 + c as u32 + d as u32
}

#[kernel]
struct Sizes {
    count: usize,
    tag: char,
}

fn main() {}
