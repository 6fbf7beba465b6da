//! Associated functions and constants.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
struct Lobe {
    sharpness: f32,
}

impl Lobe {
    const LIMIT: f32 = 1.0;

    fn new(sharpness: f32) -> Self {
        Self { sharpness }
    }
}

#[kernel]
fn functions(x: f32) -> Vec3 {
    let s = f32::sqrt(x) + f32::from(true) + f32::max(x, 1.0);
    let l = Lobe::new(s);
    Vec3::from_array([l.sharpness, 0.0, 0.0]) + Vec3::dot(Vec3::X, Vec3::Y)
}

#[kernel]
fn constants(x: f32) -> f32 {
    x + f32::INFINITY + f32::NAN + f32::DIGITS as f32 + Lobe::LIMIT + Vec3::AXES[0].x
}

fn main() {}
