//! No labels, no values out of loops.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn labelled(n: u32) -> u32 {
    let mut total = 0u32;
    'outer: for i in 0..n {
        for j in 0..i {
            if j == 3 {
                continue 'outer;
            }
            if j == 5 {
                break 'outer;
            }
            total += j;
        }
    }
    let k = 'block: {
        if n > 3 {
            break 'block 1;
        }
        2
    };
    total + k
}

#[kernel]
fn value_of_loop(n: u32) -> u32 {
    let mut i = 0u32;
    let found = loop {
        i += 1;
        if i * i > n {
            break i;
        }
    };
    found
}

fn main() {}
