//! Values of all lanes: a column for each scalar of a type.

use super::error::{Internal, Result};
use super::model::Model;
use naga::{ArraySize, Handle, Module, ScalarKind, Type, TypeInner};
use std::rc::Rc;

/// One scalar of a type, in all lanes.
#[derive(Debug, Clone)]
pub(super) enum Column<M: Model> {
    /// Floats.
    F(Vec<M::F>),
    /// Integers of 32 bits; signedness is the type's.
    W(Vec<M::W>),
    /// Booleans.
    B(Vec<M::B>),
}

/// Which column a scalar has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    F,
    W,
    B,
}

impl<M: Model> Column<M> {
    /// Zeros.
    pub(super) fn zero(kind: Kind, lanes: usize) -> Self {
        match kind {
            Kind::F => Self::F(vec![M::float(0.0, 0.0); lanes]),
            Kind::W => Self::W(vec![M::word(0); lanes]),
            Kind::B => Self::B(vec![M::bool(false); lanes]),
        }
    }

    /// The floats.
    pub(super) fn floats(&self) -> Result<&[M::F]> {
        match self {
            Self::F(lanes) => Ok(lanes),
            Self::W(_) | Self::B(_) => Err(Internal::Kind.into()),
        }
    }

    /// The integers.
    pub(super) fn words(&self) -> Result<&[M::W]> {
        match self {
            Self::W(lanes) => Ok(lanes),
            Self::F(_) | Self::B(_) => Err(Internal::Kind.into()),
        }
    }

    /// The booleans.
    pub(super) fn bools(&self) -> Result<&[M::B]> {
        match self {
            Self::B(lanes) => Ok(lanes),
            Self::F(_) | Self::W(_) => Err(Internal::Kind.into()),
        }
    }

    /// Takes over the lanes of `from` where `mask` holds.
    pub(super) fn store(&mut self, from: &Self, mask: &[bool]) -> Result<()> {
        match (self, from) {
            (Self::F(to), Self::F(from)) => blend(to, from, mask),
            (Self::W(to), Self::W(from)) => blend(to, from, mask),
            (Self::B(to), Self::B(from)) => blend(to, from, mask),
            (Self::F(_) | Self::W(_) | Self::B(_), _) => return Err(Internal::Kind.into()),
        }
        Ok(())
    }

    /// Lane `i` of `from` into lane `i` of this.
    pub(super) fn copy_lane(&mut self, from: &Self, i: usize) {
        match (self, from) {
            (Self::F(to), Self::F(from)) => to[i] = from[i],
            (Self::W(to), Self::W(from)) => to[i] = from[i],
            (Self::B(to), Self::B(from)) => to[i] = from[i],
            (Self::F(_) | Self::W(_) | Self::B(_), _) => {}
        }
    }

    /// `accept` where the condition holds, otherwise `reject`.
    pub(super) fn select(condition: &[M::B], accept: &Self, reject: &Self) -> Result<Self> {
        Ok(match (accept, reject) {
            (Self::F(a), Self::F(r)) => Self::F(choose(condition, a, r, M::select_float)),
            (Self::W(a), Self::W(r)) => Self::W(choose(condition, a, r, M::select_word)),
            (Self::B(a), Self::B(r)) => Self::B(choose(condition, a, r, M::select_bool)),
            (Self::F(_) | Self::W(_) | Self::B(_), _) => return Err(Internal::Kind.into()),
        })
    }
}

fn blend<T: Copy>(to: &mut [T], from: &[T], mask: &[bool]) {
    for ((to, from), &on) in to.iter_mut().zip(from).zip(mask) {
        *to = if on { *from } else { *to };
    }
}

fn choose<B: Copy, T: Copy>(condition: &[B], accept: &[T], reject: &[T], f: fn(B, T, T) -> T) -> Vec<T> {
    condition.iter().zip(accept).zip(reject).map(|((&c, &a), &r)| f(c, a, r)).collect()
}

/// A value of any type: its scalars in declaration order.
pub(super) type Value<M> = Rc<Vec<Column<M>>>;

/// What an expression stands for.
#[derive(Debug, Clone)]
pub(super) enum Slot<M: Model> {
    /// A value.
    Value(Value<M>),
    /// A reference to memory.
    Pointer(Pointer),
}

/// A reference to memory: some variable, and the index of its first scalar there.
#[derive(Debug, Clone)]
pub(super) struct Pointer {
    /// The variable.
    pub(super) root: Root,
    /// First scalar, for all lanes or for each.
    pub(super) offset: Offset,
    /// What it points to.
    pub(super) ty: Pointee,
}

