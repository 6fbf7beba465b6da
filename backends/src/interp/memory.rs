//! Loads, stores and atomics; the memory that lanes share.

use super::error::{Fault, Internal, Result};
use super::exec::{Executor, Frame};
use super::model::Model;
use super::value::{Column, Kind, Pointee, Pointer, Root, Value, kinds, width};
use naga::{AtomicFunction, Handle, TypeInner};
use std::collections::HashMap;
use std::rc::Rc;

/// Scalars of global variables, by variable and index.
pub(super) struct Shared<M: Model>(HashMap<Handle<naga::GlobalVariable>, Vec<Cell<M>>>);

/// A scalar in shared memory.
#[derive(Debug, Clone, Copy)]
pub(super) enum Cell<M: Model> {
    F(M::F),
    W(M::W),
    B(M::B),
}

impl<M: Model> Default for Shared<M> {
    fn default() -> Self {
        Self(HashMap::new())
    }
}

impl<M: Model> Shared<M> {
    /// Gives a variable its scalars.
    pub(super) fn set(&mut self, variable: Handle<naga::GlobalVariable>, cells: Vec<Cell<M>>) {
        self.0.insert(variable, cells);
    }

    /// The scalars of a variable.
    pub(super) fn get(&self, variable: Handle<naga::GlobalVariable>) -> Result<&Vec<Cell<M>>> {
        self.0.get(&variable).ok_or_else(unbound)
    }

    fn get_mut(&mut self, variable: Handle<naga::GlobalVariable>) -> Result<&mut Vec<Cell<M>>> {
        self.0.get_mut(&variable).ok_or_else(unbound)
    }
}

fn unbound() -> Fault {
    Fault::Unsupported("a global variable outside an entry point's run".to_owned())
}

impl<M: Model> Cell<M> {
    /// From the bits in a buffer.
    pub(super) fn from_bits(kind: Kind, bits: u32) -> Self {
        match kind {
            Kind::F => Self::F(M::float(f32::from_bits(bits), f32::from_bits(bits).into())),
            Kind::W => Self::W(M::word(bits)),
            Kind::B => Self::B(M::bool(bits != 0)),
        }
    }

    /// The bits for a buffer.
    pub(super) fn bits(self) -> u32 {
        match self {
            Self::F(x) => M::float_value(x).to_bits(),
            Self::W(x) => M::word_value(x),
            Self::B(x) => M::bool_value(x).into(),
        }
    }

    fn of(column: &Column<M>, i: usize) -> Self {
        match column {
            Column::F(x) => Self::F(x[i]),
            Column::W(x) => Self::W(x[i]),
            Column::B(x) => Self::B(x[i]),
        }
    }

    fn put(self, column: &mut Column<M>, i: usize) {
        match (self, column) {
            (Self::F(x), Column::F(to)) => to[i] = x,
            (Self::W(x), Column::W(to)) => to[i] = x,
            (Self::B(x), Column::B(to)) => to[i] = x,
            (Self::F(_) | Self::W(_) | Self::B(_), _) => {}
        }
    }
}

impl<'m, M: Model> Executor<'m, M> {
    fn pointee_kinds(&self, ty: Pointee) -> Result<Vec<Kind>> {
        match ty {
            Pointee::Scalars(n, kind) => Ok(vec![kind; n]),
            Pointee::Type(ty) => {
                let mut out = Vec::new();
                kinds(self.module.module(), &self.module.module().types[ty].inner, &mut out)?;
                Ok(out)
            }
        }
    }

    /// Reads what a pointer points to.
    pub(super) fn load(&self, pointer: &Pointer) -> Result<Value<M>> {
        let kinds = self.pointee_kinds(pointer.ty)?;
        let mut columns = Vec::with_capacity(kinds.len());
        for (k, kind) in kinds.iter().enumerate() {
            columns.push(match (pointer.root, &pointer.offset) {
                (Root::Private(variable), super::value::Offset::Same(offset)) => {
                    self.private[variable][offset + k].clone()
                }
                (Root::Private(variable), super::value::Offset::Each(offsets)) => {
                    let mut column = Column::zero(*kind, self.lanes);
                    for (i, offset) in offsets.iter().enumerate() {
                        column.copy_lane(&self.private[variable][offset + k], i);
                    }
                    column
                }
                (Root::Shared(variable), offset) => {
                    let cells = self.shared.get(variable)?;
                    let mut column = Column::zero(*kind, self.lanes);
                    for i in 0..self.lanes {
                        if let Some(cell) = cells.get(offset.lane(i) + k) {
                            cell.put(&mut column, i);
                        }
                    }
                    column
                }
            });
        }
        Ok(Rc::new(columns))
    }

