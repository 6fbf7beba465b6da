//! Any pure operation, on bits as registers hold them: for executors that go number by number.

use super::super::program::op::{Comparison, FloatOp, IntOp, LogicOp, Simple};
use super::super::program::{Op, Scalar};
use super::convert::{Half, Number, Truth, bitcast, convert};
use super::float;
use super::integer::Integer;

/// The bits of the result; `None` of what depends on more than its operands: inputs, memory, ...
pub(crate) fn eval(op: Op, args: &[u64]) -> Option<u64> {
    let arg = |at: usize| args.get(at).copied().unwrap_or(0);
    Some(match op {
        Op::Copy(_) => arg(0),
        Op::Float(scalar, op) => float(scalar, op, [arg(0), arg(1), arg(2)])?,
        Op::Int(scalar, op) => integer(scalar, op, [arg(0), arg(1), arg(2), arg(3)])?,
        Op::Compare(scalar, comparison) => mask(compare(scalar, comparison, arg(0), arg(1))),
        Op::Logic(op) => logic(op, arg(0), arg(1)),
        Op::IsNan(scalar) => mask(as_f64(scalar, arg(0)).is_nan()),
        Op::IsInf(scalar) => mask(as_f64(scalar, arg(0)).is_infinite()),
        Op::Select(_) if arg(0) as u32 != 0 => arg(1),
        Op::Select(_) => arg(2),
        Op::Convert(from, to) => converted(from, to, arg(0)),
        Op::Bitcast(from, to) => bitcast(from, to, arg(0))?,
        Op::Exponent(scalar) => u64::from(float::exponent(as_f64(scalar, arg(0))) as u32),
        Op::Ldexp(scalar) => ldexp(scalar, arg(0), arg(1) as i32)?,
        Op::Fused { first, second, flipped } => {
            let inner = simple(first, single(arg(0)), single(arg(1)));
            let (a, b) = if flipped { (single(arg(2)), inner) } else { (inner, single(arg(2))) };
            simple(second, a, b).to_bits().into()
        }
        // A polynomial's coefficients are the program's.
        Op::Input(..)
        | Op::Index { .. }
        | Op::IndexWithin { .. }
        | Op::Length { .. }
        | Op::Load { .. }
        | Op::Mark(..)
        | Op::Horner { .. } => return None,
    })
}

fn mask(holds: bool) -> u64 {
    u32::from(holds).wrapping_neg().into()
}

fn single(bits: u64) -> f32 {
    f32::from_bits(bits as u32)
}

fn as_f64(scalar: Scalar, bits: u64) -> f64 {
    if scalar == Scalar::F64 { f64::from_bits(bits) } else { single(bits).into() }
}

fn simple(op: Simple, a: f32, b: f32) -> f32 {
    match op {
        Simple::Add => a + b,
        Simple::Sub => a - b,
        Simple::Mul => a * b,
    }
}

fn float(scalar: Scalar, op: FloatOp, args: [u64; 3]) -> Option<u64> {
    match scalar {
        Scalar::F32 => Some(float::f32(op, args.map(single)).to_bits().into()),
        Scalar::F16 => Some(float::f16(op, args.map(single)).to_bits().into()),
        Scalar::F64 => Some(float::f64(op, args.map(f64::from_bits)).to_bits()),
        Scalar::Bool | Scalar::I16 | Scalar::U16 | Scalar::I32 | Scalar::U32 | Scalar::I64 | Scalar::U64 => {
            None
        }
    }
}

fn ldexp(scalar: Scalar, x: u64, by: i32) -> Option<u64> {
    match scalar {
        Scalar::F32 => Some(float::ldexp_f32(single(x), by).to_bits().into()),
        Scalar::F16 => Some(float::ldexp_f16(single(x), by).to_bits().into()),
        Scalar::F64 => Some(float::ldexp_f64(f64::from_bits(x), by).to_bits()),
        Scalar::Bool | Scalar::I16 | Scalar::U16 | Scalar::I32 | Scalar::U32 | Scalar::I64 | Scalar::U64 => {
            None
        }
    }
}

fn integer(scalar: Scalar, op: IntOp, args: [u64; 4]) -> Option<u64> {
    let narrow = |a: u64| a as u32;
    let signed = |a: u64| a as u32 as i32;
    match scalar {
        Scalar::I16 => Some(u64::from(any::<i16>(op, args, signed) as u32)),
        Scalar::U16 => Some(any::<u16>(op, args, narrow).into()),
        Scalar::I32 => Some(u64::from(any::<i32>(op, args, signed) as u32)),
        Scalar::U32 => Some(any::<u32>(op, args, narrow).into()),
        Scalar::I64 => Some(any::<i64>(op, args, |a| a as i64) as u64),
        Scalar::U64 => Some(any::<u64>(op, args, |a| a)),
        Scalar::Bool | Scalar::F16 | Scalar::F32 | Scalar::F64 => None,
    }
}

