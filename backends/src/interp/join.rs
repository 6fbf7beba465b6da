//! State of a function's lanes, and how two ways through an ambiguous branch become one.
//!
//! Where a condition may come out either way on legal drivers, both sides run from the same state.
//! A lane's variables are then selected between the two, which keeps the value of the f32 path, the
//! truth of the exact path, and a bound that covers both.
//! If one side returned and the other goes on, the returned value waits in [`Returns::pending`] until
//! the lane returns at last.
//! If the sides leave a loop differently there is no one way to go on: the lane follows the f32 path and
//! is marked indeterminate.

use super::error::Result;
use super::model::Model;
use super::value::{Column, Value};
use std::rc::Rc;

/// What the lanes of a function have returned.
#[derive(Debug, Clone)]
pub(super) struct Returns<M: Model> {
    /// The value, once any lane returned one.
    pub(super) value: Option<Vec<Column<M>>>,
    /// Which lanes have returned.
    pub(super) done: Vec<bool>,
    /// A value that one side of an ambiguous branch returned while the other goes on, with the
    /// conditions under which it is the result.
    pending: Option<Pending<M>>,
}

#[derive(Debug, Clone)]
struct Pending<M: Model> {
    value: Vec<Column<M>>,
    /// Ambiguous where a value waits; its decisions say whether that is the f32 and the exact path's.
    chosen: Vec<M::B>,
    waits: Vec<bool>,
}

impl<M: Model> Returns<M> {
    pub(super) fn new(lanes: usize) -> Self {
        Self { value: None, done: vec![false; lanes], pending: None }
    }

    /// The lanes of `mask` return `value`.
    pub(super) fn put(&mut self, value: Option<&Value<M>>, mask: &[bool]) -> Result<()> {
        for (done, &on) in self.done.iter_mut().zip(mask) {
            *done |= on;
        }
        let Some(value) = value else { return Ok(()) };
        let joined = match &self.pending {
            Some(pending) => pending.join(value)?,
            None => Rc::clone(value),
        };
        match &mut self.value {
            None => self.value = Some((*joined).clone()),
            Some(old) => {
                for (old, new) in old.iter_mut().zip(joined.iter()) {
                    old.store(new, mask)?;
                }
            }
        }
        Ok(())
    }

    /// Puts what waits in some lanes back to what it was.
    pub(super) fn restore(&mut self, before: &Self, mask: &[bool]) -> Result<()> {
        match (&mut self.pending, &before.pending) {
            (None, _) => {}
            (Some(now), Some(before)) => {
                for i in (0..mask.len()).filter(|&i| mask[i]) {
                    now.chosen[i] = before.chosen[i];
                    now.waits[i] = before.waits[i];
                    for (to, from) in now.value.iter_mut().zip(&before.value) {
                        to.copy_lane(from, i);
                    }
                }
            }
            (Some(now), None) => {
                for (waits, &on) in now.waits.iter_mut().zip(mask) {
                    *waits &= !on;
                }
            }
        }
        Ok(())
    }

    /// Lane `i` returned on the side where `condition` holds (or, `accept` false, does not) only: what
    /// it returned waits.
    pub(super) fn wait(&mut self, returned: &Self, i: usize, condition: M::B, accept: bool) {
        self.done[i] = false;
        let Some(value) = &returned.value else { return };
        let lanes = self.done.len();
        let pending = self.pending.get_or_insert_with(|| Pending {
            value: value.clone(),
            chosen: vec![M::bool(false); lanes],
            waits: vec![false; lanes],
        });
        let chosen = if accept { condition } else { M::not(condition) };
        for (to, from) in pending.value.iter_mut().zip(value) {
            to.copy_lane(from, i);
        }
        // `returned` has joined what waited before, so the former decision is within its value.
        pending.chosen[i] =
            if pending.waits[i] { M::not(M::and(M::not(pending.chosen[i]), M::not(chosen))) } else { chosen };
        pending.waits[i] = true;
    }
}

impl<M: Model> Pending<M> {
    fn join(&self, value: &Value<M>) -> Result<Value<M>> {
        let columns = self.value.iter().zip(value.iter()).map(|(waiting, new)| {
            let mut joined = Column::select(&self.chosen, waiting, new)?;
            let keep: Vec<bool> = self.waits.iter().map(|w| !w).collect();
            joined.store(new, &keep)?;
            Ok(joined)
        });
        Ok(Rc::new(columns.collect::<Result<Vec<_>>>()?))
    }
}
