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

/// A word near another of the values: a few representable numbers on, a share of it or of the range away, at an edge,
/// or anywhere.
pub(super) fn near(scalar: Scalar, values: &Values, from: u32, rng: &mut Rng) -> u32 {
    let Values::Range(lo, hi) = *values else {
        return random(scalar, values, rng);
    };
    let share = 10f64.powf(-7.0 * rng.unit()) * rng.normal();
    let steps = 2f64.powf(20.0 * rng.unit()).floor() * if rng.one_in(2) { 1.0 } else { -1.0 };
    match (rng.below(8), scalar) {
        (0, _) => {
            let edges = edges(scalar, values);
            edges[rng.below(edges.len())]
        }
        (1, _) => random(scalar, values, rng),
        (2 | 3, Scalar::F32) => {
            stepped(f32::from_bits(from), steps as i32).clamp(lo as f32, hi as f32).to_bits()
        }
        (4..=6, Scalar::F32) => finish(scalar, lo, hi, f64::from(f32::from_bits(from)) * (1.0 + share)),
        (_, Scalar::F32) => finish(scalar, lo, hi, f64::from(f32::from_bits(from)) + (hi - lo) * share),
        (_, Scalar::I32) => finish(scalar, lo, hi, f64::from(from as i32) + steps),
        (_, Scalar::U32 | Scalar::Bool) => finish(scalar, lo, hi, f64::from(from) + steps),
    }
}

/// The float so many representable numbers on, among finite ones.
fn stepped(from: f32, steps: i32) -> f32 {
    // In order of value: the bits of a negative number count down.
    let order = |bits: i32| if bits < 0 { i32::MIN - bits } else { bits };
    let most = order(f32::MAX.to_bits() as i32);
    let to = order(from.to_bits() as i32).saturating_add(steps).clamp(-most, most);
    f32::from_bits(order(to) as u32)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_count_representable_numbers_through_zero() {
        assert_eq!(stepped(1.0, 1), 1.0f32.next_up());
        assert_eq!(stepped(-1.0, 1), (-1.0f32).next_up());
        assert_eq!(stepped(f32::from_bits(1), -2), -f32::from_bits(1));
        assert_eq!(stepped(f32::MAX, 5), f32::MAX);
    }

    #[test]
    fn what_is_near_stays_in_the_range() {
        let mut rng = Rng::new(7, "near");
        let values = Values::Range(-0.5, 3.0);
        let mut x = 1.0f32.to_bits();
        for _ in 0..10_000 {
            x = near(Scalar::F32, &values, x, &mut rng);
            assert!((-0.5..=3.0).contains(&f32::from_bits(x)), "{}", f32::from_bits(x));
        }
    }
}
