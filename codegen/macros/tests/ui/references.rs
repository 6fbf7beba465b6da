//! Values are passed, not references.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn by_reference(x: &f32, y: &mut f32) -> f32 {
    let z = &x;
    *y + **z
}

#[kernel]
fn by_ref(ref x: f32) -> f32 {
    let ref y = 2.0;
    x + y
}

#[kernel]
fn slices(a: &[f32], p: *const f32) -> f32 {
    a[0]
}

fn main() {}
