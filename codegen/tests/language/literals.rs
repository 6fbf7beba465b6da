//! Literals: their type, their last bit, and folding in f32.

use crate::check::{agrees, agrees_on, lowered, refusal, wgsl};
use lobe_codegen::kernels;
use lobe_codegen::module::Scope;
use lobe_codegen::prelude::*;

#[kernel]
fn tenths(x: f32) -> f32 {
    x * (0.1 + 0.2) - 0.1 * 0.2 / 0.3
}

#[kernel]
fn integers(n: i32, m: u32) -> i32 {
    let a = 7 / 2 + 7 % 4 - (1 << 3);
    let b = (0xffu32 >> 4) & 0b1010 | 1;
    a + n * -3 + (m + b) as i32
}

#[kernel]
fn literal_casts(x: f32) -> f32 {
    x + 7 as f32 + (2.9 as i32) as f32 + (-2.9 as i32) as f32 + (-1.0 as u32) as f32 + (true as u32) as f32
}

#[kernel]
fn literal_comparisons(x: f32) -> f32 {
    if 0.1 + 0.2 > 0.25 && 3 / 2 == 1 && !(1.0 != 1.0) { x } else { -x }
}

#[kernel]
fn lowest(n: i32) -> i32 {
    if n > 0 { -2147483648 } else { -2147483648i32 }
}

#[kernel]
fn bits_of_literals(n: u32) -> f32 {
    f32::from_bits(0x3f800000 + (n & 7)) * f32::from_bits(0x40490fdb) + 1.0f32.to_bits() as f32
}

#[test]
fn literals_mean_what_rust_means() {
    agrees(kernels![tenths][0]);
    agrees(kernels![integers][0]);
    agrees(kernels![literal_casts][0]);
    agrees(kernels![literal_comparisons][0]);
    agrees(kernels![lowest][0]);
    agrees(kernels![bits_of_literals][0]);
}

/// The nearest f64 of these decimals lies midway between two floats: rounded twice, it is 1.0.
#[kernel]
fn just_above_midway(x: f32) -> f32 {
    x * 1.00000005960464477540
}

#[test]
fn decimals_are_rounded_once() {
    agrees_on(kernels![just_above_midway][0], vec![vec![1f32.to_bits()]]);
    assert_ne!(just_above_midway(1.0), 1.0);
}

/// In Rust this is a comparison of f64.
#[kernel]
fn double_comparison(x: f32) -> f32 {
    if 0.1 + 0.2 > 0.3 { x } else { -x }
}

#[kernel]
fn double_cast(x: f32) -> f32 {
    x + 0.99999999999 as i32 as f32
}

/// Rust takes a float that nothing decides as f64; a shader could not follow.
#[test]
fn an_outcome_that_hangs_on_f64_is_refused() {
    assert!(refusal(kernels![double_comparison][0]).contains("differently in f32 and in f64"));
    assert!(refusal(kernels![double_cast][0]).contains("differently in f32 and in f64"));
}

#[kernel]
fn overflows(x: f32) -> f32 {
    x + 1e38 * 10.0
}

#[kernel]
fn divides_by_zero(x: f32) -> f32 {
    x + 1.0 / 0.0
}

#[kernel]
fn bits_of_nan(x: f32) -> f32 {
    x + f32::from_bits(0x7fc00000)
}

#[test]
fn a_literal_that_cannot_be_written_is_refused_at_its_line() {
    let message = refusal(kernels![overflows][0]);
    assert!(message.contains("no shading language has a literal"), "{message}");
    assert!(message.contains("x + 1e38 * 10.0"), "{message}");
    assert!(refusal(kernels![divides_by_zero][0]).contains("is inf in f32"));
    assert!(refusal(kernels![bits_of_nan][0]).contains("these bits are NaN"));
}

#[kernel]
fn three_literals(x: f32) -> f32 {
    x * 0.1 + 0.25 + 0.5 * 0.1
}

#[test]
fn the_decimals_are_remembered_only_where_f32_rounds_them() {
    let module = lowered(&kernels![three_literals]);
    let mut exact: Vec<f64> = module.meta().exact.values().copied().collect();
    exact.sort_by(f64::total_cmp);
    assert_eq!(exact, [0.5 * 0.1, 0.1]);
    let function = module.function("three_literals").unwrap();
    assert!(module.meta().exact.keys().all(|(scope, _)| *scope == Scope::Function(function)));
    assert!(wgsl(&module).contains("0.25f"), "{}", wgsl(&module));
}
