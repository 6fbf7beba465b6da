//! From type to type, as WGSL converts: integers wrap, floats go to the nearest, floats to integers are
//! truncated and clamped to what both types can hold; NaN becomes 0.

use super::super::program::Scalar;
use super::half;

/// A type of numbers.
pub(crate) trait Number: 'static {
    /// What a register holds.
    type Held: Copy + 'static;
    /// Bits of a float's significand; `None` for others.
    const DIGITS: Option<u32>;
    /// The number, of others than floats.
    fn integer(held: Self::Held) -> i128;
    /// The number, of floats.
    fn float(held: Self::Held) -> f64;
    /// The nearest, or the lower bits.
    fn of_integer(number: i128) -> Self::Held;
    /// The nearest; `digits` are those of the type that it comes from.
    fn of_float(number: f64, digits: u32) -> Self::Held;
}

/// A boolean: all ones or zero.
pub(crate) struct Truth;
/// A float of 16 bits, held as f32.
pub(crate) struct Half;

/// The largest float of so many digits that an integer of so many bits can hold.
fn largest(digits: u32, bits: u32) -> f64 {
    let most = 2.0_f64.powi(bits as i32) - 2.0_f64.powi(bits.saturating_sub(digits) as i32);
    if digits == 11 { most.min(half::MAX.into()) } else { most }
}

macro_rules! integers {
    ($($ty:ident $held:ident $bits:literal;)*) => {
        $(impl Number for $ty {
            type Held = $held;
            const DIGITS: Option<u32> = None;
            #[inline(always)]
            fn integer(held: $held) -> i128 {
                (held as $ty).into()
            }
            #[inline(always)]
            fn float(held: $held) -> f64 {
                held as f64
            }
            #[inline(always)]
            fn of_integer(number: i128) -> $held {
                number as $ty as $held
            }
            #[inline(always)]
            fn of_float(number: f64, digits: u32) -> $held {
                let most = largest(digits, $bits);
                let least = if digits == 11 { -f64::from(half::MAX) } else { f64::NEG_INFINITY };
                let number = if number > most { most } else { number };
                (if number < least { least } else { number }) as $ty as $held
            }
        })*
    };
}
integers! { i16 i32 15; u16 u32 16; i32 i32 31; u32 u32 32; i64 i64 63; u64 u64 64; }

macro_rules! floats {
    ($($ty:ident $held:ident $digits:literal |$number:ident| $near:expr;)*) => {
        $(impl Number for $ty {
            type Held = $held;
            const DIGITS: Option<u32> = Some($digits);
            #[inline(always)]
            fn integer(held: $held) -> i128 {
                held as i128
            }
            #[inline(always)]
            fn float(held: $held) -> f64 {
                held.into()
            }
            #[inline(always)]
            fn of_integer(number: i128) -> $held {
                let near = i64::try_from(number).map_or(number as $held, |small| small as $held);
                Self::of_float(near.into(), 53)
            }
            #[inline(always)]
            fn of_float($number: f64, _: u32) -> $held {
                $near
            }
        })*
    };
}
floats! {
    Half f32 11 |number| half::round_f64(number);
    f32 f32 24 |number| number as f32;
    f64 f64 53 |number| number;
}

impl Number for Truth {
    type Held = u32;
    const DIGITS: Option<u32> = None;
    #[inline(always)]
    fn integer(held: u32) -> i128 {
        (held & 1).into()
    }
    #[inline(always)]
    fn float(held: u32) -> f64 {
        (held & 1).into()
    }
    #[inline(always)]
    fn of_integer(number: i128) -> u32 {
        u32::from(number != 0).wrapping_neg()
    }
    #[inline(always)]
    fn of_float(number: f64, _: u32) -> u32 {
        u32::from(number != 0.0).wrapping_neg()
    }
}

/// A number of type `A` as one of type `B`.
#[inline(always)]
pub(crate) fn convert<A: Number, B: Number>(held: A::Held) -> B::Held {
    match A::DIGITS {
        Some(digits) => B::of_float(A::float(held), digits),
        None => B::of_integer(A::integer(held)),
    }
}

/// From f32, truncated, at most the largest f32 that fits.
///
/// WGSL and the drivers stop there; Rust's `as` goes on to the largest integer, for numbers from 2^31 on.
#[inline(always)]
pub(crate) fn to_i32(x: f32) -> i32 {
    const MOST: f32 = 2_147_483_520.0;
    (if x > MOST { MOST } else { x }) as i32
}

/// The same, unsigned.
#[inline(always)]
pub(crate) fn to_u32(x: f32) -> u32 {
    const MOST: f32 = 4_294_967_040.0;
    (if x > MOST { MOST } else { x }) as u32
}

/// A float of a type of so many digits as an integer, as registers hold it.
pub(crate) fn truncated(number: f64, digits: u32, to: Scalar) -> u64 {
    match to {
        Scalar::I16 => (i16::of_float(number, digits) as u32).into(),
        Scalar::U16 => u16::of_float(number, digits).into(),
        Scalar::I64 => i64::of_float(number, digits) as u64,
        Scalar::U64 => u64::of_float(number, digits),
        Scalar::U32 => u32::of_float(number, digits).into(),
        Scalar::Bool | Scalar::I32 | Scalar::F32 | Scalar::F16 | Scalar::F64 => {
            (i32::of_float(number, digits) as u32).into()
        }
    }
}

/// The same bits as another type of the same size; `None` if the sizes differ.
pub(crate) fn bitcast(from: Scalar, to: Scalar, bits: u64) -> Option<u64> {
    if from.bytes() != to.bytes() {
        return None;
    }
    let word = match from {
        Scalar::F16 => u64::from(half::to_bits(f32::from_bits(bits as u32))),
        Scalar::Bool
        | Scalar::I16
        | Scalar::U16
        | Scalar::I32
        | Scalar::U32
        | Scalar::F32
        | Scalar::I64
        | Scalar::U64
        | Scalar::F64 => bits,
    };
    Some(match to {
        Scalar::F16 => half::from_bits(word as u16).to_bits().into(),
        Scalar::I16 => u64::from(word as u16 as i16 as u32),
        Scalar::U16 => u64::from(word as u16),
        Scalar::Bool | Scalar::I32 | Scalar::U32 | Scalar::F32 | Scalar::I64 | Scalar::U64 | Scalar::F64 => {
            word
        }
    })
}
