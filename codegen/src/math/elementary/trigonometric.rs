//! Trigonometric functions.
//!
//! Angles below 2^20 are reduced in a few operations; beyond that, the exact reduction takes many. [`near`] has the
//! functions for the first alone, so that a loop over lanes can ask once for all of them.

use super::angle::{self, Angle};
use super::polynomial;

/// The same functions for angles of which [`holds`](near::holds) is true: same results, without the way for others.
pub mod near {
    use super::super::angle;

    /// Whether the functions here take this angle.
    #[inline(always)]
    pub fn holds(x: f32) -> bool {
        angle::is_near(x)
    }

    /// See [`sin`](super::sin).
    #[inline(always)]
    pub fn sin(x: f32) -> f32 {
        super::sine(angle::near(x))
    }

    /// See [`cos`](super::cos).
    #[inline(always)]
    pub fn cos(x: f32) -> f32 {
        super::cosine(angle::near(x))
    }

    /// See [`tan`](super::tan).
    #[inline(always)]
    pub fn tan(x: f32) -> f32 {
        super::tangent(angle::near(x))
    }
}

/// Sine and cosine of at most an eighth of a turn.
#[inline(always)]
fn both(rest: f64) -> [f64; 2] {
    let z = rest * rest;
    let sine = polynomial(
        z,
        [
            1.0,
            -0.166_666_666_407_996_16,
            0.008_333_329_305_019_751,
            -1.983_931_227_997_015_8e-4,
            2.718_121_421_978_225e-6,
        ],
    );
    let cosine = polynomial(
        z,
        [
            1.0,
            -0.499_999_996_946_079,
            0.041_666_620_367_044_53,
            -0.001_388_668_183_877_342,
            2.438_357_758_799_938_4e-5,
        ],
    );
    [rest * sine, cosine]
}

/// `x` with its sign changed where `quarters` is beyond half a turn.
#[inline(always)]
fn signed(x: f64, quarters: u64) -> f32 {
    f64::from_bits(x.to_bits() ^ ((quarters & 2) << 62)) as f32
}

#[inline(always)]
fn sine(a: Angle) -> f32 {
    let [s, c] = both(a.rest);
    signed(if a.quarters & 1 == 0 { s } else { c }, a.quarters)
}

#[inline(always)]
fn cosine(a: Angle) -> f32 {
    let [s, c] = both(a.rest);
    signed(if a.quarters & 1 == 0 { c } else { s }, a.quarters.wrapping_add(1))
}

#[inline(always)]
fn tangent(a: Angle) -> f32 {
    let [s, c] = both(a.rest);
    let even = a.quarters & 1 == 0;
    ((if even { s } else { -c }) / (if even { c } else { s })) as f32
}

/// `near` of small angles, `far` of others, NaN of those without size.
#[inline(always)]
fn of_any(x: f32, near: fn(f32) -> f32, far: fn(Angle) -> f32) -> f32 {
    let result = if angle::is_near(x) { near(x) } else { far(angle::far(x)) };
    if x.is_finite() { result } else { f32::NAN }
}

/// Sine of radians. At most 0.51 ULP, however large the angle is.
#[inline(always)]
pub fn sin(x: f32) -> f32 {
    of_any(x, near::sin, sine)
}

/// Cosine of radians. At most 0.51 ULP, however large the angle is.
#[inline(always)]
pub fn cos(x: f32) -> f32 {
    of_any(x, near::cos, cosine)
}

/// Tangent of radians. At most 0.51 ULP, however large the angle is.
#[inline(always)]
pub fn tan(x: f32) -> f32 {
    of_any(x, near::tan, tangent)
}
