//! All mistakes of an item are shown at once.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel(family = "sg", domain(z = 0.0..=1.0))]
fn float(x: f64, half: &f32) -> (f32, f32) {
    let f = |a| a;
    for v in [1.0, 2.0] {
        let _ = v.exp();
    }
    let t = 'a';
    println!("{t}");
    (f(x) as f32, float(x, half).0)
}

fn main() {}
