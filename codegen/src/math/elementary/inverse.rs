//! Inverse trigonometric functions.

use super::polynomial;
use std::f64::consts::{FRAC_PI_2, PI};

/// Arc sine of `s`, of which `z` is the square, up to 1/2.
#[inline(always)]
fn arc_sine(s: f64, z: f64) -> f64 {
    s * polynomial(
        z,
        [
            1.0,
            0.166_666_671_793_805_37,
            0.074_999_489_669_390_27,
            0.044_659_954_558_865_36,
            0.030_112_724_133_840_967,
            0.024_603_607_237_996_265,
            0.007_512_434_971_105_69,
            0.034_643_271_958_282_42,
        ],
    )
}

/// Arc sine up to 1/2; beyond that, which the flag says, that of the root of half of what is left to 1.
#[inline(always)]
fn halved(x: f32) -> (bool, f64) {
    let a = f64::from(x.abs());
    let beyond = a > 0.5;
    let z = if beyond { 0.5 * (1.0 - a) } else { a * a };
    let s = if beyond { z.sqrt() } else { a };
    (beyond, arc_sine(s, z))
}

/// Arc sine. At most 0.51 ULP; NaN beyond 1.
#[inline(always)]
pub fn asin(x: f32) -> f32 {
    let (beyond, p) = halved(x);
    (if beyond { FRAC_PI_2 - 2.0 * p } else { p }).copysign(x.into()) as f32
}

/// Arc cosine. At most 0.51 ULP; NaN beyond 1.
#[inline(always)]
pub fn acos(x: f32) -> f32 {
    let (beyond, p) = halved(x);
    let p = if beyond { FRAC_PI_2 - 2.0 * p } else { p };
    (FRAC_PI_2 - p.copysign(x.into())) as f32
}

/// Arc tangent of 0 to 1.
#[inline(always)]
fn arc_tangent(t: f64) -> f64 {
    t * polynomial(
        t * t,
        [
            1.0,
            -0.333_333_321_339_095_2,
            0.199_999_272_470_519_7,
            -0.142_841_672_388_128_73,
            0.110_945_034_434_200_33,
            -0.089_854_370_863_995_18,
            0.072_594_303_149_572_71,
            -0.054_515_794_772_080_22,
            0.034_475_646_141_572_05,
            -0.016_299_266_566_681_37,
            0.004_926_274_691_044_156,
            -6.979_416_189_501_998e-4,
        ],
    )
}

/// Arc tangent. At most 0.51 ULP.
#[inline(always)]
pub fn atan(x: f32) -> f32 {
    let a = f64::from(x.abs());
    let beyond = a > 1.0;
    let p = arc_tangent(if beyond { 1.0 / a } else { a });
    (if beyond { FRAC_PI_2 - p } else { p }).copysign(x.into()) as f32
}

/// Angle of the point `(x, y)`, by the signs of zeros too. At most 0.51 ULP.
#[inline(always)]
pub fn atan2(y: f32, x: f32) -> f32 {
    let (a, b) = (f64::from(y.abs()), f64::from(x.abs()));
    let steep = a > b;
    let (low, high) = if steep { (b, a) } else { (a, b) };
    let t = low / high;
    let t = if high == 0.0 { 0.0 } else { t };
    let t = if low == f64::INFINITY { 1.0 } else { t };
    let p = arc_tangent(t);
    let p = if steep { FRAC_PI_2 - p } else { p };
    let p = if x.is_sign_negative() { PI - p } else { p };
    let p = if x.is_nan() | y.is_nan() { f64::NAN } else { p };
    p.copysign(y.into()) as f32
}
