//! Weighted means and spreads, merged without cancellation.

use super::budget::moments_distance4;
use super::toksvig::{toksvig_length_paper, toksvig_sharpness_paper, toksvig_spread};
#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Chan83, Toksvig05, Tokuyoshi15, Tokuyoshi15b};
use crate::sg::Sg;
use lobe_codegen::prelude::*;

/// Weight, mean and spread of lobes or of positions.
///
/// Of positions the spread is the trace of their covariance; of lobes, one less the square of the length of
/// their mean direction.
#[kernel]
pub struct Moments {
    /// Sum of the weights, or their average: only ratios matter.
    #[domain(0.0..=1e6)]
    pub weight: f32,
    /// Weighted mean, less the origin or the reference direction that the caller has chosen.
    #[domain(-1e4..=1e4)]
    pub mean: Vec3,
    /// Weighted mean square of the distances from the mean; for lobes together with their widths.
    #[domain(0.0..=1e8)]
    pub spread: f32,
}

/// Moments of nothing; merged with others they change nothing.
///
/// Source: the definition.
///
/// Returns moments of weight 0.
#[kernel(family = "filter", cite = "definition", budget(0.0), measured)]
pub fn moments_empty() -> Moments {
    Moments { weight: 0.0, mean: Vec3::new(0.0, 0.0, 0.0), spread: 0.0 }
}

/// Moments of one position.
///
/// Mean `x - origin`, spread 0.
/// Source: [Tokuyoshi15b] section 2.2, relative to an origin.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `position` | `x` | -1e4 ..= 1e4 | length |
/// | `weight` | power times reflectance, as a luminance | 0 ..= 1e6 | any |
/// | `origin` | a point among the positions, the same for all that are merged | -1e4 ..= 1e4 | length |
///
/// Returns the moments.
///
/// Numerics: choose the origin near, say the first position or the middle of the shadow map's view. The mean
/// holds distances from it only, and so does what is lost when means are subtracted.
#[kernel(
    family = "filter",
    cite = "[Tokuyoshi15b] section 2.2",
    domain(position = -1e4..=1e4, weight = 0.0..=1e6, origin = -1e4..=1e4),
    budget(weight = 1e-37, mean = 2e-7 * length(position - origin) + 1e-37, spread = 0.0),
    measured
)]
pub fn moments_of_position(position: Vec3, weight: f32, origin: Vec3) -> Moments {
    Moments { weight, mean: position - origin, spread: 0.0 }
}

/// Moments of one lobe's directions.
///
/// With `u = 1/(k + 1)` ([`toksvig_spread`]) the mean direction is `m = (1 - u) v`; mean
/// `m - r = (1 - u) (v - r) - u r`, spread `1 - |m|² = u (2 - u)`.
/// Source: [Tokuyoshi15b] section 2.1 ([Toksvig05]), relative to a reference direction.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `axis` | unit axis `v` | sphere | 1 |
/// | `sharpness` | `k` | 0 ..= 1e6 | 1 |
/// | `weight` | power times reflectance, as a luminance | 0 ..= 1e6 | any |
/// | `reference` | `r`, a vector near the mean directions, the same for all that are merged | length up to 1 | 1 |
///
/// Returns the moments. The average of the paper's directions is `reference + mean`.
///
/// Numerics: a good reference is the mean direction of any of the lobes, `k/(k + 1) v`. The difference of near
/// vectors is exact, so sharp lobes about nearly one axis keep the digits of their spread, where the mean
/// direction itself would round to length 1. The zero vector will do for wide lobes.
#[kernel(
    family = "filter",
    cite = "[Tokuyoshi15b] section 2.1",
    domain(axis = unit, sharpness = 0.0..=1e6, weight = 0.0..=1e6, reference = -1.0..=1.0),
    budget(
        weight = 1e-37,
        mean = 8e-7 * (toksvig_length_paper(sharpness) * length(axis - reference) + toksvig_spread(sharpness) * length(reference)) + 1e-37,
        spread = 1.2e-6 * result.spread
    ),
    measured
)]
pub fn moments_of_lobe(axis: Vec3, sharpness: f32, weight: f32, reference: Vec3) -> Moments {
    let u = toksvig_spread(sharpness);
    let mean = toksvig_length_paper(sharpness) * (axis - reference) - u * reference;
    Moments { weight, mean, spread: u * (2.0 - u) }
}

