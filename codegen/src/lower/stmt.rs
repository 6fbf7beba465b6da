//! Statements.

use super::body::{BodyBuilder, Local};
use super::error::{Fail, Lowered};
use super::value::{Sink, Value};
use crate::def::{BinaryOp, Block, Expr, ExprKind, Span, Stmt, StmtKind, TypeDef};
use naga::Statement;

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
        self.at = stmt.span;
        match &stmt.kind {
            StmtKind::Let { local, ty, init } => self.let_stmt(*local, ty.as_ref(), init.as_ref(), stmt.span),
            StmtKind::Assign { place, op, value } => self.assign(place, *op, value, stmt.span),
            StmtKind::Expr(e) => self.expr_into(e, &mut Sink::Discard),
            StmtKind::While { condition, body } => self.while_loop(condition, body, stmt.span),
            StmtKind::Loop(body) => self.endless_loop(body, stmt.span),
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
                if let Some(ty) = ty {
                    self.fit(Value::expr(place.ty, place.pointer), ty, init.span)?;
                }
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
                let mut value = self.expr_expecting(e, wanted.as_ref())?;
                if let Some(place) = place {
                    value = self.fit(value, &place.ty, e.span)?;
                }
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
}

/// Whether the value of `e` comes out of branches.
pub(super) fn branches(e: &Expr) -> bool {
    matches!(e.kind, ExprKind::If { .. } | ExprKind::Match { .. } | ExprKind::Block(_))
}
