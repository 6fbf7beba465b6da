//! Filtered samples, gathered and compared ones.

use super::address::{self, Pair};
use super::lod::{self, Lod};
use super::{Texels, cube};
use crate::texture::{Dimension, Filter, Format, Sampler};

/// One sample.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample<'s> {
    pub(crate) sampler: &'s Sampler,
    pub(crate) coordinates: [f32; 3],
    /// Clamped to those that there are.
    pub(crate) layer: i64,
    pub(crate) lod: Lod,
    /// In texels, added before edges are regarded.
    pub(crate) offset: [i32; 3],
    /// What depths are compared with.
    pub(crate) reference: Option<f32>,
    /// The channel to gather.
    pub(crate) gather: Option<usize>,
    /// Keeps coordinates half a texel away from the edges.
    pub(crate) clamp_to_edge: bool,
}

/// The four channels of a sample.
pub(crate) fn sample(texels: &impl Texels, sample: &Sample<'_>) -> [f32; 4] {
    let spot = Spot::new(texels, sample);
    if let Some(channel) = sample.gather {
        return spot.gather(channel);
    }
    let levels = lod::levels(&texels.shape(), sample.sampler, sample.lod, sample.coordinates);
    let mut sum = spot.filter(levels.first, levels.filter);
    if let Some((second, weight)) = levels.second {
        let next = spot.filter(second, levels.filter);
        for (a, b) in sum.iter_mut().zip(next) {
            *a = mix(*a, b, weight);
        }
    }
    sum.map(|n| n as f32)
}

/// Equal sides keep their value, infinite ones too.
fn mix(a: f64, b: f64, weight: f64) -> f64 {
    if a == b || weight == 0.0 { a } else { a * (1.0 - weight) + b * weight }
}

/// Where a sample is taken: cubes are unfolded to their faces.
pub(super) struct Spot<'s, T> {
    pub(super) texels: &'s T,
    pub(super) sample: &'s Sample<'s>,
    layer: u32,
    coordinates: [f32; 3],
    face: Option<u32>,
    reference: Option<f32>,
}

impl<'s, T: Texels> Spot<'s, T> {
    pub(super) fn new(texels: &'s T, sample: &'s Sample<'s>) -> Self {
        let shape = texels.shape();
        let cube = matches!(shape.dimension, Dimension::Cube | Dimension::CubeArray);
        let layers = if cube { shape.layers / 6 } else { shape.layers };
        let layer = sample.layer.clamp(0, i64::from(layers) - 1) as u32;
        // Depths that are fixed point are compared as such.
        let clamp = |reference: f32| {
            if shape.format == Format::Depth16Unorm { reference.clamp(0.0, 1.0) } else { reference }
        };
        let mut spot = Self {
            texels,
            sample,
            layer,
            coordinates: sample.coordinates,
            face: None,
            reference: sample.reference.map(clamp),
        };
        if cube {
            let met = cube::meet(sample.coordinates);
            (spot.face, spot.coordinates) = (Some(met.face), [met.place[0], met.place[1], 0.0]);
        }
        if sample.clamp_to_edge {
            for axis in 0..2 {
                let half = 0.5 / shape.size[axis] as f32;
                spot.coordinates[axis] = spot.coordinates[axis].clamp(half, 1.0 - half);
            }
        }
        spot
    }

    /// Whether it is on a face of a cube.
    pub(super) fn is_cube(&self) -> bool {
        self.face.is_some()
    }

    pub(super) fn axes(&self) -> usize {
        match self.texels.shape().dimension {
            Dimension::D1 => 1,
            Dimension::D2 | Dimension::D2Array | Dimension::Cube | Dimension::CubeArray => 2,
            Dimension::D3 => 3,
        }
    }