/// Where memory lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Root {
    /// Each lane's own: an index into the executor's private variables.
    Private(usize),
    /// Shared by all lanes: a global variable.
    Shared(Handle<naga::GlobalVariable>),
}

/// An index of scalars.
#[derive(Debug, Clone)]
pub(super) enum Offset {
    /// The same in all lanes.
    Same(usize),
    /// One for each lane.
    Each(Rc<Vec<usize>>),
}

impl Offset {
    /// Of lane `i`.
    pub(super) fn lane(&self, i: usize) -> usize {
        match self {
            Self::Same(offset) => *offset,
            Self::Each(offsets) => offsets[i],
        }
    }
}

/// The type behind a pointer: a vector's component has no type of its own in the arena.
#[derive(Debug, Clone, Copy)]
pub(super) enum Pointee {
    /// Of the arena.
    Type(Handle<Type>),
    /// A component of a vector, or a column of a matrix: so many scalars of this kind.
    Scalars(usize, Kind),
}

/// The kinds of all scalars of a type; a runtime array has those of one element.
pub(super) fn kinds(module: &Module, inner: &TypeInner, out: &mut Vec<Kind>) -> Result<()> {
    match *inner {
        TypeInner::Scalar(s) | TypeInner::Atomic(s) => out.push(kind(s)?),
        TypeInner::Vector { size, scalar } => out.extend(vec![kind(scalar)?; size as usize]),
        TypeInner::Matrix { columns, rows, scalar } => {
            out.extend(vec![kind(scalar)?; columns as usize * rows as usize]);
        }
        TypeInner::Array { base, size, .. } => {
            for _ in 0..fixed(size)?.unwrap_or(1) {
                kinds(module, &module.types[base].inner, out)?;
            }
        }
        TypeInner::Struct { ref members, .. } => {
            members.iter().try_for_each(|m| kinds(module, &module.types[m.ty].inner, out))?;
        }
        TypeInner::Pointer { .. }
        | TypeInner::ValuePointer { .. }
        | TypeInner::Image { .. }
        | TypeInner::Sampler { .. }
        | TypeInner::AccelerationStructure { .. }
        | TypeInner::RayQuery { .. }
        | TypeInner::CooperativeMatrix { .. }
        | TypeInner::BindingArray { .. } => return Err(Internal::Type.into()),
    }
    Ok(())
}

/// How many scalars a type has.
pub(super) fn width(module: &Module, inner: &TypeInner) -> Result<usize> {
    Ok(match *inner {
        TypeInner::Array { base, size, .. } => {
            fixed(size)?.unwrap_or(1) * width(module, &module.types[base].inner)?
        }
        TypeInner::Struct { ref members, .. } => {
            members.iter().map(|m| width(module, &module.types[m.ty].inner)).sum::<Result<usize>>()?
        }
        _ => {
            let mut out = Vec::new();
            kinds(module, inner, &mut out)?;
            out.len()
        }
    })
}

/// The length of an array; `None` if that is known only when it runs.
pub(super) fn fixed(size: ArraySize) -> Result<Option<usize>> {
    match size {
        ArraySize::Constant(n) => Ok(Some(n.get() as usize)),
        ArraySize::Dynamic => Ok(None),
        ArraySize::Pending(_) => Err(Internal::Type.into()),
    }
}

pub(super) fn kind(scalar: naga::Scalar) -> Result<Kind> {
    match (scalar.kind, scalar.width) {
        (ScalarKind::Float, 4) => Ok(Kind::F),
        (ScalarKind::Sint | ScalarKind::Uint, 4) => Ok(Kind::W),
        (ScalarKind::Bool, _) => Ok(Kind::B),
        (
            ScalarKind::Float
            | ScalarKind::Sint
            | ScalarKind::Uint
            | ScalarKind::AbstractInt
            | ScalarKind::AbstractFloat,
            _,
        ) => Err(Internal::Type.into()),
    }
}

impl<M: Model> Column<M> {
    /// Lane `i`: what `accept` has where the condition holds, otherwise what is here.
    pub(super) fn join_lane(&mut self, accept: &Self, i: usize, condition: M::B) {
        match (self, accept) {
            (Self::F(r), Self::F(a)) => r[i] = M::select_float(condition, a[i], r[i]),
            (Self::W(r), Self::W(a)) => r[i] = M::select_word(condition, a[i], r[i]),
            (Self::B(r), Self::B(a)) => r[i] = M::select_bool(condition, a[i], r[i]),
            (Self::F(_) | Self::W(_) | Self::B(_), _) => {}
        }
    }
}
