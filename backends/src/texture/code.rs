//! Channels as bits, and back: the conversions of the Vulkan and WebGPU specifications.
//!
//! To numbers they are exact, or rounded once. From numbers they round to the nearest code, halves to even; drivers may
//! return the neighbour.

use super::Format;
use half::f16;

/// How a channel's bits are a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Coding {
    /// From 0 to 1.
    Unorm,
    /// From -1 to 1.
    Snorm,
    /// From 0 to 1, on the sRGB curve.
    Srgb,
    /// Itself.
    Uint,
    /// In two's complement.
    Sint,
    /// IEEE of 32 or 16 bits; of 11 or 10 the same as 16 without sign and the last bits.
    Float,
}

/// A channel's width and coding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Code {
    pub(super) bits: u32,
    pub(super) coding: Coding,
}

/// A channel in a texel: number `channel` of red, green, blue and alpha, from bit `shift` on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Field {
    pub(super) channel: usize,
    pub(super) code: Code,
    pub(super) shift: u32,
}

impl Format {
    /// The four numbers of a texel, whose bytes are those of `texel` from the lowest on, as bits of f32, i32, u32 or u64;
    /// channels that lack are 0, 0 and 1.
    #[must_use]
    pub fn decode(self, texel: u128) -> [u64; 4] {
        let one = match self.kind() {
            super::Kind::Float | super::Kind::Depth => 1f32.to_bits().into(),
            super::Kind::Sint | super::Kind::Uint => 1,
        };
        let mut numbers = [0, 0, 0, one];
        for Field { channel, code, shift } in self.fields() {
            numbers[channel] = code.decode((texel >> shift) as u64 & code.mask());
        }
        numbers
    }

    /// The texel of four such numbers, the other way.
    #[must_use]
    pub fn encode(self, numbers: [u64; 4]) -> u128 {
        let place = |Field { channel, code, shift }: Field| {
            u128::from(code.encode(numbers[channel]) & code.mask()) << shift
        };
        self.fields().map(place).fold(0, |texel, bits| texel | bits)
    }
}

impl Code {
    pub(super) fn mask(self) -> u64 {
        u64::MAX >> (64 - self.bits)
    }

    /// The largest code of a unorm, or of a snorm.
    pub(super) fn scale(self) -> f64 {
        let sign = u32::from(self.coding == Coding::Snorm);
        (self.mask() >> sign) as f64
    }

    pub(super) fn decode(self, bits: u64) -> u64 {
        let signed = ((bits << (64 - self.bits)) as i64) >> (64 - self.bits);
        let number = match self.coding {
            Coding::Uint => return bits,
            Coding::Sint => return signed as u32 as u64,
            Coding::Unorm => bits as f32 / self.scale() as f32,
            Coding::Snorm => (signed as f32 / self.scale() as f32).max(-1.0),
            Coding::Srgb => linear(bits as f64 / self.scale()) as f32,
            Coding::Float => match self.bits {
                32 => f32::from_bits(bits as u32),
                // The same exponent as f16, but no sign.
                bits_of => {
                    f16::from_bits((bits << (if bits_of == 16 { 0 } else { 15 - bits_of })) as u16).to_f32()
                }
            },
        };
        number.to_bits().into()
    }

    pub(super) fn encode(self, bits: u64) -> u64 {
        let number = f32::from_bits(bits as u32);
        // NaN becomes 0.
        let code = |number: f64| (number * self.scale()).round_ties_even() as i64 as u64;
        match self.coding {
            Coding::Uint => bits.min(self.mask()),
            Coding::Sint => {
                let largest = i64::from(i32::MAX >> (32 - self.bits));
                i64::from(bits as u32 as i32).clamp(-largest - 1, largest) as u64
            }
            Coding::Unorm => code(f64::from(number).clamp(0.0, 1.0)),
            Coding::Snorm => code(f64::from(number).clamp(-1.0, 1.0)),
            Coding::Srgb => code(curved(f64::from(number).clamp(0.0, 1.0))),
            Coding::Float => match self.bits {
                32 => bits,
                16 => f16::from_f32(number).to_bits().into(),
                bits_of => unsigned_float(number, 15 - bits_of),
            },
        }
    }
}

