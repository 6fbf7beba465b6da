//! `for` runs over ranges.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn iterators(a: [f32; 4], n: u32) -> f32 {
    let mut total = 0.0;
    for x in a {
        total += x;
    }
    for x in a.iter() {
        total += x;
    }
    for i in (0..n).rev() {
        total += i as f32;
    }
    for i in (0..n).step_by(2) {
        total += i as f32;
    }
    for i in 3.. {
        total += i as f32;
    }
    total + a[0..2][0]
}

fn main() {}
