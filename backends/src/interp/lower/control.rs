//! Statements that decide.
//!
//! While walking, each scalar of a variable *is* a value (`Lowerer::variables`): a store changes what it is,
//! a load costs nothing.
//! Where two ways meet, a select joins what they made of it.
//! A construct that lanes leave early (a loop, a switch with breaks, a function with returns in its midst)
//! *keeps* the variables that it writes in registers: lanes that leave assign them, and behind its end
//! the variable is what is kept.

use super::super::error::Res;
use super::super::program::{Args, Block as Code, Eval, Label, Op, Reg, Scalar, Stmt, Value};
use super::Lowerer;
use super::frame::{Frame, Returning, Root};
use super::scan::{self, Variable};
use naga::{Block, Expression, Handle, Statement};
use std::collections::BTreeSet;

/// Whether lanes reach the end of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Flow {
    Falls,
    Ends,
}

/// What a way out is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Purpose {
    Break,
    Continue,
    Return,
}

/// A construct that lanes may leave early.
#[derive(Debug, Clone)]
pub(crate) struct Exit {
    label: Label,
    purpose: Purpose,
    /// Scalars of variables and the registers that keep them.
    kept: Vec<(usize, Reg)>,
}

/// Statements that follow.
#[derive(Clone, Copy)]
pub(crate) struct Then<'a, 'm> {
    pub(super) statements: &'m [Statement],
    pub(super) next: Option<&'a Then<'a, 'm>>,
}

impl<'m> Lowerer<'m> {
    /// Walks `statements`, then what follows.
    pub(crate) fn sequence(
        &mut self,
        frame: &mut Frame<'m>,
        statements: &'m [Statement],
        then: Option<&Then<'_, 'm>>,
    ) -> Res<Flow> {
        for (at, statement) in statements.iter().enumerate() {
            self.locate(statement);
            let rest = Then { statements: &statements[at + 1..], next: then };
            if let Statement::Block(inner) = statement {
                return self.sequence(frame, inner, Some(&rest));
            }
            if let Statement::If { condition, accept, reject } = statement
                && frame.returning == Returning::Last
                && (scan::returns(accept) || scan::returns(reject))
            {
                let after = |arm| if scan::always_returns(arm) { None } else { Some(&rest) };
                return self.decide(frame, *condition, (accept, after(accept)), (reject, after(reject)));
            }
            if self.statement(frame, statement)? == Flow::Ends {
                return Ok(Flow::Ends);
            }
        }
        match then {
            Some(then) => self.sequence(frame, then.statements, then.next),
            None => Ok(Flow::Falls),
        }
    }

    /// Walks a block of its own.
    fn arm(
        &mut self,
        frame: &mut Frame<'m>,
        statements: &'m [Statement],
        then: Option<&Then<'_, 'm>>,
    ) -> Res<(Code, Flow)> {
        self.b.begin();
        let flow = self.sequence(frame, statements, then);
        let code = self.b.end();
        Ok((code, flow?))
    }

