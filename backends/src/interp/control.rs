//! Branches and loops.

use super::error::Result;
use super::exec::{Executor, Flow, Frame, and_not, any, merge};
use super::model::Model;
use super::value::Column;
use naga::{Block, Expression, Handle, SwitchCase, SwitchValue};

impl<'m, M: Model> Executor<'m, M> {
    pub(super) fn if_else(
        &mut self,
        frame: &mut Frame<'m, M>,
        condition: Handle<Expression>,
        accept: &'m Block,
        reject: &'m Block,
    ) -> Result<()> {
        let condition = self.value(frame, condition)?;
        let lanes = condition[0].bools()?.to_vec();
        let live = frame.flow.live.clone();
        let unsure: Vec<bool> = lanes.iter().zip(&live).map(|(&c, &on)| on && M::is_ambiguous(c)).collect();
        let holds: Vec<bool> =
            lanes.iter().zip(&live).map(|(&c, &on)| on && M::bool_value(c) && !M::is_ambiguous(c)).collect();
        let fails = and_not(&and_not(&live, &holds), &unsure);
        if any(&unsure) {
            return self.both(frame, &lanes, [accept, reject], [&holds, &fails, &unsure]);
        }
        frame.flow.live = holds;
        self.block(frame, accept)?;
        let after = std::mem::replace(&mut frame.flow.live, fails);
        self.block(frame, reject)?;
        merge(&mut frame.flow.live, &after);
        Ok(())
    }

    /// Runs both sides in the unsure lanes, and joins them.
    fn both(
        &mut self,
        frame: &mut Frame<'m, M>,
        condition: &[M::B],
        [accept, reject]: [&'m Block; 2],
        [holds, fails, unsure]: [&[bool]; 3],
    ) -> Result<()> {
        merge(&mut self.notes.ambiguous, unsure);
        let before = (self.private.clone(), frame.flow.clone());
        // The side that holds, in its own lanes and the unsure ones.
        frame.flow.live = holds.to_vec();
        merge(&mut frame.flow.live, unsure);
        self.block(frame, accept)?;
        let after_accept = (self.private.clone(), frame.flow.clone());
        // The other side: the unsure lanes start from where they were.
        restore(&mut self.private, &before.0, unsure);
        frame.flow.restore(&before.1, unsure)?;
        let kept = std::mem::replace(&mut frame.flow.live, fails.to_vec());
        merge(&mut frame.flow.live, unsure);
        self.block(frame, reject)?;
        for (i, live) in frame.flow.live.iter_mut().enumerate() {
            *live |= kept[i] && !unsure[i];
        }
        for (variable, accepted) in self.private.iter_mut().zip(&after_accept.0) {
            for (column, accepted) in variable.iter_mut().zip(accepted) {
                let joined = Column::select(condition, accepted, column)?;
                column.store(&joined, unsure)?;
            }
        }
        for i in (0..self.lanes).filter(|&i| unsure[i]) {
            self.join_flow(frame, &after_accept.1, i, condition[i]);
        }
        Ok(())
    }

    /// Lane `i` went both ways: where is it now?
    fn join_flow(&mut self, frame: &mut Frame<'m, M>, accepted: &Flow<M>, i: usize, condition: M::B) {
        let flow = &mut frame.flow;
        match (accepted.position(i), flow.position(i)) {
            (Position::Returned, Position::Returned) => flow.join_returns(accepted, i, condition),
            (Position::Returned, Position::Live) => flow.returns.wait(&accepted.returns, i, condition, true),
            (Position::Live, Position::Returned) => {
                let rejected = flow.returns.clone();
                flow.returns.done[i] = false;
                flow.returns.wait(&rejected, i, condition, false);
                flow.live[i] = true;
            }
            (a, b) if a == b => {}
            _ => {
                self.notes.indeterminate[i] = true;
                if M::bool_value(condition) {
                    flow.take_position(accepted, i);
                }
            }
        }
    }

    pub(super) fn switch(
        &mut self,
        frame: &mut Frame<'m, M>,
        selector: Handle<Expression>,
        cases: &'m [SwitchCase],
    ) -> Result<()> {
        let selector = self.value(frame, selector)?;
        let words = selector[0].words()?;
        let live = std::mem::replace(&mut frame.flow.live, vec![false; self.lanes]);
        for (i, &word) in words.iter().enumerate() {
            self.notes.indeterminate[i] |= live[i] && !M::is_known(word);
        }
        let targets: Vec<usize> = words.iter().map(|&w| target(cases, M::word_value(w))).collect();
        frame.flow.broken.push(vec![false; self.lanes]);
        let mut after = vec![false; self.lanes];
        for (k, case) in cases.iter().enumerate() {
            // Lanes that fell through the case above are live already.
            for (i, on) in frame.flow.live.iter_mut().enumerate() {
                *on |= live[i] && targets[i] == k;
            }
            self.block(frame, &case.body)?;
            if !case.fall_through {
                let ended = std::mem::replace(&mut frame.flow.live, vec![false; self.lanes]);
                merge(&mut after, &ended);
            }
        }
        merge(&mut after, &frame.flow.live);
        if let Some(broken) = frame.flow.broken.pop() {
            merge(&mut after, &broken);
        }
        frame.flow.live = after;
        Ok(())
    }

    pub(super) fn repeat(
        &mut self,
        frame: &mut Frame<'m, M>,
        body: &'m Block,
        continuing: &'m Block,
        break_if: Option<Handle<Expression>>,
    ) -> Result<()> {
        frame.flow.broken.push(vec![false; self.lanes]);
        while any(&frame.flow.live) {
            self.burn(frame)?;
            frame.flow.continued.push(vec![false; self.lanes]);
            self.block(frame, body)?;
            if let Some(continued) = frame.flow.continued.pop() {
                merge(&mut frame.flow.live, &continued);
            }
            self.block(frame, continuing)?;
            if let Some(condition) = break_if
                && any(&frame.flow.live)
            {
                self.leave_if(frame, condition)?;
            }
        }
        if let Some(broken) = frame.flow.broken.pop() {
            frame.flow.live = broken;
        }
        Ok(())
    }

    fn leave_if(&mut self, frame: &mut Frame<'m, M>, condition: Handle<Expression>) -> Result<()> {
        let condition = self.value(frame, condition)?;
        let lanes = condition[0].bools()?;
        for (i, &lane) in lanes.iter().enumerate() {
            if frame.flow.live[i] {
                self.notes.indeterminate[i] |= M::is_ambiguous(lane);
                if M::bool_value(lane) {
                    frame.flow.live[i] = false;
                    if let Some(broken) = frame.flow.broken.last_mut() {
                        broken[i] = true;
                    }
                }
            }
        }
        Ok(())
    }
}

/// The case that a selector goes to.
fn target(cases: &[SwitchCase], word: u32) -> usize {
    let is = |case: &SwitchCase| match case.value {
        SwitchValue::I32(v) => v as u32 == word,
        SwitchValue::U32(v) => v == word,
        SwitchValue::Default => false,
    };
    let default = || cases.iter().position(|c| c.value == SwitchValue::Default);
    cases.iter().position(is).or_else(default).unwrap_or(cases.len())
}

/// Puts the variables of some lanes back to what they were.
fn restore<M: Model>(variables: &mut [Vec<Column<M>>], before: &[Vec<Column<M>>], mask: &[bool]) {
    for (variable, before) in variables.iter_mut().zip(before) {
        for (column, before) in variable.iter_mut().zip(before) {
            for i in (0..mask.len()).filter(|&i| mask[i]) {
                column.copy_lane(before, i);
            }
        }
    }
}

/// Where a lane is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Position {
    Live,
    Returned,
    Broken(usize),
    Continued(usize),
    Gone,
}

