//! Branches, loops and jumps.
//!
//! Where rounding decides, a lane's choice is *ambiguous*: some permitted driver takes one arm, some the other.
//! Such a lane is *divided*: it runs both arms, one after the other, each from the state before the branch.
//! What the arms compute lies in registers of their own, which selects join behind the branch: values from
//! the arm that the f32 numbers choose, exact values from the one that the exact numbers choose, bounds around
//! both. Kept registers and memory of lanes are joined here.
//! One half of a lane may leave a construct while the other goes on; then its state waits at the construct's
//! end ([`Waiting`]) until the other half arrives, and both are joined.
//! A row of a call that may leave a loop or go round once more is marked as lost, as it says nothing of the
//! function that it may do so; an invocation of a dispatch goes on, since the words of others depend on what it writes.

use super::super::error::InterpError;
use super::super::mask::Mask;
use super::super::model::{Model, Pick};
use super::super::program::{Block, Label, Reg, Value};
use super::column::Column;
use super::picture::Picture;
use super::plan::Changes;
use super::waiting::Waiting;
use super::{MISMATCH, Machine, Res};
use naga::Span;

/// Rounds that a loop may run in the shadow lane.
const SHADOW_ROUNDS: u32 = 1 << 16;

/// The program, which nobody leaves early.
const WHOLE: Label = Label(0);

/// Where lanes are.
pub(super) struct Flow<M: Model> {
    /// Execute here.
    pub(super) active: Mask,
    /// Are where their f32 numbers lead; the other half of a divided lane is not.
    pub(super) value: Mask,
    /// Are where their exact numbers lead.
    pub(super) exact: Mask,
    /// The constructs around, outermost first: the whole program.
    pub(super) around: Vec<Construct<M>>,
}

/// A construct that lanes may leave early.
pub(super) struct Construct<M: Model> {
    label: Label,
    /// Lanes that left, as a whole.
    left: Mask,
    /// Lanes that are divided by a branch within.
    divided: Mask,
    pub(super) waiting: Option<Waiting<M>>,
    pub(super) changes: Changes,
}

impl<M: Model> Construct<M> {
    fn new(label: Label, lanes: usize, changes: Changes) -> Self {
        let none = Mask::none(lanes);
        Self { label, left: none.clone(), divided: none, waiting: None, changes }
    }
}

impl<M: Model> Flow<M> {
    pub(super) fn new(lanes: usize, active: Mask) -> Self {
        let (value, exact) = (Mask::all(lanes), Mask::all(lanes));
        Self { active, value, exact, around: vec![Construct::new(WHOLE, lanes, Changes::default())] }
    }

    /// Whether the lane has another half, within these constructs.
    fn halved(&self, from: usize, lane: usize) -> bool {
        let waits = |c: &Construct<M>| c.waiting.as_ref().is_some_and(|w| w.here.get(lane));
        self.around[from..].iter().any(|c| c.divided.get(lane) || waits(c))
    }

    /// Whether what the lane does may not happen.
    pub(super) fn unsure(&self, lane: usize) -> bool {
        M::SHADOW && self.halved(0, lane)
    }

    /// What joins take of the lane.
    pub(super) fn pick(&self, lane: usize) -> Pick {
        Pick { value: self.value.get(lane), exact: self.exact.get(lane) }
    }
}

