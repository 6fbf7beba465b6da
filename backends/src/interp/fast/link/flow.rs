//! Branches, loops and ways out.

use super::super::super::error::Res;
use super::super::super::passes::Owner;
use super::super::super::program::{Block, Label, Op, Scalar, Stmt, Value};
use super::super::control::{Clear, Jump, JumpIf, Round, SkipEmpty, Split};
use super::super::shape::Ask;
use super::super::{Inst, ops};
use super::{COPIES, Linker};

/// The mask that a block runs under.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mask {
    pub(super) owner: Owner,
    pub(super) slot: u32,
}

/// A stretch of code that lanes can leave at its end.
#[derive(Debug)]
pub(super) struct Region {
    pub(super) mask: Mask,
    /// Of a loop or scope.
    pub(super) label: Option<Label>,
    /// Jumps to the end, to be told where it is.
    pub(super) ends: Vec<usize>,
}

impl<const N: usize> Linker<'_, N> {
    /// The mask of a block: its own, in a slot of its depth, or the one around.
    fn inner(&mut self, own: bool, around: Mask) -> Mask {
        self.blocks += 1;
        if !own {
            return around;
        }
        let slot = if around.slot == 0 { 1 + COPIES } else { around.slot + 1 };
        Mask { owner: Owner(self.blocks), slot }
    }

    /// These jumps lead here.
    pub(super) fn arrive(&mut self, jumps: Vec<usize>) {
        let here = self.insts.len() as u32;
        jumps.into_iter().for_each(|at| self.insts[at].n[0] = here);
    }

    fn jump(&mut self) -> usize {
        self.push::<Jump>(0, [0; 4], [0; 3]);
        self.insts.len() - 1
    }

    /// Zero in a slot.
    fn zero(&mut self, slot: u32) {
        let run = ops::splat(Scalar::U32, self.isa);
        self.insts.push(Inst { run, d: slot, s: [self.zero, 0, 0, 0], n: [0; 3] });
    }

    fn copy_mask(&mut self, to: u32, from: u32) {
        let ask = Ask { isa: self.isa, varying: [true, false, false, false] };
        let op = Op::Copy(Scalar::Bool);
        if let Some(run) = ops::find::<N>(op, ask).flatten() {
            self.insts.push(Inst { run, d: to, s: [from, 0, 0, 0], n: [0; 3] });
        }
    }

    /// A branch that all lanes take together.
    pub(super) fn choose(
        &mut self,
        condition: Value,
        accept: &Block,
        reject: &Block,
        mask: Mask,
        arrays: &[u32],
    ) -> Res<()> {
        let s = [self.place(condition), 0, 0, 0];
        if accept.is_empty() {
            self.push::<JumpIf<true>>(0, s, [0; 3]);
        } else {
            self.push::<JumpIf<false>>(0, s, [0; 3]);
        }
        self.arms(accept, reject, mask, arrays)
    }

    /// Links a comparison and the branch that nothing but its result decides as one step, if there is one for the two.
    pub(super) fn compare_and_choose(&mut self, block: &[Stmt], mask: Mask, arrays: &[u32]) -> Res<bool> {
        let [Stmt::Eval(eval), Stmt::If { condition, accept, reject }, ..] = block else {
            return Ok(false);
        };
        let only = *condition == Value::Reg(eval.to) && self.uses[eval.to.0 as usize] == 1;
        let Op::Compare(scalar, comparison) = eval.op else {
            return Ok(false);
        };
        if !only || self.program.varying(*condition) {
            return Ok(false);
        }
        let found = if accept.is_empty() {
            ops::jump::<true, N>(scalar, comparison)
        } else {
            ops::jump::<false, N>(scalar, comparison)
        };
        let Some(run) = found else {
            return Ok(false);
        };
        let s = [self.place(eval.args[0]), self.place(eval.args[1]), 0, 0];
        self.insts.push(Inst { run, d: 0, s, n: [0; 3] });
        self.arms(accept, reject, mask, arrays)?;
        Ok(true)
    }

    /// The arms of a branch, of which the last step jumps over the first, or over the second where the first is
    /// empty.
    fn arms(&mut self, accept: &Block, reject: &Block, mask: Mask, arrays: &[u32]) -> Res<()> {
        let mut over = self.insts.len() - 1;
        let inner = self.inner(false, mask);
        self.block(accept, inner, arrays)?;
        if !accept.is_empty() && !reject.is_empty() {
            let end = self.jump();
            self.arrive(vec![over]);
            over = end;
        }
        let inner = self.inner(false, mask);
        self.block(reject, inner, arrays)?;
        self.arrive(vec![over]);
        Ok(())
    }

    /// A branch where lanes part.
    pub(super) fn part(
        &mut self,
        condition: Value,
        accept: &Block,
        reject: &Block,
        mask: Mask,
        arrays: &[u32],
    ) -> Res<()> {
        let condition = self.place(condition);
        for (arm, wanted) in [(accept, true), (reject, false)] {
            let inner = self.inner(true, mask);
            if arm.is_empty() {
                continue;
            }
            let s = [mask.slot, condition, 0, 0];
            if wanted {
                self.push::<Split<true>>(inner.slot, s, [0; 3]);
            } else {
                self.push::<Split<false>>(inner.slot, s, [0; 3]);
            }
            let ends = vec![self.insts.len() - 1];
            self.within(Region { mask: inner, label: None, ends }, arm, arrays)?;
        }
        Ok(())
    }

    /// A block that can be left at its end.
    fn within(&mut self, region: Region, block: &Block, arrays: &[u32]) -> Res<()> {
        let mask = region.mask;
        self.regions.push(region);
        self.block(block, mask, arrays)?;
        let ends = self.regions.pop().map(|r| r.ends).unwrap_or_default();
        self.arrive(ends);
        Ok(())
    }

    pub(super) fn scope(&mut self, label: Label, body: &Block, mask: Mask, arrays: &[u32]) -> Res<()> {
        let inner = self.inner(self.masks.split.contains(&label), mask);
        if inner.owner != mask.owner {
            self.copy_mask(inner.slot, mask.slot);
        }
        self.within(Region { mask: inner, label: Some(label), ends: Vec::new() }, body, arrays)
    }

    pub(super) fn repeat(
        &mut self,
        label: Label,
        body: &Block,
        function: u32,
        mask: Mask,
        arrays: &[u32],
    ) -> Res<()> {
        let inner = self.inner(self.masks.split.contains(&label), mask);
        let own = inner.owner != mask.owner;
        if own {
            self.copy_mask(inner.slot, mask.slot);
        }
        let top = self.insts.len() as u32;
        self.regions.push(Region { mask: inner, label: Some(label), ends: Vec::new() });
        self.block(body, inner, arrays)?;
        if own {
            self.skip_empty(inner);
        }
        self.push::<Round>(0, [0; 4], [top, function, 0]);
        let ends = self.regions.pop().map(|r| r.ends).unwrap_or_default();
        self.arrive(ends);
        Ok(())
    }

    /// Goes to the end of the region that owns `mask` if it has no lane left.
    pub(super) fn skip_empty(&mut self, mask: Mask) {
        self.push::<SkipEmpty>(0, [mask.slot, 0, 0, 0], [0; 3]);
        self.end_with(mask.owner);
    }

    /// The last step jumps to the end of the region that owns a mask.
    fn end_with(&mut self, owner: Owner) {
        let at = self.insts.len() - 1;
        if let Some(region) = self.regions.iter_mut().find(|r| r.mask.owner == owner) {
            region.ends.push(at);
        }
    }

    /// The active lanes go to the end of the construct of `label`.
    pub(super) fn leave(&mut self, label: Label, mask: Mask) {
        let Some(target) = self.regions.iter().rposition(|r| r.label == Some(label)) else {
            return;
        };
        if self.regions[target].mask.owner == mask.owner {
            // Nobody stays behind.
            let at = self.jump();
            self.regions[target].ends.push(at);
            return;
        }
        let mut seen = vec![mask.owner];
        for at in target..self.regions.len() {
            let outer = self.regions[at].mask;
            if !seen.contains(&outer.owner) {
                seen.push(outer.owner);
                self.push::<Clear>(outer.slot, [mask.slot, 0, 0, 0], [0; 3]);
                self.cleared.insert(outer.owner);
            }
        }
        self.zero(mask.slot);
        self.jump();
        self.end_with(mask.owner);
    }
}