    /// The channels at a level.
    fn filter(&self, level: u32, filter: Filter) -> [f64; 4] {
        match filter {
            Filter::Nearest => {
                let size = self.texels.shape().level_size(level);
                let place = std::array::from_fn(|axis| {
                    let texel = address::nearest(self.coordinates[axis], size[axis]);
                    // Only rounding can leave a face.
                    if self.face.is_some() { texel.clamp(0, i64::from(size[axis]) - 1) } else { texel }
                });
                self.value(level, place).unwrap_or_default()
            }
            Filter::Linear => self.linear(level),
        }
    }

    /// Blends the texels around, axis by axis.
    fn linear(&self, level: u32) -> [f64; 4] {
        let (axes, pairs) = (self.axes(), self.pairs(level));
        let mut values: Vec<[f64; 4]> = self.corners(level, &pairs);
        for pair in pairs.iter().take(axes) {
            let blend = |two: &[[f64; 4]]| {
                std::array::from_fn(|channel| mix(two[0][channel], two[1][channel], pair.weight))
            };
            values = values.chunks_exact(2).map(blend).collect();
        }
        values.first().copied().unwrap_or_default()
    }

    fn pairs(&self, level: u32) -> [Pair; 3] {
        let size = self.texels.shape().level_size(level);
        std::array::from_fn(|axis| address::around(self.coordinates[axis], size[axis]))
    }

    /// The values of the texels around, the first axis changing fastest. Past a corner of a cube it is the mean of the
    /// three that meet there.
    fn corners(&self, level: u32, pairs: &[Pair; 3]) -> Vec<[f64; 4]> {
        let value = |corner: usize| {
            let place = |axis: usize| pairs[axis].first + i64::from(corner >> axis & 1 == 1);
            self.value(level, std::array::from_fn(|axis| if axis < self.axes() { place(axis) } else { 0 }))
        };
        let values: Vec<Option<[f64; 4]>> = (0..1 << self.axes()).map(value).collect();
        let present: Vec<&[f64; 4]> = values.iter().flatten().collect();
        let mean = std::array::from_fn(|channel| {
            present.iter().map(|v| v[channel]).sum::<f64>() / present.len().max(1) as f64
        });
        values.into_iter().map(|v| v.unwrap_or(mean)).collect()
    }

    /// The value of a texel, or of how it compares; `None` past a corner of a cube.
    fn value(&self, level: u32, place: [i64; 3]) -> Option<[f64; 4]> {
        let shape = self.texels.shape();
        let (layer, place) = self.texel(level, place)?;
        let texel = self.texels.texel(shape.texel(level, layer, place, 0));
        let channels = shape.format.decode(texel).map(|bits| f32::from_bits(bits as u32));
        Some(match (self.reference, self.sample.sampler.compare) {
            (Some(reference), Some(compare)) => {
                [f64::from(u8::from(compare.holds(reference, channels[0]))); 4]
            }
            (Some(_) | None, _) => channels.map(f64::from),
        })
    }

    /// Layer and place of the texel that stands for the one at `place`.
    pub(super) fn texel(&self, level: u32, place: [i64; 3]) -> Option<(u32, [u32; 3])> {
        let size = self.texels.shape().level_size(level);
        if let Some(face) = self.face {
            let (face, [x, y]) = cube::neighbour(face, [place[0], place[1]], size[0])?;
            return Some((self.layer * 6 + face, [x, y, 0]));
        }
        let place = std::array::from_fn(|axis| {
            let texel = place[axis] + i64::from(self.sample.offset[axis]);
            address::wrap(texel, size[axis], self.sample.sampler.address[axis])
        });
        Some((self.layer, place))
    }