/// Moments of two sets together.
///
/// With the shares `p` and `q` of the weights: mean `p a + q b`, spread `p A + q B + p q |a - b|²`.
/// Source: [Chan83] eq. 2.1; for directions it is the same identity, since
/// `|p a + q b|² = p |a|² + q |b|² - p q |a - b|²`.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `a`, `b` | moments about the same origin or reference | weight 0 ..= 1e6 | as of the moments |
///
/// Returns the moments of the union. Two empty sets give the empty set.
///
/// Numerics: a sum of terms that are not negative, so neither is the spread; the papers' mean of squares less
/// square of the mean ([`moments_variance_paper`]) is off by more than the value for spreads below 1e-3 of the
/// distance from the origin, and negative every other time.
#[kernel(
    family = "filter",
    cite = "[Chan83] eq. 2.1",
    budget(
        weight = 2e-7 * result.weight + 1e-37,
        mean = 7e-7 * (a.weight * length(a.mean) + b.weight * length(b.mean)) / max(a.weight + b.weight, 1e-20)
            + 1e-17 * (length(a.mean) + length(b.mean)) + 1e-37,
        spread = 2e-6 * result.spread + 1e-17 * (a.spread + b.spread + dot(a.mean - b.mean, a.mean - b.mean)) + 1e-37
    ),
    measured
)]
pub fn moments_merge(a: Moments, b: Moments) -> Moments {
    let weight = a.weight + b.weight;
    // The floor is for empty sets.
    let total = max(weight, 1e-20);
    let p = a.weight / total;
    let q = b.weight / total;
    let gap = b.mean - a.mean;
    Moments {
        weight,
        mean: p * a.mean + q * b.mean,
        spread: p * a.spread + q * b.spread + p * q * dot(gap, gap),
    }
}

/// Moments of four sets together: a step of a mip chain.
///
/// Source: [Tokuyoshi15] section 3.2, by [`moments_merge`].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `a`, `b`, `c`, `d` | moments about the same origin or reference | weight 0 ..= 1e6 | as of the moments |
///
/// Returns the moments of the union, in any order the same but for rounding. The weight is the sum; a mip level
/// may store a quarter of it.
///
/// Numerics: the means of the pairs are rounded, by 1e-7 of their distance from the origin: hence the budget's
/// root. For texels that lie as far apart as they lie from the origin it is 3e-6 of the spread.
#[kernel(
    family = "filter",
    cite = "[Tokuyoshi15] section 3.2",
    budget(
        weight = 4e-7 * result.weight + 1e-37,
        mean = 1.5e-6 * (a.weight * length(a.mean) + b.weight * length(b.mean) + c.weight * length(c.mean) + d.weight * length(d.mean))
            / max(a.weight + b.weight + c.weight + d.weight, 1e-20)
            + 1e-16 * (length(a.mean) + length(b.mean) + length(c.mean) + length(d.mean)) + 1e-37,
        spread = 3e-6 * result.spread + 3e-6 * sqrt(result.spread) * moments_distance4(a, b, c, d)
            + 3e-12 * moments_distance4(a, b, c, d) * moments_distance4(a, b, c, d)
            + 1e-16 * (a.spread + b.spread + c.spread + d.spread) + 1e-37
    ),
    measured
)]
pub fn moments_merge4(a: Moments, b: Moments, c: Moments, d: Moments) -> Moments {
    moments_merge(moments_merge(a, b), moments_merge(c, d))
}

