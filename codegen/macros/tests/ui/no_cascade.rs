//! Those who use an item with a mistake are not at fault.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn broken(x: f32) -> f32 {
    x.exp()
}

#[kernel]
struct Lobe {
    half: f32,
}

#[kernel]
const PASS: f32 = 1.0;

#[kernel]
fn sound(lobe: Lobe) -> f32 {
    broken(lobe.half) * PASS
}

#[kernel]
fn also_sound(x: f32) -> Lobe {
    Lobe { half: sound(Lobe { half: x }) }
}

fn main() {
    lobe_codegen::lower(&lobe_codegen::kernels![also_sound]);
}
