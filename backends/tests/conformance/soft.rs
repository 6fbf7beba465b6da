//! Floats of any format by integer arithmetic: what IEEE says, without a float anywhere.

/// A format: bits of the significand with the hidden one, bits in all.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Format {
    pub(crate) digits: u32,
    pub(crate) bits: u32,
}

pub(crate) const F16: Format = Format { digits: 11, bits: 16 };
pub(crate) const F32: Format = Format { digits: 24, bits: 32 };
pub(crate) const F64: Format = Format { digits: 53, bits: 64 };

/// A number: `(-1)^negative * size * 2^power`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Number {
    Nan,
    Infinite { negative: bool },
    Finite { negative: bool, size: u128, power: i32 },
}

use Number::{Finite, Infinite, Nan};

impl Format {
    fn bias(self) -> i32 {
        (1 << (self.bits - self.digits - 1)) - 1
    }

    /// The power of two of the last bit of the smallest numbers.
    pub(crate) fn least(self) -> i32 {
        1 - self.bias() - (self.digits as i32 - 1)
    }

    fn fraction(self) -> u64 {
        (1 << (self.digits - 1)) - 1
    }

    pub(crate) fn infinity_bits(self) -> u64 {
        ((1 << (self.bits - self.digits)) - 1) << (self.digits - 1)
    }

    pub(crate) fn nan(self) -> u64 {
        self.infinity_bits() | 1 << (self.digits - 2)
    }

    pub(crate) fn is_nan(self, bits: u64) -> bool {
        self.decode(bits) == Nan
    }

    pub(crate) fn decode(self, bits: u64) -> Number {
        let negative = bits >> (self.bits - 1) & 1 == 1;
        let exponent = (bits & self.infinity_bits()) >> (self.digits - 1);
        let fraction = bits & self.fraction();
        match (bits & self.infinity_bits() == self.infinity_bits(), exponent) {
            (true, _) if fraction != 0 => Nan,
            (true, _) => Infinite { negative },
            (false, 0) => Finite { negative, size: fraction.into(), power: self.least() },
            (false, e) => {
                let size = u128::from(fraction | 1 << (self.digits - 1));
                Finite { negative, size, power: self.least() + e as i32 - 1 }
            }
        }
    }

    /// The bits of the nearest number, ties to even.
    pub(crate) fn encode(self, number: Number) -> u64 {
        let sign = |negative: bool| u64::from(negative) << (self.bits - 1);
        match number {
            Nan => self.nan(),
            Infinite { negative } => sign(negative) | self.infinity_bits(),
            Finite { negative, size: 0, .. } => sign(negative),
            Finite { negative, size, power } => {
                let length = 128 - size.leading_zeros() as i32;
                let last = (power + length - self.digits as i32).max(self.least());
                let kept = rounded(size, last - power);
                // A carry makes the next exponent: bits of neighbours are neighbours.
                let exponent = (last - self.least()) as u128;
                let bits = kept + (exponent << (self.digits - 1));
                sign(negative) | bits.min(self.infinity_bits().into()) as u64
            }
        }
    }
}

/// `size / 2^by`, to the nearest, ties to even.
fn rounded(size: u128, by: i32) -> u128 {
    match by {
        i32::MIN..=0 => size << -by,
        1..=127 => {
            let (kept, rest, half) = (size >> by, size & ((1 << by) - 1), 1_u128 << (by - 1));
            kept + u128::from(rest > half || (rest == half && kept & 1 == 1))
        }
        _ => 0,
    }
}

fn negative(number: Number) -> bool {
    match number {
        Nan => false,
        Infinite { negative } | Finite { negative, .. } => negative,
    }
}

pub(crate) fn neg(a: Number) -> Number {
    match a {
        Nan => Nan,
        Infinite { negative } => Infinite { negative: !negative },
        Finite { negative, size, power } => Finite { negative: !negative, size, power },
    }
}

pub(crate) fn abs(a: Number) -> Number {
    if negative(a) { neg(a) } else { a }
}

/// The highest bit at 125, so that sums fit; what is shifted out stays as a last bit.
fn aligned(size: u128, power: i32, top: i32) -> u128 {
    let shift = power - top;
    match shift {
        0.. => size << shift,
        -127..0 => size >> -shift | u128::from(size & ((1 << -shift) - 1) != 0),
        _ => u128::from(size != 0),
    }
}

pub(crate) fn add(a: Number, b: Number) -> Number {
    match (a, b) {
        (Nan, _) | (_, Nan) => Nan,
        (Infinite { negative: x }, Infinite { negative: y }) if x != y => Nan,
        (Infinite { .. }, _) => a,
        (_, Infinite { .. }) => b,
        (Finite { size: 0, negative: x, .. }, Finite { size: 0, negative: y, power }) => {
            Finite { negative: x && y, size: 0, power }
        }
        (Finite { size: 0, .. }, _) => b,
        (_, Finite { size: 0, .. }) => a,
        (Finite { negative: x, size: m, power: p }, Finite { negative: y, size: n, power: q }) => {
            let top = |size: u128, power: i32| power + 127 - size.leading_zeros() as i32;
            let power = top(m, p).max(top(n, q)) - 125;
            let (m, n) = (aligned(m, p, power) as i128, aligned(n, q, power) as i128);
            let sum = if x { -m } else { m } + if y { -n } else { n };
            Finite { negative: sum < 0, size: sum.unsigned_abs(), power }
        }
    }
}

