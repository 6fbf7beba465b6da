//! Which registers lanes may differ in, and which blocks need a mask of their own.
//!
//! Everything is taken for uniform until something shows that it is not; what that makes varying in turn
//! is found by going over the program until nothing changes.
//!
//! A block runs under the mask of the block around it, unless lanes part there: the arms of a branch on a
//! varying condition, and loops and scopes that some lanes leave while others stay.

use super::super::program::op::Input;
use super::super::program::{Block, Label, Op, Place, Program, Reg, Stmt};
use std::collections::{HashMap, HashSet};

/// The block that owns a mask, by the order in which [`classify`] meets blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Owner(pub(crate) u32);

/// Which masks there are.
#[derive(Debug, Clone, Default)]
pub(crate) struct Masks {
    /// Loops and scopes that lanes leave while others stay.
    pub(crate) split: HashSet<Label>,
    /// The block under whose mask each kept register was first set.
    pub(crate) declared: HashMap<Reg, Owner>,
}

struct Pass<'p> {
    program: &'p mut Program,
    masks: Masks,
    packed: bool,
    changed: bool,
    blocks: u32,
    /// Enclosing loops and scopes with the mask of their bodies.
    around: Vec<(Label, Owner)>,
}

/// Classifies registers and masks.
pub(crate) fn classify(program: &mut Program, packed: bool) -> Masks {
    program.registers.iter_mut().for_each(|r| r.varying = false);
    let body = std::mem::take(&mut program.body);
    let mut pass =
        Pass { program, masks: Masks::default(), packed, changed: true, blocks: 0, around: Vec::new() };
    while pass.changed {
        pass.changed = false;
        pass.blocks = 0;
        pass.masks.declared.clear();
        pass.block(&body, Owner(0));
    }
    let masks = pass.masks;
    program.body = body;
    masks
}

impl Pass<'_> {
    /// A mask of its own if `own`, else the one around.
    fn owner(&mut self, own: bool, around: Owner) -> Owner {
        self.blocks += 1;
        if own { Owner(self.blocks) } else { around }
    }

    fn block(&mut self, block: &Block, mask: Owner) {
        for stmt in block {
            self.statement(stmt, mask);
        }
    }

    fn varies(&mut self, Reg(at): Reg) {
        let register = &mut self.program.registers[at as usize];
        self.changed |= !std::mem::replace(&mut register.varying, true);
    }

    fn statement(&mut self, stmt: &Stmt, mask: Owner) {
        let mut varying = false;
        stmt.operands(&mut |v| varying |= self.program.varying(v));
        match stmt {
            Stmt::Eval(eval) => {
                if varying || self.source(eval.op) {
                    self.varies(eval.to);
                }
            }
            Stmt::Set { to, .. } => {
                let declared = *self.masks.declared.entry(*to).or_insert(mask);
                if varying || declared != mask {
                    self.varies(*to);
                }
            }
            Stmt::Atomic(_) | Stmt::Texture(_) | Stmt::Subgroup(_) => {
                stmt.targets().for_each(|to| self.varies(to));
            }
            Stmt::If { accept, reject, .. } => {
                for arm in [accept, reject] {
                    let inner = self.owner(varying, mask);
                    self.block(arm, inner);
                }
            }
            Stmt::Loop { label, body, .. } | Stmt::Scope { label, body } => {
                let inner = self.owner(self.masks.split.contains(label), mask);
                self.around.push((*label, inner));
                self.block(body, inner);
                self.around.pop();
            }
            Stmt::Leave(label) => self.leave(*label, mask),
            Stmt::Store { .. } | Stmt::Barrier { .. } => {}
        }
    }

    /// Lanes part in every construct that they leave under another mask than its own.
    fn leave(&mut self, target: Label, mask: Owner) {
        for (label, inner) in self.around.iter().rev() {
            if *inner != mask {
                self.changed |= self.masks.split.insert(*label);
            }
            if *label == target {
                break;
            }
        }
    }

    /// Whether an operation of uniform operands may differ from lane to lane.
    fn source(&self, op: Op) -> bool {
        match op {
            Op::Input(input, _) => match input {
                Input::Column(_)
                | Input::GlobalInvocationId(_)
                | Input::LocalInvocationId(_)
                | Input::LocalInvocationIndex
                | Input::SubgroupInvocationId
                | Input::SubgroupId => true,
                Input::WorkGroupId(_) => self.packed,
                Input::NumWorkGroups(_)
                | Input::WorkGroupSize(_)
                | Input::SubgroupSize
                | Input::NumSubgroups => false,
            },
            Op::Load { place, .. } => matches!(place, Place::Lane { .. }),
            Op::Copy(_)
            | Op::Float(..)
            | Op::Int(..)
            | Op::Compare(..)
            | Op::Logic(_)
            | Op::IsNan(_)
            | Op::IsInf(_)
            | Op::Select(_)
            | Op::Convert(..)
            | Op::Bitcast(..)
            | Op::Exponent(_)
            | Op::Ldexp(_)
            | Op::Mark(..)
            | Op::Index { .. }
            | Op::IndexWithin { .. }
            | Op::Length { .. }
            | Op::Fused { .. }
            | Op::Horner { .. } => false,
        }
    }
}
