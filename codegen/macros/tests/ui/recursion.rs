//! No recursion.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn factorial(n: u32) -> u32 {
    if n < 2 { 1 } else { n * factorial(n - 1) }
}

#[kernel]
fn again(n: u32) -> u32 {
    if n < 2 { 1 } else { n * self::again(n - 1) }
}

fn main() {}
