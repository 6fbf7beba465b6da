//! Branches: each arm runs for the lanes that choose it.
//!
//! Where rounding decides, a lane's choice is *ambiguous*: some permitted driver takes one arm, some the
//! other.
//! Such a lane runs every arm, each from the state before the branch, and the states are joined after it:
//! values from the arm that the f32 numbers choose, exact values from the one that the exact numbers choose,
//! bounds around both.
//! An arm may return while another goes on; then the returned value waits in [`Flow::result`] and the lane
//! continues, until it returns too and both are joined.
//! What cannot be joined is a lane that leaves a loop in one arm only: it is marked as lost.

use super::super::error::Res;
use super::super::leaf::Leaf;
use super::super::mask::Mask;
use super::super::model::{Model, Pick};
use super::{Flow, Frame, Machine};
use naga::{Block, Expression, Handle};

/// The arm that each lane takes.
pub(super) struct Choice {
    /// By its f32 numbers.
    pub(super) value: Vec<usize>,
    /// By its exact numbers.
    pub(super) exact: Vec<usize>,
    /// Lanes that may take any arm.
    pub(super) ambiguous: Mask,
}

/// What an ambiguous branch changes.
struct State<M: Model> {
    variables: Vec<Vec<Leaf<M>>>,
    flow: Flow<M>,
}

impl<M: Model> Clone for State<M> {
    fn clone(&self) -> Self {
        Self { variables: self.variables.clone(), flow: self.flow.clone() }
    }
}

impl<'m, M: Model> Machine<'m, M> {
    /// `if`: arm 0 rejects, arm 1 accepts.
    pub(super) fn decide(
        &mut self,
        frame: &mut Frame<'m, M>,
        condition: Handle<Expression>,
        accept: &'m Block,
        reject: &'m Block,
    ) -> Res<()> {
        let m = &self.model;
        let bools = frame.scalar(condition)?.bools()?;
        let choice = Choice {
            value: bools.iter().map(|b| usize::from(m.decision(*b))).collect(),
            exact: bools.iter().map(|b| usize::from(m.decision_exact(*b))).collect(),
            ambiguous: frame.flow.active.filter(|lane| m.ambiguous(bools[lane])),
        };
        self.branch(frame, &[reject, accept], &choice)
    }

    /// Runs each arm for the lanes that choose it.
    pub(super) fn branch(
        &mut self,
        frame: &mut Frame<'m, M>,
        arms: &[&'m Block],
        choice: &Choice,
    ) -> Res<()> {
        if choice.ambiguous.any() {
            return self.fork(frame, arms, choice);
        }
        let entry = frame.flow.active.take();
        let mut after = Mask::none(self.lanes);
        for (index, arm) in arms.iter().enumerate() {
            frame.flow.active = entry.filter(|lane| choice.value[lane] == index);
            self.block(frame, arm)?;
            after.join(&frame.flow.active);
        }
        frame.flow.active = after;
        Ok(())
    }

    /// The same where lanes are ambiguous.
    fn fork(&mut self, frame: &mut Frame<'m, M>, arms: &[&'m Block], choice: &Choice) -> Res<()> {
        choice.ambiguous.lanes().for_each(|lane| self.flags.ambiguous[lane] = true);
        let entry = frame.flow.active.take();
        let before = State { variables: self.memory.lane.clone(), flow: frame.flow.clone() };
        let mut after = before.clone();
        for (index, arm) in arms.iter().enumerate() {
            let sure = entry.filter(|lane| choice.value[lane] == index && !choice.ambiguous.get(lane));
            self.memory.lane.clone_from(&before.variables);
            frame.flow = before.flow.clone();
            frame.flow.active = sure.clone();
            frame.flow.active.join(&choice.ambiguous);
            self.block(frame, arm)?;
            let state = State { variables: std::mem::take(&mut self.memory.lane), flow: frame.flow.clone() };
            let mut taken = sure;
            if index == 0 {
                taken.join(&choice.ambiguous);
            } else {
                self.join(&mut after, &state, choice, index)?;
            }
            after.take_over(&state, &taken)?;
        }
        self.memory.lane = after.variables;
        frame.flow = after.flow;
        Ok(())
    }

