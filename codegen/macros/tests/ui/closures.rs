//! No closures, no function values.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn closure(x: f32) -> f32 {
    let double = |a: f32| 2.0 * a;
    double(x)
}

#[kernel]
fn pointer(f: fn(f32) -> f32, x: f32) -> f32 {
    f(x)
}

#[kernel]
fn called_value(x: f32) -> f32 {
    (if x > 0.0 { sin } else { cos })(x)
}

fn main() {}
