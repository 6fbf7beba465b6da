//! The attribute's own arguments.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel(familly = "sg")]
fn misspelt(x: f32) -> f32 {
    x
}

#[kernel(family = 3)]
fn no_text(x: f32) -> f32 {
    x
}

#[kernel(domain(y = 0.0..=1.0, x = 0.0..1.0, x = near))]
fn domains(x: f32) -> f32 {
    x
}

#[kernel(budget(1e-6))]
fn no_result(x: f32) {
    let _ = x;
}

#[kernel(truth = exact)]
fn three(x: f32, y: f32, z: f32) -> f32 {
    x + y + z
}

#[kernel(workgroup_size(1, 2, 3, 4))]
fn four() {}

#[kernel(workgroup_size(many))]
fn many() {}

#[kernel(family = "sg")]
struct Lobe {
    #[domain(0.0..1.0)]
    sharpness: f32,
}

#[kernel(family = "a", family = "b")]
fn twice(x: f32) -> f32 {
    x
}

fn main() {}
