//! What each operation does to numbers, a family a file.
//!
//! [`find`] is exhaustive over [`Op`]; an operation that has no form yet is `None` and refused when linked.

mod cast;
mod chain;
mod float;
mod floats;
mod fused;
mod horner;
mod in_place;
mod integer;
mod logic;
mod sized;

use super::super::program::{Op, Scalar};
use super::shape::{Ask, Exec, Found};

pub(super) use chain::{chained, find as find_chain};
pub(super) use in_place::{InPlace, add_products, in_place, update};
pub(super) use logic::jump;

/// Declares functions of numbers: the type, its arguments and the expression.
macro_rules! functions {
    () => {};
    ($name:ident($a:ident: $ta:ty) -> $r:ty = $body:expr; $($rest:tt)*) => {
        pub(super) struct $name;
        impl $crate::interp::fast::shape::Fn1 for $name {
            type A = $ta;
            type R = $r;
            #[inline(always)]
            fn eval($a: $ta) -> $r { $body }
        }
        functions! { $($rest)* }
    };
    ($name:ident($a:ident: $ta:ty, $b:ident: $tb:ty) -> $r:ty = $body:expr; $($rest:tt)*) => {
        pub(super) struct $name;
        impl $crate::interp::fast::shape::Fn2 for $name {
            type A = $ta;
            type B = $tb;
            type R = $r;
            #[inline(always)]
            fn eval($a: $ta, $b: $tb) -> $r { $body }
        }
        functions! { $($rest)* }
    };
    ($name:ident($a:ident: $ta:ty, $b:ident: $tb:ty, $c:ident: $tc:ty) -> $r:ty = $body:expr; $($rest:tt)*) => {
        pub(super) struct $name;
        impl $crate::interp::fast::shape::Fn3 for $name {
            type A = $ta;
            type B = $tb;
            type C = $tc;
            type R = $r;
            #[inline(always)]
            fn eval($a: $ta, $b: $tb, $c: $tc) -> $r { $body }
        }
        functions! { $($rest)* }
    };
}
use functions;

/// All ones or zero.
#[inline(always)]
fn mask(holds: bool) -> u32 {
    u32::from(holds).wrapping_neg()
}

/// The form of a pure operation, if there is one; the inner `None` asks for operands in slots.
pub(super) fn find<const N: usize>(op: Op, ask: Ask) -> Option<Found<N>> {
    match op {
        Op::Copy(scalar) => Some(cast::copy(scalar, ask)),
        Op::Float(Scalar::F32, op) => Some(float::find(op, ask)),
        Op::Float(Scalar::F16, op) => Some(floats::find::<floats::Half, N>(op, ask)),
        Op::Float(Scalar::F64, op) => Some(floats::find::<floats::Double, N>(op, ask)),
        Op::Int(scalar, op) => integer::find(scalar, op, ask),
        Op::Compare(scalar, comparison) => Some(logic::compare(scalar, comparison, ask)),
        Op::Logic(op) => Some(logic::find(op, ask)),
        Op::IsNan(scalar) => Some(logic::is_nan(scalar, ask)),
        Op::IsInf(scalar) => Some(logic::is_inf(scalar, ask)),
        Op::Select(scalar) => Some(logic::select(scalar, ask)),
        Op::Convert(from, to) => Some(cast::convert(from, to, ask)),
        Op::Bitcast(from, to) => cast::bitcast(from, to, ask),
        Op::Exponent(scalar) => Some(floats::exponent(scalar, ask)),
        Op::Ldexp(scalar) => Some(floats::ldexp(scalar, ask)),
        Op::Fused { first, second, flipped } => Some(fused::find(first, second, flipped, ask)),
        Op::Horner { count, begun, .. } => Some(horner::find(count, begun, ask)),
        // `memory` and `control` link these.
        Op::Input(..) | Op::Index { .. } | Op::IndexWithin { .. } | Op::Length { .. } | Op::Load { .. } => {
            None
        }
        // For judges.
        Op::Mark(..) => None,
        Op::Float(_, _) => None,
    }
}

/// Copies a cell to all lanes of a slot.
pub(super) fn splat<const N: usize>(scalar: Scalar, isa: super::Isa) -> Exec<N> {
    cast::splat(scalar, isa)
}
