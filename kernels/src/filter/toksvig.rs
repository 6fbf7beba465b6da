//! Mean direction of a lobe against its sharpness.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Toksvig05, Tokuyoshi15b};
use lobe_codegen::prelude::*;

/// By how much the mean direction of a lobe is shorter than 1.
///
/// `1 - |m| = 1/(k + 1)`
/// Source: [Toksvig05], [Tokuyoshi15b] section 2.1: `|m| = k/(k + 1)` ([`toksvig_length_paper`]).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `sharpness` | `k` | 0 ..= 1e6 | 1 |
///
/// Returns the spread, in 0 ..= 1: 1 for the constant lobe.
///
/// Numerics: this is what to store. The length itself has no room for a sharpness: in f32 the way to the length
/// and back loses 3e-4 of a sharpness of 1e4 and 1e-2 of 1e6. The model is not the lobe's own mean,
/// `coth k - 1/k`, which is 0.537 instead of 0.667 at `k = 2` and 0.900 instead of 0.909 at 10; it is the
/// clamped cosine's, though: a mean of 2/3 is a sharpness of 2.
#[kernel(family = "filter", cite = "[Toksvig05]", domain(sharpness = 0.0..=1e6), budget(6e-7 * result), measured)]
pub fn toksvig_spread(sharpness: f32) -> f32 {
    1.0 / (sharpness + 1.0)
}

/// Sharpness of the lobe whose mean direction is shorter than 1 by `spread`.
///
/// `k = (1 - u)/u`, the inverse of [`toksvig_spread`].
/// Source: [Toksvig05], [Tokuyoshi15b] section 2.1: `k = |m|/(1 - |m|)` ([`toksvig_sharpness_paper`]).
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `spread` | `u` | 1e-7 ..= 1 | 1 |
///
/// Returns the sharpness, at least 0; a spread below 1e-30 counts as that.
#[kernel(family = "filter", cite = "[Toksvig05]", domain(spread = 1e-7..=1.0), budget(6e-7 * result), measured)]
pub fn toksvig_sharpness(spread: f32) -> f32 {
    max(1.0 - spread, 0.0) / max(spread, 1e-30)
}

/// Length of the mean direction of a lobe, as printed.
///
/// `|m| = k/(k + 1)`
/// Source: [Tokuyoshi15b] section 2.1. Argument and domain as of [`toksvig_spread`].
///
/// Returns the length, in 0 ..= 1. It is right as a length, but near 1 it cannot hold what the sharpness was.
#[kernel(
    family = "filter",
    cite = "[Tokuyoshi15b] section 2.1",
    domain(sharpness = 0.0..=1e6),
    budget(6e-7 * result + 1e-37),
    variant_of = toksvig_spread,
    measured
)]
pub fn toksvig_length_paper(sharpness: f32) -> f32 {
    sharpness / (sharpness + 1.0)
}

/// Sharpness of the lobe whose mean direction has a length, as printed.
///
/// `k = |m|/(1 - |m|)`
/// Source: [Tokuyoshi15b] section 2.1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `len` | length of the mean direction, `|m|` | 0 ..= 0.999999 | 1 |
///
/// Returns the sharpness. The difference is exact for the length that is given; but a length that has been
/// rounded once, by 6e-8, moves the result by `6e-8 k` of itself: see [`moments_to_lobe_paper`].
///
/// [`moments_to_lobe_paper`]: crate::filter::moments_to_lobe_paper
#[kernel(
    family = "filter",
    cite = "[Tokuyoshi15b] section 2.1",
    domain(len = 0.0..=0.999999),
    budget(6e-7 * result + 1e-37),
    variant_of = toksvig_sharpness,
    measured
)]
pub fn toksvig_sharpness_paper(len: f32) -> f32 {
    len / max(1.0 - len, 1e-30)
}
