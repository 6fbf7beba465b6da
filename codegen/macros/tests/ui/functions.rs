//! What stands before `fn`.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
async fn later(x: f32) -> f32 {
    x
}

#[kernel]
unsafe fn risky(x: f32) -> f32 {
    unsafe { x }
}

#[kernel]
extern "C" fn foreign(x: f32) -> f32 {
    x
}

struct Holder;

impl Holder {
    #[kernel]
    fn method(self, x: f32) -> f32 {
        x
    }
}

fn main() {}
