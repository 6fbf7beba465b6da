//! Pictures as texts: exact, and small.
//!
//! Floats become places in the order of all floats, a place becomes its distance from a guess, and the four bytes of the
//! distances stand in four planes: of numbers that are guessed well, the planes of the higher bytes are zeros.
//! The guess is the same value of another picture, else the value before it of the same channel.
//! The planes are deflated, and written in base64. `web/decode.js` is the way back.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::{Compression, write::DeflateEncoder};
use std::io::Write;

/// The text of a picture with `channels` values a pixel, guessed from `base`.
pub(super) fn pack(values: &[f32], channels: usize, base: Option<&[f32]>) -> std::io::Result<String> {
    let place = |at: usize| place(values[at]);
    let distances = (0..values.len()).map(|at| {
        let guess = match base {
            Some(base) => base.get(at).map_or(0, |value| self::place(*value)),
            None => at.checked_sub(channels).map_or(0, place),
        };
        zigzag(place(at).wrapping_sub(guess))
    });
    let distances: Vec<u32> = distances.collect();
    let mut deflated = DeflateEncoder::new(Vec::new(), Compression::best());
    for byte in 0..4 {
        let plane: Vec<u8> = distances.iter().map(|distance| distance.to_le_bytes()[byte]).collect();
        deflated.write_all(&plane)?;
    }
    Ok(STANDARD.encode(deflated.finish()?))
}

/// The place of a float among all, negative ones reversed; its own inverse on bits.
fn place(value: f32) -> i32 {
    let bits = value.to_bits() as i32;
    if bits < 0 { bits ^ i32::MAX } else { bits }
}

/// Small distances of either sign as small numbers.
fn zigzag(distance: i32) -> u32 {
    ((distance << 1) ^ (distance >> 31)) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::read::DeflateDecoder;
    use std::io::Read;

    fn unpack(text: &str, channels: usize, base: Option<&[f32]>) -> Vec<f32> {
        let mut planes = Vec::new();
        DeflateDecoder::new(&STANDARD.decode(text).unwrap()[..]).read_to_end(&mut planes).unwrap();
        let n = planes.len() / 4;
        let mut values: Vec<f32> = Vec::new();
        for at in 0..n {
            let zigzag = u32::from_le_bytes([0, 1, 2, 3].map(|byte| planes[byte * n + at]));
            let distance = (zigzag >> 1) as i32 ^ -((zigzag & 1) as i32);
            let guess = match base {
                Some(base) => place(base[at]),
                None => at.checked_sub(channels).map_or(0, |before| place(values[before])),
            };
            let bits = guess.wrapping_add(distance);
            values.push(f32::from_bits((if bits < 0 { bits ^ i32::MAX } else { bits }) as u32));
        }
        values
    }

    #[track_caller]
    fn check(values: &[f32], base: Option<&[f32]>) {
        let back = unpack(&pack(values, 3, base).unwrap(), 3, base);
        let bits = |values: &[f32]| values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&back), bits(values));
    }

    #[test]
    fn every_bit_comes_back() {
        let odd =
            [0.0, -0.0, 1.0, -1.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::MIN_POSITIVE, 1e-45];
        let payload = [f32::from_bits(0xffc0_0001), f32::from_bits(0x7f80_0001), f32::MAX];
        let values = [&odd[..], &payload[..]].concat();
        check(&values, None);
        check(&values, Some(&values));
        check(&values, Some(&[1.0; 12]));
        check(&[], None);
    }

    #[test]
    fn what_is_nearly_the_base_is_small() {
        let base: Vec<f32> = (0..3 * 64 * 64).map(|i| (i as f32).sin()).collect();
        let near: Vec<f32> = base.iter().map(|value| f32::from_bits(value.to_bits() + 1)).collect();
        assert!(pack(&near, 3, Some(&base)).unwrap().len() < 200);
    }
}
