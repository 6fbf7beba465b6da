//! How types flatten to scalars, and where those lie in memory.
//!
//! Memory of a function or workgroup is *packed*: one unit a scalar, in declaration order, as values are.
//! Buffers have the layout that the shading language gives them (*host*): one unit is a 32-bit word.

use super::error::{InterpError, Res};
use naga::{ArraySize, Handle, ScalarKind, Type, TypeInner, UniqueArena, VectorSize};

/// Kind of a scalar.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    F32,
    I32,
    U32,
    Bool,
}

/// How scalars are placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Packing {
    Packed,
    Host,
}

/// The type behind a pointer; vectors' components and matrices' columns have no handle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Pointee {
    Type(Handle<Type>),
    Vector(VectorSize, naga::Scalar),
    Scalar(naga::Scalar),
}

/// Where the parts of a composite lie.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parts {
    /// Type of each.
    pub(super) part: Pointee,
    /// Units from one to the next.
    pub(super) stride: u32,
    /// How many; `None` when the buffer's length says it.
    pub(super) count: Option<u32>,
}

/// The module's types.
#[derive(Debug, Clone, Copy)]
pub(super) struct Types<'m>(pub(super) &'m UniqueArena<Type>);

fn unsupported(inner: &TypeInner) -> InterpError {
    let what = match inner {
        TypeInner::CooperativeMatrix { .. } => "cooperative matrices",
        TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. } => "pointers as values",
        TypeInner::Image { .. } | TypeInner::Sampler { .. } => "images and samplers",
        TypeInner::AccelerationStructure { .. } | TypeInner::RayQuery { .. } => "ray queries",
        TypeInner::BindingArray { .. } => "binding arrays",
        TypeInner::Array { .. } => "runtime-sized arrays as values",
        TypeInner::Scalar(_) | TypeInner::Vector { .. } | TypeInner::Matrix { .. } | TypeInner::Atomic(_) => {
            "scalars other than f32, i32, u32 and bool"
        }
        TypeInner::Struct { .. } => "this structure",
    };
    InterpError::Unsupported { what: what.to_owned(), function: "types".to_owned() }
}

/// The kind of a scalar type, if the interpreter has it.
pub(super) fn kind(scalar: naga::Scalar) -> Res<Kind> {
    match (scalar.kind, scalar.width) {
        (ScalarKind::Float, 4) => Ok(Kind::F32),
        (ScalarKind::Sint, 4) => Ok(Kind::I32),
        (ScalarKind::Uint, 4) => Ok(Kind::U32),
        (ScalarKind::Bool, _) => Ok(Kind::Bool),
        (
            ScalarKind::Float
            | ScalarKind::Sint
            | ScalarKind::Uint
            | ScalarKind::AbstractInt
            | ScalarKind::AbstractFloat,
            _,
        ) => Err(unsupported(&TypeInner::Scalar(scalar))),
    }
}

/// Words from one column of a matrix in a buffer to the next.
fn column_stride(rows: VectorSize) -> u32 {
    if rows == VectorSize::Bi { 2 } else { 4 }
}

