//! Looks for mistakes of the program that runs, beside each statement; what it computes stays as it is.
//!
//! - `bounds` looks at indices and at the numbers of texels.
//! - `race` knows who touched which word of shared memory since when.
//! - `unwritten` follows values that nothing was written to until somebody uses one.

mod bounds;
mod race;
mod unwritten;

use super::super::error::{InterpError, Res};
use super::super::finding::{Checks, Fault, Finding, Invocation};
use super::super::model::Model;
use super::super::program::op::IntOp;
use super::super::program::{Block, Eval, Op, Scalar, Stmt, Subgroup, Value};
use super::super::subgroup::Brought;
use super::input::{Inputs, local};
use super::{Machine, integer};
use naga::Span;
use race::{Races, Touch};
use std::collections::HashSet;
use unwritten::Unwritten;

/// What was found, and what is known to find more.
pub(super) struct Watch {
    checks: Checks,
    findings: Vec<Finding>,
    seen: HashSet<(Fault, Option<std::ops::Range<usize>>)>,
    races: Races,
    unwritten: Option<Unwritten>,
}

impl Watch {
    pub(super) fn new(checks: Checks) -> Self {
        Self {
            checks,
            findings: Vec::new(),
            seen: HashSet::new(),
            races: Races::default(),
            unwritten: checks.unwritten.then(Unwritten::default),
        }
    }

    /// Notes a mistake, once for each place of the source.
    fn report<M: Model>(
        &mut self,
        m: &Machine<'_, M>,
        (kind, at): (Fault, Span),
        lane: usize,
        message: impl FnOnce() -> String,
    ) {
        if self.findings.len() < self.checks.limit && self.seen.insert((kind, at.to_range())) {
            let invocation = m.invocation(lane);
            self.findings.push(Finding { kind, span: at, invocation, message: message() });
        }
    }

    /// Looks at a statement that is about to be executed.
    fn before<M: Model>(&mut self, m: &Machine<'_, M>, stmt: &Stmt) -> Res<()> {
        if let Some(unwritten) = &mut self.unwritten
            && let Some((lane, at)) = unwritten.before(m, stmt)?
        {
            self.report(m, (Fault::Unwritten, at), lane, || UNWRITTEN.to_owned());
        }
        match stmt {
            Stmt::Eval(eval) => self.operands(m, eval),
            Stmt::Store { place, value, at } => {
                self.touch(m, *place, m.program.scalar(*value), Touch::WRITE, *at)
            }
            Stmt::Atomic(atomic) => {
                self.touch(m, atomic.place, m.program.scalar(atomic.value), Touch::ATOMIC, atomic.at)
            }
            Stmt::Texture(access) => self.texels(m, access),
            Stmt::Barrier { at, .. } => {
                self.barrier(m, *at);
                Ok(())
            }
            Stmt::Set { .. }
            | Stmt::If { .. }
            | Stmt::Loop { .. }
            | Stmt::Scope { .. }
            | Stmt::Leave(_)
            | Stmt::Subgroup(_) => Ok(()),
        }
    }

    fn operands<M: Model>(&mut self, m: &Machine<'_, M>, eval: &Eval) -> Res<()> {
        match (eval.op, &eval.args[..]) {
            (Op::Index { count, stride }, &[index, ..]) => self.index(m, eval.at, (count, stride), index),
            (Op::IndexWithin { .. }, &[index, _, count]) => self.index_within(m, eval.at, index, count),
            (Op::Int(scalar, IntOp::Div | IntOp::Rem), &[a, b]) => self.division(m, eval.at, scalar, (a, b)),
            (Op::Load { place, scalar, .. }, _) => self.touch(m, place, scalar, Touch::READ, eval.at),
            _ => Ok(()),
        }
    }

    fn division<M: Model>(
        &mut self,
        m: &Machine<'_, M>,
        at: Span,
        scalar: Scalar,
        (a, b): (Value, Value),
    ) -> Res<()> {
        let (a, b) = (m.words(a)?, m.words(b)?);
        for lane in m.flow.active.lanes() {
            let number = |bits| integer::number(bits, scalar);
            let (a, b) = (number(m.model.word_value(a.at(lane))), number(m.model.word_value(b.at(lane))));
            if !integer::divides(scalar, a, b) {
                let message = || format!("{a} is divided by {b}");
                self.report(m, (Fault::DivisionByZero, at), lane, message);
            }
        }
        Ok(())
    }

    fn barrier<M: Model>(&mut self, m: &Machine<'_, M>, at: Span) {
        if m.inputs.workgroup()
            && let Some(absent) = (0..m.lanes).find(|lane| !m.flow.active.get(*lane))
        {
            let here = m.flow.active.lanes().count();
            let message = || format!("{here} of {} invocations reach a barrier, this one does not", m.lanes);
            self.report(m, (Fault::NonUniformBarrier, at), absent, message);
        }
    }

