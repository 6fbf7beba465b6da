//! The one table of built-in operations: name, signature, naga operation.
//!
//! Everything that knows an operation iterates this table: the names that kernels may call
//! ([`crate::prelude`]), the lowering to naga, the interpreter's shadow lane, the op-conformance
//! tests.
//! The native form of each function is the one of the same name in [`crate::math`].
//!
//! How accurate they are is told by [`crate::accuracy`].

use naga::{AtomicFunction, MathFunction, RelationalFunction};

/// What an operation takes and returns; `T` is the type of its first argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// `n` arguments `T`, a float or vector of floats; returns `T`.
    Float(u8),
    /// `n` arguments `T`, any number or vector of numbers; returns `T`.
    Numeric(u8),
    /// One argument `T`, signed or float; returns `T`.
    Signed,
    /// One argument `T`, an integer or vector of integers; returns `T`.
    Integer,
    /// `(T, u32, u32)`, `T` an integer or vector of integers; returns `T`.
    ExtractBits,
    /// `(T, T, u32, u32)`, `T` an integer or vector of integers; returns `T`.
    InsertBits,
    /// `n` float vectors `T`; returns `f32`.
    Reduce(u8),
    /// Two `Vec3`; returns `Vec3`.
    Cross,
    /// `n` float vectors `T`; returns `T`.
    Vector(u8),
    /// `(T, T, f32)`, `T` a float vector; returns `T`.
    Refract,
    /// A matrix; returns its transpose.
    Transpose,
    /// `(T, T, bool)`; returns `T`.
    Select,
    /// A vector of booleans; returns `bool`.
    Relational,
    /// A reference to an atomic; returns its value.
    AtomicLoad,
    /// A reference to an atomic and a value; returns nothing.
    AtomicStore,
    /// A reference to an atomic and a value; returns the former value.
    AtomicUpdate,
    /// Nothing; returns nothing.
    Barrier,
}

/// The naga operation behind an intrinsic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Op {
    /// `Expression::Math`
    Math(MathFunction),
    /// `Expression::Relational`
    Relational(RelationalFunction),
    /// `Expression::Select`
    Select,
    /// `Statement::Atomic` through this function.
    Atomic(AtomicFunction),
    /// `Expression::Load` of an atomic.
    AtomicLoad,
    /// `Statement::Store` to an atomic.
    AtomicStore,
    /// `Statement::ControlBarrier`
    Barrier(naga::Barrier),
}

/// A row of the table.
#[derive(Debug, Clone, Copy)]
pub struct Row {
    /// The operation.
    pub intrinsic: Intrinsic,
    /// Name in Rust kernels.
    pub name: &'static str,
    /// Signature.
    pub shape: Shape,
    /// naga's form.
    pub op: Op,
}

macro_rules! table {
    ($($name:ident $variant:ident $shape:expr, $op:expr;)*) => {
        /// A built-in operation of the kernel language.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Intrinsic {
            $(
                #[doc = concat!("`", stringify!($name), "`")]
                $variant,
            )*
        }

        /// All operations.
        pub const TABLE: &[Row] = &[
            $(Row {
                intrinsic: Intrinsic::$variant,
                name: stringify!($name),
                shape: $shape,
                op: $op,
            },)*
        ];

        /// A type of the same name beside each function, by which `#[kernel]` refers to it.
        pub mod markers {
            use crate::def::{Callable, Callee};
            $(
                #[doc = concat!("Stands for the operation `", stringify!($name), "`.")]
                #[allow(non_camel_case_types, reason = "named as the function it stands for")]
                #[derive(Debug)]
                pub enum $name {}
                impl Callable for $name {
                    const CALLEE: Callee = Callee::Intrinsic(super::Intrinsic::$variant);
                }
            )*
        }
    };
}

use MathFunction as M;
use Shape::{Float, Numeric, Reduce, Vector};

