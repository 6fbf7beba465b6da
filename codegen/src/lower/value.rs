//! Values and places while a function is under construction.

use crate::def::{Scalar, TypeDef};
use naga::{Expression, Handle, Literal};

pub(super) const F32: TypeDef = TypeDef::Scalar(Scalar::F32);
pub(super) const I32: TypeDef = TypeDef::Scalar(Scalar::I32);
pub(super) const U32: TypeDef = TypeDef::Scalar(Scalar::U32);
pub(super) const BOOL: TypeDef = TypeDef::Scalar(Scalar::Bool);

/// A value: not yet in the arena as long as it is a literal, so that literals fold.
#[derive(Debug, Clone, Copy)]
pub(super) struct Value {
    pub(super) ty: TypeDef,
    pub(super) repr: Repr,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Repr {
    Expr(Handle<Expression>),
    Literal(Lit),
}

/// A literal under folding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Lit {
    /// The f32, and the value that the source's decimals state.
    F32(f32, f64),
    I32(i32),
    U32(u32),
    /// An integer whose type is not decided yet.
    Int(i64),
    Bool(bool),
}

impl Lit {
    pub(super) fn ty(self) -> TypeDef {
        match self {
            Self::F32(..) => F32,
            Self::I32(_) | Self::Int(_) => I32,
            Self::U32(_) => U32,
            Self::Bool(_) => BOOL,
        }
    }

    pub(super) fn naga(self) -> Literal {
        match self {
            Self::F32(value, _) => Literal::F32(value),
            Self::I32(value) => Literal::I32(value),
            Self::U32(value) => Literal::U32(value),
            // An undecided integer is an i32, as in Rust.
            Self::Int(value) => Literal::I32(value as i32),
            Self::Bool(value) => Literal::Bool(value),
        }
    }

    /// The number of an integer; 0 for others.
    pub(super) fn as_i64(self) -> i64 {
        match self {
            Self::Int(value) => value,
            Self::I32(value) => value.into(),
            Self::U32(value) => value.into(),
            Self::F32(..) | Self::Bool(_) => 0,
        }
    }

    /// The same number as a literal of type `ty`, if it is undecided and fits.
    pub(super) fn decide(self, ty: &TypeDef) -> Self {
        let element = match ty {
            TypeDef::Scalar(s) | TypeDef::Vector(_, s) => *s,
            TypeDef::Matrix(..)
            | TypeDef::Array(..)
            | TypeDef::Slice(_)
            | TypeDef::Atomic(_)
            | TypeDef::Struct(_) => return self,
        };
        match (self, element) {
            (Self::Int(v), Scalar::U32) => u32::try_from(v).map_or(self, Self::U32),
            (Self::Int(v), Scalar::I32) => i32::try_from(v).map_or(self, Self::I32),
            (Self::Int(_), Scalar::F32 | Scalar::Bool)
            | (Self::F32(..) | Self::I32(_) | Self::U32(_) | Self::Bool(_), _) => self,
        }
    }
}

impl Value {
    pub(super) fn expr(ty: TypeDef, handle: Handle<Expression>) -> Self {
        Self { ty, repr: Repr::Expr(handle) }
    }

    pub(super) fn literal(lit: Lit) -> Self {
        Self { ty: lit.ty(), repr: Repr::Literal(lit) }
    }

    pub(super) fn float(value: f64) -> Self {
        Self::literal(Lit::F32(value as f32, value))
    }

    /// Decides the type of an undecided integer literal.
    pub(super) fn decide(self, ty: &TypeDef) -> Self {
        match self.repr {
            Repr::Literal(lit) => Self::literal(lit.decide(ty)),
            Repr::Expr(_) => self,
        }
    }

    /// Decides the type of an undecided integer literal by a value of decided type beside it.
    pub(super) fn follow(self, other: &Self) -> Self {
        if other.is_undecided() { self } else { self.decide(&other.ty) }
    }

    /// Whether it is an integer literal without a decided type.
    pub(super) fn is_undecided(&self) -> bool {
        matches!(self.repr, Repr::Literal(Lit::Int(_)))
    }
}

/// Memory: a variable, a binding, or a part of one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) pointer: Handle<Expression>,
    pub(super) ty: TypeDef,
}

/// Where the value of a block goes.
#[derive(Debug, Clone, Copy)]
pub(super) enum Sink {
    /// Nowhere: it is a statement.
    Discard,
    /// Out of the function.
    Return,
    /// Into a variable, made by the first branch that has a value.
    Variable {
        /// What to call it.
        name: Option<&'static str>,
        /// A type to take for integers without suffix; another may turn out.
        expected: Option<TypeDef>,
        /// Once made.
        place: Option<Place>,
    },
}