/// A float without sign, `dropped` bits shorter than an f16 is: less than zero is zero, and no finite number infinite.
fn unsigned_float(number: f32, dropped: u32) -> u64 {
    const INFINITE: u64 = 0x7c00;
    let largest = (INFINITE - 1) >> dropped;
    if number.is_nan() {
        return (INFINITE >> dropped) + 1;
    }
    if number <= 0.0 {
        return 0;
    }
    if number.is_infinite() {
        return INFINITE >> dropped;
    }
    // Halves go to even: find the nearest of the two codes around.
    let value = |code: u64| f64::from(f16::from_bits((code << dropped) as u16).to_f32());
    let number = f64::from(number);
    let (mut low, mut high) = (0, largest);
    while low < high {
        let middle = (low + high).div_ceil(2);
        if value(middle) <= number {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    if low == largest {
        return largest;
    }
    let (below, above) = (number - value(low), value(low + 1) - number);
    if above < below || (above == below && low % 2 == 1) { low + 1 } else { low }
}

fn linear(code: f64) -> f64 {
    if code <= 0.04045 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

fn curved(number: f64) -> f64 {
    if number <= 0.003_130_8 { number * 12.92 } else { 1.055 * number.powf(1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::Kind;
    use naga::StorageFormat as S;

    fn floats(numbers: [f32; 4]) -> [u64; 4] {
        numbers.map(|n| n.to_bits().into())
    }

    #[test]
    fn what_is_decoded_encodes_to_itself() {
        let mut seed = 0x2545_f491_4f6c_dd1d_u64;
        let mut next = || {
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            seed
        };
        for format in Format::all() {
            let mask = u128::MAX >> (128 - format.bytes() * 8);
            for _ in 0..1000 {
                let texel = (u128::from(next()) << 64 | u128::from(next())) & mask;
                let numbers = format.decode(texel);
                let again = format.decode(format.encode(numbers));
                for (a, b) in numbers.into_iter().zip(again) {
                    let nan = |bits: u64| f32::from_bits(bits as u32).is_nan();
                    let float = matches!(format.kind(), Kind::Float | Kind::Depth);
                    assert!(a == b || (float && nan(a) && nan(b)), "{format} {texel:#x}: {a:#x} {b:#x}");
                }
            }
        }
    }

    #[test]
    fn numbers_of_known_codes() {
        let cases: [(S, u128, [f32; 4]); 9] = [
            (S::Rgba8Unorm, 0xff00_8001, [1.0 / 255.0, 128.0 / 255.0, 0.0, 1.0]),
            (S::Bgra8Unorm, 0xff00_8001, [0.0, 128.0 / 255.0, 1.0 / 255.0, 1.0]),
            (S::Rgba8Snorm, 0x8081_7f40, [64.0 / 127.0, 1.0, -1.0, -1.0]),
            (S::R16Float, 0x3c00, [1.0, 0.0, 0.0, 1.0]),
            (S::Rg16Float, 0xc000_7bff, [65504.0, -2.0, 0.0, 1.0]),
            (S::Rg11b10Ufloat, 0x3c0 | 0x3c0 << 11 | 0x1e0 << 22, [1.0; 4]),
            (S::Rgb10a2Unorm, 0x3ff | 1 << 30, [1.0, 0.0, 0.0, 1.0 / 3.0]),
            (S::R16Unorm, 0xffff, [1.0, 0.0, 0.0, 1.0]),
            (S::R32Float, 0x4000_0000, [2.0, 0.0, 0.0, 1.0]),
        ];
        for (format, texel, numbers) in cases {
            assert_eq!(Format::Storage(format).decode(texel), floats(numbers), "{format:?}");
        }
        assert_eq!(Format::Storage(S::Rgb10a2Uint).decode(0xc010_0802), [2, 2, 1, 3]);
        assert_eq!(Format::Storage(S::R8Sint).decode(0xff), [u64::from(u32::MAX), 0, 0, 1]);
        let [half, ..] = Format::Rgba8UnormSrgb.decode(0xbc);
        assert!((f32::from_bits(half as u32) - 0.5028).abs() < 1e-3);
    }

    #[test]
    fn stores_clamp_and_round() {
        let store = |format, numbers| Format::Storage(format).encode(floats(numbers));
        assert_eq!(store(S::Rgba8Unorm, [2.0, -1.0, f32::NAN, 0.5]), 0x8000_00ff);
        assert_eq!(store(S::Rgba8Snorm, [2.0, -2.0, f32::NAN, 0.0]), 0x0000_817f);
        assert_eq!(store(S::Rg11b10Ufloat, [-1.0, 1e6, f32::INFINITY, 0.0]), 0x7bf << 11 | 0x3e0 << 22);
        assert_eq!(store(S::R16Float, [65520.0, 0.0, 0.0, 0.0]), 0x7c00);
        assert_eq!(Format::Storage(S::Rg8Uint).encode([300, 7, 0, 0]), 0x07ff);
        assert_eq!(Format::Storage(S::R8Sint).encode([u64::from(-200i32 as u32), 0, 0, 0]), 0x80);
    }
}
