//! What drivers may find where a sample takes texels as they are: the nearest one, or those that are gathered.
//!
//! Vulkan promises divisions of a texel, and of a level, by 2^4 (`subTexelPrecisionBits`, `mipmapPrecisionBits`), to
//! which drivers snap; and of what is computed outside of shaders, coordinates in texels among it, that it is good to one
//! part in 10^5. So a coordinate near the edge of a texel finds either neighbour.
//!
//! Of blends nothing is told: some drivers compute those of 8-bit formats in 8 bits.

use super::lod::{self, Lod};
use super::sample::{Sample, Spot};
use super::{Texels, address};
use crate::texture::{Compare, Filter, Format, Known, Sampler, TextureShape};

/// Divisions of a texel and of a level.
const DIVISIONS: f64 = 16.0;

/// Largest relative error of a coordinate in texels.
const OUTSIDE: f64 = 1e-5;

/// More texels than these along an axis are as good as all.
const MOST: i64 = 4;

/// What is known of a sample's operands that are not integers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reach {
    pub(crate) coordinates: [Known; 3],
    pub(crate) reference: Option<Known>,
}

/// What drivers may find; `None` where nothing is told.
pub(crate) fn reach(texels: &impl Texels, sample: &Sample<'_>, reach: &Reach) -> Option<[Known; 4]> {
    let spot = Spot::new(texels, sample);
    let shape = texels.shape();
    if spot.is_cube() || sample.clamp_to_edge {
        return None;
    }
    let level = match sample.gather {
        Some(_) => 0,
        None => only_level(&shape, sample)?,
    };
    let size = shape.level_size(level);
    // Gathered are the texels whose centres are around.
    let shift = if sample.gather.is_some() { 0.5 } else { 0.0 };
    let (mut places, mut strict) = ([[0, 0]; 3], [0; 3]);
    for axis in 0..spot.axes() {
        let coordinate = sample.coordinates[axis];
        strict[axis] = match sample.gather {
            Some(_) => address::around(coordinate, size[axis]).first,
            None => address::nearest(coordinate, size[axis]),
        };
        places[axis] = around(reach.coordinates[axis], size[axis], shift)?;
    }
    let found = |corner: [i64; 3]| {
        let moved = std::array::from_fn(|axis| places[axis].map(|texel| texel + corner[axis]));
        let strict = std::array::from_fn(|axis| strict[axis] + corner[axis]);
        spot.found(level, strict, moved, reach.reference)
    };
    match sample.gather {
        None => found([0; 3]),
        Some(channel) => {
            let corner = |x, y| Some(found([x, y, 0])?[channel]);
            Some([corner(0, 1)?, corner(1, 1)?, corner(1, 0)?, corner(0, 0)?])
        }
    }
}

/// The level that all drivers take a texel of.
fn only_level(shape: &TextureShape, sample: &Sample<'_>) -> Option<u32> {
    let Lod::Exact(level) = sample.lod else { return None };
    let sampler: &Sampler = sample.sampler;
    let snapped = [f64::floor, f64::ceil].map(|to| (to(f64::from(level) * DIVISIONS) / DIVISIONS) as f32);
    let [low, high] = snapped.map(|level| lod::levels(shape, sampler, Lod::Exact(level), sample.coordinates));
    (low == high && low.filter == Filter::Nearest && low.second.is_none()).then_some(low.first)
}

/// The first and the last texel that a coordinate may be taken to lie in, edges not regarded.
fn around(coordinate: Known, size: u32, shift: f64) -> Option<[i64; 2]> {
    let end = |x: f64, side: f64| x * f64::from(size) + side * (x * f64::from(size)).abs() * OUTSIDE - shift;
    let low = (end(coordinate.low, -1.0) * DIVISIONS).floor() / DIVISIONS;
    let high = (end(coordinate.high, 1.0) * DIVISIONS).ceil() / DIVISIONS;
    let texels = [low.floor() as i64, high.floor() as i64];
    (low.is_finite() && high.is_finite() && texels[1] - texels[0] < MOST).then_some(texels)
}

impl<T: Texels> Spot<'_, T> {
    /// What may be found in one of the texels from the first to the last along each axis, of which `strict` is the one
    /// that the interpreter finds.
    fn found(
        &self,
        level: u32,
        strict: [i64; 3],
        [xs, ys, zs]: [[i64; 2]; 3],
        reference: Option<Known>,
    ) -> Option<[Known; 4]> {
        let mut all = self.read(level, strict, reference)?;
        for z in zs[0]..=zs[1] {
            for y in ys[0]..=ys[1] {
                for x in xs[0]..=xs[1] {
                    let numbers = self.read(level, [x, y, z], reference)?;
                    all = std::array::from_fn(|channel| all[channel].or(numbers[channel]));
                }
            }
        }
        Some(all)
    }

    /// What depths are compared with: those that are fixed point as such.
    fn clamped(&self, reference: Known) -> Known {
        let Known { exact, low, high } = reference;
        match self.texels.shape().format {
            Format::Depth16Unorm => {
                let [exact, low, high] = [exact, low, high].map(|x| x.clamp(0.0, 1.0));
                Known { exact, low, high }
            }
            _ => reference,
        }
    }

    /// What may be read of a texel, or of how it compares.
    fn read(&self, level: u32, place: [i64; 3], reference: Option<Known>) -> Option<[Known; 4]> {
        let shape = self.texels.shape();
        let (layer, place) = self.texel(level, place)?;
        let texel = self.texels.texel(shape.texel(level, layer, place, 0));
        let numbers = shape.format.read(shape.format.numbers(texel));
        let (Some(reference), Some(compare)) = (reference, self.sample.sampler.compare) else {
            return Some(numbers);
        };
        Some([compared(compare, self.clamped(reference), numbers[0]); 4])
    }
}

/// How two numbers compare, of which so much is known.
fn compared(compare: Compare, reference: Known, depth: Known) -> Known {
    let holds = |a: f64, b: f64| compare.holds(a as f32, b as f32);
    let ends = [reference.low, reference.high].map(|a| [depth.low, depth.high].map(|b| holds(a, b)));
    let is_same = ends.as_flattened().iter().all(|end| *end == ends[0][0]);
    // Numbers that may be equal may be different, unless each is one number.
    let are_apart = reference.high < depth.low || depth.high < reference.low;
    let are_points = reference.low == reference.high && depth.low == depth.high;
    let is_of_equality = matches!(compare, Compare::Equal | Compare::NotEqual);
    let truth = Known::point(f64::from(u8::from(holds(reference.exact, depth.exact))));
    if is_same && (!is_of_equality || are_apart || are_points) {
        truth
    } else {
        Known { low: 0.0, high: 1.0, ..truth }
    }
}
