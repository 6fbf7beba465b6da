//! Products of matrices, in the order in which glam's scalar code adds: column after column.

use super::super::error::Res;
use super::super::leaf::Leaf;
use super::super::model::Model;
use super::{InterpError, Machine};
use naga::TypeInner;

/// Columns and rows of a matrix type.
pub(super) fn dimensions(ty: &TypeInner) -> Option<(u32, u32)> {
    match *ty {
        TypeInner::Matrix { columns, rows, .. } => Some((columns as u32, rows as u32)),
        TypeInner::Scalar(_)
        | TypeInner::Vector { .. }
        | TypeInner::CooperativeMatrix { .. }
        | TypeInner::Atomic(_)
        | TypeInner::Pointer { .. }
        | TypeInner::ValuePointer { .. }
        | TypeInner::Array { .. }
        | TypeInner::Struct { .. }
        | TypeInner::Image { .. }
        | TypeInner::Sampler { .. }
        | TypeInner::AccelerationStructure { .. }
        | TypeInner::RayQuery { .. }
        | TypeInner::BindingArray { .. } => None,
    }
}

impl<M: Model> Machine<'_, M> {
    /// A product of which at least one operand is a matrix.
    pub(super) fn matrix_product(
        &self,
        (ty_a, a): (&TypeInner, &[Leaf<M>]),
        (ty_b, b): (&TypeInner, &[Leaf<M>]),
    ) -> Res<Vec<Leaf<M>>> {
        match (dimensions(ty_a), dimensions(ty_b)) {
            (Some((columns, rows)), Some(_)) => {
                let products = b.chunks(columns as usize).map(|b| self.matrix_vector(rows as usize, a, b));
                Ok(products.collect::<Res<Vec<_>>>()?.concat())
            }
            (Some((_, rows)), None) if b.len() > 1 => self.matrix_vector(rows as usize, a, b),
            (None, Some((_, rows))) if a.len() > 1 => {
                b.chunks(rows as usize).map(|column| self.dot(a, column)).collect()
            }
            (Some(_), None) | (None, Some(_)) => self.columns(a, b, |a, b| self.mul_leaf(a, b)),
            (None, None) => Err(InterpError::Malformed("a matrix product without a matrix")),
        }
    }

    /// `a[0] * b[0] + a[1] * b[1] + ..` over the columns of `a`.
    fn matrix_vector(&self, rows: usize, a: &[Leaf<M>], b: &[Leaf<M>]) -> Res<Vec<Leaf<M>>> {
        (0..rows)
            .map(|row| {
                let across: Vec<_> = a.iter().skip(row).step_by(rows).cloned().collect();
                self.dot(&across, b)
            })
            .collect()
    }
}
