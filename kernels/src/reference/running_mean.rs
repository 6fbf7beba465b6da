//! Mean and standard error of a stream of samples.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Chan83, Pharr23, Welford62};
use lobe_codegen::prelude::*;

/// What is kept of a stream of numbers.
#[kernel]
pub struct RunningMean {
    /// How many there were.
    #[domain(0.0..=16777214.0)]
    pub count: u32,
    /// Their mean.
    #[domain(-1e4..=1e4)]
    pub mean: f32,
    /// Sum of their squared differences from the mean.
    #[domain(0.0..=1e12)]
    pub squares: f32,
}

/// Takes a number into a stream's running.
///
/// `mean' = mean + (x - mean)/n`, `squares' = squares + (x - mean)² (n - 1)/n`, `n` with the new number.
/// Source: [Welford62].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `running` | of what came before; all 0 for nothing | count below 2^24 | any |
/// | `value` | the number `x` | -1e4 ..= 1e4 | any |
///
/// Returns those of all.
///
/// Numerics: sums of squares of the numbers themselves cancel when the noise is small against the mean; here
/// nothing but differences from the mean is squared. The mean is rounded at every step, which adds up to
/// `6e-8 √n` of it: for more than some 1e5 numbers, [`running_mean_merge`] those of parts.
#[kernel(
    family = "reference",
    cite = "[Welford62]",
    domain(value = -1e4..=1e4),
    budget(
        mean = 6e-7 * (abs(running.mean) + abs(value) / (running.count as f32 + 1.0)) + 1e-37,
        squares = 1.5e-6 * result.squares + 1e-36
    ),
    measured
)]
pub fn running_mean_add(running: RunningMean, value: f32) -> RunningMean {
    let before = running.count as f32;
    let count = before + 1.0;
    let difference = value - running.mean;
    RunningMean {
        count: running.count + 1,
        mean: running.mean + difference / count,
        squares: running.squares + (difference * difference) * (before / count),
    }
}

/// Mean and squares of two streams together.
///
/// `mean = mean_a + d n_b/n`, `squares = squares_a + squares_b + d² n_a n_b/n`, `d = mean_b - mean_a`.
/// Source: [Chan83] eq. 2.1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `a`, `b` | of the streams; all 0 for an empty one | counts below 2^24 | any |
///
/// Returns those of all.
#[kernel(
    family = "reference",
    cite = "[Chan83] eq. 2.1",
    budget(mean = 1e-6 * (abs(a.mean) + abs(b.mean)) + 1e-37, squares = 2e-6 * result.squares + 1e-30),
    measured
)]
pub fn running_mean_merge(a: RunningMean, b: RunningMean) -> RunningMean {
    let difference = b.mean - a.mean;
    let share = b.count as f32 / max((a.count + b.count) as f32, 1.0);
    RunningMean {
        count: a.count + b.count,
        mean: a.mean + difference * share,
        squares: a.squares + b.squares + (difference * difference) * (a.count as f32 * share),
    }
}

/// Standard error of a stream's mean.
///
/// `√(squares/(n (n - 1)))`
/// Source: [Welford62].
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `running` | of the stream | count below 2^24 | any |
///
/// Returns the standard error, at least 0; for fewer than two numbers, which have none, the root of `squares`, 0.
#[kernel(family = "reference", cite = "[Welford62]", budget(3e-6 * result + 3e-19), measured)]
pub fn running_mean_standard_error(running: RunningMean) -> f32 {
    let count = running.count as f32;
    sqrt(running.squares / max(count, 1.0) / max(count - 1.0, 1.0))
}

/// Luminance of a colour.
///
/// `Y = 0.2126 R + 0.7152 G + 0.0722 B`
/// Source: [Pharr23] section 4.6.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `colour` | linear RGB of the primaries of sRGB | 0 ..= 1e4 | any |
///
/// Returns the luminance, in the colour's unit.
#[kernel(family = "reference", cite = "[Pharr23] section 4.6", domain(colour = 0.0..=1e4), budget(6e-7 * result + 1e-37), measured)]
pub fn luminance(colour: Vec3) -> f32 {
    dot(colour, Vec3::new(0.2126, 0.7152, 0.0722))
}
