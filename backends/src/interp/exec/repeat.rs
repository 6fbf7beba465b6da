//! Loops and switches.

use super::super::error::{InterpError, Res};
use super::super::mask::Mask;
use super::super::model::Model;
use super::branch::Choice;
use super::{Frame, Machine};
use naga::{Block, Expression, Handle, SwitchCase, SwitchValue};

/// Rounds that a loop may run in the shadow lane.
const SHADOW_ROUNDS: u32 = 1 << 16;

impl<'m, M: Model> Machine<'m, M> {
    /// Repeats until no lane is left in the loop.
    pub(super) fn repeat(
        &mut self,
        frame: &mut Frame<'m, M>,
        body: &'m Block,
        continuing: &'m Block,
        break_if: Option<Handle<Expression>>,
    ) -> Res<()> {
        let outer_broke = frame.flow.broke.take();
        let outer_continued = frame.flow.continued.take();
        let mut rounds = 0;
        while frame.flow.active.any() {
            rounds += 1;
            if self.fuel == 0 || (M::SHADOW && rounds > SHADOW_ROUNDS) {
                self.exhausted(frame)?;
                break;
            }
            self.fuel -= 1;
            self.block(frame, body)?;
            let continued = frame.flow.continued.take();
            frame.flow.active.join(&continued);
            self.block(frame, continuing)?;
            if let Some(condition) = break_if
                && frame.flow.active.any()
            {
                self.leave_if(frame, condition)?;
            }
        }
        let left = std::mem::replace(&mut frame.flow.broke, outer_broke);
        frame.flow.active.join(&left);
        frame.flow.continued = outer_continued;
        Ok(())
    }

    /// Without fuel a loop ends; shadow lanes that follow a path no f32 number takes may well run forever,
    /// so there it is the row that is lost, not the batch.
    fn exhausted(&mut self, frame: &mut Frame<'m, M>) -> Res<()> {
        if !M::SHADOW {
            return Err(InterpError::OutOfFuel { function: frame.name() });
        }
        frame.flow.active.lanes().for_each(|lane| self.flags.lost[lane] = true);
        Ok(())
    }

    fn leave_if(&mut self, frame: &mut Frame<'m, M>, condition: Handle<Expression>) -> Res<()> {
        let m = &self.model;
        let bools = frame.scalar(condition)?.bools()?.to_vec();
        for lane in frame.flow.active.lanes().filter(|lane| m.ambiguous(bools[*lane])) {
            self.flags.lost[lane] = true;
        }
        let leaving = frame.flow.active.filter(|lane| m.decision(bools[lane]));
        frame.flow.active = frame.flow.active.filter(|lane| !leaving.get(lane));
        frame.flow.broke.join(&leaving);
        Ok(())
    }

    /// `switch`: cases without a body share that of the next one.
    pub(super) fn switch(
        &mut self,
        frame: &mut Frame<'m, M>,
        selector: Handle<Expression>,
        cases: &'m [SwitchCase],
    ) -> Res<()> {
        let arms: Vec<&Block> = cases.iter().filter(|c| !shares(c)).map(|c| &c.body).collect();
        if cases.iter().any(|c| c.fall_through && !c.body.is_empty()) {
            return Err(frame.unsupported("a case that falls through after statements"));
        }
        let m = &self.model;
        let words = frame.scalar(selector)?.words()?;
        let arm = |word: u32| arm_of(cases, word).unwrap_or(arms.len());
        let choice = Choice {
            value: words.iter().map(|w| arm(m.word_value(*w))).collect(),
            exact: words.iter().map(|w| arm(m.word_exact(*w))).collect(),
            ambiguous: frame.flow.active.filter(|lane| !m.known(words[lane])),
        };
        let outer_broke = frame.flow.broke.take();
        self.branch(frame, &arms, &choice)?;
        let left: Mask = std::mem::replace(&mut frame.flow.broke, outer_broke);
        frame.flow.active.join(&left);
        Ok(())
    }
}

fn shares(case: &SwitchCase) -> bool {
    case.fall_through && case.body.is_empty()
}

/// The arm for `word`: that of its case, or else of the default.
fn arm_of(cases: &[SwitchCase], word: u32) -> Option<usize> {
    let position = |wanted: &dyn Fn(SwitchValue) -> bool| cases.iter().position(|c| wanted(c.value));
    let own = position(&|value| match value {
        SwitchValue::I32(v) => v as u32 == word,
        SwitchValue::U32(v) => v == word,
        SwitchValue::Default => false,
    });
    let case = own.or_else(|| position(&|value| value == SwitchValue::Default))?;
    Some(cases[..case].iter().filter(|c| !shares(c)).count())
}
