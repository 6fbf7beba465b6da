//! Filtering: averages of lobes and of positions that keep their digits.
//!
//! Lobes and positions are averaged the same way, by [`Moments`]: a weight, a mean relative to a point of the
//! caller's choice, and a spread that never comes out of a difference.

mod moments;
mod toksvig;

pub use moments::{
    Moments, moments_distance4, moments_empty, moments_merge, moments_merge4, moments_of_lobe,
    moments_of_position, moments_to_lobe, moments_to_lobe_paper, moments_variance_paper, planar_variance,
};
pub use toksvig::{toksvig_length_paper, toksvig_sharpness, toksvig_sharpness_paper, toksvig_spread};
