//! Constants of the kernel language.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
struct Lobe {
    sharpness: f32,
}

#[kernel]
const DOUBLE: f64 = 1.0;

#[kernel]
const NAME: &str = "lobe";

#[kernel]
const LOBE: Lobe = Lobe { sharpness: 1.0 };

const N: usize = 2;

#[kernel]
const TABLE: [f32; N] = [1.0, 2.0];

#[kernel]
const PAIR: (f32, f32) = (1.0, 2.0);

fn main() {}
