//! The floats that models have numbers for: of 16, 32 and 64 bits.
//!
//! Models hold all of them as f64. Of doubles Vulkan says that they are no less precise than singles, and nothing else:
//! their results are rounded to 24 digits, with the range of f64.

use super::program::Scalar;
use super::program::op::FloatOp;
use super::scalar::{float, half};

/// A format, as a parameter of models.
pub(super) trait Precision: std::fmt::Debug + Clone + Copy + 'static {
    /// What programs call it.
    const SCALAR: Scalar;
    /// Digits of its numbers.
    const DIGITS: u32;
    /// One ULP, relative.
    const ULP: f64;
    /// Spacing of the subnormal numbers.
    const TINY: f64;
    /// Below this, numbers may be flushed.
    const MIN_NORMAL: f64;
    /// Largest finite number.
    const MAX: f64;
    /// Whether its numbers have more digits than are promised, and a range that products of f64 do not have.
    const IS_WIDE: bool = false;

    /// The number nearest to `x`, of as many digits as are promised.
    fn nearest(x: f64) -> f64;
    /// The largest such number that is not above `x`.
    fn down(x: f64) -> f64;
    /// The smallest such number that is not below `x`.
    fn up(x: f64) -> f64 {
        -Self::down(-x)
    }
    /// The result of an operation, as the interpreter has it.
    fn strict(op: FloatOp, args: [f64; 3]) -> f64;
    /// The number nearest to `x` as registers hold it.
    fn bits(x: f64) -> u64;
    /// The number that registers hold by these bits.
    fn of_bits(bits: u64) -> f64;
    /// The number nearest to `x`, of all digits.
    fn held(x: f64) -> f64 {
        Self::of_bits(Self::bits(x))
    }
    /// The number nearest to an integer, of all digits.
    fn of_integer(x: i128) -> f64;
}

/// f32.
#[derive(Debug, Clone, Copy)]
pub(super) struct Single;

/// f16.
#[derive(Debug, Clone, Copy)]
pub(super) struct Half;

/// f64.
#[derive(Debug, Clone, Copy)]
pub(super) struct Double;

impl Precision for Single {
    const SCALAR: Scalar = Scalar::F32;
    const DIGITS: u32 = 24;
    const ULP: f64 = 1.0 / (1 << 23) as f64;
    const TINY: f64 = 1.401298464324817e-45;
    const MIN_NORMAL: f64 = f32::MIN_POSITIVE as f64;
    const MAX: f64 = f32::MAX as f64;

    #[inline(always)]
    fn nearest(x: f64) -> f64 {
        (x as f32).into()
    }
    #[inline(always)]
    fn down(x: f64) -> f64 {
        let nearest = x as f32;
        f64::from(if f64::from(nearest) > x { nearest.next_down() } else { nearest })
    }
    #[inline(always)]
    fn strict(op: FloatOp, args: [f64; 3]) -> f64 {
        float::f32(op, args.map(|a| a as f32)).into()
    }
    #[inline(always)]
    fn bits(x: f64) -> u64 {
        (x as f32).to_bits().into()
    }
    #[inline(always)]
    fn of_bits(bits: u64) -> f64 {
        f32::from_bits(bits as u32).into()
    }
    fn of_integer(x: i128) -> f64 {
        (x as f32).into()
    }
}

impl Precision for Half {
    const SCALAR: Scalar = Scalar::F16;
    const DIGITS: u32 = 11;
    const ULP: f64 = 1.0 / (1 << 10) as f64;
    const TINY: f64 = 1.0 / (1 << 24) as f64;
    const MIN_NORMAL: f64 = 1.0 / (1 << 14) as f64;
    const MAX: f64 = half::MAX as f64;

    fn nearest(x: f64) -> f64 {
        half::round_f64(x).into()
    }
    fn down(x: f64) -> f64 {
        let nearest = half::round_f64(x);
        if f64::from(nearest) > x { next_down(nearest).into() } else { nearest.into() }
    }
    fn strict(op: FloatOp, args: [f64; 3]) -> f64 {
        float::f16(op, args.map(|a| a as f32)).into()
    }
    fn bits(x: f64) -> u64 {
        half::round_f64(x).to_bits().into()
    }
    fn of_bits(bits: u64) -> f64 {
        Single::of_bits(bits)
    }
    fn of_integer(x: i128) -> f64 {
        Self::nearest(x as f64)
    }
}

/// The next lower f16.
fn next_down(x: f32) -> f32 {
    let bits = half::to_bits(x);
    half::from_bits(match bits {
        0 => 0x8001,
        _ if bits >> 15 == 0 => bits - 1,
        _ => bits + 1,
    })
}

/// The bits of an f64 that an f32 has no room for.
const BEYOND: u64 = (1 << (f64::MANTISSA_DIGITS - f32::MANTISSA_DIGITS)) - 1;

impl Precision for Double {
    const SCALAR: Scalar = Scalar::F64;
    const DIGITS: u32 = 53;
    const ULP: f64 = Single::ULP;
    const TINY: f64 = f64::from_bits(BEYOND + 1);
    /// More than the smallest normal f64, so that what the arithmetic of models loses below that number does not count.
    const MIN_NORMAL: f64 = f64::from_bits((1023 - 900) << 52);
    const MAX: f64 = f64::MAX;
    const IS_WIDE: bool = true;

    fn nearest(x: f64) -> f64 {
        let (low, high) = (Self::down(x), Self::up(x));
        if high - x < x - low { high } else { low }
    }
    fn down(x: f64) -> f64 {
        if !x.is_finite() {
            return x;
        }
        // Towards zero, or away from it.
        let bits = if x < 0.0 { x.to_bits() + BEYOND } else { x.to_bits() };
        f64::from_bits(bits & !BEYOND)
    }
    fn strict(op: FloatOp, args: [f64; 3]) -> f64 {
        float::f64(op, args)
    }
    fn bits(x: f64) -> u64 {
        x.to_bits()
    }
    fn of_bits(bits: u64) -> f64 {
        f64::from_bits(bits)
    }
    fn of_integer(x: i128) -> f64 {
        x as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn encloses<P: Precision>(numbers: &[f64]) {
        for x in numbers.iter().flat_map(|x| [*x, -x]) {
            let (low, high) = (P::down(x), P::up(x));
            assert!(low <= x && x <= high, "{low:e} {x:e} {high:e}");
            assert!([low, high].contains(&P::nearest(x)), "{low:e} {x:e} {high:e}");
            assert!(high - low <= P::ULP * x.abs().max(P::MIN_NORMAL), "{low:e} {x:e} {high:e}");
            assert_eq!([P::down(low), P::up(low), P::down(high), P::up(high)], [low, low, high, high]);
        }
    }

    #[test]
    fn numbers_lie_between_their_neighbours() {
        let numbers = [0.0, 1.0, 1.0 / 3.0, 1e-3, 0.1, 2049.0, 2e-8, 6e-5, 6.2e-5, 65503.9];
        encloses::<Single>(&numbers);
        encloses::<Half>(&numbers);
        encloses::<Double>(&numbers);
        assert_eq!((Half::down(1e6), Half::up(1e6)), (Half::MAX, f64::INFINITY));
        assert_eq!((Double::down(0.5), Double::up(1e-320) > 0.0), (0.5, true));
    }
}
