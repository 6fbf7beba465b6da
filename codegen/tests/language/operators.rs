//! Operators on scalars.

use crate::check::{agrees, agrees_on, lowered, refusal, wgsl};
use lobe_codegen::kernels;
use lobe_codegen::prelude::*;

#[kernel]
fn arithmetic(x: f32, y: f32) -> f32 {
    -x * y + x / y - (x - y) % 3.0
}

#[kernel]
fn with_sign(a: i32, b: i32) -> i32 {
    (a + b) * 3 - a / 3 + b % 5 + (a & b) + (a | 12) + (a ^ b) + !a - -b
}

#[kernel]
fn without_sign(a: u32, b: u32) -> u32 {
    (a + b) * 3 + a / 3 + b % 5 + (a & b) + (a | 12) + (a ^ b) + (!a >> 8)
}

#[kernel]
fn shifts(a: i32, b: u32, n: i32) -> i32 {
    let n = n & 15;
    (a << n) + (a >> 2u32) + (b << 3) as i32 + (b >> n) as i32 + (-64 >> n) + (1 << n)
}

/// The left side of a shift does not take the type of the right one.
#[kernel]
fn sign_bit(n: u32) -> f32 {
    (1 << (n & 31)) as f32
}

#[kernel]
fn comparisons(x: f32, y: f32, a: i32, b: u32) -> bool {
    (x < y) ^ (x <= y) | (x > y) & (x >= y) | (x == y) & (x != y) ^ (a < 3) ^ (b >= 4) == (a != 1)
}

#[kernel]
fn logic(p: bool, q: bool, x: f32) -> bool {
    let r = !p && q || x < 1.0;
    (r || p) && !(q & r)
}

#[kernel]
fn casts(x: f32, a: i32, b: u32, p: bool) -> f32 {
    x as i32 as f32
        + x as u32 as f32
        + a as u32 as i32 as f32
        + b as i32 as f32
        + p as i32 as f32
        + p as u32 as f32
}

#[kernel]
fn wrapping(a: u32, b: i32) -> u32 {
    0x9e3779b9u32.wrapping_mul(a).wrapping_add(0xffffffff).wrapping_sub(b.wrapping_mul(0x7fffffff) as u32)
}

#[kernel]
fn float_methods(x: f32, y: f32) -> f32 {
    x.abs().sqrt() + x.recip() + x.mul_add(y, 1.0) + (x.to_bits() & 1) as f32
}

#[test]
fn operators_compute_what_rust_computes() {
    agrees(kernels![arithmetic][0]);
    agrees(kernels![with_sign][0]);
    agrees(kernels![without_sign][0]);
    agrees(kernels![shifts][0]);
    agrees(kernels![sign_bit][0]);
    agrees_on(kernels![sign_bit][0], vec![vec![31], vec![30], vec![0]]);
    agrees(kernels![comparisons][0]);
    agrees(kernels![logic][0]);
    agrees(kernels![casts][0]);
    agrees(kernels![wrapping][0]);
    agrees(kernels![float_methods][0]);
}

#[test]
fn conversions_saturate_as_in_rust() {
    let rows = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 3e9, -3e9, 5e9, -0.9, 0.9, 1e-40];
    agrees_on(kernels![casts][0], rows.iter().map(|x| vec![x.to_bits(), 1, 2, 1]).collect());
}

#[kernel]
fn guarded(x: f32, n: u32) -> f32 {
    let a = [1.0, 2.0, 4.0];
    // The right side may only run when the left one holds.
    if n < 3 && a[n as usize] > 1.0 || n > 5 && 12 / (n - 5) > 3 { x } else { 0.0 }
}

#[test]
fn the_right_side_of_a_logical_operator_runs_only_when_it_counts() {
    agrees(kernels![guarded][0]);
    let text = wgsl(&lowered(&kernels![guarded]));
    let test = text.find("n < 3u").unwrap_or_else(|| panic!("{text}"));
    assert!(text[test..].find("if").is_some_and(|i| text[test + i..].contains("> 1f")), "{text}");
}

#[kernel]
fn ordered_booleans(p: bool, q: bool) -> bool {
    p < q
}

#[kernel]
#[allow(arithmetic_overflow, reason = "that is what is tested")]
fn too_far(n: u32) -> u32 {
    n + (1 << 40)
}

#[kernel]
#[allow(unconditional_panic, reason = "that is what is tested")]
fn by_zero(n: u32) -> u32 {
    n + 3 / (2 - 2)
}

#[test]
fn operators_without_a_shader_form_are_refused() {
    assert!(refusal(kernels![ordered_booleans][0]).contains("no shading language orders booleans"));
}

#[test]
fn literals_that_rust_would_panic_on_are_refused() {
    assert!(refusal(kernels![too_far][0]).contains("cannot be shifted by 40 bits"));
    assert!(refusal(kernels![by_zero][0]).contains("3 is divided by zero"));
}
