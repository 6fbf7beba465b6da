//! How types flatten to scalars, and where those lie in memory.
//!
//! Variables of lanes and of workgroups are *packed*: one unit a scalar, in declaration order, as values are.
//! Buffers have the layout that the shading language gives them (*host*), in bytes.

use super::super::error::{InterpError, Res};
use super::super::program::Scalar;
use naga::{ArraySize, Handle, ScalarKind, Type, TypeInner, VectorSize};

/// How scalars are placed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Packing {
    /// Scalar after scalar, each of so many units.
    Packed(u32),
    /// As the shading language has it, in bytes.
    Host,
}

/// The type behind a pointer or of a value; vectors' components and matrices' columns have no handle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Shape {
    Type(Handle<Type>),
    Matrix(VectorSize, VectorSize, naga::Scalar),
    Vector(VectorSize, naga::Scalar),
    Scalar(naga::Scalar),
}

/// Where the equal parts of a composite lie.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Parts {
    /// Type of each.
    pub(crate) part: Shape,
    /// Units from one to the next.
    pub(crate) stride: u32,
    /// How many; `None` when the buffer's length says it.
    pub(crate) count: Option<u32>,
}

/// Scalars of a variable or value: each lane has them all.
const MOST: u32 = 1 << 20;

/// The module's types.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Types<'m>(pub(crate) &'m naga::Module);

/// The scalar of a naga type, if programs have it.
pub(crate) fn scalar(scalar: naga::Scalar) -> Res<Scalar> {
    match (scalar.kind, scalar.width) {
        (ScalarKind::Float, 4) => Ok(Scalar::F32),
        (ScalarKind::Float, 2) => Ok(Scalar::F16),
        (ScalarKind::Float, 8) => Ok(Scalar::F64),
        (ScalarKind::Sint, 2) => Ok(Scalar::I16),
        (ScalarKind::Sint, 4) => Ok(Scalar::I32),
        (ScalarKind::Sint, 8) => Ok(Scalar::I64),
        (ScalarKind::Uint, 2) => Ok(Scalar::U16),
        (ScalarKind::Uint, 4) => Ok(Scalar::U32),
        (ScalarKind::Uint, 8) => Ok(Scalar::U64),
        (ScalarKind::Bool, _) => Ok(Scalar::Bool),
        (
            ScalarKind::Float
            | ScalarKind::Sint
            | ScalarKind::Uint
            | ScalarKind::AbstractInt
            | ScalarKind::AbstractFloat,
            _,
        ) => Err(unsupported("numbers of this width")),
    }
}

fn unsupported(what: &str) -> InterpError {
    InterpError::Unsupported { what: what.to_owned(), function: "types".to_owned(), at: None }
}

fn refuse(inner: &TypeInner) -> InterpError {
    unsupported(match inner {
        TypeInner::CooperativeMatrix { .. } => "cooperative matrices",
        TypeInner::Pointer { .. } | TypeInner::ValuePointer { .. } => "pointers as values",
        TypeInner::Image { .. } | TypeInner::Sampler { .. } => "images and samplers",
        TypeInner::AccelerationStructure { .. } | TypeInner::RayQuery { .. } => "ray queries",
        TypeInner::BindingArray { .. } => "binding arrays as values",
        TypeInner::Array { .. } => "runtime-sized arrays as values",
        TypeInner::Scalar(_) | TypeInner::Vector { .. } | TypeInner::Matrix { .. } | TypeInner::Atomic(_) => {
            "parts of a scalar"
        }
        TypeInner::Struct { .. } => "this structure",
    })
}

/// Bytes from one column of a matrix in a buffer to the next.
fn column_stride(rows: VectorSize, scalar: naga::Scalar) -> u32 {
    let components = if rows == VectorSize::Bi { 2 } else { 4 };
    components * u32::from(scalar.width)
}