    /// A channel of the four texels around, of level 0: lower left, lower right, upper right, upper left, down being
    /// where coordinates grow.
    fn gather(&self, channel: usize) -> [f32; 4] {
        let values = self.corners(0, &self.pairs(0));
        [2, 3, 1, 0].map(|corner: usize| values[corner][channel] as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::{Address, Compare, Texture, TextureShape};
    use naga::StorageFormat;

    const LINEAR: Sampler = Sampler {
        address: [Address::ClampToEdge; 3],
        magnify: Filter::Linear,
        minify: Filter::Linear,
        mip: Filter::Linear,
        lod: [0.0, 32.0],
        compare: None,
    };

    fn at(sampler: &Sampler, coordinates: [f32; 3]) -> Sample<'_> {
        Sample {
            sampler,
            coordinates,
            layer: 0,
            lod: Lod::Exact(0.0),
            offset: [0; 3],
            reference: None,
            gather: None,
            clamp_to_edge: false,
        }
    }

    /// A texture whose texels are their own number.
    fn counted(dimension: Dimension, size: [u32; 3], levels: u32) -> Texture {
        let shape =
            TextureShape::new(Format::Storage(StorageFormat::R32Float), dimension, size).levelled(levels);
        let numbers = (0..shape.bytes() / 4).flat_map(|n| (n as f32).to_le_bytes());
        Texture::new(shape, numbers.collect()).expect("a texture")
    }

    #[test]
    fn weights_are_those_of_the_formula() {
        let texture = counted(Dimension::D2, [4, 4, 1], 3);
        let red = |s: &Sample| sample(&texture, s)[0];
        assert_eq!(red(&at(&LINEAR, [0.375, 0.375, 0.0])), 5.0);
        assert_eq!(red(&at(&LINEAR, [0.4375, 0.375, 0.0])), 5.25);
        assert_eq!(red(&at(&LINEAR, [0.5, 0.5, 0.0])), 7.5);
        assert_eq!(red(&at(&LINEAR, [-1.0, 2.0, 0.0])), 12.0);
        // Between level 0 (7.5 in the middle) and level 1 (16 + 1.5).
        assert_eq!(red(&Sample { lod: Lod::Exact(0.25), ..at(&LINEAR, [0.5, 0.5, 0.0]) }), 10.0);
        assert_eq!(red(&Sample { offset: [1, -1, 0], ..at(&LINEAR, [0.375, 0.375, 0.0]) }), 2.0);
        assert_eq!(
            red(&Sample { clamp_to_edge: true, ..at(&LINEAR.addressed(Address::Repeat), [0.0; 3]) }),
            0.0
        );
        assert_eq!(red(&at(&LINEAR.addressed(Address::Repeat), [0.0; 3])), 7.5);
        let volume = counted(Dimension::D3, [2, 2, 2], 1);
        assert_eq!(sample(&volume, &at(&LINEAR, [0.5; 3])), [3.5, 0.0, 0.0, 1.0]);
    }

    #[test]
    fn gathers_go_round_from_below() {
        let texture = counted(Dimension::D2, [4, 4, 1], 1);
        let gathered = sample(&texture, &Sample { gather: Some(0), ..at(&LINEAR, [0.5, 0.5, 0.0]) });
        assert_eq!(gathered, [9.0, 10.0, 6.0, 5.0]);
    }

    #[test]
    fn comparisons_are_filtered_not_depths() {
        let texture = counted(Dimension::D2, [2, 1, 1], 1);
        let sampler = LINEAR.comparing(Compare::Less);
        let half = Sample { reference: Some(0.5), ..at(&sampler, [0.5, 0.5, 0.0]) };
        assert_eq!(sample(&texture, &half)[0], 0.5);
        let quarter = Sample { reference: Some(0.5), ..at(&sampler, [0.375, 0.5, 0.0]) };
        assert_eq!(sample(&texture, &quarter)[0], 0.25);
    }

    #[test]
    fn edges_of_cubes_blend_two_faces_and_corners_three() {
        let texture = counted(Dimension::Cube, [1, 1, 1], 1);
        let red = |direction| sample(&texture, &at(&LINEAR, direction))[0];
        assert_eq!(red([1.0, 0.0, 0.0]), 0.0);
        assert!((red([1.0, 0.0, 0.999_999]) - 2.0).abs() < 1e-4);
        assert!((red([1.0, 1.0, 1.0]) - 2.0).abs() < 1e-4, "{}", red([1.0, 1.0, 1.0]));
    }
}
