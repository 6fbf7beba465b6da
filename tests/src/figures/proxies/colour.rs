//! A colour for each rectangle.

/// The golden angle, rad: hues that follow each other are far apart, and none returns soon.
const STEP: f64 = 2.399_963;

/// Linear light of the `index`-th hue, by lightness and chroma of OKLCH.
pub(super) fn hue(index: usize, lightness: f64, chroma: f64) -> [f32; 3] {
    let (sine, cosine) = (STEP * index as f64 + 0.5).sin_cos();
    let (a, b) = (chroma * cosine, chroma * sine);
    let cone = |by_a: f64, by_b: f64| (lightness + by_a * a + by_b * b).powi(3);
    let (l, m, s) = (
        cone(0.396_337_777_4, 0.215_803_757_3),
        cone(-0.105_561_345_8, -0.063_854_172_8),
        cone(-0.089_484_177_5, -1.291_485_548),
    );
    [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701 * s,
    ]
    .map(|light| light.clamp(0.0, 1.0) as f32)
}
