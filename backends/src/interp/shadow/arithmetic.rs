//! Operators.

use super::{Real, TINY};
use lobe_codegen::math::scalar;

/// Largest and smallest divisor for which division keeps its 2.5 ULP.
const DIVISORS: std::ops::RangeInclusive<f64> = TINY..=8.507059173023462e37;

pub(super) fn add(a: Real, b: Real) -> Real {
    sum(a.value + b.value, a.exact + b.exact, a, b)
}

pub(super) fn subtract(a: Real, b: Real) -> Real {
    sum(a.value - b.value, a.exact - b.exact, a, b)
}

fn sum(value: f32, exact: f64, a: Real, b: Real) -> Real {
    let spread = a.bound + b.bound;
    // A sum of certain operands that is representable comes out as it is; so does x + 0.
    let representable = spread == 0.0 && f64::from(value) == exact && is_exact_sum(exact, a.exact, b.exact);
    let unchanged = a.is_certain() && a.exact == 0.0 || b.is_certain() && b.exact == 0.0;
    Real::rounded(value, exact, spread, if representable || unchanged { 0.0 } else { 1.0 })
}

/// Whether f64 did not round `exact = a ± b`.
fn is_exact_sum(exact: f64, a: f64, b: f64) -> bool {
    (exact - a).abs() == b.abs() && ((exact - b).abs() == a.abs() || (exact + b).abs() == a.abs())
}

pub(super) fn multiply(a: Real, b: Real) -> Real {
    let (value, exact) = (a.value * b.value, a.exact * b.exact);
    let spread = product_spread(a, b);
    // f64 holds a product of two f32 whole, so this sees whether it is representable.
    let representable = spread == 0.0 && f64::from(value) == exact;
    // A product by a power of two, by 1 above all, is exact on every driver.
    let is_exact = representable || power_of_two(a) || power_of_two(b);
    Real::rounded(value, exact, spread, if is_exact { 0.0 } else { 1.0 })
}

fn power_of_two(x: Real) -> bool {
    x.is_certain() && x.exact != 0.0 && x.exact.to_bits() & ((1 << 52) - 1) == 0
}

/// Distance of the product from the exact one, by the operands' bounds.
fn product_spread(a: Real, b: Real) -> f64 {
    if a.bound.is_infinite() || b.bound.is_infinite() {
        return f64::INFINITY;
    }
    a.exact.abs() * b.bound + b.exact.abs() * a.bound + a.bound * b.bound
}

pub(super) fn divide(a: Real, b: Real) -> Real {
    let (value, exact) = (a.value / b.value, a.exact / b.exact);
    let smallest = b.exact.abs() - b.bound;
    if !DIVISORS.contains(&smallest) || !DIVISORS.contains(&b.magnitude()) {
        return Real::unknown(value, exact);
    }
    let spread = (a.bound + exact.abs() * b.bound) / smallest;
    Real::rounded(value, exact, spread, 2.5)
}

/// Either fused or as a product and a sum; the latter's bound covers both.
pub(super) fn fma(x: Real, y: Real, z: Real) -> Real {
    Real { value: scalar::fma(x.value, y.value, z.value), ..add(multiply(x, y), z) }
}

/// `x (1 - t) + y t`
pub(super) fn mix(x: Real, y: Real, t: Real) -> Real {
    let one = Real::given(1.0, 1.0);
    let sum = add(multiply(x, subtract(one, t)), multiply(y, t));
    Real { value: scalar::mix(x.value, y.value, t.value), ..sum }
}

pub(super) fn negate(x: Real) -> Real {
    Real { value: -x.value, exact: -x.exact, ..x }
}