    /// Joins the ambiguous lanes of the state after arm `index` into `after`.
    fn join(&mut self, after: &mut State<M>, state: &State<M>, choice: &Choice, index: usize) -> Res<()> {
        let pick =
            |lane: usize| Pick { value: choice.value[lane] == index, exact: choice.exact[lane] == index };
        // Variables of lanes that one arm ends do not count.
        let (mut both, mut new) = (Mask::none(self.lanes), Mask::none(self.lanes));
        let (mut both_returned, mut newly_returned) = (Mask::none(self.lanes), Mask::none(self.lanes));
        for lane in choice.ambiguous.lanes() {
            let (old_place, new_place) = (after.flow.place(lane), state.flow.place(lane));
            self.flags.lost[lane] |=
                old_place != new_place && old_place != Place::Gone && new_place != Place::Gone;
            both.set(lane, old_place != Place::Gone && new_place != Place::Gone);
            new.set(lane, old_place == Place::Gone && new_place != Place::Gone);
            let (old, now) = (after.flow.returned.get(lane), state.flow.returned.get(lane));
            both_returned.set(lane, old && now);
            newly_returned.set(lane, !old && now);
        }
        join_columns(
            &self.model,
            after.variables.iter_mut().flatten(),
            state.variables.iter().flatten(),
            &both,
            &new,
            pick,
        )?;
        let results = (after.flow.result.iter_mut(), state.flow.result.iter());
        join_columns(&self.model, results.0, results.1, &both_returned, &newly_returned, pick)?;
        for lane in choice.ambiguous.lanes() {
            after.flow.join_place(&state.flow, lane, pick(lane));
        }
        Ok(())
    }
}

fn join_columns<'a, M: Model + 'a>(
    m: &M,
    after: impl Iterator<Item = &'a mut Leaf<M>>,
    state: impl Iterator<Item = &'a Leaf<M>>,
    both: &Mask,
    new: &Mask,
    pick: impl Fn(usize) -> Pick,
) -> Res<()> {
    for (a, b) in after.zip(state) {
        a.join(m, b, both, &pick)?;
        a.blend(b, new)?;
    }
    Ok(())
}

/// Where a lane is after an arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    Here,
    Broke,
    Continued,
    Gone,
}

impl<M: Model> Flow<M> {
    fn place(&self, lane: usize) -> Place {
        if self.active.get(lane) {
            Place::Here
        } else if self.broke.get(lane) {
            Place::Broke
        } else if self.continued.get(lane) {
            Place::Continued
        } else {
            Place::Gone
        }
    }

    fn set_place(&mut self, lane: usize, place: Place) {
        self.active.set(lane, place == Place::Here);
        self.broke.set(lane, place == Place::Broke);
        self.continued.set(lane, place == Place::Continued);
    }

    /// A lane is where it still executes; if both sides do, where the f32 numbers lead.
    fn join_place(&mut self, other: &Self, lane: usize, pick: Pick) {
        if (pick.value && other.place(lane) != Place::Gone) || self.place(lane) == Place::Gone {
            self.set_place(lane, other.place(lane));
        }
        self.returned.set(lane, self.returned.get(lane) || other.returned.get(lane));
        if pick.value {
            self.value_returned.set(lane, other.value_returned.get(lane));
        }
        if pick.exact {
            self.exact_returned.set(lane, other.exact_returned.get(lane));
        }
    }
}

impl<M: Model> State<M> {
    /// Takes the lanes of `mask` from `other`.
    fn take_over(&mut self, other: &Self, mask: &Mask) -> Res<()> {
        let (to, from) = (self.variables.iter_mut().flatten(), other.variables.iter().flatten());
        to.zip(from).try_for_each(|(a, b)| a.blend(b, mask))?;
        let results = self.flow.result.iter_mut().zip(&other.flow.result);
        results.into_iter().try_for_each(|(a, b)| a.blend(b, mask))?;
        for lane in mask.lanes() {
            self.flow.set_place(lane, other.flow.place(lane));
            self.flow.returned.set(lane, other.flow.returned.get(lane));
            self.flow.value_returned.set(lane, other.flow.value_returned.get(lane));
            self.flow.exact_returned.set(lane, other.flow.exact_returned.get(lane));
        }
        Ok(())
    }
}
