//! The one table of built-in operations: name, signature, naga operation, accuracy class.
//!
//! Everything that knows an operation iterates this table: the names that kernels may call
//! ([`crate::prelude`]), the lowering to naga, the interpreter's shadow lane, the op-conformance
//! tests.
//! The native form of each function is the one of the same name in [`crate::math`].
//!
//! The accuracy classes are the looser of WGSL section 15.7.4 ("Floating Point Accuracy") and the
//! Vulkan specification, appendix "Precision and Operation of SPIR-V Instructions", tables
//! "Precision of core SPIR-V Instructions" and "Precision of GLSL.std.450 Instructions".

use naga::{AtomicFunction, BinaryOperator, MathFunction, RelationalFunction};

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

/// How far a driver's result may lie from the exact one.
///
/// One ULP is taken as `2^-23` of the result's magnitude, which no representable value exceeds.
/// Beside its class, every float operation may flush subnormal operands and results to zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// The result is representable, and that one is returned.
    Exact,
    /// One of the two floats that enclose the exact result.
    Correct,
    /// So many ULP.
    Ulp(f64),
    /// `base + slope·|x|` ULP, `x` being the argument.
    UlpScaled {
        /// At 0.
        base: f64,
        /// Growth.
        slope: f64,
    },
    /// An absolute error for arguments in `from..=to`, so many ULP elsewhere.
    UlpOrAbsolute {
        /// Elsewhere.
        ulp: f64,
        /// Within the range.
        absolute: f64,
        /// Begin of the range.
        from: f64,
        /// End of the range.
        to: f64,
    },
    /// An absolute error for arguments in `from..=to`, no promise elsewhere.
    AbsoluteOn {
        /// Within the range.
        absolute: f64,
        /// Begin of the range.
        from: f64,
        /// End of the range.
        to: f64,
    },
    /// As accurate as this formula of other operations.
    Inherited(&'static str),
    /// The worse of an absolute error and of this formula.
    InheritedOrAbsolute(&'static str, f64),
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
    /// Accuracy on floats; results on integers are exact.
    pub accuracy: Accuracy,
}

const SIN: Accuracy =
    Accuracy::AbsoluteOn { absolute: 0.00048828125, from: -std::f64::consts::PI, to: std::f64::consts::PI };
const LOG: Accuracy = Accuracy::UlpOrAbsolute { ulp: 3.0, absolute: 4.76837158203125e-7, from: 0.5, to: 2.0 };
const EXP: Accuracy = Accuracy::UlpScaled { base: 3.0, slope: 2.0 };

macro_rules! table {
    ($($name:ident $variant:ident $shape:expr, $op:expr, $accuracy:expr;)*) => {
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
                accuracy: $accuracy,
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

use Accuracy::{Correct, Exact, Inherited, InheritedOrAbsolute, Ulp};
use MathFunction as M;
use Shape::{Float, Numeric, Reduce, Vector};

table! {
    abs Abs Shape::Signed, Op::Math(M::Abs), Exact;
    min Min Numeric(2), Op::Math(M::Min), Exact;
    max Max Numeric(2), Op::Math(M::Max), Exact;
    clamp Clamp Numeric(3), Op::Math(M::Clamp), Exact;
    saturate Saturate Float(1), Op::Math(M::Saturate), Exact;
    sign Sign Shape::Signed, Op::Math(M::Sign), Exact;
    ceil Ceil Float(1), Op::Math(M::Ceil), Exact;
    floor Floor Float(1), Op::Math(M::Floor), Exact;
    round Round Float(1), Op::Math(M::Round), Exact;
    trunc Trunc Float(1), Op::Math(M::Trunc), Exact;
    fract Fract Float(1), Op::Math(M::Fract), Correct;
    step Step Float(2), Op::Math(M::Step), Exact;

    sqrt Sqrt Float(1), Op::Math(M::Sqrt), Inherited("1.0 / inverse_sqrt(x)");
    inverse_sqrt InverseSqrt Float(1), Op::Math(M::InverseSqrt), Ulp(2.0);
    exp Exp Float(1), Op::Math(M::Exp), EXP;
    exp2 Exp2 Float(1), Op::Math(M::Exp2), EXP;
    log Log Float(1), Op::Math(M::Log), LOG;
    log2 Log2 Float(1), Op::Math(M::Log2), LOG;
    pow Pow Float(2), Op::Math(M::Pow), Inherited("exp2(y * log2(x))");

    sin Sin Float(1), Op::Math(M::Sin), SIN;
    cos Cos Float(1), Op::Math(M::Cos), SIN;
    tan Tan Float(1), Op::Math(M::Tan), Inherited("sin(x) / cos(x)");
    asin Asin Float(1), Op::Math(M::Asin), InheritedOrAbsolute("atan2(x, sqrt(1.0 - x * x))", 6.81e-5);
    acos Acos Float(1), Op::Math(M::Acos), InheritedOrAbsolute("atan2(sqrt(1.0 - x * x), x)", 6.81e-5);
    atan Atan Float(1), Op::Math(M::Atan), Ulp(4096.0);
    atan2 Atan2 Float(2), Op::Math(M::Atan2), Ulp(4096.0);
    sinh Sinh Float(1), Op::Math(M::Sinh), Inherited("(exp(x) - exp(-x)) * 0.5");
    cosh Cosh Float(1), Op::Math(M::Cosh), Inherited("(exp(x) + exp(-x)) * 0.5");
    tanh Tanh Float(1), Op::Math(M::Tanh), InheritedOrAbsolute("sinh(x) / cosh(x)", 1e-5);
    asinh Asinh Float(1), Op::Math(M::Asinh), Inherited("log(x + sqrt(x * x + 1.0))");
    acosh Acosh Float(1), Op::Math(M::Acosh), Inherited("log(x + sqrt(x * x - 1.0))");
    atanh Atanh Float(1), Op::Math(M::Atanh), Inherited("log((1.0 + x) / (1.0 - x)) * 0.5");

    degrees Degrees Float(1), Op::Math(M::Degrees), Inherited("x * 57.295779513082322865");
    radians Radians Float(1), Op::Math(M::Radians), Inherited("x * 0.017453292519943295474");
    fma Fma Float(3), Op::Math(M::Fma), Inherited("x * y + z");
    mix Mix Float(3), Op::Math(M::Mix), Inherited("x * (1.0 - z) + y * z");
    smoothstep SmoothStep Float(3), Op::Math(M::SmoothStep),
        Inherited("t * t * (3.0 - 2.0 * t), t = clamp((z - x) / (y - x), 0.0, 1.0)");

    dot Dot Reduce(2), Op::Math(M::Dot), Inherited("x[0] * y[0] + x[1] * y[1] + ..");
    length Length Reduce(1), Op::Math(M::Length), Inherited("sqrt(dot(x, x))");
    distance Distance Reduce(2), Op::Math(M::Distance), Inherited("length(x - y)");
    normalize Normalize Vector(1), Op::Math(M::Normalize), Inherited("x / length(x)");
    cross Cross Shape::Cross, Op::Math(M::Cross), Inherited("x[i] * y[j] - x[j] * y[i]");
    reflect Reflect Vector(2), Op::Math(M::Reflect), Inherited("x - 2.0 * dot(x, y) * y");
    refract Refract Shape::Refract, Op::Math(M::Refract),
        Inherited("z * x - (z * dot(y, x) + sqrt(k)) * y, k = 1.0 - z * z * (1.0 - dot(y, x) * dot(y, x))");
    face_forward FaceForward Vector(3), Op::Math(M::FaceForward), Inherited("select(-x, x, dot(y, z) < 0.0)");
    transpose Transpose Shape::Transpose, Op::Math(M::Transpose), Exact;

    count_one_bits CountOneBits Shape::Integer, Op::Math(M::CountOneBits), Exact;
    count_leading_zeros CountLeadingZeros Shape::Integer, Op::Math(M::CountLeadingZeros), Exact;
    count_trailing_zeros CountTrailingZeros Shape::Integer, Op::Math(M::CountTrailingZeros), Exact;
    reverse_bits ReverseBits Shape::Integer, Op::Math(M::ReverseBits), Exact;
    first_leading_bit FirstLeadingBit Shape::Integer, Op::Math(M::FirstLeadingBit), Exact;
    first_trailing_bit FirstTrailingBit Shape::Integer, Op::Math(M::FirstTrailingBit), Exact;
    extract_bits ExtractBits Shape::ExtractBits, Op::Math(M::ExtractBits), Exact;
    insert_bits InsertBits Shape::InsertBits, Op::Math(M::InsertBits), Exact;

    select Select Shape::Select, Op::Select, Exact;
    all All Shape::Relational, Op::Relational(RelationalFunction::All), Exact;
    any Any Shape::Relational, Op::Relational(RelationalFunction::Any), Exact;

    atomic_load AtomicLoad Shape::AtomicLoad, Op::AtomicLoad, Exact;
    atomic_store AtomicStore Shape::AtomicStore, Op::AtomicStore, Exact;
    atomic_add AtomicAdd Shape::AtomicUpdate, Op::Atomic(AtomicFunction::Add), Exact;
    atomic_sub AtomicSub Shape::AtomicUpdate, Op::Atomic(AtomicFunction::Subtract), Exact;
    atomic_min AtomicMin Shape::AtomicUpdate, Op::Atomic(AtomicFunction::Min), Exact;
    atomic_max AtomicMax Shape::AtomicUpdate, Op::Atomic(AtomicFunction::Max), Exact;
    atomic_and AtomicAnd Shape::AtomicUpdate, Op::Atomic(AtomicFunction::And), Exact;
    atomic_or AtomicOr Shape::AtomicUpdate, Op::Atomic(AtomicFunction::InclusiveOr), Exact;
    atomic_xor AtomicXor Shape::AtomicUpdate, Op::Atomic(AtomicFunction::ExclusiveOr), Exact;
    atomic_exchange AtomicExchange Shape::AtomicUpdate,
        Op::Atomic(AtomicFunction::Exchange { compare: None }), Exact;
    workgroup_barrier WorkgroupBarrier Shape::Barrier, Op::Barrier(naga::Barrier::WORK_GROUP), Exact;
    storage_barrier StorageBarrier Shape::Barrier, Op::Barrier(naga::Barrier::STORAGE), Exact;
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

/// Accuracy of an infix operator on floats.
pub fn operator_accuracy(op: BinaryOperator) -> Accuracy {
    match op {
        // 2.5 ULP while the divisor lies in 2^-126 ..= 2^126; the shadow lane refuses others.
        BinaryOperator::Divide => Ulp(2.5),
        BinaryOperator::Modulo => Inherited("x - y * trunc(x / y)"),
        BinaryOperator::Add | BinaryOperator::Subtract | BinaryOperator::Multiply => Correct,
        BinaryOperator::Equal
        | BinaryOperator::NotEqual
        | BinaryOperator::Less
        | BinaryOperator::LessEqual
        | BinaryOperator::Greater
        | BinaryOperator::GreaterEqual
        | BinaryOperator::And
        | BinaryOperator::ExclusiveOr
        | BinaryOperator::InclusiveOr
        | BinaryOperator::LogicalAnd
        | BinaryOperator::LogicalOr
        | BinaryOperator::ShiftLeft
        | BinaryOperator::ShiftRight => Exact,
    }
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
