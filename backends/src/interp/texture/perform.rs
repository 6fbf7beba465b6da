//! One operation of a program in one invocation.

use super::super::program::Update;
use super::super::program::texture::{Operands, Sampling, TextureOp};
use super::{At, Lod, Sample, TexelsMut, inside, load, sample, store};
use crate::texture::{Dimension, Sampler, TextureShape};

/// Does `op` with operands by their bits, integers with their sign; `sampler` is that of a sample.
pub(crate) fn perform(
    texels: &mut impl TexelsMut,
    sampler: Option<&Sampler>,
    op: TextureOp,
    operands: &Operands<u64>,
) -> [u64; 4] {
    let shape = texels.shape();
    match op {
        TextureOp::Load => load(texels, place(operands)),
        TextureOp::Store => {
            store(texels, place(operands), operands.values.map(Option::unwrap_or_default));
            [0; 4]
        }
        TextureOp::Atomic(fun) => {
            update(texels, place(operands), fun, operands.values[0].unwrap_or_default());
            [0; 4]
        }
        TextureOp::Sample(sampling) => {
            let Some(sampler) = sampler else {
                return [0; 4];
            };
            sample(texels, &wanted(sampler, sampling, operands)).map(|channel| channel.to_bits().into())
        }
        TextureOp::Size => {
            let level = u32::try_from(integer(operands.level)).ok().filter(|level| *level < shape.levels);
            let [width, height, depth] = level.map_or([0; 3], |level| shape.level_size(level));
            [width.into(), height.into(), depth.into(), 0]
        }
        TextureOp::Levels => [shape.levels.into(), 0, 0, 0],
        TextureOp::Layers => {
            let cubes = shape.dimension == Dimension::CubeArray;
            [u64::from(if cubes { shape.layers / 6 } else { shape.layers }), 0, 0, 0]
        }
        TextureOp::Samples => [shape.samples.into(), 0, 0, 0],
    }
}

/// The sample that operands ask for.
pub(crate) fn wanted<'s>(sampler: &'s Sampler, sampling: Sampling, operands: &Operands<u64>) -> Sample<'s> {
    Sample {
        sampler,
        coordinates: operands.place.map(float),
        layer: integer(operands.layer),
        lod: lod(operands),
        offset: sampling.offset,
        reference: operands.reference.map(|r| f32::from_bits(r as u32)),
        gather: sampling.gather.map(usize::from),
        clamp_to_edge: sampling.clamp_to_edge,
    }
}

/// The first byte of the texel that a load, a store or an atomic names, if there is one.
pub(crate) fn texel_at(shape: TextureShape, operands: &Operands<u64>) -> Option<usize> {
    inside(shape, place(operands))
}

/// Where `op` looks for a texel, or whose level it asks about, if there is nothing there.
pub(crate) fn astray(shape: TextureShape, op: TextureOp, operands: &Operands<u64>) -> Option<At> {
    let at = place(operands);
    let is_inside = match op {
        TextureOp::Load | TextureOp::Store | TextureOp::Atomic(_) => inside(shape, at).is_some(),
        TextureOp::Size => (0..i64::from(shape.levels)).contains(&at.level),
        TextureOp::Sample(_) | TextureOp::Levels | TextureOp::Layers | TextureOp::Samples => true,
    };
    (!is_inside).then_some(at)
}

fn integer(bits: Option<u64>) -> i64 {
    bits.unwrap_or_default() as i64
}

fn float(bits: Option<u64>) -> f32 {
    f32::from_bits(bits.unwrap_or_default() as u32)
}

fn place(operands: &Operands<u64>) -> At {
    At {
        place: operands.place.map(integer),
        layer: integer(operands.layer),
        level: integer(operands.level),
        sample: integer(operands.sample),
    }
}

fn lod(operands: &Operands<u64>) -> Lod {
    if operands.gradient[0][0].is_some() {
        Lod::Gradient(operands.gradient.map(|step| step.map(float)))
    } else {
        Lod::Exact(float(operands.level))
    }
}

/// An atomic update of a texel of one integer channel.
fn update(texels: &mut impl TexelsMut, at: At, fun: Update, value: u64) {
    let format = texels.shape().format;
    if let Some(place) = inside(texels.shape(), at) {
        let [old, ..] = format.decode(texels.texel(place));
        let signed = format.kind() == crate::texture::Kind::Sint;
        let wide = format.bytes() == 8;
        let number = |bits: u64| if signed { i64::from(bits as u32 as i32) } else { bits as i64 };
        let new = match fun {
            Update::Add => old.wrapping_add(value),
            Update::Subtract => old.wrapping_sub(value),
            Update::And => old & value,
            Update::Xor => old ^ value,
            Update::Or => old | value,
            Update::Min if signed => number(old).min(number(value)) as u64,
            Update::Max if signed => number(old).max(number(value)) as u64,
            Update::Min => old.min(value),
            Update::Max => old.max(value),
            Update::Exchange | Update::CompareExchange => value,
        };
        let new = if wide { new } else { new & u64::from(u32::MAX) };
        let texel = format.encode([new, 0, 0, 0]);
        texels.set_texel(place, texel);
    }
}
