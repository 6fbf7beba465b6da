//! No enumerations, no tuple structures.
#![allow(unused)]
use lobe_codegen::prelude::*;

struct Wrapped(f32);

enum Kind {
    First,
    Second(f32),
}

#[kernel]
fn variants(x: f32) -> f32 {
    let y = Wrapped(x);
    let a = Kind::First;
    let b = Kind::Second(x);
    x
}

fn main() {}
