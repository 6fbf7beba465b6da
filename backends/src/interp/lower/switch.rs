//! `switch`: a chain of decisions.
//!
//! A case that falls through runs the bodies behind it too, so those are walked once for each way into them.

use super::super::error::Res;
use super::super::program::op::{Comparison, LogicOp};
use super::super::program::{Op, Stmt, Value};
use super::Lowerer;
use super::control::{Flow, Purpose, Then};
use super::frame::Frame;
use super::scan;
use naga::{Block, Expression, Handle, SwitchCase, SwitchValue};
use std::collections::BTreeSet;

/// What a switch may choose.
struct Arm<'m> {
    /// Of the default there is none.
    condition: Option<Value>,
    bodies: Vec<&'m Block>,
}

/// The bodies that run from the first case on: up to one that does not fall through.
fn reached(cases: &[SwitchCase]) -> Vec<&Block> {
    let last = cases.iter().position(|c| !c.fall_through).unwrap_or(cases.len() - 1);
    cases[..=last].iter().map(|c| &c.body).collect()
}

impl<'m> Lowerer<'m> {
    /// `switch`
    pub(crate) fn switch(
        &mut self,
        frame: &mut Frame<'m>,
        selector: Handle<Expression>,
        cases: &'m [SwitchCase],
    ) -> Res<Flow> {
        let selector = frame.single(selector)?;
        let arms = self.arms(selector, cases);
        if !cases.iter().any(|c| scan::breaks(&c.body)) {
            return self.choose(frame, &arms);
        }
        let mut written = BTreeSet::new();
        cases.iter().for_each(|c| written.extend(self.scan.written(frame.function, &c.body)));
        let scalars = self.scalars_of(frame, &written)?;
        let kept = self.keep(scalars);
        let (label, body) =
            self.within(Purpose::Break, kept, frame, |this, frame, _| this.choose(frame, &arms))?;
        self.b.push(Stmt::Scope { label, body });
        Ok(Flow::Falls)
    }

    /// The bodies and when they are chosen; the default, which has no condition, comes last.
    fn arms(&mut self, selector: Value, cases: &'m [SwitchCase]) -> Vec<Arm<'m>> {
        let (mut arms, mut otherwise) = (Vec::new(), None);
        let mut start = 0;
        for (at, case) in cases.iter().enumerate() {
            // It shares the body of the next one.
            if case.fall_through && case.body.is_empty() {
                continue;
            }
            let group = &cases[start..=at];
            start = at + 1;
            let bodies = reached(&cases[at..]);
            if group.iter().any(|c| c.value == SwitchValue::Default) {
                otherwise = Some(Arm { condition: None, bodies });
                continue;
            }
            let mut condition = None;
            for case in group {
                let same = self.is(selector, case.value);
                condition = Some(match condition {
                    Some(before) => self.b.eval(Op::Logic(LogicOp::Or), &[before, same]),
                    None => same,
                });
            }
            arms.push(Arm { condition, bodies });
        }
        arms.extend(otherwise);
        arms
    }

    fn is(&mut self, selector: Value, value: SwitchValue) -> Value {
        let word = match value {
            SwitchValue::I32(v) => v as u32,
            SwitchValue::U32(v) => v,
            SwitchValue::Default => 0,
        };
        let scalar = self.b.scalar(selector);
        let word = self.b.bits(scalar, word.into(), word.into());
        self.b.eval(Op::Compare(scalar, Comparison::Equal), &[selector, word])
    }

    /// The first arm whose condition holds.
    fn choose(&mut self, frame: &mut Frame<'m>, arms: &[Arm<'m>]) -> Res<Flow> {
        let Some((arm, rest)) = arms.split_first() else {
            return Ok(Flow::Falls);
        };
        let Some(condition) = arm.condition else {
            return self.bodies(frame, &arm.bodies, None);
        };
        let block = |this: &mut Self,
                     frame: &mut Frame<'m>,
                     within: &dyn Fn(&mut Self, &mut Frame<'m>) -> Res<Flow>| {
            this.b.begin();
            let flow = within(this, frame);
            let code = this.b.end();
            Ok((code, flow?))
        };
        self.fork(
            condition,
            frame,
            |this, frame| block(this, frame, &|this, frame| this.bodies(frame, &arm.bodies, None)),
            |this, frame| block(this, frame, &|this, frame| this.choose(frame, rest)),
        )
    }

    /// Bodies of cases that fall through, one after the other.
    fn bodies(
        &mut self,
        frame: &mut Frame<'m>,
        bodies: &[&'m Block],
        then: Option<&Then<'_, 'm>>,
    ) -> Res<Flow> {
        match bodies {
            [] => Ok(Flow::Falls),
            [only] => self.sequence(frame, only, then),
            [before @ .., last] => self.bodies(frame, before, Some(&Then { statements: last, next: then })),
        }
    }
}