table! {
    abs Abs Shape::Signed, Op::Math(M::Abs);
    min Min Numeric(2), Op::Math(M::Min);
    max Max Numeric(2), Op::Math(M::Max);
    clamp Clamp Numeric(3), Op::Math(M::Clamp);
    saturate Saturate Float(1), Op::Math(M::Saturate);
    sign Sign Shape::Signed, Op::Math(M::Sign);
    ceil Ceil Float(1), Op::Math(M::Ceil);
    floor Floor Float(1), Op::Math(M::Floor);
    round Round Float(1), Op::Math(M::Round);
    trunc Trunc Float(1), Op::Math(M::Trunc);
    fract Fract Float(1), Op::Math(M::Fract);
    step Step Float(2), Op::Math(M::Step);

    sqrt Sqrt Float(1), Op::Math(M::Sqrt);
    inverse_sqrt InverseSqrt Float(1), Op::Math(M::InverseSqrt);
    exp Exp Float(1), Op::Math(M::Exp);
    exp2 Exp2 Float(1), Op::Math(M::Exp2);
    log Log Float(1), Op::Math(M::Log);
    log2 Log2 Float(1), Op::Math(M::Log2);
    pow Pow Float(2), Op::Math(M::Pow);

    sin Sin Float(1), Op::Math(M::Sin);
    cos Cos Float(1), Op::Math(M::Cos);
    tan Tan Float(1), Op::Math(M::Tan);
    asin Asin Float(1), Op::Math(M::Asin);
    acos Acos Float(1), Op::Math(M::Acos);
    atan Atan Float(1), Op::Math(M::Atan);
    atan2 Atan2 Float(2), Op::Math(M::Atan2);
    sinh Sinh Float(1), Op::Math(M::Sinh);
    cosh Cosh Float(1), Op::Math(M::Cosh);
    tanh Tanh Float(1), Op::Math(M::Tanh);
    asinh Asinh Float(1), Op::Math(M::Asinh);
    acosh Acosh Float(1), Op::Math(M::Acosh);
    atanh Atanh Float(1), Op::Math(M::Atanh);

    degrees Degrees Float(1), Op::Math(M::Degrees);
    radians Radians Float(1), Op::Math(M::Radians);
    fma Fma Float(3), Op::Math(M::Fma);
    mix Mix Float(3), Op::Math(M::Mix);
    smoothstep SmoothStep Float(3), Op::Math(M::SmoothStep);

    dot Dot Reduce(2), Op::Math(M::Dot);
    length Length Reduce(1), Op::Math(M::Length);
    distance Distance Reduce(2), Op::Math(M::Distance);
    normalize Normalize Vector(1), Op::Math(M::Normalize);
    cross Cross Shape::Cross, Op::Math(M::Cross);
    reflect Reflect Vector(2), Op::Math(M::Reflect);
    refract Refract Shape::Refract, Op::Math(M::Refract);
    face_forward FaceForward Vector(3), Op::Math(M::FaceForward);
    transpose Transpose Shape::Transpose, Op::Math(M::Transpose);

    count_one_bits CountOneBits Shape::Integer, Op::Math(M::CountOneBits);
    count_leading_zeros CountLeadingZeros Shape::Integer, Op::Math(M::CountLeadingZeros);
    count_trailing_zeros CountTrailingZeros Shape::Integer, Op::Math(M::CountTrailingZeros);
    reverse_bits ReverseBits Shape::Integer, Op::Math(M::ReverseBits);
    first_leading_bit FirstLeadingBit Shape::Integer, Op::Math(M::FirstLeadingBit);
    first_trailing_bit FirstTrailingBit Shape::Integer, Op::Math(M::FirstTrailingBit);
    extract_bits ExtractBits Shape::ExtractBits, Op::Math(M::ExtractBits);
    insert_bits InsertBits Shape::InsertBits, Op::Math(M::InsertBits);

    select Select Shape::Select, Op::Select;
    all All Shape::Relational, Op::Relational(RelationalFunction::All);
    any Any Shape::Relational, Op::Relational(RelationalFunction::Any);

    atomic_load AtomicLoad Shape::AtomicLoad, Op::AtomicLoad;
    atomic_store AtomicStore Shape::AtomicStore, Op::AtomicStore;
    atomic_add AtomicAdd Shape::AtomicUpdate, Op::Atomic(AtomicFunction::Add);
    atomic_sub AtomicSub Shape::AtomicUpdate, Op::Atomic(AtomicFunction::Subtract);
    atomic_min AtomicMin Shape::AtomicUpdate, Op::Atomic(AtomicFunction::Min);
    atomic_max AtomicMax Shape::AtomicUpdate, Op::Atomic(AtomicFunction::Max);
    atomic_and AtomicAnd Shape::AtomicUpdate, Op::Atomic(AtomicFunction::And);
    atomic_or AtomicOr Shape::AtomicUpdate, Op::Atomic(AtomicFunction::InclusiveOr);
    atomic_xor AtomicXor Shape::AtomicUpdate, Op::Atomic(AtomicFunction::ExclusiveOr);
    atomic_exchange AtomicExchange Shape::AtomicUpdate,
        Op::Atomic(AtomicFunction::Exchange { compare: None });
    workgroup_barrier WorkgroupBarrier Shape::Barrier, Op::Barrier(naga::Barrier::WORK_GROUP);
    storage_barrier StorageBarrier Shape::Barrier, Op::Barrier(naga::Barrier::STORAGE);
}

impl Intrinsic {
    /// Its row.
    pub fn row(self) -> &'static Row {
        // The table and the enumeration come from one list, in one order.
        &TABLE[self as usize]
    }
}

/// The row whose operation is this naga math function.
pub fn math_row(function: MathFunction) -> Option<&'static Row> {
    TABLE.iter().find(|row| row.op == Op::Math(function))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_at_their_own_index() {
        for row in TABLE {
            assert_eq!(row.intrinsic.row().name, row.name);
        }
    }

    #[test]
    fn no_two_rows_share_a_name_or_a_naga_operation() {
        for (i, a) in TABLE.iter().enumerate() {
            for b in &TABLE[..i] {
                assert!(a.name != b.name && a.op != b.op, "{} and {}", a.name, b.name);
            }
        }
    }
}
