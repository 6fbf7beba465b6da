//! Halves of lanes that wait for the other half, and how states are joined.

use super::super::mask::Mask;
use super::super::model::{Model, Pick};
use super::super::program::Reg;
use super::column::Column;
use super::plan::Changes;
use super::{Machine, Res};

/// Halves of lanes that wait at the end of a construct.
pub(super) struct Waiting<M: Model> {
    pub(super) here: Mask,
    pub(super) value: Mask,
    pub(super) exact: Mask,
    pub(super) state: State<M>,
}

/// What a block may change.
pub(super) struct State<M: Model> {
    kept: Vec<Column<M>>,
    arrays: Vec<Vec<Column<M>>>,
}

impl<M: Model> Machine<'_, M> {
    /// Halves of lanes wait at the end of a construct, joined with the other half if that is there.
    pub(super) fn wait(&mut self, at: usize, halves: &Mask) -> Res<()> {
        let changes = self.flow.around[at].changes.clone();
        let none = Mask::none(self.lanes);
        let waiting = self.flow.around[at].waiting.take();
        let mut now = Waiting {
            here: halves.clone(),
            value: self.flow.value.filter(|lane| halves.get(lane)),
            exact: self.flow.exact.filter(|lane| halves.get(lane)),
            state: self.state(&changes),
        };
        if let Some(before) = waiting {
            let only_before = before.here.filter(|lane| !halves.get(lane));
            let met = before.here.filter(|lane| halves.get(lane));
            let kept = self.state(&changes);
            self.join_memory(&changes, &before, &met)?;
            self.put_back(&changes, &before.state, &only_before)?;
            now.state = self.state(&changes);
            let all = Mask::all(self.lanes);
            self.put_back(&changes, &kept, &all)?;
            now.here.join(&before.here);
            now.value.join(&before.value);
            now.exact.join(&before.exact);
        }
        debug_assert!(now.here != none);
        self.flow.around[at].waiting = Some(now);
        Ok(())
    }

    pub(super) fn state(&self, changes: &Changes) -> State<M> {
        State {
            kept: changes.kept.iter().map(|Reg(at)| self.registers[*at as usize].clone()).collect(),
            arrays: changes.arrays.iter().map(|at| self.arrays[*at as usize].clone()).collect(),
        }
    }

    pub(super) fn put_back(&mut self, changes: &Changes, state: &State<M>, lanes: &Mask) -> Res<()> {
        if !lanes.any() {
            return Ok(());
        }
        for (Reg(at), from) in changes.kept.iter().zip(&state.kept) {
            self.registers[*at as usize].take(from, lanes)?;
        }
        self.each_cell(changes, state, |_, to, from| to.take(from, lanes))
    }

    pub(super) fn join_memory(&mut self, changes: &Changes, other: &Waiting<M>, lanes: &Mask) -> Res<()> {
        if !lanes.any() {
            return Ok(());
        }
        let pick = |lane| Pick { value: other.value.get(lane), exact: other.exact.get(lane) };
        for (Reg(at), from) in changes.kept.iter().zip(&other.state.kept) {
            self.registers[*at as usize].join(&self.model, from, lanes, pick)?;
        }
        self.each_cell(changes, &other.state, |m, to, from| to.join(m, from, lanes, pick))
    }

    /// Cells that nothing was stored to hold nothing.
    fn each_cell(
        &mut self,
        changes: &Changes,
        state: &State<M>,
        f: impl Fn(&M, &mut Column<M>, &Column<M>) -> Res<()>,
    ) -> Res<()> {
        for (at, from) in changes.arrays.iter().zip(&state.arrays) {
            for (to, from) in self.arrays[*at as usize].iter_mut().zip(from) {
                if from.len() > 0 && to.len() > 0 {
                    f(&self.model, to, from)?;
                }
            }
        }
        Ok(())
    }
}
