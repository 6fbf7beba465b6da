//! What drivers may make of numbers in texels: the Vulkan specification's sections on floating-point format conversions
//! and on fixed-point data conversions.
//!
//! A number goes to one of the two codes around it, and to its own code if it has one; beyond the ends it goes to the
//! end, a large float to the largest or to infinity.
//! Codes of floats are read as they are.
//! Those of normalised numbers are a quotient, computed outside of shaders, where results are good to about one part in
//! 10^5. Of the sRGB curve the specification says nothing more, so its codes may be read as any number.

use super::Format;
use super::code::{Code, Coding, Field};

/// Largest relative error of what is computed outside of shaders.
const OUTSIDE: f64 = 1e-5;

/// What is known of a number: the exact one, and the ends of those that drivers may have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Known {
    pub(crate) exact: f64,
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Known {
    /// A number that all have.
    pub(crate) fn point(exact: f64) -> Self {
        Self { exact, low: exact, high: exact }
    }

    /// Nothing is.
    pub(crate) fn nothing(exact: f64) -> Self {
        Self { exact, low: f64::NEG_INFINITY, high: f64::INFINITY }
    }

    /// Either of two, of which this one is the exact one.
    pub(crate) fn or(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high), ..self }
    }

    fn is_bounded(self) -> bool {
        self.low.is_finite() && self.high.is_finite()
    }
}

impl Format {
    /// The numbers of a texel.
    pub(crate) fn numbers(self, texel: u128) -> [Known; 4] {
        let mut numbers = [0.0, 0.0, 0.0, 1.0].map(Known::point);
        for field in self.fields() {
            numbers[field.channel] = Known::point(field.code.number(field.bits(texel)));
        }
        numbers
    }

    /// The numbers of a texel that such numbers were stored to.
    pub(crate) fn kept(self, stored: [Known; 4]) -> [Known; 4] {
        let mut numbers = [0.0, 0.0, 0.0, 1.0].map(Known::point);
        for Field { channel, code, .. } in self.fields().filter(|field| field.code.is_of_floats()) {
            let known = stored[channel];
            if !known.is_bounded() {
                numbers[channel] = known;
                continue;
            }
            let [low, _] = code.around(below(known.low));
            let [_, high] = code.around(-below(-known.high));
            numbers[channel] = Known { exact: known.exact, low: code.number(low), high: code.number(high) };
        }
        numbers
    }

    /// What shaders may read of such numbers.
    pub(crate) fn read(self, mut numbers: [Known; 4]) -> [Known; 4] {
        for Field { channel, code, .. } in self.fields() {
            let Known { exact, low, high } = numbers[channel];
            numbers[channel] = match code.coding {
                Coding::Unorm | Coding::Snorm => {
                    let wide = |x: f64| x.abs() * OUTSIDE;
                    Known { exact, low: low - wide(low), high: high + wide(high) }
                }
                Coding::Srgb => Known::nothing(exact),
                Coding::Float | Coding::Uint | Coding::Sint => continue,
            };
        }
        numbers
    }

    /// Whether a driver may leave `texel` where it stores such numbers.
    #[must_use]
    pub fn admits(self, texel: u128, numbers: [[f64; 2]; 4]) -> bool {
        self.fields().all(|field| {
            let [low, high] = numbers[field.channel];
            let is_open = !(low.is_finite() && high.is_finite());
            is_open || field.code.admits(field.bits(texel), low, high)
        })
    }

    /// How far apart the numbers of two such texels may be.
    #[must_use]
    pub fn spread(self, numbers: [[f64; 2]; 4]) -> f64 {
        let known = self.kept(numbers.map(|[low, high]| Known { exact: low, low, high }));
        known.into_iter().map(|number| number.high - number.low).fold(0.0, f64::max)
    }

