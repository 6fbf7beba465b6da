//! Elementary functions of our own: arithmetic without branches, table or contraction.
//!
//! A loop over lanes that calls one of them becomes vector code on every instruction set, and since only
//! operations that IEEE 754 rounds correctly occur, in a fixed order, the bits are the same everywhere.
//! Selects stand where others branch; what an unselected side computes does not matter.
//! Exponentials and logarithms, which lighting is made of, are f32 throughout, and flush results and arguments below
//! the smallest normal number where they say so: the shading languages permit it, and processors are slow there.
//! The others compute in f64 and round once.
//!
//! Polynomials were fitted for the smallest largest error, relative to the function.
//! `benches/elementary.rs` measures errors over all floats, and time.

mod abreast;
mod angle;
mod double;
mod exponential;
mod hyperbolic;
mod inverse;
mod logarithm;
mod power;
mod trigonometric;

pub use exponential::{exp, exp2, finite, several};
pub use hyperbolic::{acosh, asinh, atanh, cosh, sinh, tanh};
pub use inverse::{acos, asin, atan, atan2};
pub use logarithm::{log, log2};
pub use power::pow;
pub use trigonometric::{cos, near, sin, tan};

use std::ops::{Add, Mul};

/// `c[0] + c[1] x + ..`, from the highest power down.
#[inline(always)]
fn polynomial<T: Copy + Add<Output = T> + Mul<Output = T>, const N: usize>(x: T, c: [T; N]) -> T {
    let mut sum = c[N - 1];
    let mut at = N - 1;
    while at > 0 {
        at -= 1;
        sum = sum * x + c[at];
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use f32 as F;

    type Row = (fn(f32) -> f32, fn(f64) -> f64);

    fn check(found: f32, wanted: f64, at: &dyn std::fmt::Debug) {
        let nearest = wanted as f32;
        let same = found == nearest || found.is_nan() && nearest.is_nan();
        let flushed = found == 0.0 && wanted.abs() <= f64::from(F::MIN_POSITIVE);
        let ulp = f64::from(nearest.abs().next_up() - nearest.abs());
        let near = (f64::from(found) - wanted).abs() <= ulp;
        assert!(same || flushed || near, "{at:?}: {found:e}, {wanted:e}");
    }

    /// Every 1021st float: no result further than 1 ULP from f64's, but for those that are flushed.
    #[test]
    fn functions_are_within_one_ulp() {
        let table: [Row; 16] = [
            (exp, libm::exp),
            (exp2, libm::exp2),
            (log, libm::log),
            (log2, libm::log2),
            (sin, libm::sin),
            (cos, libm::cos),
            (tan, libm::tan),
            (asin, libm::asin),
            (acos, libm::acos),
            (atan, libm::atan),
            (sinh, libm::sinh),
            (cosh, libm::cosh),
            (tanh, libm::tanh),
            (asinh, libm::asinh),
            // libm has a number below -1.
            (acosh, |x| if x < 1.0 { f64::NAN } else { libm::acosh(x) }),
            (atanh, libm::atanh),
        ];
        for (row, (f, exact)) in table.into_iter().enumerate() {
            for x in (0..=u32::MAX).step_by(1021).map(F::from_bits) {
                check(f(x), exact(x.into()), &(row, x));
            }
        }
    }

    /// Pairs of floats from all over their range: the same.
    #[test]
    fn functions_of_two_are_within_one_ulp() {
        let mut seed = 1_u64;
        for _ in 0..4_000_000 {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let bits = (seed ^ seed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            let (a, b) = (F::from_bits((bits >> 32) as u32), F::from_bits(bits as u32));
            check(atan2(a, b), libm::atan2(a.into(), b.into()), &(a, b));
            // Most powers of any two floats are 0 or infinite: bases near 1 have others.
            for x in [a.abs(), 1.0 + 1e-3 * a.abs().min(1e3), a.abs().sqrt().sqrt()] {
                check(pow(x, b), libm::pow(x.into(), b.into()), &(x, b));
                check(pow(x, b.sqrt()), libm::pow(x.into(), b.sqrt().into()), &(x, b.sqrt()));
            }
        }
    }

    #[test]
    fn special_values_are_kept() {
        let (inf, nan, zero) = (F::INFINITY, F::NAN, 0.0_f32);
        assert_eq!((exp(0.0), exp(-inf), exp(inf)), (1.0, 0.0, inf));
        assert_eq!((exp2(-3.0), exp2(-inf), exp2(inf), exp2(127.0)), (0.125, 0.0, inf, 127_f32.exp2()));
        assert_eq!((log(1.0), log(0.0), log(inf)), (0.0, -inf, inf));
        assert_eq!((log2(8.0), log2(0.0), log2(inf)), (3.0, -inf, inf));
        assert!([exp, exp2, log, log2, sin, cos, tan, asin, acos, atan].iter().all(|f| f(nan).is_nan()));
        assert!([sinh, cosh, tanh, asinh, acosh, atanh].iter().all(|f| f(nan).is_nan()));
        assert!(log(-1.0).is_nan() && log2(-1.0).is_nan() && sin(inf).is_nan() && acosh(-inf).is_nan());
        let odd = [sin, tan, asin, atan, sinh, tanh, asinh, atanh];
        assert!(odd.iter().all(|f| f(-zero).to_bits() == (-zero).to_bits()));
        assert_eq!((atanh(1.0), atanh(-1.0), asinh(-inf), acosh(inf)), (inf, -inf, -inf, inf));
        assert_eq!((pow(0.0, 0.0), pow(inf, 0.0), pow(1.0, inf), pow(0.0, -1.0)), (1.0, 1.0, 1.0, inf));
        assert_eq!((pow(0.5, inf), pow(2.0, -inf), pow(inf, -1.0), pow(nan, 0.0)), (0.0, 0.0, 0.0, 1.0));
        assert!(pow(-1.0, 0.0).is_nan() && pow(nan, 1.0).is_nan() && pow(2.0, nan).is_nan());
    }

    /// Zeros, infinities and NaN: the quadrants and signs of f64's function.
    #[test]
    fn points_on_axes_have_their_angles() {
        let values = [0.0, -0.0, 1.0, -1.0, 1e-45, F::MAX, F::INFINITY, F::NEG_INFINITY, F::NAN];
        for (y, x) in values.iter().flat_map(|y| values.map(|x| (*y, x))) {
            let (found, wanted) = (atan2(y, x), libm::atan2(y.into(), x.into()) as f32);
            let same = found.to_bits() == wanted.to_bits() || found.is_nan() && wanted.is_nan();
            assert!(same, "{y:e}, {x:e}: {found:e}, {wanted:e}");
        }
    }

    /// Every 1021st float that the short ways take, and the last ones.
    #[test]
    fn finite_powers_are_the_same() {
        /// When the short way may be taken, and what it is.
        type Short = (fn(f32) -> bool, fn(f32) -> f32);
        let table: [(Short, Row); 2] = [
            ((finite::has_exp, |x| finite::exp([x; 2])[1]), (exp, libm::exp)),
            ((finite::has_exp2, |x| finite::exp2([x; 2])[1]), (exp2, libm::exp2)),
        ];
        for (row, ((has, short), (long, exact))) in table.into_iter().enumerate() {
            let last = (0..F::MAX.to_bits()).rev().map(F::from_bits).find(|x| has(*x)).unwrap_or(F::NAN);
            assert!(long(last).is_finite() && long(last.next_up()) == F::INFINITY, "{row}: {last}");
            let some = (0..=u32::MAX).step_by(1021).map(F::from_bits);
            for x in some.chain([last, F::NAN, -F::NAN, F::INFINITY, F::NEG_INFINITY]) {
                assert!(!has(x) || short(x).to_bits() == long(x).to_bits(), "{row}: {x:e}");
                assert_eq!(has(x), !x.is_nan() && exact(x.into()) as f32 != F::INFINITY, "{row}: {x:e}");
            }
        }
    }

    /// Angles of both kinds, and those that come closest to a whole quarter turn.
    #[test]
    fn ways_to_reduce_agree() {
        for x in (0..=u32::MAX).step_by(9973).map(F::from_bits).filter(|x| near::holds(*x)) {
            let [found, wanted] = [angle::far(x), angle::near(x)];
            let turned = found.quarters.wrapping_sub(wanted.quarters) as i64 % 4;
            let apart = (found.rest - wanted.rest).abs();
            assert!(turned == 0 && apart <= 1e-9 * wanted.rest.abs() || apart > 1.5, "{x:e}");
        }
    }
}