    /// Writes what a pointer points to, in the lanes of `mask`.
    pub(super) fn store(&mut self, pointer: &Pointer, value: &Value<M>, mask: &[bool]) -> Result<()> {
        for (k, column) in value.iter().enumerate() {
            match (pointer.root, &pointer.offset) {
                (Root::Private(variable), super::value::Offset::Same(offset)) => {
                    self.private[variable][offset + k].store(column, mask)?;
                }
                (Root::Private(variable), super::value::Offset::Each(offsets)) => {
                    for (i, offset) in offsets.iter().enumerate().filter(|(i, _)| mask[*i]) {
                        self.private[variable][offset + k].copy_lane(column, i);
                    }
                }
                (Root::Shared(variable), offset) => {
                    let cells = self.shared.get_mut(variable)?;
                    for i in (0..self.lanes).filter(|&i| mask[i]) {
                        if let Some(cell) = cells.get_mut(offset.lane(i) + k) {
                            *cell = Cell::of(column, i);
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Updates an atomic, lane after lane; returns the former values.
    pub(super) fn atomic(
        &mut self,
        frame: &mut Frame<'m, M>,
        pointer: &Pointer,
        fun: &AtomicFunction,
        value: &Value<M>,
        signed: bool,
    ) -> Result<Value<M>> {
        let compare = match fun {
            AtomicFunction::Exchange { compare: Some(_) } => {
                return Err(Fault::Unsupported("atomicCompareExchangeWeak".to_owned()));
            }
            fun => fun,
        };
        let operands = value[0].words()?;
        let Root::Shared(variable) = pointer.root else { return Err(Internal::Kind.into()) };
        let cells = self.shared.get_mut(variable)?;
        let mut former = Column::zero(Kind::W, operands.len());
        for (i, operand) in operands.iter().enumerate().filter(|(i, _)| frame.flow.live[*i]) {
            let Some(cell) = cells.get_mut(pointer.offset.lane(i)) else { continue };
            let Cell::W(old) = *cell else { return Err(Internal::Kind.into()) };
            Cell::<M>::W(old).put(&mut former, i);
            *cell = Cell::W(M::w2(old, *operand, |old, new| updated(compare, old, new, signed)));
        }
        Ok(Rc::new(vec![former]))
    }

    /// Elements of the array that a pointer points to.
    pub(super) fn array_length(&self, pointer: &Pointer) -> Result<usize> {
        let module = self.module.module();
        let Pointee::Type(ty) = pointer.ty else { return Err(Internal::Kind.into()) };
        let TypeInner::Array { base, size, .. } = module.types[ty].inner else {
            return Err(Internal::Kind.into());
        };
        if let Some(n) = super::value::fixed(size)? {
            return Ok(n);
        }
        let Root::Shared(variable) = pointer.root else { return Err(Internal::Kind.into()) };
        // A runtime array is the last thing in its variable.
        let rest = self.shared.get(variable)?.len().saturating_sub(pointer.offset.lane(0));
        Ok(rest / width(module, &module.types[base].inner)?.max(1))
    }
}

fn updated(fun: &AtomicFunction, old: u32, new: u32, signed: bool) -> u32 {
    match fun {
        AtomicFunction::Add => old.wrapping_add(new),
        AtomicFunction::Subtract => old.wrapping_sub(new),
        AtomicFunction::And => old & new,
        AtomicFunction::ExclusiveOr => old ^ new,
        AtomicFunction::InclusiveOr => old | new,
        AtomicFunction::Min if signed => (old as i32).min(new as i32) as u32,
        AtomicFunction::Min => old.min(new),
        AtomicFunction::Max if signed => (old as i32).max(new as i32) as u32,
        AtomicFunction::Max => old.max(new),
        AtomicFunction::Exchange { .. } => new,
    }
}
