//! Numbers out of a range: its edges, evenly spaced, random.

use super::rng::Rng;
use super::slot::{Values, word};
use lobe_codegen::def::Scalar;

/// Ratio beyond which a range is drawn by its exponents too.
const WIDE: f64 = 100.0;

/// The words at which something may change: ends and their neighbours, zeros, the smallest normal and
/// subnormals, one, powers of two and ten.
pub(super) fn edges(scalar: Scalar, values: &Values) -> Vec<u32> {
    let (lo, hi) = match values {
        Values::Listed(list) => return list.iter().map(|v| word(scalar, *v)).collect(),
        Values::Range(lo, hi) => (*lo, *hi),
    };
    let mut words: Vec<u32> = match scalar {
        Scalar::F32 => float_edges(lo as f32, hi as f32),
        Scalar::I32 | Scalar::U32 | Scalar::Bool => integer_edges(scalar, lo, hi),
    };
    let mut seen = std::collections::HashSet::new();
    words.retain(|w| seen.insert(*w));
    words
}

fn float_edges(lo: f32, hi: f32) -> Vec<u32> {
    let tiny = [0.0, f32::MIN_POSITIVE, f32::from_bits(1), 1e-40, 1e-30, 1e-20, 1e-10];
    let plain = [1.0, 0.5, 2.0, 3.0, 10.0, 16.0, 100.0, 1e3, 65536.0, 1e5, 1e6, 1e10, 1e20, 1e30];
    let near = [1.0 - f32::EPSILON / 2.0, 1.0 + f32::EPSILON, 1e-3, 0.015625, 1e-6, 1e-7];
    let magnitudes = tiny.into_iter().chain(plain).chain(near);
    let inner = magnitudes.flat_map(|m| [m, -m]);
    let all = [lo, hi, lo.next_up(), hi.next_down()].into_iter().chain(inner);
    // `-0.0` lies in a range that begins at `0.0`: IEEE says that they are equal.
    all.filter(|v| (lo..=hi).contains(v)).map(f32::to_bits).collect()
}

fn integer_edges(scalar: Scalar, lo: f64, hi: f64) -> Vec<u32> {
    let inner = [0.0, 1.0, -1.0, 2.0, 3.0, 7.0, 8.0, 31.0, 32.0, 255.0, 256.0, 65535.0, 65536.0];
    let all = [lo, hi, lo + 1.0, hi - 1.0].into_iter().chain(inner);
    all.filter(|v| (lo..=hi).contains(v)).map(|v| word(scalar, v)).collect()
}

/// The word at `fraction` (0 to 1) of the way through the values, by exponent when `by_exponent`.
pub(super) fn at(scalar: Scalar, values: &Values, fraction: f64, by_exponent: bool) -> u32 {
    match values {
        Values::Listed(list) => {
            let index = (fraction * list.len() as f64) as usize;
            word(scalar, list[index.min(list.len() - 1)])
        }
        Values::Range(lo, hi) if by_exponent && is_wide(*lo, *hi) => {
            finish(scalar, *lo, *hi, exponential(*lo, *hi, fraction))
        }
        Values::Range(lo, hi) => finish(scalar, *lo, *hi, lo + (hi - lo) * fraction),
    }
}

/// A random word of the values.
pub(super) fn random(scalar: Scalar, values: &Values, rng: &mut Rng) -> u32 {
    let (fraction, by_exponent) = (rng.unit(), !rng.one_in(3));
    at(scalar, values, fraction, by_exponent)
}

fn is_wide(lo: f64, hi: f64) -> bool {
    (lo <= 0.0 && hi >= 0.0 && lo < hi) || lo.abs().max(hi.abs()) > WIDE * lo.abs().min(hi.abs())
}

/// Log-uniform over the magnitudes of the range, both signs where it has both.
fn exponential(lo: f64, hi: f64, fraction: f64) -> f64 {
    let (largest_negative, largest_positive) = (-lo.min(0.0), hi.max(0.0));
    if largest_negative > 0.0 && largest_positive > 0.0 {
        let (sign, largest) = if fraction < 0.5 { (-1.0, largest_negative) } else { (1.0, largest_positive) };
        return sign * between(0.0, largest, (2.0 * fraction).fract());
    }
    if hi > 0.0 { between(lo, hi, fraction) } else { -between(-hi, -lo, fraction) }
}

/// From `smallest` to `largest` by exponent. A range that reaches 0 is entered twelve decades deep, and
/// once in eight times down to the smallest normal number.
fn between(smallest: f64, largest: f64, fraction: f64) -> f64 {
    let deep = fraction < 0.125;
    let floor = if deep { f64::from(f32::MIN_POSITIVE) } else { largest * 1e-12 };
    let begin = smallest.max(floor).min(largest);
    let fraction = if deep { fraction * 8.0 } else { (fraction - 0.125) / 0.875 };
    begin * (largest / begin).powf(fraction)
}

/// Rounds to the scalar's kind without leaving the range.
fn finish(scalar: Scalar, lo: f64, hi: f64, value: f64) -> u32 {
    match scalar {
        Scalar::F32 => (value as f32).clamp(lo as f32, hi as f32).to_bits(),
        Scalar::I32 | Scalar::U32 | Scalar::Bool => word(scalar, value.round().clamp(lo, hi)),
    }
}
