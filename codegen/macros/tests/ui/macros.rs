//! No macro calls.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn asserts(x: f32) -> f32 {
    assert!(x > 0.0);
    let a = vec![x];
    println!("{x}");
    if x > 1.0 { panic!("large") } else { x + matches!(a.len(), 1) as u32 as f32 }
}

fn main() {}
