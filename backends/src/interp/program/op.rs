//! The table of operations on scalars.
//!
//! To add one: a variant here, its result in [`Op::result`]; its lowering in the family's file of `lower`; its
//! form on lanes in the family's file of `fast::ops`. Exhaustive matches name what is still missing.

use super::{Count, Place};

/// What a register holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Scalar {
    /// All ones or zero.
    Bool,
    I32,
    U32,
    F32,
    /// Held as f32, rounded after each operation.
    F16,
    /// Held in 32 bits, extended by its sign.
    I16,
    /// Held in 32 bits, extended by zeros.
    U16,
    I64,
    U64,
    F64,
}

impl Scalar {
    /// Whether it takes 64 bits.
    pub(crate) fn wide(self) -> bool {
        match self {
            Self::I64 | Self::U64 | Self::F64 => true,
            Self::Bool | Self::I16 | Self::U16 | Self::I32 | Self::U32 | Self::F32 | Self::F16 => false,
        }
    }

    /// Whether it is a word of 32 bits in memory.
    pub(crate) fn is_word(self) -> bool {
        matches!(self, Self::I32 | Self::U32 | Self::F32)
    }

    /// Bytes in memory.
    pub(crate) fn bytes(self) -> u32 {
        match self {
            Self::F16 | Self::I16 | Self::U16 => 2,
            Self::Bool | Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// Whether it is a float.
    pub(crate) fn float(self) -> bool {
        match self {
            Self::F32 | Self::F16 | Self::F64 => true,
            Self::Bool | Self::I16 | Self::U16 | Self::I32 | Self::U32 | Self::I64 | Self::U64 => false,
        }
    }

    /// Whether it is a signed integer.
    pub(crate) fn signed(self) -> bool {
        match self {
            Self::I16 | Self::I32 | Self::I64 => true,
            Self::Bool | Self::U16 | Self::U32 | Self::U64 | Self::F32 | Self::F16 | Self::F64 => false,
        }
    }
}

/// Operations on floats, as [`lobe_codegen::math::scalar`] has them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum FloatOp {
    Add,
    Sub,
    Mul,
    Div,
    Rem,
    Neg,
    /// `a * a`, both factors being the same number.
    Square,
    /// `a`, of which a decision has told that it is not negative.
    Nonnegative,
    Abs,
    Min,
    Max,
    Sign,
    Ceil,
    Floor,
    Round,
    Trunc,
    Fract,
    Step,
    Clamp,
    Saturate,
    Sqrt,
    InverseSqrt,
    Exp,
    Exp2,
    Log,
    Log2,
    Pow,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Degrees,
    Radians,
    /// Of a number: its magnitude.
    Length,
    Fma,
    Mix,
    SmoothStep,
    /// Of `frexp`, the number in `[0.5, 1)`.
    Significand,
}

/// Operations on integers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum IntOp {
    Add,
    Sub,
    Mul,
    /// `a` when `b` is zero or the quotient overflows.
    Div,
    /// 0 when `b` is zero or the quotient overflows.
    Rem,
    Neg,
    Not,
    And,
    Or,
    Xor,
    /// By a u32, of which the lower bits count.
    Shl,
    Shr,
    Abs,
    Sign,
    Min,
    Max,
    Clamp,
    CountOneBits,
    CountLeadingZeros,
    CountTrailingZeros,
    ReverseBits,
    FirstLeadingBit,
    FirstTrailingBit,
    ExtractBits,
    InsertBits,
}

/// Comparisons; greater is less with its operands exchanged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Comparison {
    Equal,
    NotEqual,
    Less,
    LessEqual,
}

/// Operations on booleans.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum LogicOp {
    Not,
    And,
    Or,
    Xor,
    /// `a == b`
    Same,
    /// `a && !b`; made by passes.
    AndNot,
}

/// What the executor knows before the program runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Input {
    /// A column of the arguments.
    Column(u32),
    GlobalInvocationId(u8),
    LocalInvocationId(u8),
    LocalInvocationIndex,
    WorkGroupId(u8),
    NumWorkGroups(u8),
    WorkGroupSize(u8),
    SubgroupInvocationId,
    SubgroupId,
    SubgroupSize,
    NumSubgroups,
}

