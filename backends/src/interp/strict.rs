//! Plain IEEE f32: what the native functions compute, bit for bit, because they compute it.

use super::judge::integer;
use super::model::{Model, Pick};
use super::program::Scalar;
use crate::texture::Known;
use lobe_codegen::math::scalar;

/// One number a lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strict;

macro_rules! native {
    ($($name:ident($($arg:ident)*);)*) => {
        $(fn $name(&self, $($arg: f32),*) -> f32 {
            scalar::$name($($arg),*)
        })*
    };
}

macro_rules! infix {
    ($($name:ident $op:tt;)*) => {
        $(fn $name(&self, a: f32, b: f32) -> f32 {
            a $op b
        })*
    };
}

impl Model for Strict {
    const SHADOW: bool = false;
    const ALL_WIDTHS: bool = false;
    type F = f32;
    type W = u64;
    type B = bool;

    type Half = Self;
    type Double = Self;
    fn half(&self) -> Self {
        Self
    }
    fn double(&self) -> Self {
        Self
    }

    fn float(&self, value: f32, _: f64) -> f32 {
        value
    }
    fn ranged(&self, value: f32, _: Known) -> f32 {
        value
    }
    fn converted(&self, a: f32, _: Scalar) -> f32 {
        a
    }
    fn unpromised(&self, a: f32) -> f32 {
        a
    }
    fn value(&self, a: f32) -> f32 {
        a
    }
    fn exact(&self, a: f32) -> f64 {
        a.into()
    }
    fn with_truth(&self, a: f32, _: f64) -> f32 {
        a
    }
    fn join_f(&self, a: f32, b: f32, pick: Pick) -> f32 {
        if pick.value { a } else { b }
    }

    fn word(&self, value: u64) -> u64 {
        value
    }
    fn word_value(&self, a: u64) -> u64 {
        a
    }
    fn word_exact(&self, a: u64) -> u64 {
        a
    }
    fn known(&self, _: u64) -> bool {
        true
    }
    fn word_parts(&self, value: u64, _: u64) -> u64 {
        value
    }
    fn forget(&self, a: u64) -> u64 {
        a
    }
    fn map_w(&self, a: u64, f: impl Fn(u64) -> u64) -> u64 {
        f(a)
    }
    fn zip_w(&self, a: u64, b: u64, f: impl Fn(u64, u64) -> u64) -> u64 {
        f(a, b)
    }
    fn join_w(&self, a: u64, b: u64, pick: Pick) -> u64 {
        if pick.value { a } else { b }
    }

    fn boolean(&self, value: bool) -> bool {
        value
    }
    fn decision(&self, a: bool) -> bool {
        a
    }
    fn decision_exact(&self, a: bool) -> bool {
        a
    }
    fn ambiguous(&self, _: bool) -> bool {
        false
    }
    fn join_b(&self, a: bool, b: bool, pick: Pick) -> bool {
        if pick.value { a } else { b }
    }
    fn not(&self, a: bool) -> bool {
        !a
    }
    fn and(&self, a: bool, b: bool) -> bool {
        a && b
    }
    fn xor(&self, a: bool, b: bool) -> bool {
        a != b
    }

    fn compare_w(&self, a: u64, b: u64, f: impl Fn(u64, u64) -> bool) -> bool {
        f(a, b)
    }
    fn less(&self, a: f32, b: f32) -> bool {
        a < b
    }
    fn less_equal(&self, a: f32, b: f32) -> bool {
        a <= b
    }
    fn equal(&self, a: f32, b: f32) -> bool {
        a == b
    }
    fn is_nan(&self, a: f32) -> bool {
        a.is_nan()
    }
    fn is_inf(&self, a: f32) -> bool {
        a.is_infinite()
    }

    fn to_word(&self, a: f32, to: Scalar) -> u64 {
        integer::truncated(a, to)
    }
    fn to_float(&self, a: u64, from: Scalar) -> f32 {
        integer::rounded(a, from)
    }
    fn bits(&self, a: f32) -> u64 {
        a.to_bits().into()
    }
    fn float_of_bits(&self, a: u64) -> f32 {
        f32::from_bits(a as u32)
    }

    infix! { add +; sub -; mul *; div /; rem %; }
    fn neg(&self, a: f32) -> f32 {
        -a
    }
    fn length(&self, a: f32) -> f32 {
        a.abs()
    }
    native! {
        abs(a); min(a b); max(a b); sign(a); ceil(a); floor(a); round(a); trunc(a); fract(a); step(edge x);
        clamp(x low high); saturate(x); sqrt(a); inverse_sqrt(a); exp(a); exp2(a); log(a); log2(a); pow(x y);
        sin(a); cos(a); tan(x); asin(x); acos(x); atan(a); atan2(y x);
        sinh(x); cosh(x); tanh(x); asinh(x); acosh(x); atanh(x);
        degrees(x); radians(x); fma(x y z); mix(x y t); smoothstep(low high x);
    }
}
