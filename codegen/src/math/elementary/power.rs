//! Powers.

use super::double;

/// `x^y` as `exp2(y * log2(x))`, rounded once: at most 0.51 ULP; a negative base gives NaN, as in the shading languages.
/// `x^0` and `1^y` are 1.
#[inline(always)]
pub fn pow(x: f32, y: f32) -> f32 {
    let logarithm = double::log2(f64::from(x));
    let logarithm = if x == 0.0 { f64::NEG_INFINITY } else { logarithm };
    let logarithm = if x == f32::INFINITY { f64::INFINITY } else { logarithm };
    let exponent = f64::from(y) * logarithm;
    let exponent = if exponent > 200.0 { 200.0 } else { exponent };
    let exponent = if exponent < -200.0 { -200.0 } else { exponent };
    let result = double::exp2(exponent) as f32;
    let result = if x.is_nan() { x } else { result };
    let result = if y == 0.0 || x == 1.0 { 1.0 } else { result };
    if x < 0.0 { f32::NAN } else { result }
}
