//! Several numbers in a word: the products of normalised numbers are f32, rounded to the nearest, ties to even.

use crate::run::{Operation, Ty};
use crate::soft::{self, F16, F32, Number, Way};

/// Bits of a part, and whether it has a sign.
#[derive(Clone, Copy)]
struct Part {
    bits: u32,
    signed: bool,
}

impl Part {
    fn largest(self) -> i128 {
        (1 << (self.bits - u32::from(self.signed))) - 1
    }

    fn least(self) -> i128 {
        if self.signed { -self.largest() - 1 } else { 0 }
    }

    fn low(self, value: i128) -> u64 {
        (value & ((1 << self.bits) - 1)) as u64
    }

    /// Part `at` of a word.
    fn of(self, word: u64, at: u32) -> i128 {
        let part = i128::from(word >> (at * self.bits)) & ((1 << self.bits) - 1);
        if part > self.largest() { part - (1 << self.bits) } else { part }
    }

    fn join(self, parts: impl IntoIterator<Item = u64>) -> u64 {
        (0..).zip(parts).map(|(at, part)| part << (at * self.bits)).sum()
    }
}

const I8: Part = Part { bits: 8, signed: true };
const U8: Part = Part { bits: 8, signed: false };
const I16: Part = Part { bits: 16, signed: true };
const U16: Part = Part { bits: 16, signed: false };

fn f32_of(number: Number) -> Number {
    F32.decode(F32.encode(number))
}

/// The integer of a normalised number.
fn normalised(part: Part, bits: u64) -> u64 {
    let (low, high) = (if part.signed { -1 } else { 0 }, 1);
    let number = F32.decode(bits);
    let clamped = if soft::compare(number, soft::of_integer(low)).is_none_or(|o| o.is_lt()) {
        soft::of_integer(low)
    } else if soft::compare(number, soft::of_integer(high)).is_some_and(|o| o.is_gt()) {
        soft::of_integer(high)
    } else {
        number
    };
    let scaled = f32_of(soft::mul(clamped, soft::of_integer(part.largest())));
    part.low(soft::to_integer(soft::whole(scaled, Way::ToEven), -70000, 70000))
}

/// The normalised number of an integer.
fn ratio(part: Part, value: i128) -> u64 {
    F32.encode(soft::div(soft::of_integer(value.max(-part.largest())), soft::of_integer(part.largest())))
}

/// An F16 with the sign of a NaN.
fn half(bits: u64) -> u64 {
    F16.encode(F32.decode(bits)) | (bits >> 16 & 0x8000)
}

fn operation(wgsl: &str, args: Vec<Ty>, result: Ty, oracle: impl Fn(&[u64]) -> u64 + 'static) -> Operation {
    Operation { wgsl: wgsl.to_owned(), args, result, oracle: Box::new(oracle) }
}

fn packs() -> Vec<Operation> {
    let each = |wgsl: &str, ty: Ty, part: Part, f: fn(Part, u64) -> u64| {
        let count = 32 / part.bits as usize;
        let args = if count == 4 { "vec4(a, b, c, d)" } else { "vec2(a, b)" };
        operation(&format!("{wgsl}({args})"), vec![ty; count], Ty::U32, move |v| {
            part.join(v.iter().map(|x| f(part, *x)))
        })
    };
    vec![
        each("pack4x8snorm", Ty::F32, I8, normalised),
        each("pack4x8unorm", Ty::F32, U8, normalised),
        each("pack2x16snorm", Ty::F32, I16, normalised),
        each("pack2x16unorm", Ty::F32, U16, normalised),
        each("pack2x16float", Ty::F32, U16, |_, x| half(x)),
        each("pack4xI8", Ty::I32, I8, |_, x| x & 255),
        each("pack4xU8", Ty::U32, U8, |_, x| x & 255),
        each("pack4xI8Clamp", Ty::I32, I8, |p, x| p.low(Ty::I32.value(x).clamp(p.least(), p.largest()))),
        each("pack4xU8Clamp", Ty::U32, U8, |_, x| x.min(255)),
    ]
}

fn unpacks() -> Vec<Operation> {
    let mut all = Vec::new();
    let mut each = |wgsl: &str, part: Part, result: Ty, f: fn(Part, i128) -> u64| {
        for at in 0..32 / part.bits {
            let wgsl = format!("{wgsl}(a)[{at}]");
            all.push(operation(&wgsl, vec![Ty::U32], result, move |v| f(part, part.of(v[0], at))));
        }
    };
    each("unpack4x8snorm", I8, Ty::F32, ratio);
    each("unpack4x8unorm", U8, Ty::F32, ratio);
    each("unpack2x16snorm", I16, Ty::F32, ratio);
    each("unpack2x16unorm", U16, Ty::F32, ratio);
    each("unpack2x16float", U16, Ty::F32, |_, x| F32.encode(F16.decode(x as u64)));
    each("unpack4xI8", I8, Ty::I32, |_, x| Ty::I32.wrap(x));
    each("unpack4xU8", U8, Ty::U32, |_, x| Ty::U32.wrap(x));
    all
}

pub(crate) fn operations() -> Vec<Operation> {
    let dot = |wgsl: &str, part: Part, result: Ty| {
        operation(wgsl, vec![Ty::U32; 2], result, move |v| {
            result.wrap((0..4).map(|at| part.of(v[0], at) * part.of(v[1], at)).sum())
        })
    };
    let dots = vec![dot("dot4I8Packed(a, b)", I8, Ty::I32), dot("dot4U8Packed(a, b)", U8, Ty::U32)];
    [packs(), unpacks(), dots].into_iter().flatten().collect()
}