/// Exact, of up to 64 bits each.
pub(crate) fn mul(a: Number, b: Number) -> Number {
    let sign = negative(a) != negative(b);
    match (a, b) {
        (Nan, _) | (_, Nan) => Nan,
        (Infinite { .. }, Finite { size: 0, .. }) | (Finite { size: 0, .. }, Infinite { .. }) => Nan,
        (Infinite { .. }, _) | (_, Infinite { .. }) => Infinite { negative: sign },
        (Finite { size: m, power: p, .. }, Finite { size: n, power: q, .. }) => {
            Finite { negative: sign, size: m * n, power: p + q }
        }
    }
}

/// To more digits than any format has; the last bit says whether there are others.
pub(crate) fn div(a: Number, b: Number) -> Number {
    let sign = negative(a) != negative(b);
    match (a, b) {
        (Nan, _) | (_, Nan) | (Infinite { .. }, Infinite { .. }) => Nan,
        (Infinite { .. }, _) => Infinite { negative: sign },
        (Finite { power, .. }, Infinite { .. }) => Finite { negative: sign, size: 0, power },
        (Finite { size: 0, .. }, Finite { size: 0, .. }) => Nan,
        (_, Finite { size: 0, .. }) => Infinite { negative: sign },
        (Finite { size: m, power: p, .. }, Finite { size: n, power: q, .. }) => {
            let shift = m.leading_zeros() as i32 - 1;
            let m = m << shift;
            Finite {
                negative: sign,
                size: ((m / n) << 1) | u128::from(!m.is_multiple_of(n)),
                power: p - shift - q - 1,
            }
        }
    }
}

/// The remainder of truncated division, exact.
pub(crate) fn rem(a: Number, b: Number) -> Number {
    match (a, b) {
        (Nan | Infinite { .. }, _) | (_, Nan | Finite { size: 0, .. }) => Nan,
        (_, Infinite { .. }) => a,
        (Finite { negative, size: m, power: p }, Finite { size: n, power: q, .. }) => {
            if p < q {
                let n = if q - p < 64 { n << (q - p) } else { u128::MAX };
                return Finite { negative, size: m % n, power: p };
            }
            let (mut m, mut left) = (m % n, p - q);
            while left > 0 {
                let step = left.min(64);
                m = (m << step) % n;
                left -= step;
            }
            Finite { negative, size: m, power: q }
        }
    }
}

/// To more digits than any format has.
pub(crate) fn sqrt(a: Number) -> Number {
    match a {
        Finite { size: 0, .. } | Infinite { negative: false } => a,
        Finite { negative: false, size, power } => {
            let shift = (size.leading_zeros() as i32 - 2) & !1;
            let shift = if (power - shift) % 2 == 0 { shift } else { shift + 1 };
            let size = size << shift;
            let root = size.isqrt();
            let rest = u128::from(root * root != size);
            Finite { negative: false, size: root << 1 | rest, power: (power - shift) / 2 - 1 }
        }
        Nan | Infinite { .. } | Finite { .. } => Nan,
    }
}

/// How a number becomes whole.
#[derive(Clone, Copy)]
pub(crate) enum Way {
    Down,
    Up,
    ToZero,
    ToEven,
}

pub(crate) fn whole(a: Number, way: Way) -> Number {
    let Finite { negative, size, power } = a else { return a };
    if power >= 0 {
        return a;
    }
    let (kept, rest) = match -power {
        by @ 1..=127 => (size >> by, size & ((1 << by) - 1) != 0),
        _ => (0, size != 0),
    };
    let size = match way {
        Way::ToZero => kept,
        Way::Down => kept + u128::from(rest && negative),
        Way::Up => kept + u128::from(rest && !negative),
        Way::ToEven => rounded(size, -power),
    };
    Finite { negative, size, power: 0 }
}

/// Truncated and between these.
pub(crate) fn to_integer(a: Number, low: i128, high: i128) -> i128 {
    match whole(a, Way::ToZero) {
        Nan => 0,
        Infinite { negative: true } => low,
        Infinite { negative: false } => high,
        Finite { size: 0, .. } => 0,
        Finite { negative, size, power } => {
            let size = if power > 70 { i128::MAX } else { (size << power) as i128 };
            (if negative { -size } else { size }).clamp(low, high)
        }
    }
}

pub(crate) fn of_integer(value: i128) -> Number {
    Finite { negative: value < 0, size: value.unsigned_abs(), power: 0 }
}

/// Which is less, if either is.
pub(crate) fn compare(a: Number, b: Number) -> Option<std::cmp::Ordering> {
    let zero = |n| matches!(n, Finite { size: 0, .. });
    match (a, b) {
        (Nan, _) | (_, Nan) => None,
        (Infinite { negative: x }, Infinite { negative: y }) => Some(y.cmp(&x)),
        (Infinite { negative: true }, _) => Some(std::cmp::Ordering::Less),
        (Infinite { negative: false }, _) => Some(std::cmp::Ordering::Greater),
        (_, Infinite { .. }) => compare(b, a).map(std::cmp::Ordering::reverse),
        (a, b) if zero(a) && zero(b) => Some(std::cmp::Ordering::Equal),
        (a, b) => match add(a, neg(b)) {
            Finite { size: 0, .. } => Some(std::cmp::Ordering::Equal),
            Finite { negative: true, .. } => Some(std::cmp::Ordering::Less),
            _ => Some(std::cmp::Ordering::Greater),
        },
    }
}
