//! Filtering: averages of lobes and of positions that keep their digits.
//!
//! Lobes and positions are averaged the same way, by [`Moments`]: a weight, a mean relative to a point of the
//! caller's choice, and a spread that never comes out of a difference. In the order of use:
//!
//! 1. choose an origin near the positions and a reference near the lobes' mean directions: one for all that
//!    is merged;
//! 2. [`moments_of_position`], [`moments_of_lobe`] of each texel; [`moments_empty`] for none;
//! 3. [`moments_merge`] for two, [`moments_merge4`] for a step of a mip chain, in any order;
//! 4. [`planar_variance`] of the spread of positions, [`moments_to_lobe`] of lobes.
//!
//! A lobe of sharpness `k` counts by its mean direction, of length `k/(k + 1)` ([Toksvig05]).
//! [`toksvig_spread`] is what that lacks of 1, and [`toksvig_sharpness`] the way back: the same for a normal
//! map's normals.
//!
//! Conventions: weights are at least 0, and only their ratios matter to means and spreads; the spread of
//! positions is the trace of their covariance, that of lobes one less the square of the mean direction's
//! length. The forms that subtract, as printed, are kept as `.._paper`.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Toksvig05;

mod budget;
mod moments;
mod toksvig;

pub use budget::moments_distance4;
pub use moments::{
    Moments, moments_empty, moments_merge, moments_merge4, moments_of_lobe, moments_of_position,
    moments_to_lobe, moments_to_lobe_paper, moments_variance_paper, planar_variance,
};
pub use toksvig::{toksvig_length_paper, toksvig_sharpness, toksvig_sharpness_paper, toksvig_spread};