    /// The texel of such numbers, as bits of f32, where `up` tells which of two codes each one gets.
    pub(crate) fn encode_either(self, numbers: [u64; 4], mut up: impl FnMut() -> bool) -> u128 {
        let exactly = self.encode(numbers);
        self.fields().fold(exactly, |texel, field| {
            let number = f32::from_bits(numbers[field.channel] as u32);
            if !field.code.is_of_floats() || number.is_nan() {
                return texel;
            }
            let code = field.code.around(number)[usize::from(up())];
            texel & !(u128::from(field.code.mask()) << field.shift) | u128::from(code) << field.shift
        })
    }
}

/// The largest f32 that is not above a number.
fn below(x: f64) -> f32 {
    let near = x as f32;
    if f64::from(near) > x { near.next_down() } else { near }
}

impl Field {
    fn bits(self, texel: u128) -> u64 {
        (texel >> self.shift) as u64 & self.code.mask()
    }
}

impl Code {
    fn is_of_floats(self) -> bool {
        !matches!(self.coding, Coding::Uint | Coding::Sint)
    }

    /// The number of a code.
    fn number(self, bits: u64) -> f64 {
        match self.coding {
            Coding::Unorm => bits as f64 / self.scale(),
            Coding::Snorm => (self.order(bits) as f64 / self.scale()).max(-1.0),
            Coding::Uint => bits as f64,
            Coding::Sint => self.order(bits) as f64,
            Coding::Srgb | Coding::Float => f32::from_bits(self.decode(bits) as u32).into(),
        }
    }

    /// The place of a code among all, by their numbers.
    fn order(self, bits: u64) -> i64 {
        let sign = 1 << (self.bits - 1);
        let is_signed = match self.coding {
            Coding::Snorm | Coding::Sint => true,
            Coding::Float => self.bits >= 16,
            Coding::Unorm | Coding::Srgb | Coding::Uint => false,
        };
        match self.coding {
            _ if !is_signed || bits < sign => bits as i64,
            Coding::Float => -((bits - sign) as i64),
            _ => bits as i64 - 2 * sign as i64,
        }
    }

    /// The code at a place.
    fn at(self, order: i64) -> u64 {
        match self.coding {
            Coding::Float if order < 0 => (1 << (self.bits - 1)) | order.unsigned_abs(),
            _ => order as u64 & self.mask(),
        }
    }

    /// The codes that enclose a number; twice its own if it has one, or is beyond the ends.
    fn around(self, number: f32) -> [u64; 2] {
        let nearest = self.encode(number.to_bits().into()) & self.mask();
        if self.coding == Coding::Float && self.bits == 32 {
            return [nearest; 2];
        }
        let (place, found) = (self.order(nearest), self.number(nearest));
        let number = self.clamped(number.into());
        if found < number {
            [nearest, self.at(place + 1)]
        } else if found > number {
            [self.at(place - 1), nearest]
        } else {
            [nearest; 2]
        }
    }

    /// A number, or the end that it is beyond.
    fn clamped(self, number: f64) -> f64 {
        match self.coding {
            Coding::Unorm | Coding::Srgb => number.clamp(0.0, 1.0),
            Coding::Snorm => number.clamp(-1.0, 1.0),
            Coding::Float if self.bits < 16 => number.max(0.0),
            Coding::Float | Coding::Uint | Coding::Sint => number,
        }
    }

