//! A number for each pixel, pooled, and as a picture to look at.

use crate::render::{FileError, png_of};
use serde::{Deserialize, Serialize};

/// A number in 0 ..= 1 for each pixel, row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    /// Columns and rows.
    pub size: [u32; 2],
    /// The numbers.
    pub values: Vec<f32>,
}

/// What a map comes to.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Pooled {
    /// The mean of all pixels.
    pub mean: f64,
    /// Pixels of at most this value make up a quarter of the sum of all.
    pub first_quartile: f32,
    /// Those that make up half of it.
    pub weighted_median: f32,
    /// Those that make up three quarters.
    pub third_quartile: f32,
    /// The largest value.
    pub max: f32,
}

impl Map {
    /// Its mean, and its quartiles weighted by the values themselves (Andersson et al. 2020): where a few pixels are wrong
    /// and most are right, an unweighted median would say nothing of the few.
    #[must_use]
    pub fn pooled(&self) -> Pooled {
        let mut sorted = self.values.clone();
        sorted.sort_by(f32::total_cmp);
        let sum: f64 = sorted.iter().map(|value| f64::from(*value)).sum();
        let weighted = |share: f64| {
            let mut below = 0.0;
            let reached = sorted.iter().find(|value| {
                below += f64::from(**value);
                below >= share * sum
            });
            reached.or(sorted.last()).copied().unwrap_or(0.0)
        };
        Pooled {
            mean: sum / sorted.len().max(1) as f64,
            first_quartile: weighted(0.25),
            weighted_median: weighted(0.5),
            third_quartile: weighted(0.75),
            max: sorted.last().copied().unwrap_or(0.0),
        }
    }

    /// The map as a PNG file in the colour map magma: black is 0, a pale yellow 1, and lightness grows all the way.
    ///
    /// # Errors
    /// When the map has no size.
    pub fn png(&self) -> Result<Vec<u8>, FileError> {
        let colour =
            |value: &f32| colorous::MAGMA.eval_continuous(f64::from(value.clamp(0.0, 1.0))).as_array();
        png_of(self.size, &self.values.iter().flat_map(colour).collect::<Vec<u8>>())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_are_weighted() {
        // Sum 8: the zeros weigh nothing, the first four ones reach a half.
        let values = vec![0.0, 1.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0];
        let pooled = Map { size: [11, 1], values }.pooled();
        assert_eq!((pooled.first_quartile, pooled.weighted_median, pooled.max), (1.0, 1.0, 1.0));
        assert!((pooled.mean - 8.0 / 11.0).abs() < 1e-12);
        let few = Map { size: [4, 1], values: vec![0.3, 0.1, 0.2, 0.4] }.pooled();
        assert_eq!((few.first_quartile, few.weighted_median, few.third_quartile), (0.2, 0.3, 0.4));
        let black = Map { size: [2, 1], values: vec![0.0; 2] }.pooled();
        assert_eq!((black.mean, black.weighted_median), (0.0, 0.0));
    }

    #[test]
    fn colours_grow_lighter() {
        let map = Map { size: [256, 1], values: (0..256).map(|i| i as f32 / 255.0).collect() };
        let bytes = map.png().unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        let light = |rgb: &[u8]| 3 * u32::from(rgb[0]) + 10 * u32::from(rgb[1]) + u32::from(rgb[2]);
        let lights: Vec<u32> = pixels.chunks(3).map(light).collect();
        assert!(lights.windows(9).all(|w| w[8] > w[0]), "{lights:?}");
    }
}