/// The lobe that stands for the lobes of which these are the moments.
///
/// With the mean direction `m = reference + mean` and `1 - |m|² = spread`:
/// `k = |m|/(1 - |m|) = |m| (1 + |m|)/spread`, axis `m/|m|`.
/// Source: [Tokuyoshi15b] section 2.1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `moments` | of lobes ([`moments_of_lobe`]) | spread 1e-7 ..= 1 | 1 |
/// | `reference` | the reference direction of the moments | length up to 1 | 1 |
///
/// Returns the lobe, of amplitude 1. Where the lobes cancel, or there are none, the sharpness is 0 and the
/// axis has no meaning: it is shorter than 1, down to the zero vector.
///
/// Numerics: `1 - |m|` is `spread/(1 + |m|)`, so nothing is left of the cancellation that makes the paper's
/// form ([`moments_to_lobe_paper`]) lose a sharpness of 1e6 altogether.
#[kernel(
    family = "filter",
    cite = "[Tokuyoshi15b] section 2.1",
    domain(moments.mean = -1.0..=1.0, moments.spread = 1e-7..=1.0, reference = -1.0..=1.0),
    budget(
        axis = 1e-6 + 1e-6 / max(length(reference + moments.mean), 1e-6),
        sharpness = 1.6e-6 * (result.sharpness + 1.0 / max(moments.spread, 1e-12)),
        log_amplitude = 0.0
    ),
    measured
)]
pub fn moments_to_lobe(moments: Moments, reference: Vec3) -> Sg {
    // Fades to nothing as the weight does, below what `moments_merge` can tell from 0.
    let mean = min(1e20 * moments.weight, 1.0) * (reference + moments.mean);
    let len = length(mean);
    Sg {
        axis: mean / max(len, 1e-6),
        sharpness: len * ((1.0 + len) / max(moments.spread, 1e-12)),
        log_amplitude: 0.0,
    }
}

/// The lobe that stands for lobes with this average direction, as printed.
///
/// Sharpness `|m|/(1 - |m|)`, axis `m/|m|`. Source: [Tokuyoshi15b] section 2.1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `mean` | the average `m` of the directions | length up to 0.9994 | 1 |
///
/// Returns the lobe, of amplitude 1.
///
/// Numerics: `1 - |m|` has an error of 1e-7 whatever it is, so a sharpness of 1e4 is off by 1e-3 and one of
/// 1e6 by its whole value; at a length of 1 it is 0/0 in the end. [`moments_to_lobe`] keeps the spread apart.
#[kernel(
    family = "filter",
    cite = "[Tokuyoshi15b] section 2.1",
    domain(mean = -0.577..=0.577),
    budget(
        axis = 1e-6 + 1e-6 / max(length(mean), 1e-6),
        sharpness = 3e-6 * (result.sharpness + 1.0),
        log_amplitude = 0.0
    ),
    variant_of = moments_to_lobe,
    not_robust = "1 - |m| cancels for sharp lobes",
    measured
)]
pub fn moments_to_lobe_paper(mean: Vec3) -> Sg {
    let len = length(mean);
    Sg { axis: mean / max(len, 1e-6), sharpness: toksvig_sharpness_paper(len), log_amplitude: 0.0 }
}

/// Variance of positions, as printed.
///
/// `E|x|² - |E x|²`
/// Source: [Tokuyoshi15] section 3.2, [Tokuyoshi15b] section 2.2.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `mean_of_squares` | `E|x|²` | 0 ..= 3e8 | length² |
/// | `mean` | `E x` | -1e4 ..= 1e4 | length |
///
/// Returns the trace of the covariance, or what is left of it: negative for many positions that are close
/// together and far from the origin. [`moments_merge`] does not subtract.
#[kernel(
    family = "filter",
    cite = "[Tokuyoshi15] section 3.2",
    domain(mean_of_squares = 0.0..=3e8, mean = -1e4..=1e4),
    budget(2e-6 * abs(result) + 1e-30),
    variant_of = moments_merge,
    not_robust = "a difference of near values, far from the origin",
    measured
)]
pub fn moments_variance_paper(mean_of_squares: f32, mean: Vec3) -> f32 {
    mean_of_squares - dot(mean, mean)
}

/// Variance along one axis of positions on a plane.
///
/// Half the trace of their covariance.
/// Source: [Tokuyoshi15b] section 2.2, corrected.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `trace` | [`Moments::spread`] of positions | 0 ..= 1e8 | length² |
///
/// Returns the variance, at least 0.
///
/// [Tokuyoshi15b] takes the trace itself for the variance of its isotropic Gaussian, whose normalisation
/// `1/(2π s²)` means the variance along each axis. With the trace, a disk of VPLs with radius 0.1, 0.3 and 1
/// times the distance gives 0.968, 0.930 and 0.731 of the light that the VPLs give, with half of it 0.975,
/// 0.985 and 1.067.
#[kernel(family = "filter", cite = "[Tokuyoshi15b] section 2.2", domain(trace = 0.0..=1e8), budget(1e-37), measured)]
pub fn planar_variance(trace: f32) -> f32 {
    0.5 * trace
}
