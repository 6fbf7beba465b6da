//! Elementary functions of our own: f32 arithmetic without branches, table or contraction.
//!
//! A loop over lanes that calls one of them becomes vector code on every instruction set, and since only
//! operations that IEEE 754 rounds correctly occur, in a fixed order, the bits are the same everywhere.
//! Selects stand where others branch; what an unselected side computes does not matter.
//! Results and arguments below the smallest normal number are flushed where a function says so: the shading
//! languages permit it, and processors are slow there.
//!
//! Polynomials were fitted by weighted least squares, iterated towards the smallest largest error.
//! `benches/elementary.rs` measures errors over all floats.

mod exponential;
mod logarithm;

pub use exponential::exp;
pub use logarithm::log;

/// `c[0] + c[1] x + ..`, from the highest power down.
#[inline(always)]
fn polynomial<const N: usize>(x: f32, c: [f32; N]) -> f32 {
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
    use super::{exp, log};

    type Row = (fn(f32) -> f32, fn(f64) -> f64);

    /// Every 251st float: no result further than 1 ULP from f64's, but for those that are flushed.
    #[test]
    fn functions_are_within_one_ulp() {
        let table: [Row; 2] = [(exp, libm::exp), (log, libm::log)];
        for (f, exact) in table {
            for x in (0..=u32::MAX).step_by(251).map(f32::from_bits) {
                let (found, wanted) = (f(x), exact(x.into()));
                let nearest = wanted as f32;
                let same = found == nearest || found.is_nan() && nearest.is_nan();
                let flushed = found == 0.0 && wanted.abs() <= f64::from(f32::MIN_POSITIVE);
                let ulp = f64::from(nearest.abs().next_up() - nearest.abs());
                let near = (f64::from(found) - wanted).abs() <= ulp;
                assert!(same || flushed || near, "{x:e}: {found:e}, {wanted:e}");
            }
        }
    }

    #[test]
    fn special_values_are_kept() {
        assert_eq!((exp(0.0), exp(f32::NEG_INFINITY), exp(f32::INFINITY)), (1.0, 0.0, f32::INFINITY));
        assert_eq!((log(1.0), log(0.0), log(f32::INFINITY)), (0.0, f32::NEG_INFINITY, f32::INFINITY));
        assert!(exp(f32::NAN).is_nan() && log(f32::NAN).is_nan() && log(-1.0).is_nan());
    }
}
