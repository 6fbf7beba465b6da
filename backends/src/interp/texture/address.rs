//! From coordinates to texels along one axis.

use crate::texture::Address;

/// Two neighbouring texels along an axis and the weight of the second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pair {
    pub(super) first: i64,
    pub(super) weight: f64,
}

/// A coordinate in texels; what is no number, or beyond all textures, is where it does no harm.
fn texels(coordinate: f32, size: u32) -> f64 {
    const FAR: f32 = 1e9;
    let texels = (coordinate * size as f32).clamp(-FAR, FAR);
    if texels.is_nan() { 0.0 } else { f64::from(texels) }
}

/// The texel that a coordinate lies in, edges not regarded.
pub(super) fn nearest(coordinate: f32, size: u32) -> i64 {
    texels(coordinate, size).floor() as i64
}

/// The texels whose centres a coordinate lies between, edges not regarded.
pub(super) fn around(coordinate: f32, size: u32) -> Pair {
    let shifted = texels(coordinate, size) - 0.5;
    let first = shifted.floor();
    Pair { first: first as i64, weight: shifted - first }
}

/// The texel that stands for number `texel`.
pub(super) fn wrap(texel: i64, size: u32, address: Address) -> u32 {
    let size = i64::from(size);
    let wrapped = match address {
        Address::ClampToEdge => texel.clamp(0, size - 1),
        Address::Repeat => texel.rem_euclid(size),
        Address::MirrorRepeat => {
            let folded = texel.rem_euclid(2 * size);
            if folded < size { folded } else { 2 * size - 1 - folded }
        }
    };
    wrapped as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texels_past_the_edges() {
        let cases = [
            (Address::ClampToEdge, [0, 0, 0, 1, 2, 2, 2, 2]),
            (Address::Repeat, [1, 2, 0, 1, 2, 0, 1, 2]),
            (Address::MirrorRepeat, [1, 0, 0, 1, 2, 2, 1, 0]),
        ];
        for (address, expected) in cases {
            let found: Vec<u32> = (-2..6).map(|texel| wrap(texel, 3, address)).collect();
            assert_eq!(found, expected, "{address:?}");
        }
    }

    #[test]
    fn coordinates_between_centres() {
        assert_eq!(around(0.5, 4), Pair { first: 1, weight: 0.5 });
        assert_eq!(around(0.0, 4), Pair { first: -1, weight: 0.5 });
        assert_eq!(around(0.375, 4), Pair { first: 1, weight: 0.0 });
        assert_eq!((nearest(0.5, 4), nearest(-0.1, 4), nearest(f32::NAN, 4)), (2, -1, 0));
        assert!(nearest(f32::INFINITY, 4) > 1 << 20 && nearest(f32::NEG_INFINITY, 4) < -(1 << 20));
    }
}