    /// Looks at what an operation has returned.
    fn result<M: Model>(&mut self, m: &Machine<'_, M>, eval: &Eval) -> Res<()> {
        if let Some(unwritten) = &mut self.unwritten {
            unwritten.result(m, eval)?;
        }
        let Op::Float(Scalar::F32, op) = eval.op else {
            return Ok(());
        };
        let result = m.floats(Value::Reg(eval.to))?;
        for lane in m.flow.active.lanes().filter(|lane| m.model.value(result.at(*lane)).is_nan()) {
            let operands = eval.args.iter().map(|a| Ok(m.model.value(m.floats(*a)?.at(lane))));
            let operands = operands.collect::<Res<Vec<f32>>>()?;
            if !operands.iter().any(|x| x.is_nan()) {
                let message = || format!("{op:?} of {operands:?} is NaN");
                self.report(m, (Fault::NanBirth, eval.at), lane, message);
            }
        }
        Ok(())
    }
}

const UNWRITTEN: &str = "a variable is used that nothing was written to";

impl<M: Model> Machine<'_, M> {
    /// Who a lane is.
    fn invocation(&self, lane: usize) -> Invocation {
        match self.inputs {
            Inputs::Rows { first, .. } => Invocation::Row(first + lane),
            Inputs::Group { group, size, .. } => Invocation::Global { group, local: local(size, lane) },
        }
    }

    fn watched(&mut self, f: impl FnOnce(&mut Watch, &Self) -> Res<()>) -> Res<()> {
        let Some(mut watch) = self.watch.take() else {
            return Ok(());
        };
        let done = f(&mut watch, self);
        self.watch = Some(watch);
        done
    }

    /// A workgroup, or a batch, begins.
    pub(super) fn watch_begin(&mut self) {
        // It has nothing that could fail.
        let _ = self.watched(|watch, m| {
            watch.races.begin(m);
            if let Some(unwritten) = &mut watch.unwritten {
                unwritten.begin(m);
            }
            Ok(())
        });
    }

    pub(super) fn watch_before(&mut self, stmt: &Stmt) -> Res<()> {
        self.watched(|watch, m| watch.before(m, stmt))
    }

    /// The lanes of a subgroup have brought their values.
    pub(super) fn watch_exchange(&mut self, subgroup: &Subgroup, first: usize, lanes: &[Option<Brought>]) {
        let _ = self.watched(|watch, m| {
            watch.gathered(m, subgroup, first, lanes);
            Ok(())
        });
    }

    pub(super) fn watch_result(&mut self, eval: &Eval) -> Res<()> {
        self.watched(|watch, m| watch.result(m, eval))
    }

    /// A loop has run out of fuel.
    pub(super) fn watch_loop(&mut self, at: Span) {
        let _ = self.watched(|watch, m| {
            if let Some(lane) = m.flow.active.lanes().next() {
                let message = || "a loop runs longer than the fuel allows".to_owned();
                watch.report(m, (Fault::EndlessLoop, at), lane, message);
            }
            Ok(())
        });
    }

    /// The results of a function are used, too.
    pub(super) fn watch_results(&mut self) -> Res<()> {
        let at = last_span(&self.program.body).unwrap_or_default();
        self.watched(|watch, m| {
            let Some(unwritten) = &watch.unwritten else {
                return Ok(());
            };
            let used = m.program.results.iter().find_map(|v| unwritten.used(m, *v));
            if let Some(lane) = used {
                watch.report(m, (Fault::Unwritten, at), lane, || UNWRITTEN.to_owned());
            }
            Ok(())
        })
    }
}

/// Where the source has what happens last.
fn last_span(block: &Block) -> Option<Span> {
    block.iter().rev().find_map(|stmt| match stmt {
        Stmt::Eval(eval) => Some(eval.at),
        _ => stmt.blocks().into_iter().flatten().find_map(last_span),
    })
}

/// What was found, whether or not that ended the run.
pub(super) fn findings(outcome: Res<()>, watch: Option<Watch>) -> Res<Vec<Finding>> {
    match outcome {
        Ok(()) | Err(InterpError::OutOfFuel { .. }) => Ok(watch.map_or_else(Vec::new, |w| w.findings)),
        Err(error) => Err(error),
    }
}

/// Of findings of several batches, the first of each kind and place.
pub(super) fn first_of_each(findings: impl Iterator<Item = Finding>, checks: Checks) -> Vec<Finding> {
    let mut seen = HashSet::new();
    findings.filter(|f| seen.insert((f.kind, f.span.to_range()))).take(checks.limit).collect()
}
