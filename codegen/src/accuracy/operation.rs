//! What the tables have rows for.

use crate::intrinsics::{Intrinsic, Shape, TABLE};
use naga::BinaryOperator;
use std::fmt;

/// An operation on floats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
    /// A built-in function.
    Builtin(Intrinsic),
    /// An infix operator.
    Infix(BinaryOperator),
    /// `-x`
    Negate,
    /// A conversion from an integer.
    FromInteger,
}

/// Those that are no built-in functions.
const OPERATORS: [Operation; 13] = {
    use BinaryOperator as B;
    [
        Operation::Negate,
        Operation::FromInteger,
        Operation::Infix(B::Add),
        Operation::Infix(B::Subtract),
        Operation::Infix(B::Multiply),
        Operation::Infix(B::Divide),
        Operation::Infix(B::Modulo),
        Operation::Infix(B::Equal),
        Operation::Infix(B::NotEqual),
        Operation::Infix(B::Less),
        Operation::Infix(B::LessEqual),
        Operation::Infix(B::Greater),
        Operation::Infix(B::GreaterEqual),
    ]
};

/// Whether operations of this shape compute with floats; `select` only moves them.
const fn computes_floats(shape: Shape) -> bool {
    match shape {
        Shape::Float(_)
        | Shape::Numeric(_)
        | Shape::Signed
        | Shape::Reduce(_)
        | Shape::Cross
        | Shape::Vector(_)
        | Shape::Refract
        | Shape::Transpose => true,
        Shape::Integer
        | Shape::ExtractBits
        | Shape::InsertBits
        | Shape::Select
        | Shape::Relational
        | Shape::AtomicLoad
        | Shape::AtomicStore
        | Shape::AtomicUpdate
        | Shape::Barrier => false,
    }
}

/// Place of every built-in function among [`Operation::all`]; of those without floats, the place of the next.
const PLACES: [usize; TABLE.len()] = {
    let mut places = [0; TABLE.len()];
    let (mut i, mut next) = (0, OPERATORS.len());
    while i < TABLE.len() {
        places[i] = next;
        next += computes_floats(TABLE[i].shape) as usize;
        i += 1;
    }
    places
};

impl Operation {
    /// Every operation that has a row.
    pub fn all() -> impl Iterator<Item = Self> {
        let builtins = TABLE.iter().filter(|row| computes_floats(row.shape));
        OPERATORS.into_iter().chain(builtins.map(|row| Self::Builtin(row.intrinsic)))
    }

    /// Whether SPIR-V has it for `f64`, or it is one product.
    pub(super) fn takes_doubles(self) -> bool {
        use Intrinsic as I;
        let Self::Builtin(intrinsic) = self else { return true };
        !matches!(
            intrinsic,
            I::Sin
                | I::Cos
                | I::Tan
                | I::Asin
                | I::Acos
                | I::Atan
                | I::Atan2
                | I::Sinh
                | I::Cosh
                | I::Tanh
                | I::Asinh
                | I::Acosh
                | I::Atanh
                | I::Pow
                | I::Exp
                | I::Exp2
                | I::Log
                | I::Log2
        )
    }

    /// Its place in [`Operation::all`], if it computes with floats.
    pub(super) fn index(self) -> Option<usize> {
        match self {
            Self::Builtin(intrinsic) => {
                computes_floats(intrinsic.row().shape).then(|| PLACES[intrinsic as usize])
            }
            _ => OPERATORS.iter().position(|operator| *operator == self),
        }
    }
}

impl fmt::Display for Operation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        use BinaryOperator as B;
        match self {
            Self::Builtin(intrinsic) => f.write_str(intrinsic.row().name),
            Self::Negate => f.write_str("-x"),
            Self::FromInteger => f.write_str("f32(i)"),
            Self::Infix(op) => f.write_str(match op {
                B::Add => "x + y",
                B::Subtract => "x - y",
                B::Multiply => "x * y",
                B::Divide => "x / y",
                B::Modulo => "x % y",
                B::Equal => "x == y",
                B::NotEqual => "x != y",
                B::Less => "x < y",
                B::LessEqual => "x <= y",
                B::Greater => "x > y",
                B::GreaterEqual => "x >= y",
                B::And
                | B::ExclusiveOr
                | B::InclusiveOr
                | B::LogicalAnd
                | B::LogicalOr
                | B::ShiftLeft
                | B::ShiftRight => "no operator on floats",
            }),
        }
    }
}