/// A binary operation of a [`Op::Fused`] pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Simple {
    Add,
    Sub,
    Mul,
}

/// What a judge wants to know of a value; the value is the first operand. Lowered for judges alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Mark {
    /// A result of a function.
    Settled,
    /// The result of a function that stands for an exact one, of [`super::Program::truths`]; then its arguments.
    Truth(u32),
    /// Zero, of a variable that nothing was written to; has no operand.
    Unwritten,
}

/// A pure, total operation on scalars.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Op {
    /// The operand itself.
    Copy(Scalar),
    /// Something that the executor provides.
    Input(Input, Scalar),
    Float(Scalar, FloatOp),
    Int(Scalar, IntOp),
    Compare(Scalar, Comparison),
    Logic(LogicOp),
    IsNan(Scalar),
    IsInf(Scalar),
    /// Of condition, accepted and rejected value.
    Select(Scalar),
    /// The nearest number of another type, as WGSL converts.
    Convert(Scalar, Scalar),
    /// The same bits as another type of the same size.
    Bitcast(Scalar, Scalar),
    /// Of `frexp`, the power of two, as i32.
    Exponent(Scalar),
    /// A float times two to the power of an i32.
    Ldexp(Scalar),
    /// `args[1] + min(args[0], count - 1) * stride`; without `args[1]` nothing is added.
    Index {
        count: Count,
        stride: u32,
    },
    /// `args[1] + min(args[0], args[2] - 1) * stride`: of a runtime-sized array in an element of a binding array.
    IndexWithin {
        stride: u32,
    },
    /// Elements of a runtime-sized array.
    Length {
        buffer: u32,
        begin: u32,
        stride: u32,
    },
    /// What memory holds. `epoch` tells loads apart that a store may lie between.
    Load {
        place: Place,
        scalar: Scalar,
        epoch: u32,
    },
    /// See [`Mark`].
    Mark(Scalar, Mark),
    /// `(a first b) second c`, or `c second (a first b)` if `flipped`; rounded twice. Made by passes.
    Fused {
        first: Simple,
        second: Simple,
        flipped: bool,
    },
    /// A polynomial in `args[0]` by Horner's rule, each product and each sum rounded. It begins with `args[1]` if
    /// `begun`; its coefficients are `count` constants from `first` on. Made by passes.
    Horner {
        first: u32,
        count: u32,
        begun: bool,
    },
}

impl Op {
    /// What the result is.
    pub(crate) fn result(self) -> Scalar {
        match self {
            Self::Copy(s)
            | Self::Input(_, s)
            | Self::Float(s, _)
            | Self::Int(s, _)
            | Self::Select(s)
            | Self::Convert(_, s)
            | Self::Bitcast(_, s)
            | Self::Ldexp(s)
            | Self::Mark(s, _)
            | Self::Load { scalar: s, .. } => s,
            Self::Compare(..) | Self::Logic(_) | Self::IsNan(_) | Self::IsInf(_) => Scalar::Bool,
            Self::Exponent(_) => Scalar::I32,
            Self::Index { .. } | Self::IndexWithin { .. } | Self::Length { .. } => Scalar::U32,
            Self::Fused { .. } | Self::Horner { .. } => Scalar::F32,
        }
    }

    /// The memory that it reads.
    pub(crate) fn place(self) -> Option<Place> {
        match self {
            Self::Load { place, .. } => Some(place),
            Self::Copy(_)
            | Self::Input(..)
            | Self::Float(..)
            | Self::Int(..)
            | Self::Compare(..)
            | Self::Logic(_)
            | Self::IsNan(_)
            | Self::IsInf(_)
            | Self::Select(_)
            | Self::Convert(..)
            | Self::Bitcast(..)
            | Self::Exponent(_)
            | Self::Ldexp(_)
            | Self::Index { .. }
            | Self::IndexWithin { .. }
            | Self::Length { .. }
            | Self::Mark(..)
            | Self::Fused { .. }
            | Self::Horner { .. } => None,
        }
    }
}
