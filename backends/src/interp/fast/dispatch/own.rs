//! Whose an element of an array is.

use super::super::super::program::op::{Input, IntOp};
use super::super::super::program::{Eval, Op, Place, Program, Reg, Scalar, Value};
use super::bind::Memory;
use std::collections::HashMap;

/// The invocations of a dispatch, and its memory.
pub(super) struct Launch<'a> {
    pub(super) groups: [u32; 3],
    pub(super) size: [u32; 3],
    pub(super) memory: &'a Memory,
}

impl Launch<'_> {
    /// Invocations along an axis.
    pub(super) fn extent(&self, axis: usize) -> u64 {
        u64::from(self.groups[axis]) * u64::from(self.size[axis])
    }

    /// Whether all invocations lie along the first axes, so many.
    fn within(&self, axes: usize) -> bool {
        (axes..3).all(|axis| self.extent(axis) <= 1)
    }

    fn volume(&self) -> usize {
        self.size.iter().map(|n| *n as usize).product()
    }
}

/// Who has the elements of an array to himself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    /// Each invocation that at its number along the first axis.
    Invocation,
    /// Each workgroup that at its number along the first axis.
    Workgroup,
    /// Each invocation that at its place in rows of this width.
    Place(u64),
}

/// How many invocations, by number from the first on, have elements to themselves.
pub(super) struct Owned {
    pub(super) owner: Owner,
    pub(super) free: usize,
}

/// Asks whose an element is.
pub(super) struct Whose<'a> {
    pub(super) program: &'a Program,
    pub(super) evals: &'a HashMap<Reg, &'a Eval>,
    pub(super) launch: &'a Launch<'a>,
}

impl Whose<'_> {
    fn eval(&self, value: Value) -> Option<&Eval> {
        match value {
            Value::Reg(reg) => self.evals.get(&reg).copied(),
            Value::Const(_) => None,
        }
    }

    /// Whose the element is that a place is or lies in; `None`: anybody's.
    pub(super) fn element(&self, place: &Place) -> Option<Owned> {
        let (index, count, stride) = match *place {
            Place::Element { index, count, stride, .. } => (index, count, stride),
            Place::Buffer { .. } | Place::Lane { .. } => {
                let eval = self.eval(place.index()?)?;
                match (eval.op, &eval.args[..]) {
                    (Op::Index { count, stride }, [index]) => (*index, count, stride),
                    _ => return None,
                }
            }
        };
        let owner = self.owner(index)?;
        // Indices are clamped, so that the last element may be everybody's who is beyond it.
        let length = self.launch.memory.length(count, stride);
        let free = match owner {
            Owner::Invocation => length,
            Owner::Workgroup => length.saturating_mul(self.launch.volume()),
            Owner::Place(width) => {
                let rows = self.launch.extent(1).saturating_sub(1);
                let last = rows.saturating_mul(width).saturating_add(self.launch.extent(0));
                if last <= length as u64 && last <= u32::MAX.into() { usize::MAX } else { 0 }
            }
        };
        Some(Owned { owner, free })
    }

    fn owner(&self, index: Value) -> Option<Owner> {
        let eval = self.eval(index)?;
        match (eval.op, &eval.args[..]) {
            (Op::Input(Input::GlobalInvocationId(0), _), _) if self.launch.within(1) => {
                Some(Owner::Invocation)
            }
            // Invocations of a cooperative workgroup run in the same order whatever others do.
            (Op::Input(Input::WorkGroupId(0), _), _) if self.program.cooperative && self.launch.within(1) => {
                Some(Owner::Workgroup)
            }
            (Op::Int(Scalar::U32, IntOp::Add), &[a, b]) if self.launch.within(2) => {
                let (row, column) = if self.is_number(a, 0) { (b, a) } else { (a, b) };
                let width = self.is_number(column, 0).then(|| self.factor(row)).flatten()?;
                (width >= self.launch.extent(0)).then_some(Owner::Place(width))
            }
            _ => None,
        }
    }

    /// Whether a value is the invocation's number along an axis.
    fn is_number(&self, value: Value, axis: u8) -> bool {
        let op = self.eval(value).map(|eval| eval.op);
        matches!(op, Some(Op::Input(Input::GlobalInvocationId(along), _)) if along == axis)
    }

    /// By what the number along the second axis is multiplied.
    fn factor(&self, product: Value) -> Option<u64> {
        let eval = self.eval(product)?;
        match (eval.op, &eval.args[..]) {
            (Op::Int(Scalar::U32, IntOp::Mul), &[a, b]) if self.is_number(a, 1) => self.known(b),
            (Op::Int(Scalar::U32, IntOp::Mul), &[a, b]) if self.is_number(b, 1) => self.known(a),
            _ => None,
        }
    }

    /// What a value is in this dispatch, where that can be told.
    fn known(&self, value: Value) -> Option<u64> {
        let Value::Reg(_) = value else {
            return self.constant(value);
        };
        let eval = self.eval(value)?;
        match (eval.op, &eval.args[..]) {
            (Op::Input(Input::NumWorkGroups(axis), _), _) => {
                Some(self.launch.groups[usize::from(axis)].into())
            }
            (Op::Int(Scalar::U32, IntOp::Mul), &[a, b]) => {
                let product = self.known(a)?.checked_mul(self.known(b)?)?;
                u32::try_from(product).ok().map(u64::from)
            }
            (
                Op::Load {
                    place: Place::Buffer { buffer, offset, index: None }, scalar: Scalar::U32, ..
                },
                _,
            ) if !self.program.buffers[buffer as usize].writable => {
                self.launch.memory.word(buffer, offset).map(u64::from)
            }
            _ => None,
        }
    }

    fn constant(&self, value: Value) -> Option<u64> {
        match value {
            Value::Const(id) => Some(u64::from(self.program.constants[id as usize].bits as u32)),
            Value::Reg(_) => None,
        }
    }
}