fn any<T: Integer>(op: IntOp, args: [u64; 4], held: impl Fn(u64) -> T::Held) -> T::Held {
    let [a, b, c, _] = args.map(held);
    match op {
        IntOp::Neg
        | IntOp::Not
        | IntOp::Abs
        | IntOp::Sign
        | IntOp::CountOneBits
        | IntOp::CountLeadingZeros
        | IntOp::CountTrailingZeros
        | IntOp::ReverseBits
        | IntOp::FirstLeadingBit
        | IntOp::FirstTrailingBit => T::one(op, a),
        IntOp::Add
        | IntOp::Sub
        | IntOp::Mul
        | IntOp::Div
        | IntOp::Rem
        | IntOp::And
        | IntOp::Or
        | IntOp::Xor
        | IntOp::Min
        | IntOp::Max => T::two(op, a, b),
        IntOp::Shl | IntOp::Shr => T::shift(op, a, args[1] as u32),
        IntOp::Clamp => T::clamp(a, b, c),
        IntOp::ExtractBits => T::extract(a, args[1] as u32, args[2] as u32),
        IntOp::InsertBits => T::insert(a, b, args[2] as u32, args[3] as u32),
    }
}

/// Whether a comparison holds.
fn compare(scalar: Scalar, comparison: Comparison, a: u64, b: u64) -> bool {
    let order = match scalar {
        Scalar::F16 | Scalar::F32 | Scalar::F64 => as_f64(scalar, a).partial_cmp(&as_f64(scalar, b)),
        Scalar::I16 | Scalar::I32 => Some((a as i32).cmp(&(b as i32))),
        Scalar::Bool | Scalar::U16 | Scalar::U32 => Some((a as u32).cmp(&(b as u32))),
        Scalar::I64 => Some((a as i64).cmp(&(b as i64))),
        Scalar::U64 => Some(a.cmp(&b)),
    };
    match comparison {
        Comparison::Equal => order.is_some_and(|o| o.is_eq()),
        Comparison::NotEqual => order.is_none_or(|o| o.is_ne()),
        Comparison::Less => order.is_some_and(|o| o.is_lt()),
        Comparison::LessEqual => order.is_some_and(|o| o.is_le()),
    }
}

fn logic(op: LogicOp, a: u64, b: u64) -> u64 {
    let bits = match op {
        LogicOp::Not => !a,
        LogicOp::And => a & b,
        LogicOp::Or => a | b,
        LogicOp::Xor => a ^ b,
        LogicOp::Same => !(a ^ b),
        LogicOp::AndNot => a & !b,
    };
    u64::from(bits as u32)
}

/// What goes from a type's bits to what registers hold of it, and back.
trait Bits: Number {
    fn hold(bits: u64) -> Self::Held;
    fn bits(held: Self::Held) -> u64;
}

macro_rules! bits {
    ($($ty:ident |$bits:ident| $hold:expr, |$held:ident| $back:expr;)*) => {
        $(impl Bits for $ty {
            fn hold($bits: u64) -> Self::Held { $hold }
            fn bits($held: Self::Held) -> u64 { $back }
        })*
    };
}
bits! {
    Truth |bits| bits as u32, |held| held.into();
    i16 |bits| bits as u32 as i32, |held| u64::from(held as u32);
    u16 |bits| bits as u32, |held| held.into();
    i32 |bits| bits as u32 as i32, |held| u64::from(held as u32);
    u32 |bits| bits as u32, |held| held.into();
    i64 |bits| bits as i64, |held| held as u64;
    u64 |bits| bits, |held| held;
    Half |bits| single(bits), |held| held.to_bits().into();
    f32 |bits| single(bits), |held| held.to_bits().into();
    f64 |bits| f64::from_bits(bits), |held| held.to_bits();
}

/// The number of type `to`.
fn converted(from: Scalar, to: Scalar, bits: u64) -> u64 {
    match from {
        Scalar::Bool => converted_from::<Truth>(to, bits),
        Scalar::I16 => converted_from::<i16>(to, bits),
        Scalar::U16 => converted_from::<u16>(to, bits),
        Scalar::I32 => converted_from::<i32>(to, bits),
        Scalar::U32 => converted_from::<u32>(to, bits),
        Scalar::I64 => converted_from::<i64>(to, bits),
        Scalar::U64 => converted_from::<u64>(to, bits),
        Scalar::F16 => converted_from::<Half>(to, bits),
        Scalar::F32 => converted_from::<f32>(to, bits),
        Scalar::F64 => converted_from::<f64>(to, bits),
    }
}

fn converted_from<A: Bits>(to: Scalar, bits: u64) -> u64 {
    let held = A::hold(bits);
    match to {
        Scalar::Bool => Truth::bits(convert::<A, Truth>(held)),
        Scalar::I16 => i16::bits(convert::<A, i16>(held)),
        Scalar::U16 => u16::bits(convert::<A, u16>(held)),
        Scalar::I32 => i32::bits(convert::<A, i32>(held)),
        Scalar::U32 => u32::bits(convert::<A, u32>(held)),
        Scalar::I64 => i64::bits(convert::<A, i64>(held)),
        Scalar::U64 => u64::bits(convert::<A, u64>(held)),
        Scalar::F16 => Half::bits(convert::<A, Half>(held)),
        Scalar::F32 => f32::bits(convert::<A, f32>(held)),
        Scalar::F64 => f64::bits(convert::<A, f64>(held)),
    }
}