impl<M: Model> Machine<'_, M> {
    /// `if`
    pub(super) fn branch(&mut self, condition: Value, accept: &Block, reject: &Block) -> Res<()> {
        let open = self.open(condition)?;
        if M::SHADOW && open.any() {
            return self.fork(condition, &open, accept, reject);
        }
        let bools = self.bools(condition)?;
        let yes = self.flow.active.filter(|lane| self.model.decision(bools.at(lane)));
        let no = self.flow.active.filter(|lane| !self.model.decision(bools.at(lane)));
        self.flow.active = yes;
        self.block(accept)?;
        let after = std::mem::replace(&mut self.flow.active, no);
        self.block(reject)?;
        self.flow.active.join(&after);
        Ok(())
    }

    /// The same where lanes are divided.
    fn fork(&mut self, condition: Value, open: &Mask, accept: &Block, reject: &Block) -> Res<()> {
        let Value::Reg(decision) = condition else { return Err(MISMATCH) };
        open.lanes().for_each(|lane| self.flags.ambiguous[lane] = true);
        let before = self.registers[decision.0 as usize].clone();
        let (entry, value, exact) =
            (self.flow.active.clone(), self.flow.value.clone(), self.flow.exact.clone());
        let divided = self.divide(open);
        let plan = self.plan.clone();
        let (yes, no) = (plan.changes(accept), plan.changes(reject));

        let both = yes.memory_with(no);
        let memory = self.state(&both);
        self.enter(decision, &before, open, &entry, (&value, &exact), true)?;
        self.arm(accept, yes, open)?;
        let accepted = (self.flow.active.clone(), self.flow.value.clone(), self.flow.exact.clone());
        let after = self.state(&both);
        self.put_back(&both, &memory, open)?;

        self.enter(decision, &before, open, &entry, (&value, &exact), false)?;
        self.arm(reject, no, open)?;

        let met = open.filter(|lane| accepted.0.get(lane) && self.flow.active.get(lane));
        let only_accepted = open.filter(|lane| accepted.0.get(lane) && !self.flow.active.get(lane));
        let source = Waiting { here: accepted.0, value: accepted.1, exact: accepted.2, state: after };
        self.join_memory(&both, &source, &met)?;
        self.put_back(&both, &source.state, &only_accepted)?;
        self.decide(decision, &only_accepted, true)?;
        self.registers[decision.0 as usize].take(&before, &met)?;
        for lane in open.lanes() {
            if met.get(lane) {
                self.flow.value.set(lane, self.flow.value.get(lane) || source.value.get(lane));
                self.flow.exact.set(lane, self.flow.exact.get(lane) || source.exact.get(lane));
            } else if only_accepted.get(lane) {
                self.flow.value.set(lane, source.value.get(lane));
                self.flow.exact.set(lane, source.exact.get(lane));
            }
        }
        self.flow.active.join(&source.here);
        if let (Some(inner), Some(divided)) = (self.flow.around.last_mut(), divided) {
            inner.divided = divided;
        }
        Ok(())
    }

    /// Notes in the innermost construct that lanes are divided; returns those that were before.
    fn divide(&mut self, open: &Mask) -> Option<Mask> {
        let inner = self.flow.around.last_mut()?;
        let before = inner.divided.clone();
        inner.divided.join(open);
        Some(before)
    }

    /// Sends the lanes into an arm that choose it or may choose it; divided ones know what they decided.
    fn enter(
        &mut self,
        decision: Reg,
        before: &Column<M>,
        open: &Mask,
        entry: &Mask,
        (value, exact): (&Mask, &Mask),
        accept: bool,
    ) -> Res<()> {
        let Column::Bool(bools) = before else { return Err(MISMATCH) };
        let m = &self.model;
        self.flow.active = entry.filter(|lane| open.get(lane) || m.decision(bools[lane]) == accept);
        for lane in open.lanes() {
            self.flow.value.set(lane, value.get(lane) && m.decision(bools[lane]) == accept);
            self.flow.exact.set(lane, exact.get(lane) && m.decision_exact(bools[lane]) == accept);
        }
        self.decide(decision, open, accept)
    }

    /// The lanes are sure of a decision.
    fn decide(&mut self, decision: Reg, lanes: &Mask, accept: bool) -> Res<()> {
        let sure = self.model.boolean(accept);
        match &mut self.registers[decision.0 as usize] {
            Column::Bool(bools) => lanes.lanes().for_each(|lane| bools[lane] = sure),
            Column::Float(_) | Column::Word(_) => return Err(MISMATCH),
        }
        Ok(())
    }

    /// Runs an arm. What a lane kept for those who wait where it went is not what its other half has.
    fn arm(&mut self, arm: &Block, changes: &Changes, open: &Mask) -> Res<()> {
        let kept = Changes { kept: changes.kept.clone(), arrays: Vec::new() };
        let before = self.state(&kept);
        self.block(arm)?;
        let gone = open.filter(|lane| !self.flow.active.get(lane));
        self.put_back(&kept, &before, &gone)
    }

    /// The active lanes go to the end of a construct.
    pub(super) fn leave(&mut self, label: Label) -> Res<()> {
        let at = self.flow.around.iter().rposition(|c| c.label == label).ok_or(MISMATCH)?;
        let lanes = self.flow.active.take();
        let halves =
            if M::SHADOW { lanes.filter(|lane| self.flow.halved(at, lane)) } else { Mask::none(self.lanes) };
        if halves.any() {
            self.wait(at, &halves)?;
        }
        let whole = lanes.filter(|lane| !halves.get(lane));
        self.flow.around[at].left.join(&whole);
        Ok(())
    }

    fn begin(&mut self, label: Label, body: &Block) {
        let changes = if M::SHADOW { self.plan.changes(body).clone() } else { Changes::default() };
        self.flow.around.push(Construct::new(label, self.lanes, changes));
    }

    /// All lanes meet at the end of the innermost construct.
    fn end(&mut self) -> Res<()> {
        let Some(Construct { left, waiting, changes, .. }) = self.flow.around.pop() else {
            return Err(MISMATCH);
        };
        if let Some(waiting) = waiting {
            let met = waiting.here.filter(|lane| self.flow.active.get(lane));
            let alone = waiting.here.filter(|lane| !self.flow.active.get(lane));
            self.join_memory(&changes, &waiting, &met)?;
            self.put_back(&changes, &waiting.state, &alone)?;
            for lane in waiting.here.lanes() {
                let joined = met.get(lane);
                self.flow.value.set(lane, waiting.value.get(lane) || (joined && self.flow.value.get(lane)));
                self.flow.exact.set(lane, waiting.exact.get(lane) || (joined && self.flow.exact.get(lane)));
            }
            self.flow.active.join(&waiting.here);
        }
        self.flow.active.join(&left);
        Ok(())
    }

    /// `body`, which lanes may leave early.
    pub(super) fn scope(&mut self, label: Label, body: &Block) -> Res<()> {
        self.begin(label, body);
        self.block(body)?;
        self.end()
    }

    /// Repeats `body` until no lane is left in it.
    pub(super) fn repeat(&mut self, label: Label, body: &Block, name: (u32, Span)) -> Res<()> {
        self.begin(label, body);
        let mut rounds = 0;
        while self.flow.active.any() {
            rounds += 1;
            if self.fuel == 0 || (M::SHADOW && rounds > SHADOW_ROUNDS) {
                self.exhausted(name)?;
                break;
            }
            self.fuel -= 1;
            self.block(body)?;
            self.lose_halves();
        }
        self.end()
    }

    /// Lanes of which one half left the loop and the other goes on are lost; they follow the f32 numbers.
    fn lose_halves(&mut self) {
        if !self.shared.is_empty() {
            return;
        }
        let flow = &mut self.flow;
        let Some(waiting) = flow.around.last_mut().and_then(|c| c.waiting.as_mut()) else {
            return;
        };
        for lane in waiting.here.filter(|lane| flow.active.get(lane)).lanes() {
            self.flags.lost[lane] = true;
            if flow.value.get(lane) {
                waiting.here.set(lane, false);
            } else {
                flow.active.set(lane, false);
            }
        }
    }

    /// Without fuel a loop ends; shadow lanes that follow a path no f32 number takes may well run forever,
    /// so there it is the row that is lost, not the batch.
    fn exhausted(&mut self, (function, at): (u32, Span)) -> Res<()> {
        self.watch_loop(at);
        if !M::SHADOW {
            return Err(InterpError::OutOfFuel { function: self.function(function) });
        }
        self.flow.active.lanes().for_each(|lane| self.flags.lost[lane] = true);
        // Whatever they would have written.
        let written = self.program.buffers.iter().zip(&mut self.shared).filter(|(b, _)| b.written);
        written.for_each(|(_, shared)| shared.spoiled = true);
        let written =
            |image: &&mut Picture| image.found.variable.is_some_and(|at| self.program.images[at].written);
        self.images.iter_mut().filter(written).for_each(|image| image.spoiled = true);
        Ok(())
    }

    /// The active lanes in which a decision is ambiguous.
    pub(super) fn open(&self, condition: Value) -> Res<Mask> {
        let bools = self.bools(condition)?;
        Ok(self.flow.active.filter(|lane| self.model.ambiguous(bools.at(lane))))
    }

    /// The active lanes in which an integer is not known.
    pub(super) fn unknown(&self, value: Value) -> Res<Mask> {
        let words = self.words(value)?;
        Ok(self.flow.active.filter(|lane| !self.model.known(words.at(lane))))
    }
}
