//! The order in which a map's texels are summed: along Hilbert's curve, so that those of a stratum are near each other both ways.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Hilbert1891;
use crate::rsm::chain::MapLevel;
use crate::scene::NOWHERE;
use lobe_codegen::prelude::*;

/// Where a step of the curve through a square of `2^bits` by `2^bits` texels leads.
///
/// Source: [Hilbert1891]; from the smallest square to the whole, each quarter turned or mirrored into its place.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `place` | the step, from 0 | 0 ..= 4^bits - 1 | 1 |
/// | `bits` | logarithm of the side | 0 ..= 15 | 1 |
///
/// Returns column and row; 0, 0 for the first step, a neighbour of the one before for the others.
#[kernel]
pub fn curve_place(place: u32, bits: u32) -> UVec2 {
    let mut x = 0_u32;
    let mut y = 0_u32;
    for level in 0..bits {
        let side = 1_u32 << level;
        let quarter = (place >> (2 * level)) & 3;
        let right = quarter >> 1;
        let down = (quarter ^ right) & 1;
        let is_mirrored = down == 0 && right == 1;
        let along = select(x, side - 1 - x, is_mirrored);
        let across = select(y, side - 1 - y, is_mirrored);
        x = select(along, across, down == 0) + side * right;
        y = select(across, along, down == 0) + side * down;
    }
    UVec2::new(x, y)
}

/// The logarithm of the least power of two that is no less than a map's sides, of 1024 texels at most.
#[kernel]
pub fn curve_bits(map: MapLevel) -> u32 {
    let side = max(map.width, map.height);
    let mut bits = 0_u32;
    for k in 0_u32..10 {
        bits += select(0_u32, 1_u32, side > (1_u32 << k));
    }
    bits
}

/// The texel of a map to which a step of the curve leads; [`NOWHERE`] beside the map.
#[kernel]
pub fn curve_texel(place: u32, map: MapLevel) -> u32 {
    let at = curve_place(place, curve_bits(map));
    select(NOWHERE, at.y * map.width + at.x, at.x < map.width && at.y < map.height)
}