impl<'m> Types<'m> {
    pub(crate) fn inner(self, ty: Handle<Type>) -> &'m TypeInner {
        &self.0.types[ty].inner
    }

    /// The shape of a type without a handle, or of one with.
    pub(crate) fn shape(self, ty: &naga::proc::TypeResolution) -> Res<Shape> {
        match ty {
            naga::proc::TypeResolution::Handle(handle) => Ok(Shape::Type(*handle)),
            naga::proc::TypeResolution::Value(inner) => match *inner {
                TypeInner::Scalar(scalar) => Ok(Shape::Scalar(scalar)),
                TypeInner::Vector { size, scalar } => Ok(Shape::Vector(size, scalar)),
                TypeInner::Matrix { columns, rows, scalar } => Ok(Shape::Matrix(columns, rows, scalar)),
                TypeInner::CooperativeMatrix { .. }
                | TypeInner::Atomic(_)
                | TypeInner::Pointer { .. }
                | TypeInner::ValuePointer { .. }
                | TypeInner::Array { .. }
                | TypeInner::Struct { .. }
                | TypeInner::Image { .. }
                | TypeInner::Sampler { .. }
                | TypeInner::AccelerationStructure { .. }
                | TypeInner::RayQuery { .. }
                | TypeInner::BindingArray { .. } => Err(refuse(inner)),
            },
        }
    }

    /// A shape whose vectors, matrices and scalars are spelt out.
    fn open(self, shape: Shape) -> Shape {
        let Shape::Type(handle) = shape else {
            return shape;
        };
        match *self.inner(handle) {
            TypeInner::Scalar(scalar) | TypeInner::Atomic(scalar) => Shape::Scalar(scalar),
            TypeInner::Vector { size, scalar } => Shape::Vector(size, scalar),
            TypeInner::Matrix { columns, rows, scalar } => Shape::Matrix(columns, rows, scalar),
            TypeInner::CooperativeMatrix { .. }
            | TypeInner::Pointer { .. }
            | TypeInner::ValuePointer { .. }
            | TypeInner::Array { .. }
            | TypeInner::Struct { .. }
            | TypeInner::Image { .. }
            | TypeInner::Sampler { .. }
            | TypeInner::AccelerationStructure { .. }
            | TypeInner::RayQuery { .. }
            | TypeInner::BindingArray { .. } => shape,
        }
    }

    /// Columns and rows, of a matrix.
    pub(crate) fn matrix(self, shape: Shape) -> Option<(usize, usize)> {
        match self.open(shape) {
            Shape::Matrix(columns, rows, _) => Some((columns as usize, rows as usize)),
            Shape::Type(_) | Shape::Vector(..) | Shape::Scalar(_) => None,
        }
    }

    /// The scalars of `shape`, in order.
    pub(crate) fn kinds(self, shape: Shape) -> Res<Vec<Scalar>> {
        Ok(self.scalars(shape, Packing::Packed(1))?.into_iter().map(|(scalar, _)| scalar).collect())
    }

    /// The scalars of `shape` and their places, in order.
    pub(crate) fn scalars(self, shape: Shape, packing: Packing) -> Res<Vec<(Scalar, u32)>> {
        let count = self.count(shape)?;
        if count > MOST {
            return Err(unsupported(&format!("variables and values of {count} scalars, more than {MOST}")));
        }
        let mut out = Vec::new();
        self.push(shape, packing, 0, &mut out)?;
        Ok(out)
    }

    fn push(self, shape: Shape, packing: Packing, at: u32, out: &mut Vec<(Scalar, u32)>) -> Res<()> {
        let shape = self.open(shape);
        if let Shape::Scalar(s) = shape {
            out.push((scalar(s)?, at));
        } else if let Shape::Type(handle) = shape
            && let TypeInner::Struct { members, .. } = self.inner(handle)
        {
            for index in 0..members.len() as u32 {
                let (part, offset) = self.member(shape, index, packing)?;
                self.push(part, packing, at + offset, out)?;
            }
        } else {
            let parts = self.parts(shape, packing)?;
            let count = parts.count.ok_or_else(|| unsupported("runtime-sized arrays as values"))?;
            for index in 0..count {
                self.push(parts.part, packing, at + index * parts.stride, out)?;
            }
        }
        Ok(())
    }

    /// The equal parts of a vector, matrix or array.
    pub(crate) fn parts(self, shape: Shape, packing: Packing) -> Res<Parts> {
        match self.open(shape) {
            Shape::Scalar(s) => Err(refuse(&TypeInner::Scalar(s))),
            Shape::Vector(size, scalar) => Ok(Parts {
                part: Shape::Scalar(scalar),
                stride: match packing {
                    Packing::Packed(unit) => unit,
                    Packing::Host => u32::from(scalar.width),
                },
                count: Some(size as u32),
            }),
            Shape::Matrix(columns, rows, scalar) => Ok(Parts {
                part: Shape::Vector(rows, scalar),
                stride: match packing {
                    Packing::Packed(unit) => unit * rows as u32,
                    Packing::Host => column_stride(rows, scalar),
                },
                count: Some(columns as u32),
            }),
            Shape::Type(handle) => match *self.inner(handle) {
                TypeInner::Array { base, size, stride } => Ok(Parts {
                    part: Shape::Type(base),
                    stride: match packing {
                        Packing::Host => stride,
                        Packing::Packed(unit) => unit * self.count(Shape::Type(base))?,
                    },
                    count: match size {
                        ArraySize::Dynamic => None,
                        ArraySize::Constant(_) | ArraySize::Pending(_) => Some(self.length(size)?),
                    },
                }),
                ref inner @ (TypeInner::Scalar(_)
                | TypeInner::Vector { .. }
                | TypeInner::Matrix { .. }
                | TypeInner::Atomic(_)
                | TypeInner::CooperativeMatrix { .. }
                | TypeInner::Pointer { .. }
                | TypeInner::ValuePointer { .. }
                | TypeInner::Struct { .. }
                | TypeInner::Image { .. }
                | TypeInner::Sampler { .. }
                | TypeInner::AccelerationStructure { .. }
                | TypeInner::RayQuery { .. }
                | TypeInner::BindingArray { .. }) => Err(refuse(inner)),
            },
        }
    }

    /// Elements of an array whose type says it, be it by an override, which has its value by now.
    fn length(self, size: ArraySize) -> Res<u32> {
        match size.resolve(self.0.to_ctx()) {
            Ok(naga::proc::IndexableLength::Known(n)) => Ok(n),
            Ok(naga::proc::IndexableLength::Dynamic) | Err(_) => {
                Err(unsupported("arrays sized by overrides without a value"))
            }
        }
    }

    /// Elements of a binding array; `None`: as many as are bound.
    pub(crate) fn elements(self, size: ArraySize) -> Res<Option<u32>> {
        match size {
            ArraySize::Dynamic => Ok(None),
            ArraySize::Constant(_) | ArraySize::Pending(_) => self.length(size).map(Some),
        }
    }

    /// Type and place of a part, of a structure or of anything with equal parts.
    pub(crate) fn member(self, shape: Shape, index: u32, packing: Packing) -> Res<(Shape, u32)> {
        if let Shape::Type(handle) = shape
            && let TypeInner::Struct { members, .. } = self.inner(handle)
        {
            let member = members.get(index as usize).ok_or_else(|| refuse(self.inner(handle)))?;
            let before = members.iter().take(index as usize);
            let offset = match packing {
                Packing::Host => member.offset,
                Packing::Packed(unit) => {
                    unit * before.map(|m| self.count(Shape::Type(m.ty))).sum::<Res<u32>>()?
                }
            };
            return Ok((Shape::Type(member.ty), offset));
        }
        let parts = self.parts(shape, packing)?;
        let last = parts.count.map_or(u32::MAX, |n| n.saturating_sub(1));
        Ok((parts.part, index.min(last).saturating_mul(parts.stride)))
    }

    /// Number of scalars.
    pub(crate) fn count(self, shape: Shape) -> Res<u32> {
        let shape = self.open(shape);
        if let Shape::Scalar(_) = shape {
            return Ok(1);
        }
        if let Shape::Type(handle) = shape
            && let TypeInner::Struct { members, .. } = self.inner(handle)
        {
            return members.iter().map(|m| self.count(Shape::Type(m.ty))).sum();
        }
        let parts = self.parts(shape, Packing::Packed(1))?;
        let count = parts.count.ok_or_else(|| unsupported("runtime-sized arrays as values"))?;
        Ok(parts.stride.saturating_mul(count))
    }
}
