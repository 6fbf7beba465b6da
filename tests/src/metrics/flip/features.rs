//! Edges and points: what the eye finds before it sees colours.

use super::filter::{Plane, scaled, taps};

/// Width of what the eye finds an edge, degrees.
const FEATURE_DEGREES: f64 = 0.082;
/// The exponent of a difference of features.
const FEATURE_POWER: f32 = 0.5;

/// A pixel's edge and point, lengths of the first and second derivative.
#[derive(Clone, Copy)]
pub(super) struct Feature {
    edge: f32,
    point: f32,
}

/// Derivatives of a Gaussian.
pub(super) struct Features {
    smooth: Vec<f32>,
    first: Vec<f32>,
    second: Vec<f32>,
}

impl Features {
    pub(super) fn new(pixels_per_degree: f32) -> Self {
        let sigma = 0.5 * FEATURE_DEGREES * f64::from(pixels_per_degree);
        let radius = (3.0 * sigma).ceil() as usize;
        let gauss = |x: f64| (-x * x / (2.0 * sigma * sigma)).exp();
        let smooth = taps(radius, gauss);
        let first = taps(radius, |x| -x * gauss(x));
        let second = taps(radius, |x| (x * x / (sigma * sigma) - 1.0) * gauss(x));
        Self {
            smooth: scaled(&smooth, smooth.iter().sum()),
            first: balanced(&first),
            second: balanced(&second),
        }
    }

    /// The features of a plane of luminance.
    pub(super) fn of(&self, luminance: &Plane) -> Vec<Feature> {
        let smooth = luminance.along_rows(&self.smooth);
        let length = |weights: &[f32]| {
            let across = luminance.along_rows(weights).along_columns(&self.smooth);
            let down = smooth.along_columns(weights);
            across.values.into_iter().zip(down.values).map(|(x, y)| x.hypot(y)).collect::<Vec<f32>>()
        };
        let (edges, points) = (length(&self.first), length(&self.second));
        edges.into_iter().zip(points).map(|(edge, point)| Feature { edge, point }).collect()
    }
}

/// Weights above 0 made to sum to 1, those below to -1.
fn balanced(weights: &[f64]) -> Vec<f32> {
    let sum = |sign: f64| weights.iter().map(|weight| (sign * weight).max(0.0)).sum::<f64>();
    let (above, below) = (sum(1.0), sum(-1.0));
    weights.iter().map(|weight| (weight / if *weight > 0.0 { above } else { below }) as f32).collect()
}

/// The difference of two features in 0 ..= 1 (Andersson et al. 2020).
pub(super) fn error(a: Feature, b: Feature) -> f32 {
    let gap = (a.edge - b.edge).abs().max((a.point - b.point).abs());
    (gap * std::f32::consts::FRAC_1_SQRT_2).powf(FEATURE_POWER).min(1.0)
}
