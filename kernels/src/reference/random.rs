//! Random numbers without state: hashes of integers, equal on every route.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::{Jarzynski20, ONeill14};
use lobe_codegen::prelude::*;

/// Hash of one number.
///
/// A step of a linear congruential generator and the permutation RXS-M-XS.
/// Source: [Jarzynski20] "pcg", [ONeill14] section 6.3.4.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `seed` | any number | 32 bits | 1 |
///
/// Returns 32 bits; a permutation of all seeds.
#[kernel(family = "reference", cite = "[Jarzynski20] pcg", domain(seed = 0.0..=4294967295.0), budget(0.0), measured)]
pub fn pcg_hash(seed: u32) -> u32 {
    let state = seed.wrapping_mul(747796405).wrapping_add(2891336453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277803737);
    (word >> 22) ^ word
}

/// Hash of three numbers to three.
///
/// Source: [Jarzynski20] "pcg3d".
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `seed` | any three numbers | 32 bits each | 1 |
///
/// Returns three times 32 bits; a permutation of all triples.
#[kernel(family = "reference", cite = "[Jarzynski20] pcg3d", domain(seed = 0.0..=4294967295.0), budget(0.0), measured)]
pub fn pcg3d(seed: UVec3) -> UVec3 {
    let mut x = seed.x.wrapping_mul(1664525).wrapping_add(1013904223);
    let mut y = seed.y.wrapping_mul(1664525).wrapping_add(1013904223);
    let mut z = seed.z.wrapping_mul(1664525).wrapping_add(1013904223);
    x = x.wrapping_add(y.wrapping_mul(z));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    x = x ^ (x >> 16);
    y = y ^ (y >> 16);
    z = z ^ (z >> 16);
    x = x.wrapping_add(y.wrapping_mul(z));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    UVec3::new(x, y, z)
}

/// Hash of four numbers to four.
///
/// Source: [Jarzynski20] "pcg4d".
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `seed` | any four numbers | 32 bits each | 1 |
///
/// Returns four times 32 bits; a permutation of all quadruples.
#[kernel(family = "reference", cite = "[Jarzynski20] pcg4d", domain(seed = 0.0..=4294967295.0), budget(0.0), measured)]
pub fn pcg4d(seed: UVec4) -> UVec4 {
    let mut x = seed.x.wrapping_mul(1664525).wrapping_add(1013904223);
    let mut y = seed.y.wrapping_mul(1664525).wrapping_add(1013904223);
    let mut z = seed.z.wrapping_mul(1664525).wrapping_add(1013904223);
    let mut w = seed.w.wrapping_mul(1664525).wrapping_add(1013904223);
    x = x.wrapping_add(y.wrapping_mul(w));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    w = w.wrapping_add(y.wrapping_mul(z));
    x = x ^ (x >> 16);
    y = y ^ (y >> 16);
    z = z ^ (z >> 16);
    w = w ^ (w >> 16);
    x = x.wrapping_add(y.wrapping_mul(w));
    y = y.wrapping_add(z.wrapping_mul(x));
    z = z.wrapping_add(x.wrapping_mul(y));
    w = w.wrapping_add(y.wrapping_mul(z));
    UVec4::new(x, y, z, w)
}

/// A uniform number out of random bits.
///
/// `⌊bits/2⁸⌋ 2⁻²⁴`
/// Source: [ONeill14] section 6; the 24 bits that an f32 holds below 1.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `bits` | random bits | 32 bits | 1 |
///
/// Returns a multiple of 2^-24 in 0 ..= 1 - 2^-24, all equally often; exact.
#[kernel(family = "reference", cite = "[ONeill14] section 6", domain(bits = 0.0..=4294967295.0), budget(0.0), measured)]
pub fn uniform_of_bits(bits: u32) -> f32 {
    (bits >> 8) as f32 * 5.9604644775390625e-8
}

/// Two uniform numbers for a place in a sampling plan.
///
/// The first two of [`pcg3d`] of the place.
/// Source: [Jarzynski20] pcg3d.
///
/// | argument | meaning | domain | unit |
/// |---|---|---|---|
/// | `pixel` | index of what is estimated | 32 bits | 1 |
/// | `index` | of the sample | 32 bits | 1 |
/// | `dimension` | of the decision within the sample | 32 bits | 1 |
///
/// Returns two multiples of 2^-24 in 0 ..= 1 - 2^-24; exact.
#[kernel(
    family = "reference",
    cite = "[Jarzynski20] pcg3d",
    domain(pixel = 0.0..=4294967295.0, index = 0.0..=4294967295.0, dimension = 0.0..=4294967295.0),
    budget(0.0),
    measured
)]
pub fn random_pair(pixel: u32, index: u32, dimension: u32) -> Vec2 {
    let hash = pcg3d(UVec3::new(pixel, index, dimension));
    Vec2::new(uniform_of_bits(hash.x), uniform_of_bits(hash.y))
}
