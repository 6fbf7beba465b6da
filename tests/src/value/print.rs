//! From words to JSON.

use super::hex::format_hex;
use lobe_codegen::data::WordReader;
use lobe_codegen::def::{FunctionDef, Scalar, TypeDef};
use serde_json::{Map, Number, Value};

/// How finite floats are written; the others are always strings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Floats {
    /// As the shortest decimal that reads back as the same f32.
    Decimal,
    /// As a string with the hexadecimal form.
    Hex,
}

/// A row of `kernel`'s arguments, as [`parse_row`](super::parse_row) reads it.
#[must_use]
pub fn args_json(kernel: &FunctionDef, words: &[u32], floats: Floats) -> Value {
    let mut reader = WordReader::new(words);
    let members = kernel.params.iter().map(|p| (p.name.to_owned(), value_json(&p.ty, &mut reader, floats)));
    Value::Object(members.collect())
}

/// The next value of type `ty`.
#[must_use]
pub fn value_json(ty: &TypeDef, words: &mut WordReader<'_>, floats: Floats) -> Value {
    let mut list = |n: usize, element: &TypeDef| {
        Value::Array((0..n).map(|_| value_json(element, words, floats)).collect())
    };
    match *ty {
        TypeDef::Scalar(scalar) => self::scalar(scalar, words.word(), floats),
        TypeDef::Vector(n, scalar) => list(n.into(), &TypeDef::Scalar(scalar)),
        TypeDef::Matrix(columns, rows) => list(columns.into(), &TypeDef::Vector(rows, Scalar::F32)),
        TypeDef::Array(element, n) => list(n as usize, element),
        TypeDef::Struct(def) => {
            let fields = def().fields.iter();
            let members: Map<_, _> =
                fields.map(|f| (f.name.to_owned(), value_json(&f.ty, words, floats))).collect();
            Value::Object(members)
        }
        TypeDef::Slice(_) | TypeDef::Atomic(_) => Value::Null,
    }
}

fn scalar(scalar: Scalar, word: u32, floats: Floats) -> Value {
    match scalar {
        Scalar::F32 => float(f32::from_bits(word), floats),
        Scalar::I32 => (word as i32).into(),
        Scalar::U32 => word.into(),
        Scalar::Bool => (word != 0).into(),
    }
}

fn float(value: f32, floats: Floats) -> Value {
    // The shortest decimal of the f32, which as an f64 would print with more digits.
    let shortest = format!("{value:e}").parse().ok().and_then(Number::from_f64);
    match (floats, shortest) {
        (Floats::Decimal, Some(number)) => Value::Number(number),
        (Floats::Decimal, None) | (Floats::Hex, _) => Value::String(format_hex(value)),
    }
}
