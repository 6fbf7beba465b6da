//! Numbers on the edges of their type, where programs and drivers err most.

use super::feed;
use super::number;
use crate::domain::Rng;
use naga::{Scalar, ScalarKind};

/// A number on an edge, or an ordinary one; integers are ordinary, since programs count and index by them.
pub(super) fn number(scalar: Scalar, rng: &mut Rng) -> Vec<u8> {
    match scalar.kind {
        ScalarKind::Float => number::float_bytes(scalar.width, float(Range::of(scalar.width), rng)),
        _ => feed::number(scalar, rng),
    }
}

/// What a type of floats holds.
#[derive(Clone, Copy)]
struct Range {
    /// The smallest normal number.
    least: f64,
    /// Decimal digits of the largest.
    digits: f64,
    /// From 1 to the next.
    epsilon: f64,
}

impl Range {
    fn of(width: u8) -> Self {
        match width {
            2 => Self { least: 2f64.powi(-14), digits: 4.8, epsilon: 2f64.powi(-10) },
            4 => Self { least: f32::MIN_POSITIVE.into(), digits: 38.5, epsilon: f32::EPSILON.into() },
            _ => Self { least: f64::MIN_POSITIVE, digits: 308.2, epsilon: f64::EPSILON },
        }
    }
}

fn float(range: Range, rng: &mut Rng) -> f64 {
    let magnitude = match rng.below(8) {
        0 => 0.0,
        1 => range.least * rng.unit(),
        2 => 1.0 + range.epsilon * (rng.below(5) as f64 - 2.0),
        3 => rng.below(32) as f64 / 2.0,
        4 => 10f64.powf(rng.range(-range.digits, 0.0)),
        5 => 10f64.powf(rng.range(0.0, range.digits)),
        6 => 10f64.powf(rng.range(-4.0, 4.0)),
        _ => rng.unit(),
    };
    if rng.one_in(2) { -magnitude } else { magnitude }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_lie_on_every_edge_and_are_numbers() {
        for width in [2, 4, 8] {
            let scalar = Scalar { kind: ScalarKind::Float, width };
            let mut rng = Rng::new(1, "edges");
            let drawn: Vec<f64> =
                (0..4000).map(|_| number::float(width, &number(scalar, &mut rng))).collect();
            let least = Range::of(width).least;
            let has = |what: fn(f64, f64) -> bool| drawn.iter().any(|x| what(*x, least));
            assert!(drawn.iter().all(|x| x.is_finite()), "{width}");
            assert!(
                has(|x, _| x == 0.0 && x.is_sign_negative()) && has(|x, _| x == 0.0 && x.is_sign_positive())
            );
            assert!(has(|x, least| x != 0.0 && x.abs() < least), "{width}: no subnormal");
            assert!(has(|x, _| x == 1.0) && has(|x, _| x < -1000.0) && has(|x, _| x > 1000.0), "{width}");
        }
    }
}
