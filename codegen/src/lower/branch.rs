//! `if` and `match`, and `break` out of a `match`.

use super::body::{BodyBuilder, Nesting};
use super::error::{Fail, Lowered};
use super::value::{BOOL, I32, Place, Sink, U32};
use crate::def::{Arm, Block, Expr, Span};
use naga::{Statement, SwitchCase, SwitchValue};

impl BodyBuilder<'_> {
    pub(super) fn if_into(
        &mut self,
        condition: &'static Expr,
        accept: &'static Block,
        reject: Option<&'static Block>,
        sink: &mut Sink,
        span: Span,
    ) -> Lowered<()> {
        let value = self.expr_expecting(condition, Some(&BOOL))?;
        let value = self.fit(value, &BOOL, condition.span)?;
        let condition = self.handle(value, condition.span);
        let (accept, accept_ended) = self.nested(|b| b.block_into(accept, sink))?;
        let (reject, reject_ended) = match reject {
            Some(block) => self.nested(|b| b.block_into(block, sink))?,
            None => (naga::Block::new(), false),
        };
        self.push(Statement::If { condition, accept, reject }, span);
        if accept_ended && reject_ended {
            self.end();
        }
        Ok(())
    }

    pub(super) fn match_into(
        &mut self,
        selector: &'static Expr,
        arms: &'static [Arm],
        sink: &mut Sink,
        span: Span,
    ) -> Lowered<()> {
        let value = self.expr(selector)?.decide(&I32);
        let unsigned = match value.ty {
            ty if ty == U32 => true,
            ty if ty == I32 => false,
            ty => return Err(Fail::new(selector.span, format!("`match` takes an i32 or u32, this is {ty}"))),
        };
        let selector = self.handle(value, selector.span);
        self.flush();
        self.nesting.push(Nesting::Switch { leave: None });
        let mut cases = Vec::new();
        let mut all_ended = true;
        for arm in arms {
            let (body, ended) = self.nested(|b| b.block_into(&arm.body, sink))?;
            all_ended &= ended;
            push_cases(&mut cases, arm, body, unsigned);
            if arm.patterns.is_empty() {
                // Rust never gets to an arm below `_`.
                break;
            }
        }
        if !cases.iter().any(|c| c.value == SwitchValue::Default) {
            cases.push(SwitchCase {
                value: SwitchValue::Default,
                body: naga::Block::new(),
                fall_through: false,
            });
        }
        let nesting = self.nesting.pop();
        // An arm may end by leaving the switch only, on its way out of a loop.
        let leave = match nesting {
            Some(Nesting::Switch { leave }) => leave,
            _ => None,
        };
        self.push(Statement::Switch { selector, cases }, span);
        if let Some(pointer) = leave {
            return self.pass_break_on(pointer, span);
        }
        if all_ended {
            self.end();
        }
        Ok(())
    }

    /// After a switch in which `break` meant the loop around it.
    fn pass_break_on(&mut self, pointer: naga::Handle<naga::Expression>, span: Span) -> Lowered<()> {
        let leave = self.load(Place { pointer, ty: BOOL }, span);
        let condition = self.handle(leave, span);
        let (accept, _) = self.nested(|b| b.break_out(span))?;
        self.push(Statement::If { condition, accept, reject: naga::Block::new() }, span);
        Ok(())
    }
}

/// The cases of one arm: all but the last value fall through.
///
/// A value that an arm above takes is left out: Rust never gets here with it, and a switch may name
/// it only once.
fn push_cases(cases: &mut Vec<SwitchCase>, arm: &Arm, body: naga::Block, unsigned: bool) {
    if arm.patterns.is_empty() {
        cases.push(SwitchCase { value: SwitchValue::Default, body, fall_through: false });
        return;
    }
    let mut own: Vec<SwitchValue> = Vec::new();
    for &v in arm.patterns {
        let value = if unsigned { SwitchValue::U32(v as u32) } else { SwitchValue::I32(v as i32) };
        if !own.contains(&value) && !cases.iter().any(|c| c.value == value) {
            own.push(value);
        }
    }
    if let Some((last, others)) = own.split_last() {
        cases.extend(others.iter().map(|&value| SwitchCase {
            value,
            body: naga::Block::new(),
            fall_through: true,
        }));
        cases.push(SwitchCase { value: *last, body, fall_through: false });
    }
}
