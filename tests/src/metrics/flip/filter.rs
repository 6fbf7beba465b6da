//! Planes, separable filters, and those that stand for the eye's sensitivity to contrast.

use rayon::prelude::*;
use std::f64::consts::PI;

/// Pixels that a thread takes at once, at least.
pub(super) const GRAIN: usize = 2048;

/// A number for each pixel, row by row.
pub(super) struct Plane {
    pub(super) width: usize,
    pub(super) values: Vec<f32>,
}

impl Plane {
    pub(super) fn new(width: usize, values: Vec<f32>) -> Self {
        Self { width, values }
    }

    /// The same of each number by itself.
    pub(super) fn map(&self, f: impl Fn(f32) -> f32) -> Self {
        Self::new(self.width, self.values.iter().map(|value| f(*value)).collect())
    }

    /// So many rows that a thread's share is worth its start.
    fn rows_at_once(&self) -> usize {
        GRAIN.div_ceil(self.width)
    }

    /// Filtered along rows; beyond an edge is what lies at it.
    pub(super) fn along_rows(&self, weights: &[f32]) -> Self {
        let radius = weights.len() / 2;
        let mut values = vec![0.0; self.values.len()];
        let rows = values.par_chunks_mut(self.width).zip(self.values.par_chunks(self.width));
        rows.with_min_len(self.rows_at_once()).for_each_init(Vec::new, |wide, (out, row)| {
            wide.clear();
            wide.extend(std::iter::repeat_n(row[0], radius));
            wide.extend_from_slice(row);
            wide.extend(std::iter::repeat_n(row[row.len() - 1], radius));
            for (at, weight) in weights.iter().enumerate() {
                add(out, &wide[at..], *weight);
            }
        });
        Self::new(self.width, values)
    }

    /// The same along columns.
    pub(super) fn along_columns(&self, weights: &[f32]) -> Self {
        let (radius, height) = (weights.len() / 2, self.values.len() / self.width);
        let mut values = vec![0.0; self.values.len()];
        let rows = values.par_chunks_mut(self.width).with_min_len(self.rows_at_once());
        rows.enumerate().for_each(|(y, out)| {
            for (at, weight) in weights.iter().enumerate() {
                let row = (y + at).saturating_sub(radius).min(height - 1);
                add(out, &self.values[row * self.width..], *weight);
            }
        });
        Self::new(self.width, values)
    }
}

/// Adds `weight` times the first of `values` to each of `out`.
fn add(out: &mut [f32], values: &[f32], weight: f32) {
    out.iter_mut().zip(values).for_each(|(out, value)| *out += weight * value);
}

/// A function's values at -radius ..= radius.
pub(super) fn taps(radius: usize, f: impl Fn(f64) -> f64) -> Vec<f64> {
    (-(radius as i64)..=radius as i64).map(|x| f(x as f64)).collect()
}

/// `weights` over `sum`, in single precision.
pub(super) fn scaled(weights: &[f64], sum: f64) -> Vec<f32> {
    weights.iter().map(|weight| (weight / sum) as f32).collect()
}

/// Sensitivity of a channel as `a1 √(π / b1) exp(-π² r² / b1) + a2 ..`, r in degrees: `[a1, b1]`, `[a2, b2]`
/// (Andersson et al. 2020).
const SENSITIVITIES: [[[f64; 2]; 2]; 3] =
    [[[1.0, 0.0047], [0.0, 1e-5]], [[1.0, 0.0053], [0.0, 1e-5]], [[34.1, 0.04], [13.5, 0.025]]];
/// The widest `b`, which decides where all filters are cut off.
const WIDEST: f64 = 0.04;

/// One Gaussian of a channel: its share, and its weights along a line, which sum to one.
struct Gaussian {
    share: f32,
    weights: Vec<f32>,
}

/// Filters of three channels.
pub(super) struct Contrast([Vec<Gaussian>; 3]);

impl Contrast {
    pub(super) fn new(pixels_per_degree: f32) -> Self {
        let per_degree = f64::from(pixels_per_degree);
        let radius = (3.0 * (WIDEST / (2.0 * PI * PI)).sqrt() * per_degree).ceil() as usize;
        Self(SENSITIVITIES.map(|terms| {
            let lines: Vec<(f64, Vec<f64>)> = terms
                .into_iter()
                .filter(|[a, _]| *a > 0.0)
                .map(|[a, b]| {
                    let weights = taps(radius, |x| (-(PI * x / per_degree).powi(2) / b).exp());
                    let sum: f64 = weights.iter().sum();
                    // The sum over the plane is the square of that over a line.
                    (a * (PI / b).sqrt() * sum * sum, weights.iter().map(|weight| weight / sum).collect())
                })
                .collect();
            let total: f64 = lines.iter().map(|(volume, _)| volume).sum();
            lines
                .into_iter()
                .map(|(volume, weights)| Gaussian {
                    share: (volume / total) as f32,
                    weights: scaled(&weights, 1.0),
                })
                .collect()
        }))
    }

    /// The channels as the eye takes them in.
    pub(super) fn filtered(&self, planes: &[Plane; 3]) -> [Plane; 3] {
        [0, 1, 2].map(|channel| {
            let plane = &planes[channel];
            let mut sum = Plane::new(plane.width, vec![0.0; plane.values.len()]);
            for Gaussian { share, weights } in &self.0[channel] {
                add(&mut sum.values, &plane.along_rows(weights).along_columns(weights).values, *share);
            }
            sum
        })
    }
}