    /// `if`
    pub(crate) fn decide(
        &mut self,
        frame: &mut Frame<'m>,
        condition: Handle<Expression>,
        accept: (&'m [Statement], Option<&Then<'_, 'm>>),
        reject: (&'m [Statement], Option<&Then<'_, 'm>>),
    ) -> Res<Flow> {
        let condition = frame.single(condition)?;
        self.fork(
            condition,
            frame,
            |this, frame| this.arm(frame, accept.0, accept.1),
            |this, frame| this.arm(frame, reject.0, reject.1),
        )
    }

    /// Both ways of a decision, and their meeting.
    pub(super) fn fork(
        &mut self,
        condition: Value,
        frame: &mut Frame<'m>,
        accept: impl FnOnce(&mut Self, &mut Frame<'m>) -> Res<(Code, Flow)>,
        reject: impl FnOnce(&mut Self, &mut Frame<'m>) -> Res<(Code, Flow)>,
    ) -> Res<Flow> {
        let before = self.variables.clone();
        let (accept, accept_flow) = accept(self, frame)?;
        let accepted = std::mem::replace(&mut self.variables, before);
        let (reject, reject_flow) = reject(self, frame)?;
        if !accept.is_empty() || !reject.is_empty() {
            self.b.push(Stmt::If { condition, accept, reject });
        }
        match (accept_flow, reject_flow) {
            (Flow::Ends, Flow::Ends) => return Ok(Flow::Ends),
            (Flow::Ends, Flow::Falls) => {}
            (Flow::Falls, Flow::Ends) => self.variables = accepted,
            (Flow::Falls, Flow::Falls) => {
                for (index, accepted) in accepted.into_iter().enumerate() {
                    let rejected = self.variables[index];
                    self.variables[index] = self.b.select(condition, accepted, rejected);
                }
            }
        }
        Ok(Flow::Falls)
    }

    /// The scalars of those variables that are registers.
    pub(crate) fn scalars_of(&self, frame: &Frame<'m>, written: &BTreeSet<Variable>) -> Res<Vec<usize>> {
        let mut out = Vec::new();
        for variable in written {
            let pointer = match *variable {
                Variable::Local(index) => Some(frame.locals[index]),
                Variable::Global(index) => self.globals[index],
                Variable::Parameter(index) => match &frame.arguments[index as usize] {
                    super::Item::Pointer(pointer) => Some(*pointer),
                    super::Item::Values(_) | super::Item::Image(_) | super::Item::Sampler(_) => None,
                },
            };
            if let Some(pointer) = pointer
                && let Root::Registers(first) = pointer.root
            {
                let first = first + pointer.offset as usize;
                out.extend(first..first + self.types().count(pointer.shape)? as usize);
            }
        }
        out.sort_unstable();
        out.dedup();
        Ok(out)
    }

    /// Moves variables into registers that last; from here on they are what is kept.
    pub(crate) fn keep(&mut self, scalars: Vec<usize>) -> Vec<(usize, Reg)> {
        let kept: Vec<_> = scalars
            .into_iter()
            .map(|index| (index, self.b.register(self.b.scalar(self.variables[index]))))
            .collect();
        self.assign(&kept);
        self.restore(&kept);
        kept
    }

    /// The kept registers take what the variables are.
    fn assign(&mut self, kept: &[(usize, Reg)]) {
        let changed: Vec<_> = kept
            .iter()
            .map(|(index, reg)| (self.variables[*index], *reg))
            .filter(|(value, reg)| *value != Value::Reg(*reg))
            .collect();
        let overwritten: BTreeSet<Reg> = changed.iter().map(|(_, reg)| *reg).collect();
        let values: Vec<_> = changed
            .iter()
            .map(|(value, _)| match value {
                Value::Reg(reg) if overwritten.contains(reg) => self.copy(*value),
                Value::Reg(_) | Value::Const(_) => *value,
            })
            .collect();
        for ((_, to), value) in changed.into_iter().zip(values) {
            self.b.push(Stmt::Set { to, value });
        }
    }

    /// A register of its own for what a kept register holds now.
    fn copy(&mut self, value: Value) -> Value {
        let scalar = self.b.scalar(value);
        let to = self.b.register(scalar);
        self.b.push(Stmt::Eval(Eval { to, op: Op::Copy(scalar), args: Args::new(&[value]), at: self.b.at }));
        Value::Reg(to)
    }

    /// The variables are what is kept.
    fn restore(&mut self, kept: &[(usize, Reg)]) {
        kept.iter().for_each(|(index, reg)| self.variables[*index] = Value::Reg(*reg));
    }

    /// A value that lasts to the end of its block, even if the kept register that it is in does not.
    pub(crate) fn lasting(&mut self, value: Value) -> Value {
        let kept = |exit: &Exit| {
            exit.purpose == Purpose::Continue && exit.kept.iter().any(|(_, reg)| Value::Reg(*reg) == value)
        };
        if self.exits.iter().any(kept) { self.copy(value) } else { value }
    }

    /// The active lanes go to the end of a construct.
    pub(crate) fn leave(&mut self, exit: usize) -> Flow {
        let Exit { label, kept, .. } = self.exits[exit].clone();
        self.assign(&kept);
        self.b.push(Stmt::Leave(label));
        Flow::Ends
    }

    /// The innermost way out for this purpose.
    pub(crate) fn innermost(&self, purpose: Purpose) -> Option<usize> {
        self.exits.iter().rposition(|exit| exit.purpose == purpose)
    }

    /// Runs `body` where lanes may leave early, then goes on with the variables that are kept.
    pub(crate) fn within(
        &mut self,
        purpose: Purpose,
        kept: Vec<(usize, Reg)>,
        frame: &mut Frame<'m>,
        body: impl FnOnce(&mut Self, &mut Frame<'m>, usize) -> Res<Flow>,
    ) -> Res<(Label, Code)> {
        let label = self.b.label();
        self.exits.push(Exit { label, purpose, kept: kept.clone() });
        let exit = self.exits.len() - 1;
        self.b.begin();
        let flow = body(self, frame, exit);
        self.exits.truncate(exit);
        if flow.as_ref().is_ok_and(|f| *f == Flow::Falls) {
            self.assign(&kept);
        }
        let code = self.b.end();
        self.restore(&kept);
        flow.map(|_| (label, code))
    }

    /// `loop`
    pub(crate) fn repeat(
        &mut self,
        frame: &mut Frame<'m>,
        body: &'m Block,
        continuing: &'m Block,
        break_if: Option<Handle<Expression>>,
    ) -> Res<Flow> {
        let mut written = self.scan.written(frame.function, body);
        written.extend(self.scan.written(frame.function, continuing));
        let scalars = self.scalars_of(frame, &written)?;
        let kept = self.keep(scalars);
        self.b.touch();
        let (function, at) = (frame.name, self.b.at);
        let inner = kept.clone();
        let (label, code) = self.within(Purpose::Break, kept, frame, |this, frame, exit| {
            let flow = if scan::continues(body) {
                let round = this.within(Purpose::Continue, inner, frame, |this, frame, _| {
                    this.sequence(frame, body, None)
                });
                let (label, body) = round?;
                this.b.push(Stmt::Scope { label, body });
                Flow::Falls
            } else {
                this.sequence(frame, body, None)?
            };
            if flow == Flow::Ends {
                return Ok(Flow::Ends);
            }
            this.sequence(frame, continuing, None)?;
            if let Some(condition) = break_if {
                let condition = frame.single(condition)?;
                let leave = |this: &mut Self, _: &mut Frame<'m>| {
                    this.b.begin();
                    let flow = this.leave(exit);
                    Ok((this.b.end(), flow))
                };
                return this.fork(condition, frame, leave, |_, _| Ok((Code::new(), Flow::Falls)));
            }
            Ok(Flow::Falls)
        })?;
        self.b.touch();
        self.b.push(Stmt::Loop { label, body: code, function, at });
        Ok(Flow::Falls)
    }

    /// `return`
    pub(crate) fn give_back(&mut self, frame: &Frame<'m>, value: Option<Handle<Expression>>) -> Res<Flow> {
        if let Some(value) = value {
            let values = frame.data(value)?;
            for (at, value) in values.iter().enumerate() {
                self.variables[frame.result + at] = *value;
            }
        }
        match frame.returning {
            Returning::Last => Ok(Flow::Falls),
            Returning::Early(exit) => Ok(self.leave(exit)),
        }
    }

    /// A boolean constant.
    pub(crate) fn boolean(&mut self, value: bool) -> Value {
        self.b.bits(Scalar::Bool, if value { u32::MAX.into() } else { 0 }, f64::from(u8::from(value)))
    }
}
