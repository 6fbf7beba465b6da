//! `match` takes integers, literals and `_`.
#![allow(unused)]
use lobe_codegen::prelude::*;

const LIMIT: u32 = 4;

#[kernel]
fn arms(n: u32, x: f32, p: bool) -> f32 {
    let a = match n {
        0 if x > 0.0 => 1.0,
        1..=3 => 2.0,
        LIMIT => 3.0,
        k => k as f32,
    };
    let b = match p {
        true => 1.0,
        false => 2.0,
    };
    a + b
}

fn main() {}
