//! Integers as WGSL has them.

use crate::support::word;

fn binary(op: &str, ty: &str, a: u32, b: u32) -> u32 {
    word(&format!("fn f(a: {ty}, b: {ty}) -> {ty} {{ return a {op} b; }}"), &[a, b])
}

#[test]
fn arithmetic_wraps() {
    assert_eq!(binary("+", "u32", u32::MAX, 2), 1);
    assert_eq!(binary("-", "i32", i32::MIN as u32, 1), i32::MAX as u32);
    assert_eq!(binary("*", "i32", 0x4000_0001, 4), 4);
    assert_eq!(word("fn f(a: i32) -> i32 { return -a; }", &[i32::MIN as u32]), i32::MIN as u32);
}

#[test]
fn division_by_zero_returns_the_dividend_and_no_remainder() {
    assert_eq!(binary("/", "u32", 7, 0), 7);
    assert_eq!(binary("%", "u32", 7, 0), 0);
    assert_eq!(binary("/", "i32", -7_i32 as u32, 0), -7_i32 as u32);
    assert_eq!(binary("%", "i32", -7_i32 as u32, 0), 0);
}

#[test]
fn the_quotient_that_overflows_is_the_dividend() {
    assert_eq!(binary("/", "i32", i32::MIN as u32, u32::MAX), i32::MIN as u32);
    assert_eq!(binary("%", "i32", i32::MIN as u32, u32::MAX), 0);
}

#[test]
fn signed_division_truncates() {
    assert_eq!(binary("/", "i32", -7_i32 as u32, 2) as i32, -3);
    assert_eq!(binary("%", "i32", -7_i32 as u32, 2) as i32, -1);
}

#[test]
fn shifts_use_the_lower_five_bits() {
    let shift = |op: &str, ty: &str, a, b| {
        word(&format!("fn f(a: {ty}, b: u32) -> {ty} {{ return a {op} b; }}"), &[a, b])
    };
    assert_eq!(shift("<<", "u32", 1, 33), 2);
    assert_eq!(shift(">>", "i32", -8_i32 as u32, 1) as i32, -4);
    assert_eq!(shift(">>", "u32", 0x8000_0000, 31), 1);
}

#[test]
fn comparisons_know_the_sign() {
    let less =
        |ty: &str| word(&format!("fn f(a: {ty}, b: {ty}) -> bool {{ return a < b; }}"), &[u32::MAX, 1]);
    assert_eq!((less("i32"), less("u32")), (1, 0));
}

#[test]
fn conversions_saturate_and_nan_becomes_zero() {
    let to = |ty: &str, x: f32| word(&format!("fn f(a: f32) -> {ty} {{ return {ty}(a); }}"), &[x.to_bits()]);
    assert_eq!(to("i32", 1e10) as i32, 2_147_483_520);
    assert_eq!(to("i32", -3.9) as i32, -3);
    assert_eq!(to("u32", -3.9), 0);
    assert_eq!(to("u32", f32::NAN), 0);
    assert_eq!(to("u32", 3e10), 4_294_967_040);
}

#[test]
fn integers_convert_to_the_nearest_float() {
    let from =
        |ty: &str, w| f32::from_bits(word(&format!("fn f(a: {ty}) -> f32 {{ return f32(a); }}"), &[w]));
    assert_eq!(from("u32", u32::MAX), 4294967296.0);
    assert_eq!(from("i32", u32::MAX), -1.0);
}

#[test]
fn bits_travel_unchanged() {
    let nan = 0x7fc0_1234;
    assert_eq!(word("fn f(a: f32) -> u32 { return bitcast<u32>(a); }", &[nan]), nan);
    assert_eq!(word("fn f(a: u32) -> f32 { return bitcast<f32>(a); }", &[nan]), nan);
    assert_eq!(word("fn f(a: u32) -> u32 { return ~a ^ (a & 15u) | 1u; }", &[6]), (!6 ^ 6) | 1);
}

#[test]
fn booleans_become_numbers_and_back() {
    assert_eq!(word("fn f(a: u32) -> u32 { return u32(bool(a)) + u32(!bool(a)) * 2u; }", &[9]), 1);
    assert_eq!(f32::from_bits(word("fn f(a: u32) -> f32 { return f32(a > 3u); }", &[9])), 1.0);
}
