//! `#[kernel] const`, and constants of types.

use crate::check::{agrees, lowered, wgsl};
use lobe_codegen::kernels;
use lobe_codegen::module::Scope;
use lobe_codegen::prelude::*;

/// A tenth.
#[kernel]
const TENTH: f32 = 0.1;

#[kernel]
const QUARTER: f32 = -0.25;

#[kernel]
const ROUNDS: u32 = 3;

#[kernel]
const OFFSET: i32 = -7 + 2;

#[kernel]
const ENABLED: bool = true;

#[kernel]
const UP: Vec3 = Vec3::new(0.0, 1.0, 0.5);

#[kernel]
const WEIGHTS: [f32; 3] = [0.1, 0.2, 0.3];

#[kernel]
const POINTS: [Vec2; 2] = [Vec2::X, Vec2::new(2.0, 3.0)];

#[kernel]
fn uses(x: f32, n: u32) -> f32 {
    let mut total = x * TENTH + QUARTER;
    for i in 0..ROUNDS {
        total += WEIGHTS[i as usize];
    }
    if ENABLED {
        total += UP.y + dot(UP, Vec3::splat(x));
    }
    total + OFFSET as f32 + POINTS[(n & 1) as usize].y + POINTS[1].x + WEIGHTS.len() as f32
}

#[kernel]
fn lengths(x: f32) -> f32 {
    let a = [x; ROUNDS as usize];
    a[2] + a.len() as f32
}

#[kernel]
fn of_types(x: f32) -> f32 {
    let v = Vec3::ZERO + Vec3::ONE * x + Vec3::NEG_Y;
    let u = UVec2::ONE;
    min(x, f32::MAX) + f32::EPSILON + v.y + u.x as f32 + (u32::MAX - 1) as f32 + (i32::MIN + 1) as f32
}

#[kernel]
fn circle(x: f32) -> f32 {
    x * std::f32::consts::PI + core::f32::consts::FRAC_1_SQRT_2
}

#[test]
fn constants_have_their_value() {
    agrees(kernels![uses][0]);
    agrees(kernels![lengths][0]);
    agrees(kernels![of_types][0]);
    agrees(kernels![circle][0]);
}

#[test]
fn constants_keep_their_names_and_decimals() {
    let module = lowered(&kernels![uses]);
    let text = wgsl(&module);
    assert!(text.contains("const TENTH: f32 = 0.1f;"), "{text}");
    assert!(text.contains("* TENTH"), "{text}");
    let global = module.meta().exact.iter().filter(|((scope, _), _)| *scope == Scope::Global);
    // A quarter is no more than itself.
    assert_eq!(global.map(|(_, exact)| *exact).collect::<Vec<_>>(), [0.1]);
}

#[test]
fn the_constants_of_the_standard_library_keep_their_f64_value() {
    let module = lowered(&kernels![circle]);
    assert!(module.meta().exact.values().any(|v| *v == std::f64::consts::PI));
}