    /// Whether a code is one of those around a number of `low ..= high`.
    fn admits(self, bits: u64, low: f64, high: f64) -> bool {
        let (low, high) = (self.clamped(low), self.clamped(high));
        let (place, found) = (self.order(bits), self.number(bits));
        if self.coding == Coding::Float && self.bits == 32 {
            return (low..=high).contains(&found);
        }
        // A code beyond an end is around a number if the next one towards it is on the other side.
        let is_below = found < low && self.number(self.at(place + 1)) <= low;
        let is_above = found > high && self.number(self.at(place - 1)) >= high;
        !found.is_nan() && !is_below && !is_above
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use naga::StorageFormat as S;

    fn code(bits: u32, coding: Coding) -> Code {
        Code { bits, coding }
    }

    #[test]
    fn a_number_has_the_two_codes_around_it_or_its_own() {
        let cases = [
            (code(8, Coding::Unorm), 0.5, [127, 128]),
            (code(8, Coding::Unorm), 1.0, [255, 255]),
            (code(8, Coding::Unorm), 7.0, [255, 255]),
            (code(8, Coding::Unorm), -1.0, [0, 0]),
            (code(8, Coding::Snorm), -0.5, [0xc0, 0xc1]),
            (code(8, Coding::Snorm), 0.001, [0, 1]),
            (code(8, Coding::Snorm), -0.001, [0xff, 0]),
            (code(8, Coding::Snorm), -1.0, [0x81, 0x81]),
            (code(16, Coding::Float), 1.0001, [0x3c00, 0x3c01]),
            (code(16, Coding::Float), -1.0001, [0xbc01, 0xbc00]),
            (code(16, Coding::Float), 1e6, [0x7bff, 0x7c00]),
            (code(16, Coding::Float), 1e-9, [0, 1]),
            (code(11, Coding::Float), 1.01, [0x3c0, 0x3c1]),
            (code(10, Coding::Float), -3.0, [0, 0]),
            (code(32, Coding::Float), 1.01, [1.01_f32.to_bits().into(); 2]),
        ];
        for (code, number, expected) in cases {
            assert_eq!(code.around(number), expected, "{number} in {code:?}");
        }
    }

    #[test]
    fn texels_are_admitted_that_a_store_may_leave_and_no_others() {
        for (code, numbers) in [
            (code(8, Coding::Unorm), [0.3, 1.0]),
            (code(8, Coding::Snorm), [-0.3, 0.001]),
            (code(16, Coding::Snorm), [-1.0, 0.5]),
            (code(16, Coding::Float), [-0.1, 1e-6]),
            (code(11, Coding::Float), [0.1, 3.3]),
            (code(10, Coding::Float), [60000.0, 1e9]),
        ] {
            for [low, high] in [[numbers[0]; 2], [numbers[1]; 2], numbers] {
                let [first, _] = code.around(low);
                let [_, last] = code.around(high);
                let range = code.order(first)..=code.order(last);
                for bits in 0..=code.mask() {
                    let is_lowest = code.coding == Coding::Snorm && code.order(bits) < -(code.scale() as i64);
                    let expected = range.contains(&code.order(bits));
                    let found = code.admits(bits, low.into(), high.into());
                    assert!(
                        found == expected || is_lowest,
                        "{bits:#x} for {low}..={high} in {code:?}: {found}"
                    );
                }
            }
        }
    }

    #[test]
    fn chance_codes_are_admitted_and_read_as_what_is_kept() {
        let mut state = 1_u64;
        let mut up = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state >> 63 == 1
        };
        for format in Format::all().filter(|f| !f.to_string().ends_with("int")) {
            for step in -40..=40 {
                let numbers = [0.031, 0.026, -0.019, 0.4].map(|scale| scale * step as f32);
                let texel = format.encode_either(numbers.map(|x| x.to_bits().into()), &mut up);
                assert!(
                    format.admits(texel, numbers.map(|x| [x.into(); 2])),
                    "{format}: {texel:#x} of {numbers:?}"
                );
                let kept = format.kept(numbers.map(|x| Known::point(x.into())));
                for (found, kept) in format.numbers(texel).into_iter().zip(kept) {
                    assert!(kept.low <= found.low && found.high <= kept.high, "{format}: {found:?} {kept:?}");
                }
            }
        }
    }

    #[test]
    fn normalised_numbers_are_read_to_a_part_in_ten_to_the_five() {
        let format = Format::Storage(S::Rgba8Unorm);
        let [r, g, ..] = format.read(format.numbers(0xff00_8001));
        assert!(r.exact == 1.0 / 255.0 && r.low < r.exact && r.high <= r.exact * 1.000_011);
        assert!(g.exact == 128.0 / 255.0 && g.low < g.exact);
        let [.., a] = Format::Storage(S::R16Float).read(Format::Storage(S::R16Float).numbers(0x3c00));
        assert_eq!(a, Known::point(1.0));
    }
}
