//! Sums, products and extremes of many numbers, in whatever order.
//!
//! In every order each of `n` numbers goes through at most `n - 1` steps, and each step errs by an ULP of what it
//! gives, and may flush what it takes and gives.

use super::Float;
use crate::interp::precision::Precision;
use naga::SubgroupOperation;

/// More than what the f64 arithmetic here errs for each number, relative.
const HAIR: f64 = 1.0 / (1_u64 << 48) as f64;

/// Numbers flushed for each that is taken: two operands and the result of its step, and of a step with a neutral element.
const FLUSHED: f64 = 6.0;

/// What drivers may make of `all`, where the strict result is `value`.
pub(super) fn collected<P: Precision>(op: SubgroupOperation, all: &[Float], value: f64) -> Float {
    let bounded = all.iter().all(|a| a.bounded());
    let result = match op {
        _ if !bounded => None,
        SubgroupOperation::Add => sum::<P>(all),
        SubgroupOperation::Mul => product::<P>(all),
        SubgroupOperation::Min => extreme(all, f64::min),
        SubgroupOperation::Max => extreme(all, f64::max),
        SubgroupOperation::All
        | SubgroupOperation::Any
        | SubgroupOperation::And
        | SubgroupOperation::Or
        | SubgroupOperation::Xor => None,
    };
    match result {
        Some((exact, low, high)) => Float::closed::<P>(value, exact, low, high),
        None => Float::unbounded(value, value),
    }
}

/// What `n` steps err by where no number is larger than `most`, and one that is flushed counts `times` as much.
fn error<P: Precision>(n: usize, most: f64, times: f64) -> f64 {
    let steps = (1.0 + P::ULP).powi(n.max(1) as i32 - 1) - 1.0;
    most * (steps + n as f64 * HAIR) + FLUSHED * n as f64 * P::MIN_NORMAL * times
}

fn magnitude(a: &Float) -> f64 {
    a.low.abs().max(a.high.abs())
}

/// Partial sums are no larger than the sum of magnitudes: if that may overflow, so may they.
fn sum<P: Precision>(all: &[Float]) -> Option<(f64, f64, f64)> {
    let whole: f64 = all.iter().map(magnitude).sum();
    let [exact, low, high] = [|a: &Float| a.exact, |a: &Float| a.low, |a: &Float| a.high]
        .map(|part| all.iter().map(part).sum::<f64>());
    let error = error::<P>(all.len(), whole, 1.0);
    // A sum has no other sign than all its numbers.
    let low =
        if low >= 0.0 && all.iter().all(|a| a.low >= 0.0) { (low - error).max(0.0) } else { low - error };
    let high =
        if high <= 0.0 && all.iter().all(|a| a.high <= 0.0) { (high + error).min(0.0) } else { high + error };
    (whole + error <= P::MAX).then_some((exact, low, high))
}

/// Partial products are no larger than the product of what is above 1, and so much counts what is flushed.
fn product<P: Precision>(all: &[Float]) -> Option<(f64, f64, f64)> {
    let most: f64 = all.iter().map(|a| magnitude(a).max(1.0)).product();
    let times = |(low, high): (f64, f64), a: &Float| {
        let corners = [low * a.low, low * a.high, high * a.low, high * a.high];
        corners.into_iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (x.min(l), x.max(h)))
    };
    let (low, high) = all.iter().fold((1.0, 1.0), times);
    let exact = all.iter().map(|a| a.exact).product();
    let error = error::<P>(all.len(), low.abs().max(high.abs()), most);
    (most + error <= P::MAX).then_some((exact, low - error, high + error))
}

fn extreme(all: &[Float], best: fn(f64, f64) -> f64) -> Option<(f64, f64, f64)> {
    let of = |part: fn(&Float) -> f64| all.iter().map(part).reduce(best);
    Some((of(|a| a.exact)?, of(|a| a.low)?, of(|a| a.high)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interp::precision::{Half, Single};

    /// A fixed sequence of numbers that look drawn.
    struct Drawn(u64);

    impl Drawn {
        fn below(&mut self, n: usize) -> usize {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 33) as usize % n
        }

        /// One of the floats around `x`, and perhaps zero for one that is subnormal.
        fn rounded<P: Precision>(&mut self, x: f64) -> f64 {
            let x = if x.abs() < P::MIN_NORMAL && self.below(2) == 0 { 0.0 } else { x };
            if self.below(2) == 0 { P::down(x) } else { P::up(x) }
        }
    }

    fn step(op: SubgroupOperation, a: f64, b: f64) -> f64 {
        match op {
            SubgroupOperation::Mul => a * b,
            SubgroupOperation::Min => a.min(b),
            SubgroupOperation::Max => a.max(b),
            _ => a + b,
        }
    }

    /// What a driver makes of the numbers, which takes any two together.
    fn driven<P: Precision>(op: SubgroupOperation, all: &[Float], drawn: &mut Drawn) -> f64 {
        let mut left: Vec<f64> = all.iter().map(|a| [a.low, a.high][drawn.below(2)]).collect();
        while left.len() > 1 {
            let a = left.swap_remove(drawn.below(left.len()));
            let b = left.swap_remove(drawn.below(left.len()));
            let [a, b] = [a, b].map(|x| drawn.rounded::<P>(x));
            left.push(drawn.rounded::<P>(step(op, a, b)));
        }
        left[0]
    }

    #[test]
    fn every_order_is_within_the_bound() {
        check::<Single>([1.0, 1e-36, 1e30, 2e-38]);
        check::<Half>([1.0, 1e-3, 300.0, 1e-4]);
    }

    fn check<P: Precision>(scales: [f64; 4]) {
        use SubgroupOperation as S;
        let mut drawn = Drawn(7);
        for round in 0..4000 {
            let op = [S::Add, S::Mul, S::Min, S::Max][round % 4];
            let count = 1 + drawn.below(32);
            let scale = scales[drawn.below(4)];
            let number = |drawn: &mut Drawn| {
                let x = P::nearest((drawn.below(2001) as f64 - 1000.0) / 700.0 * scale);
                let low = P::down(x.next_down());
                Float::closed::<P>(x, x, if drawn.below(2) == 0 { low } else { x }, x)
            };
            let all: Vec<Float> = (0..count).map(|_| number(&mut drawn)).collect();
            let bound = collected::<P>(op, &all, 0.0);
            for _ in 0..8 {
                let found = driven::<P>(op, &all, &mut drawn);
                assert!(
                    !bound.bounded() || (bound.low..=bound.high).contains(&found),
                    "{op:?} of {count}, round {round}: {found:e} is not in {:e} ..= {:e}",
                    bound.low,
                    bound.high
                );
            }
        }
    }

    #[test]
    fn bounds_are_of_the_size_of_what_is_rounded() {
        let ones = [Float::closed::<Single>(1.0, 1.0, 1.0, 1.0); 32];
        let sum = collected::<Single>(SubgroupOperation::Add, &ones, 32.0);
        let least = 31.0 * 32.0 * Single::ULP;
        assert!(sum.bound() > least && sum.bound() < 1.003 * least, "{}", sum.bound());
        let large = [Float::closed::<Single>(Single::MAX, Single::MAX, 0.0, Single::MAX); 2];
        assert!(!collected::<Single>(SubgroupOperation::Add, &large, f64::INFINITY).bounded());
        assert!(!collected::<Single>(SubgroupOperation::Mul, &large, f64::INFINITY).bounded());
    }
}