impl<'m> Types<'m> {
    pub(super) fn inner(self, ty: Handle<Type>) -> &'m TypeInner {
        &self.0[ty].inner
    }

    /// Kinds of the scalars of `ty`, in order.
    pub(super) fn kinds(self, ty: Pointee) -> Res<Vec<Kind>> {
        Ok(self.scalars(ty, Packing::Packed)?.into_iter().map(|(kind, _)| kind).collect())
    }

    /// Kinds of the scalars of `ty` and their places, in order.
    pub(super) fn scalars(self, ty: Pointee, packing: Packing) -> Res<Vec<(Kind, u32)>> {
        let mut out = Vec::new();
        self.push(ty, packing, 0, &mut out)?;
        Ok(out)
    }

    fn push(self, ty: Pointee, packing: Packing, at: u32, out: &mut Vec<(Kind, u32)>) -> Res<()> {
        if let Some(scalar) = self.scalar(ty) {
            out.push((kind(scalar)?, at));
        } else if let Pointee::Type(handle) = ty
            && let TypeInner::Struct { members, .. } = self.inner(handle)
        {
            for index in 0..members.len() as u32 {
                let (part, offset) = self.member(ty, index, packing)?;
                self.push(part, packing, at + offset, out)?;
            }
        } else {
            let parts = self.parts(ty, packing)?;
            let count = parts.count.ok_or_else(|| self.refuse(ty))?;
            for index in 0..count {
                self.push(parts.part, packing, at + index * parts.stride, out)?;
            }
        }
        Ok(())
    }

    fn scalar(self, ty: Pointee) -> Option<naga::Scalar> {
        match ty {
            Pointee::Scalar(scalar) => Some(scalar),
            Pointee::Vector(..) => None,
            Pointee::Type(handle) => match *self.inner(handle) {
                TypeInner::Scalar(scalar) | TypeInner::Atomic(scalar) => Some(scalar),
                TypeInner::Vector { .. }
                | TypeInner::Matrix { .. }
                | TypeInner::CooperativeMatrix { .. }
                | TypeInner::Pointer { .. }
                | TypeInner::ValuePointer { .. }
                | TypeInner::Array { .. }
                | TypeInner::Struct { .. }
                | TypeInner::Image { .. }
                | TypeInner::Sampler { .. }
                | TypeInner::AccelerationStructure { .. }
                | TypeInner::RayQuery { .. }
                | TypeInner::BindingArray { .. } => None,
            },
        }
    }

    /// The equal parts of a vector, matrix or array.
    pub(super) fn parts(self, ty: Pointee, packing: Packing) -> Res<Parts> {
        let vector = |size: VectorSize, scalar| Parts {
            part: Pointee::Scalar(scalar),
            stride: 1,
            count: Some(size as u32),
        };
        match ty {
            Pointee::Vector(size, scalar) => Ok(vector(size, scalar)),
            Pointee::Scalar(_) => Err(self.refuse(ty)),
            Pointee::Type(handle) => match *self.inner(handle) {
                TypeInner::Vector { size, scalar } => Ok(vector(size, scalar)),
                TypeInner::Matrix { columns, rows, scalar } => Ok(Parts {
                    part: Pointee::Vector(rows, scalar),
                    stride: if packing == Packing::Host { column_stride(rows) } else { rows as u32 },
                    count: Some(columns as u32),
                }),
                TypeInner::Array { base, size, stride } => Ok(Parts {
                    part: Pointee::Type(base),
                    stride: match packing {
                        Packing::Host => stride / 4,
                        Packing::Packed => self.count(Pointee::Type(base))?,
                    },
                    count: match size {
                        ArraySize::Constant(n) => Some(n.get()),
                        ArraySize::Dynamic => None,
                        ArraySize::Pending(_) => return Err(self.refuse(ty)),
                    },
                }),
                TypeInner::Scalar(_)
                | TypeInner::Atomic(_)
                | TypeInner::CooperativeMatrix { .. }
                | TypeInner::Pointer { .. }
                | TypeInner::ValuePointer { .. }
                | TypeInner::Struct { .. }
                | TypeInner::Image { .. }
                | TypeInner::Sampler { .. }
                | TypeInner::AccelerationStructure { .. }
                | TypeInner::RayQuery { .. }
                | TypeInner::BindingArray { .. } => Err(self.refuse(ty)),
            },
        }
    }

    /// Type and place of a part, of a structure or of anything with equal parts.
    pub(super) fn member(self, ty: Pointee, index: u32, packing: Packing) -> Res<(Pointee, u32)> {
        if let Pointee::Type(handle) = ty
            && let TypeInner::Struct { members, .. } = self.inner(handle)
        {
            let member = members.get(index as usize).ok_or_else(|| self.refuse(ty))?;
            let before = members.iter().take(index as usize);
            let offset = match packing {
                Packing::Host => member.offset / 4,
                Packing::Packed => before.map(|m| self.count(Pointee::Type(m.ty))).sum::<Res<u32>>()?,
            };
            return Ok((Pointee::Type(member.ty), offset));
        }
        let parts = self.parts(ty, packing)?;
        Ok((parts.part, index * parts.stride))
    }

    /// Number of scalars.
    pub(super) fn count(self, ty: Pointee) -> Res<u32> {
        if self.scalar(ty).is_some() {
            return Ok(1);
        }
        if let Pointee::Type(handle) = ty
            && let TypeInner::Struct { members, .. } = self.inner(handle)
        {
            return members.iter().map(|m| self.count(Pointee::Type(m.ty))).sum();
        }
        let parts = self.parts(ty, Packing::Packed)?;
        Ok(parts.stride * parts.count.ok_or_else(|| self.refuse(ty))?)
    }

    fn refuse(self, ty: Pointee) -> InterpError {
        match ty {
            Pointee::Type(handle) => unsupported(self.inner(handle)),
            Pointee::Vector(..) | Pointee::Scalar(_) => InterpError::Malformed("a scalar has no parts"),
        }
    }
}
