//! All metrics of a pair, for people and programs.

use super::flip::{self, Exposures, PIXELS_PER_DEGREE, ToneMap, exposures};
use super::{Map, Pair, Pooled, Radiometry, Range, radiometry};
use serde::Serialize;
use std::fmt;

/// How the pictures are looked at.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Viewing {
    /// Pixels in a degree of the eye's angle.
    pub pixels_per_degree: f32,
    /// Of pictures of high range, what makes them pictures for a screen.
    pub tone_map: ToneMap,
}

impl Default for Viewing {
    fn default() -> Self {
        Self { pixels_per_degree: PIXELS_PER_DEGREE, tone_map: ToneMap::default() }
    }
}

/// How a picture of high range was shown.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HighRange {
    /// The curve.
    pub tone_map: ToneMap,
    /// The stops.
    #[serde(flatten)]
    pub exposures: Exposures,
}

/// What is known of a pair.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// Columns and rows.
    pub size: [u32; 2],
    /// How much light there is.
    #[serde(flatten)]
    pub radiometry: Radiometry,
    /// FLIP, pooled.
    pub flip: Pooled,
    /// Pixels in a degree of the eye's angle.
    pub pixels_per_degree: f32,
    /// How they were shown, of pictures of high range: HDR-FLIP; none of LDR-FLIP.
    pub shown: Option<HighRange>,
    /// FLIP of each pixel.
    #[serde(skip)]
    pub map: Map,
}

/// Compares a pair.
#[must_use]
pub fn compare(pair: &Pair<'_>, range: Range, viewing: &Viewing) -> Comparison {
    let Viewing { pixels_per_degree, tone_map } = *viewing;
    let shown = match range {
        Range::Low => None,
        Range::High => Some(HighRange { tone_map, exposures: exposures(pair.truth(), tone_map) }),
    };
    let map = match &shown {
        None => flip::ldr(pair, pixels_per_degree),
        Some(shown) => flip::hdr(pair, pixels_per_degree, shown.tone_map, &shown.exposures),
    };
    Comparison {
        size: pair.size(),
        radiometry: radiometry(pair),
        flip: map.pooled(),
        pixels_per_degree,
        shown,
        map,
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Radiometry { mean_ratio, relative_rmse, worst } = &self.radiometry;
        let ratio = |value: &Option<f64>| match value {
            Some(value) => format!("{value:.4}"),
            None => "none: the truth is black".to_owned(),
        };
        writeln!(f, "mean ratio     {}", ratio(mean_ratio))?;
        writeln!(f, "relative RMSE  {}", ratio(relative_rmse))?;
        let Pooled { mean, first_quartile, weighted_median, third_quartile, max } = self.flip;
        let name = if self.shown.is_some() { "HDR-FLIP" } else { "LDR-FLIP" };
        write!(f, "{name}       {mean:.4} in the mean, weighted median {weighted_median:.4} ")?;
        writeln!(f, "({first_quartile:.4} to {third_quartile:.4}), at most {max:.4}")?;
        let [[r, g, b], [wanted_r, wanted_g, wanted_b]] = [worst.picture, worst.truth];
        write!(f, "worst pixel    column {}, row {}: {r:.4e} {g:.4e} {b:.4e} ", worst.x, worst.y)?;
        writeln!(f, "for {wanted_r:.4e} {wanted_g:.4e} {wanted_b:.4e}")
    }
}
