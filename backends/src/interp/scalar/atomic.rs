//! What an atomic update makes of a word.

use super::super::program::{Scalar, Update};

/// The new word, given the old one and the operands, as registers hold them.
pub(crate) fn update(scalar: Scalar, fun: Update, old: u64, value: u64, expected: u64) -> u64 {
    let word = |new: u64| if scalar.wide() { new } else { u64::from(new as u32) };
    match fun {
        Update::Add | Update::Subtract | Update::Min | Update::Max if scalar == Scalar::F32 => {
            let (a, b) = (f32::from_bits(old as u32), f32::from_bits(value as u32));
            let new = match fun {
                Update::Add => a + b,
                Update::Subtract => a - b,
                Update::Min => lobe_codegen::math::scalar::min(a, b),
                _ => lobe_codegen::math::scalar::max(a, b),
            };
            new.to_bits().into()
        }
        Update::Add => word(old.wrapping_add(value)),
        Update::Subtract => word(old.wrapping_sub(value)),
        Update::And => old & value,
        Update::Xor => old ^ value,
        Update::Or => old | value,
        Update::Min => smaller(scalar, old, value),
        Update::Max if smaller(scalar, old, value) == old => value,
        Update::Max => old,
        Update::Exchange => value,
        Update::CompareExchange if old == expected => value,
        Update::CompareExchange => old,
    }
}

fn smaller(scalar: Scalar, a: u64, b: u64) -> u64 {
    let less = match (scalar.signed(), scalar.wide()) {
        (true, true) => (a as i64) < b as i64,
        (true, false) => (a as i32) < b as i32,
        (false, _) => a < b,
    };
    if less { a } else { b }
}
