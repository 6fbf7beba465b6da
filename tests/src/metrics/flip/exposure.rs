//! By which stops pictures of high range are shown, and how they become pictures for screens (Andersson et al. 2021).

use lobe_codegen::glam::Vec3;
use lobe_kernels::reference::running_mean::luminance;
use serde::Serialize;

/// A curve from radiance to what a screen shows.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum ToneMap {
    /// Narkowicz' fit to that of the Academy Color Encoding System.
    #[default]
    Aces,
    /// Hable's filmic curve.
    Hable,
    /// Reinhard's, of the luminance.
    Reinhard,
}

/// What the brightest pixel of the first exposure is shown as, and the median of the last.
const SHOWN: f64 = 0.85;
/// The least median: black pixels need no exposure of their own. As the authors' program has it; the paper does not say.
const LEAST_MEDIAN: f64 = f32::EPSILON as f64;

/// A picture that is nowhere brighter is black: no number brightens it to white.
const LEAST_LIGHT: f64 = 1e-37;

impl ToneMap {
    /// Coefficients of `(k0 x² + k1 x + k2) / (k3 x² + k4 x + k5)` (Andersson et al. 2021).
    fn coefficients(self) -> [f32; 6] {
        match self {
            Self::Aces => [0.9036, 0.018, 0.0, 0.8748, 0.354, 0.14],
            Self::Hable => [0.231_683, 0.013_791, 0.0, 0.18, 0.3, 0.018],
            Self::Reinhard => [0.0, 1.0, 0.0, 0.0, 1.0, 1.0],
        }
    }

    /// What is shown of a colour that is brightened by `stops`, in 0 ..= 1.
    pub(super) fn shown(self, colour: Vec3, stops: f32) -> Vec3 {
        // So bright a pixel is white by each curve, and its square is still a number.
        let bright = (colour.max(Vec3::ZERO) * stops.exp2()).min(Vec3::splat(1e15));
        let [k0, k1, k2, k3, k4, k5] = self.coefficients();
        let curve = |x: f32| ((k0 * x + k1) * x + k2) / ((k3 * x + k4) * x + k5);
        let shown = match self {
            Self::Reinhard => bright / (1.0 + luminance(bright)),
            Self::Aces | Self::Hable => bright.map(curve),
        };
        shown.clamp(Vec3::ZERO, Vec3::ONE)
    }

    /// The value that is shown as [`SHOWN`].
    fn inverse(self) -> f64 {
        let [k0, k1, k2, k3, k4, k5] = self.coefficients().map(f64::from);
        let (a, b, c) = (k0 - SHOWN * k3, k1 - SHOWN * k4, k2 - SHOWN * k5);
        match a == 0.0 {
            true => -c / b,
            false => (-b + (b * b - 4.0 * a * c).sqrt()) / (2.0 * a),
        }
    }
}

/// Stops from `start` to `stop`, evenly spaced.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Exposures {
    /// Where the brightest pixel is just below white.
    pub start: f32,
    /// Where the median is.
    pub stop: f32,
    /// How many there are, at least two, one a stop and one more at most.
    pub count: u32,
}

impl Exposures {
    /// Each of them.
    pub(super) fn stops(&self) -> impl Iterator<Item = f32> + use<> {
        let Self { start, stop, count } = *self;
        let last = count.saturating_sub(1).max(1) as f32;
        (0..count).map(move |i| start + i as f32 / last * (stop - start))
    }
}

/// The exposures at which a picture is to be looked at, by its luminance; of an even number of pixels the median is the upper
/// of the two in the middle. A black picture is looked at as it is.
#[must_use]
pub fn exposures(truth: &[Vec3], tone_map: ToneMap) -> Exposures {
    let mut luminances: Vec<f32> = truth.iter().map(|pixel| luminance(pixel.max(Vec3::ZERO))).collect();
    luminances.sort_by(f32::total_cmp);
    let brightest = luminances.last().copied().map_or(0.0, f64::from);
    if brightest <= LEAST_LIGHT {
        return Exposures { start: 0.0, stop: 0.0, count: 2 };
    }
    let median = f64::from(luminances[luminances.len() / 2]).max(LEAST_MEDIAN).min(brightest);
    let white = tone_map.inverse();
    let [start, stop] = [brightest, median].map(|value| (white / value).log2() as f32);
    Exposures { start, stop, count: (stop - start).ceil().max(2.0) as u32 }
}
