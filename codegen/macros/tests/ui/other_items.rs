//! `#[kernel]` stands on functions, structures and constants.
#![allow(unused)]
use lobe_codegen::prelude::*;

struct Lobe;

#[kernel]
impl Lobe {}

#[kernel]
enum Kind {
    A,
    B,
}

#[kernel]
static COUNT: u32 = 3;

#[kernel]
trait Shape {}

#[kernel]
type Real = f32;

#[kernel]
mod inner {}

#[kernel]
use std::f32::consts::PI;

#[kernel]
union Bits {
    a: u32,
    b: f32,
}

fn main() {}