impl<M: Model> Flow<M> {
    fn position(&self, i: usize) -> Position {
        if self.live[i] {
            return Position::Live;
        }
        if self.returns.done[i] {
            return Position::Returned;
        }
        let broken = self.broken.iter().rposition(|mask| mask[i]).map(Position::Broken);
        let continued = self.continued.iter().rposition(|mask| mask[i]).map(Position::Continued);
        broken.or(continued).unwrap_or(Position::Gone)
    }

    /// Puts some lanes back to where they were.
    fn restore(&mut self, before: &Self, mask: &[bool]) -> Result<()> {
        for i in (0..mask.len()).filter(|&i| mask[i]) {
            self.take_position(before, i);
        }
        self.returns.restore(&before.returns, mask)
    }

    /// Takes over where lane `i` is.
    fn take_position(&mut self, from: &Self, i: usize) {
        self.live[i] = from.live[i];
        self.returns.done[i] = from.returns.done[i];
        let masks = self.broken.iter_mut().chain(&mut self.continued);
        for (to, from) in masks.zip(from.broken.iter().chain(&from.continued)) {
            to[i] = from[i];
        }
    }

    /// Both sides returned: the lane's result is joined.
    fn join_returns(&mut self, accepted: &Self, i: usize, condition: M::B) {
        if let (Some(rejected), Some(accepted)) = (&mut self.returns.value, &accepted.returns.value) {
            for (r, a) in rejected.iter_mut().zip(accepted) {
                r.join_lane(a, i, condition);
            }
        }
    }
}
