//! Levels of detail.

use crate::texture::{Dimension, Filter, Sampler, TextureShape};

/// How a sample states its level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Lod {
    /// As a number.
    Exact(f32),
    /// By how coordinates change from one pixel to the next, to the right and down.
    Gradient([[f32; 3]; 2]),
}

/// Which levels a sample blends, and how.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Levels {
    pub(super) filter: Filter,
    pub(super) first: u32,
    /// The next level and its weight.
    pub(super) second: Option<(u32, f64)>,
}

/// The level that a gradient asks for: the logarithm of the longer of the two steps, in texels of level 0.
///
/// The specification lets drivers approximate both lengths, from below by the largest component and from above by the
/// sum of components.
fn level(shape: &TextureShape, coordinates: [f32; 3], gradient: [[f32; 3]; 2]) -> f32 {
    let length = |step: [f32; 3]| {
        let parts = match shape.dimension {
            Dimension::Cube | Dimension::CubeArray => {
                let [right, down] = super::cube::slope(coordinates, step);
                [right, down, 0.0]
            }
            Dimension::D1 => [step[0].into(), 0.0, 0.0],
            Dimension::D2 | Dimension::D2Array => [step[0].into(), step[1].into(), 0.0],
            Dimension::D3 => step.map(f64::from),
        };
        let squares = (0..3).map(|axis| (parts[axis] * f64::from(shape.size[axis])).powi(2));
        squares.sum::<f64>().sqrt()
    };
    let [right, down] = gradient.map(length);
    right.max(down).log2() as f32
}

/// Chooses levels; `coordinates` are what the gradient is of.
pub(super) fn levels(shape: &TextureShape, sampler: &Sampler, lod: Lod, coordinates: [f32; 3]) -> Levels {
    let wanted = match lod {
        Lod::Exact(level) => level,
        Lod::Gradient(gradient) => level(shape, coordinates, gradient),
    };
    // What is no number goes to the lowest.
    let wanted = wanted.max(sampler.lod[0]).min(sampler.lod[1]);
    let filter = if wanted <= 0.0 { sampler.magnify } else { sampler.minify };
    let last = shape.levels - 1;
    let level = f64::from(wanted).clamp(0.0, last.into());
    match sampler.mip {
        Filter::Nearest => {
            let first = ((level + 0.5).ceil() - 1.0).max(0.0) as u32;
            Levels { filter, first, second: None }
        }
        Filter::Linear => {
            let (first, weight) = (level.floor() as u32, level.fract());
            let second = (weight > 0.0).then(|| ((first + 1).min(last), weight));
            Levels { filter, first, second }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::Format;

    #[test]
    fn levels_by_number_and_by_gradient() {
        let shape = TextureShape::new(Format::Depth32Float, Dimension::D2, [16, 8, 1]).levelled(4);
        let (near, linear) = (Sampler::default(), Sampler::linear());
        let ask = |sampler, lod| levels(&shape, sampler, lod, [0.0; 3]);
        let cases = [
            (&near, Lod::Exact(1.5), Levels { filter: Filter::Nearest, first: 1, second: None }),
            (&near, Lod::Exact(1.51), Levels { filter: Filter::Nearest, first: 2, second: None }),
            (&near, Lod::Exact(9.0), Levels { filter: Filter::Nearest, first: 3, second: None }),
            (&near, Lod::Exact(f32::NAN), Levels { filter: Filter::Nearest, first: 0, second: None }),
            (&linear, Lod::Exact(1.25), Levels { filter: Filter::Linear, first: 1, second: Some((2, 0.25)) }),
            (
                &linear,
                Lod::Gradient([[0.25, 0.0, 0.0], [0.0, 0.25, 0.0]]),
                Levels { filter: Filter::Linear, first: 2, second: None },
            ),
        ];
        for (sampler, lod, expected) in cases {
            assert_eq!(ask(sampler, lod), expected, "{lod:?}");
        }
        let clamped = Sampler { lod: [1.0, 2.0], ..near };
        assert_eq!((ask(&clamped, Lod::Exact(0.0)).first, ask(&clamped, Lod::Exact(3.0)).first), (1, 2));
        let minified = Sampler { minify: Filter::Linear, ..near };
        assert_eq!(ask(&minified, Lod::Exact(0.0)).filter, Filter::Nearest);
        assert_eq!(ask(&minified, Lod::Exact(0.1)).filter, Filter::Linear);
    }
}
