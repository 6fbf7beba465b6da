//! Statements stand alone.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn inside(x: f32) -> f32 {
    let mut a = x;
    let b = (a = 2.0);
    let c = while a > 3.0 {};
    let d = x + return a;
    b
}

#[kernel]
fn others(x: f32) -> f32 {
    let a = async { x };
    let b = const { 1.0 };
    let c = 0..3;
    let d: _ = x;
    x
}

fn main() {}
