//! Loops.

use super::body::{BodyBuilder, Local, Nesting};
use super::error::{Fail, Lowered};
use super::value::{BOOL, I32, Lit, Place, Sink, U32, Value};
use crate::def::{BinaryOp, Block, Expr, Span};
use naga::Statement;

impl BodyBuilder<'_> {
    pub(super) fn break_out(&mut self, span: Span) -> Lowered<()> {
        match self.nesting.last().copied() {
            Some(Nesting::Switch { leave }) => {
                let pointer = match leave {
                    Some(pointer) => pointer,
                    None => self.leave_flag(),
                };
                let yes = Value::literal(Lit::Bool(true));
                self.store(Place { pointer, ty: BOOL }, yes, span);
            }
            Some(Nesting::Loop { .. }) => {
                if let Some(Nesting::Loop { left }) = self.nesting.last_mut() {
                    *left = true;
                }
            }
            None => return Err(Fail::new(span, "`break` outside a loop")),
        }
        self.push(Statement::Break, span);
        Ok(())
    }

    /// A flag that is false at the start of each round of the loop around the switch.
    fn leave_flag(&mut self) -> naga::Handle<naga::Expression> {
        let place = self.variable(Some("leave_loop"), &BOOL);
        // A variable is false at first, and once true the loop is left; a loop entered again, though,
        // must find it false.
        if let Some(Nesting::Switch { leave }) = self.nesting.last_mut() {
            *leave = Some(place.pointer);
        }
        self.resets.push(place);
        place.pointer
    }

    /// `loop { body }`
    pub(super) fn endless_loop(&mut self, body: &'static Block, span: Span) -> Lowered<()> {
        self.loop_of(span, |b| b.block_into(body, &mut Sink::Discard), None)
    }

    pub(super) fn while_loop(
        &mut self,
        condition: &'static Expr,
        body: &'static Block,
        span: Span,
    ) -> Lowered<()> {
        self.loop_of(
            span,
            |b| {
                let value = b.expr_expecting(condition, Some(&BOOL))?;
                let value = b.fit(value, &BOOL, condition.span)?;
                b.break_unless(value, condition.span)?;
                b.block_into(body, &mut Sink::Discard)
            },
            None,
        )
    }

    /// `if condition {} else { break; }`
    fn break_unless(&mut self, condition: Value, span: Span) -> Lowered<()> {
        let condition = self.handle(condition, span);
        let (reject, _) = self.nested(|b| b.break_out(span))?;
        self.push(Statement::If { condition, accept: naga::Block::new(), reject }, span);
        Ok(())
    }

    pub(super) fn for_loop(
        &mut self,
        local: u32,
        [start, end]: [&'static Expr; 2],
        inclusive: bool,
        body: &'static Block,
        span: Span,
    ) -> Lowered<()> {
        let (first, last) = self.range(start, end)?;
        let declared = &self.def.locals[local as usize];
        let counter = self.variable(Some(declared.name), &first.ty);
        self.store(counter, first, start.span);
        self.locals[local as usize] = Local::Memory(counter);
        let test = if inclusive { BinaryOp::LessEqual } else { BinaryOp::Less };
        self.loop_of(
            span,
            |b| {
                let now = b.load(counter, span);
                let more = b.binary(test, now, last, span)?;
                b.break_unless(more, span)?;
                if b.def.locals[local as usize].mutable {
                    // A `mut` loop variable is a copy: changing it does not move the loop.
                    let copy = b.load(counter, span);
                    b.bind(local, copy, span);
                }
                b.block_into(body, &mut Sink::Discard)
            },
            Some(Counter { place: counter, last: inclusive.then_some(last) }),
        )
    }

    /// The bounds of a range, of one decided type.
    fn range(&mut self, start: &'static Expr, end: &'static Expr) -> Lowered<(Value, Value)> {
        let first = self.expr(start)?;
        let last = self.expr_expecting(end, Some(&first.ty))?;
        let (first, last) = match (first.is_undecided(), last.is_undecided()) {
            (true, false) => (first.decide(&last.ty), last),
            _ => (first.decide(&I32), last.decide(&first.ty)),
        };
        if first.ty != last.ty || (first.ty != I32 && first.ty != U32) {
            let message = format!("a range runs over i32 or u32, this one from {} to {}", first.ty, last.ty);
            return Err(Fail::new(start.span, message));
        }
        // The bound is evaluated once: a variable that it reads may change in the body.
        Ok((first, last))
    }

    /// A loop; with a counter, each round ends by counting.
    fn loop_of(
        &mut self,
        span: Span,
        body: impl FnOnce(&mut Self) -> Lowered<()>,
        counter: Option<Counter>,
    ) -> Lowered<()> {
        self.flush();
        let outer_resets = std::mem::take(&mut self.resets);
        self.nesting.push(Nesting::Loop { left: false });
        let (block, _) = self.nested(body)?;
        let left = matches!(self.nesting.pop(), Some(Nesting::Loop { left: true }));
        let mut break_if = None;
        let (continuing, _) = self.nested(|b| {
            break_if = b.count(counter, span)?;
            Ok(())
        })?;
        let resets = std::mem::replace(&mut self.resets, outer_resets);
        for place in resets {
            let no = Value::literal(Lit::Bool(false));
            self.store(place, no, span);
        }
        if block.is_empty() && continuing.is_empty() {
            return Err(Fail::new(span, "this loop never ends and does nothing"));
        }
        self.push(Statement::Loop { body: block, continuing, break_if }, span);
        if !left && break_if.is_none() {
            self.end();
        }
        Ok(())
    }

    /// `i = i + 1`; for an inclusive range also whether that was the last round.
    fn count(
        &mut self,
        counter: Option<Counter>,
        span: Span,
    ) -> Lowered<Option<naga::Handle<naga::Expression>>> {
        let Some(Counter { place, last }) = counter else { return Ok(None) };
        let now = self.load(place, span);
        let done = match last {
            Some(last) => {
                let done = self.binary(BinaryOp::Equal, now, last, span)?;
                Some(self.handle(done, span))
            }
            None => None,
        };
        let one = Value::literal(Lit::Int(1)).decide(&place.ty);
        let next = self.binary(BinaryOp::Add, now, one, span)?;
        self.store(place, next, span);
        Ok(done)
    }
}

/// What a `for` counts, and where an inclusive range ends.
struct Counter {
    place: Place,
    last: Option<Value>,
}
