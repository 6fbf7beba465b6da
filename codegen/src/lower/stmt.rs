//! Statements and control flow.

use super::body::{BodyBuilder, Local, Nesting};
use super::error::{Fail, Lowered};
use super::value::{BOOL, I32, Lit, Place, Sink, U32, Value};
use crate::def::{Arm, BinaryOp, Block, Expr, ExprKind, Span, Stmt, StmtKind, TypeDef};
use naga::{Statement, SwitchCase, SwitchValue};

impl BodyBuilder<'_> {
    /// Lowers a block whose value goes to `sink`.
    pub(super) fn block_into(&mut self, block: &'static Block, sink: &mut Sink) -> Lowered<()> {
        for stmt in block.stmts {
            // What stands after `return`, `break` or `continue` is never reached.
            if self.ended() {
                return Ok(());
            }
            self.stmt(stmt)?;
        }
        match block.value {
            Some(value) if !self.ended() => self.expr_into(value, sink),
            _ => Ok(()),
        }
    }

    fn stmt(&mut self, stmt: &'static Stmt) -> Lowered<()> {
        match &stmt.kind {
            StmtKind::Let { local, ty, init } => self.let_stmt(*local, ty.as_ref(), init.as_ref(), stmt.span),
            StmtKind::Assign { place, op, value } => self.assign(place, *op, value, stmt.span),
            StmtKind::Expr(e) => self.expr_into(e, &mut Sink::Discard),
            StmtKind::While { condition, body } => self.while_loop(condition, body, stmt.span),
            StmtKind::Loop(body) => self.loop_of(stmt.span, |b| b.block_into(body, &mut Sink::Discard), None),
            StmtKind::For { local, start, end, inclusive, body } => {
                self.for_loop(*local, [start, end], *inclusive, body, stmt.span)
            }
            StmtKind::Break => self.break_out(stmt.span),
            StmtKind::Continue => {
                self.push(Statement::Continue, stmt.span);
                Ok(())
            }
            StmtKind::Return(None) => {
                self.push(Statement::Return { value: None }, stmt.span);
                Ok(())
            }
            StmtKind::Return(Some(value)) if self.def.ret.is_none() => {
                self.expr_into(value, &mut Sink::Discard)?;
                if !self.ended() {
                    self.push(Statement::Return { value: None }, stmt.span);
                }
                Ok(())
            }
            StmtKind::Return(Some(value)) => self.expr_into(value, &mut Sink::Return),
        }
    }

    fn let_stmt(
        &mut self,
        local: u32,
        ty: Option<&TypeDef>,
        init: Option<&'static Expr>,
        span: Span,
    ) -> Lowered<()> {
        let Some(init) = init else {
            self.locals[local as usize] = match ty {
                Some(ty) => Local::Memory(self.variable(Some(self.def.locals[local as usize].name), ty)),
                None => Local::Unset,
            };
            return Ok(());
        };
        if branches(init) {
            let name = Some(self.def.locals[local as usize].name);
            let expected = ty.copied().or_else(|| self.peek(init));
            let mut sink = Sink::Variable { name, expected, place: None };
            self.expr_into(init, &mut sink)?;
            if let Sink::Variable { place: Some(place), .. } = sink {
                self.locals[local as usize] = Local::Memory(place);
            }
            return Ok(());
        }
        let mut value = self.expr_expecting(init, ty)?;
        if let Some(ty) = ty {
            value = self.fit(value, ty, init.span)?;
        }
        // An integer without suffix stays undecided: each use of the name decides as Rust does.
        self.bind(local, value, span);
        Ok(())
    }

    fn assign(
        &mut self,
        place: &'static Expr,
        op: Option<BinaryOp>,
        value: &'static Expr,
        span: Span,
    ) -> Lowered<()> {
        if let (ExprKind::Local(local), None) = (&place.kind, op)
            && let Local::Unset = self.locals[*local as usize]
        {
            return self.first_assignment(*local, value, span);
        }
        let unchangeable = || Fail::new(place.span, "this is no variable, so it cannot change");
        let ty = self.place_type(place)?.ok_or_else(unchangeable)?;
        // Rust evaluates the right side first, except before a compound assignment to a value that is
        // no primitive.
        let place_first = op.is_some() && !matches!(ty, TypeDef::Scalar(_));
        let early = if place_first { self.place(place)? } else { None };
        let right = self.expr_expecting(value, Some(&ty))?;
        let target = match early {
            Some(target) => target,
            None => self.place(place)?.ok_or_else(unchangeable)?,
        };
        let result = match op {
            None => right,
            Some(op) => {
                let old = self.load(target, place.span);
                self.binary(op, old, right, span)?
            }
        };
        let result = self.fit(result, &target.ty, if op.is_some() { span } else { value.span })?;
        self.store(target, result, span);
        Ok(())
    }

    /// The first value of a `let x;` decides its type.
    fn first_assignment(&mut self, local: u32, value: &'static Expr, span: Span) -> Lowered<()> {
        let value = self.expr(value)?;
        let name = self.def.locals[local as usize].name;
        if value.is_undecided() {
            self.assumed.push(name);
        }
        let place = self.variable(Some(name), &value.ty);
        self.store(place, value, span);
        self.locals[local as usize] = Local::Memory(place);
        Ok(())
    }

    /// Delivers the value of `e` to `sink`; branches deliver each their own.
    pub(super) fn expr_into(&mut self, e: &'static Expr, sink: &mut Sink) -> Lowered<()> {
        match &e.kind {
            ExprKind::If { condition, accept, reject } => {
                self.if_into(condition, accept, reject.as_ref(), sink, e.span)
            }
            ExprKind::Match { selector, arms } => self.match_into(selector, arms, sink, e.span),
            ExprKind::Block(block) => self.block_into(block, sink),
            _ => self.deliver(e, sink),
        }
    }

    fn deliver(&mut self, e: &'static Expr, sink: &mut Sink) -> Lowered<()> {
        match sink {
            Sink::Discard => self.effect(e),
            Sink::Return => {
                let ret = self.def.ret.as_ref();
                let value = self.expr_expecting(e, ret)?;
                let value = match ret {
                    Some(ret) => self.fit(value, ret, e.span)?,
                    None => value,
                };
                let value = self.handle(value, e.span);
                self.push(Statement::Return { value: Some(value) }, e.span);
                Ok(())
            }
            Sink::Variable { name, expected, place } => {
                let wanted = place.map(|p| p.ty).or(*expected);
                let value = self.expr_expecting(e, wanted.as_ref())?;
                let value = match &wanted {
                    Some(ty) => self.fit(value, ty, e.span)?,
                    None => value,
                };
                let target = match *place {
                    Some(target) => target,
                    None => {
                        if value.is_undecided() {
                            self.assumed.extend(*name);
                        }
                        *place.insert(self.variable(*name, &value.ty))
                    }
                };
                self.store(target, value, e.span);
                Ok(())
            }
        }
    }

    fn if_into(
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

    fn match_into(
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

    fn break_out(&mut self, span: Span) -> Lowered<()> {
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

    fn while_loop(&mut self, condition: &'static Expr, body: &'static Block, span: Span) -> Lowered<()> {
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

    fn for_loop(
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

/// Whether the value of `e` comes out of branches.
pub(super) fn branches(e: &Expr) -> bool {
    matches!(e.kind, ExprKind::If { .. } | ExprKind::Match { .. } | ExprKind::Block(_))
}
