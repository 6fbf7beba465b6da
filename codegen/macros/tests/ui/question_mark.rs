//! No `Option`, no `Result`.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn fallible(x: f32) -> Option<f32> {
    let y = Some(x)?;
    Some(y.min(Some(2.0).unwrap()))
}

fn main() {}
