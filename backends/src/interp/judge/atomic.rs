//! Atomics: lane after lane, in order; drivers may take any other.

use super::super::model::Model;
use super::super::program::op::IntOp;
use super::super::program::{Atomic, Place, Reg, Scalar, Update};
use super::column::{Column, Family, family};
use super::shared::Cell;
use super::{MISMATCH, Machine, Res, integer};
use std::collections::HashMap;

/// Which words atomics have changed, and since when everybody sees it.
#[derive(Default)]
pub(in super::super) struct Order {
    touched: HashMap<(u32, usize), Touch>,
    /// Words that were written, for who comes after a workgroup.
    pub(in super::super) written: Vec<(u32, usize)>,
    /// The workgroup that runs.
    pub(in super::super) group: usize,
    /// Barriers that it has passed.
    pub(in super::super) passed: u32,
    /// Whether anybody asks.
    pub(in super::super) kept: bool,
}

struct Touch {
    fun: Update,
    group: usize,
    passed: u32,
    /// Whether the outcome depends on the order.
    disputed: bool,
}

impl Order {
    pub(super) fn new(kept: bool) -> Self {
        Self { kept, ..Self::default() }
    }

    /// Whether drivers may find another word, because other invocations are about to change it.
    pub(super) fn disputes(&self, buffer: u32, at: usize) -> bool {
        let open = |t: &Touch| t.disputed || t.group != self.group || t.passed == self.passed;
        !self.touched.is_empty() && self.touched.get(&(buffer, at)).is_some_and(open)
    }

    pub(super) fn written(&mut self, buffer: u32, at: usize) {
        if self.kept {
            self.written.push((buffer, at));
        }
    }

    /// Notes an update; returns whether its outcome depends on the order.
    fn update(&mut self, buffer: u32, at: usize, fun: Update, float: bool) -> bool {
        if !self.kept {
            return false;
        }
        let now = Touch { fun, group: self.group, passed: self.passed, disputed: float || !commutes(fun) };
        let touch = self.touched.entry((buffer, at)).or_insert(Touch { ..now });
        touch.disputed |= now.disputed
            || (alike(touch.fun) != alike(fun) && touch.passed == now.passed)
            || (alike(touch.fun) != alike(fun) && touch.group != now.group);
        (touch.fun, touch.group, touch.passed) = (now.fun, now.group, now.passed);
        touch.disputed
    }

    /// Forgets the words of workgroup memory.
    pub(in super::super) fn leave_group(&mut self, own: impl Fn(u32) -> bool) {
        self.touched.retain(|(buffer, _), _| !own(*buffer));
        self.written.clear();
        self.group += 1;
        self.passed = 0;
    }
}

/// Whether the last word is the same in any order of such updates.
fn commutes(fun: Update) -> bool {
    match fun {
        Update::Add
        | Update::Subtract
        | Update::And
        | Update::Xor
        | Update::Or
        | Update::Min
        | Update::Max => true,
        Update::Exchange | Update::CompareExchange => false,
    }
}

/// Subtractions go with additions.
fn alike(fun: Update) -> Update {
    if fun == Update::Subtract { Update::Add } else { fun }
}

impl<M: Model> Machine<'_, M> {
    pub(super) fn atomic(&mut self, atomic: &Atomic) -> Res<()> {
        let Place::Buffer { buffer, offset, index } = atomic.place else { return Err(MISMATCH) };
        self.spoil_if_unknown(buffer, index)?;
        let at = self.addresses(offset, index)?;
        let scalar = self.program.scalar(atomic.value);
        let lanes: Vec<usize> = self.flow.active.lanes().collect();
        for lane in lanes {
            self.shared[buffer as usize].overwrite(at[lane], scalar.bytes());
            let at = at[lane] / 4;
            if family::<M>(scalar) == Family::Float {
                self.update_float(atomic, (buffer, at), lane)?;
            } else {
                self.update_word(atomic, scalar, (buffer, at), lane)?;
            }
        }
        Ok(())
    }

    fn update_word(
        &mut self,
        atomic: &Atomic,
        scalar: Scalar,
        (buffer, at): (u32, usize),
        lane: usize,
    ) -> Res<()> {
        let m = &self.model;
        let shared = &self.shared[buffer as usize];
        let mut old = shared.get(m, at).word(m);
        if scalar.wide() {
            old = m.zip_w(old, shared.get(m, at + 1).word(m), |low, high| low | high << 32);
        }
        let value = self.words(atomic.value)?.at(lane);
        let mut new = match atomic.expected {
            Some(expected) => {
                let same = m.compare_w(old, self.words(expected)?.at(lane), |a, b| a == b);
                let word = if m.decision(same) { value } else { old };
                if m.ambiguous(same) { m.forget(word) } else { word }
            }
            None => m.zip_w(old, value, |old, value| updated(scalar, atomic.fun, old, value)),
        };
        if self.order.update(buffer, at, atomic.fun, false) {
            new = m.forget(new);
        }
        let old = if M::SHADOW { m.forget(old) } else { old };
        if let Some(Reg(to)) = atomic.old {
            let Column::Word(to) = &mut self.registers[to as usize] else { return Err(MISMATCH) };
            to[lane] = old;
        }
        let low = Cell::Word(m.map_w(new, |w| w & u64::from(u32::MAX)));
        let high = scalar.wide().then(|| Cell::Word(m.map_w(new, |w| w >> 32)));
        self.put(buffer, at, lane, low);
        if let Some(high) = high {
            self.put(buffer, at + 1, lane, high);
        }
        Ok(())
    }

    fn update_float(&mut self, atomic: &Atomic, (buffer, at): (u32, usize), lane: usize) -> Res<()> {
        let m = &self.model;
        let old = self.shared[buffer as usize].get(m, at);
        let (before, value) = (old.float(m), self.floats(atomic.value)?.at(lane));
        let new = match atomic.fun {
            Update::Add => m.add(before, value),
            Update::Subtract => m.sub(before, value),
            Update::Min => m.min(before, value),
            Update::Max => m.max(before, value),
            Update::Exchange => value,
            Update::CompareExchange | Update::And | Update::Xor | Update::Or => return Err(MISMATCH),
        };
        let mut cell = Cell::Float(new);
        if self.order.update(buffer, at, atomic.fun, true) {
            cell = cell.forgotten(m);
        }
        if let Some(Reg(to)) = atomic.old {
            let before = if M::SHADOW { old.forgotten(m).float(m) } else { before };
            let Column::Float(to) = &mut self.registers[to as usize] else { return Err(MISMATCH) };
            to[lane] = before;
        }
        self.put(buffer, at, lane, cell);
        Ok(())
    }
}

fn updated(scalar: Scalar, fun: Update, old: u64, value: u64) -> u64 {
    let op = match fun {
        Update::Add => IntOp::Add,
        Update::Subtract => IntOp::Sub,
        Update::And => IntOp::And,
        Update::Xor => IntOp::Xor,
        Update::Or => IntOp::Or,
        Update::Min => IntOp::Min,
        Update::Max => IntOp::Max,
        Update::Exchange | Update::CompareExchange => return value,
    };
    integer::apply(scalar, op, [old, value, 0, 0])
}
