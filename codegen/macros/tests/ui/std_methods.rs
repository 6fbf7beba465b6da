//! Methods whose bits differ from machine to machine, or that no shader has.
#![allow(unused)]
use lobe_codegen::prelude::*;

#[kernel]
fn elementary(x: f32, y: f32) -> f32 {
    x.exp() + x.ln() + x.powf(y) + x.powi(2) + x.max(y) + x.clamp(0.0, 1.0) + x.sin_cos().0
}

#[kernel]
fn vectors(v: Vec3, w: Vec3) -> f32 {
    v.normalize().dot(w) + v.lerp(w, 0.5).x + v.min(w).y + v.max_element() + v.as_uvec3().x as f32
}

#[kernel]
fn others(x: f32) -> f32 {
    let y = x.clone();
    if y.is_nan() { x.exp_m1() } else { x.signum() }
}

fn main() {}
