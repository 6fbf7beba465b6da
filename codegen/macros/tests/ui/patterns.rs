//! Patterns bind one name.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
struct Pair {
    a: f32,
    b: f32,
}

#[kernel]
fn destructures(p: Pair) -> f32 {
    let Pair { a, b } = p;
    let (c, d) = (a, b);
    let [e, f] = [c, d];
    e + f
}

#[kernel]
fn in_parameter(Pair { a, b }: Pair, _: f32) -> f32 {
    a + b
}

#[kernel]
fn diverges(x: f32) -> f32 {
    let Some(y) = Some(x) else { return 0.0 };
    y
}

fn main() {}
