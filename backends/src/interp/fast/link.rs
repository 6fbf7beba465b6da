//! From programs to code: forms of operations, slots, jumps, masks.

mod direct;
mod elements;
mod evals;
mod flow;
mod once;

use super::super::error::{InterpError, Res};
use super::super::passes::{self, Masks, Owner};
use super::super::program::op::Simple;
use super::super::program::{Block, Eval, Op, Program, Reg, Scalar, Stmt, Value};
use super::allocate::{Allocation, allocate};
use super::ops;
use super::shape::{Ask, Body, exec};
use super::{Code, Inst, Isa, machine, memory, together};
use flow::{Mask, Region};
use std::collections::{HashMap, HashSet};

/// Slots that hold copies of cells for one step.
const COPIES: u32 = 4;

/// Writes code.
struct Linker<'p, const N: usize> {
    program: &'p Program,
    masks: &'p Masks,
    isa: Isa,
    places: Vec<u32>,
    /// A cell that holds zero.
    zero: u32,
    insts: Vec<Inst<N>>,
    calls: together::Calls,
    /// Arrays whose elements steps use.
    elements: Vec<memory::Array>,
    /// Registers that hold the number of the invocation along the first axis.
    numbers: HashSet<Value>,
    /// Buffers that nothing but one store uses.
    once: HashSet<u32>,
    /// How often each register is read.
    uses: Vec<u32>,
    /// Registers that have been assigned.
    assigned: HashSet<Reg>,
    /// Registers whose operations write to what would be assigned from them.
    direct: HashMap<Reg, Reg>,
    /// Counts blocks as `passes::uniform` does.
    blocks: u32,
    regions: Vec<Region>,
    /// Masks that lanes were taken out of since their blocks looked.
    cleared: HashSet<Owner>,
}

/// How deep blocks lie within each other.
fn depth(block: &Block) -> u32 {
    let inner = block.iter().flat_map(|s| s.blocks()).flatten().map(depth).max().unwrap_or(0);
    inner + 1
}

/// Links `program`, of which `masks` is known.
pub(super) fn link<const N: usize>(program: Program, masks: &Masks, isa: Isa) -> Res<Code<N>> {
    // Slot 0 is the mask of lanes that exist, then copies, then masks by depth.
    let first = 1 + COPIES + depth(&program.body);
    let mut cells = machine::cells(&program);
    let zero = cells.len() as u32;
    cells.push(0);
    let Allocation { places, narrow, wide, cells: count } =
        allocate(&program, first, COPIES, cells.len() as u32);
    cells.resize(count, 0);
    let (mut narrow, mut wide) = (narrow, wide);
    let mut arrays = Vec::new();
    for array in &program.arrays {
        let file = if array.wide { &mut wide } else { &mut narrow };
        arrays.push(*file as u32);
        *file += array.len.max(1) as usize;
    }
    let mut linker = Linker {
        program: &program,
        masks,
        isa,
        places,
        zero,
        insts: Vec::new(),
        calls: together::Calls::default(),
        elements: Vec::new(),
        numbers: HashSet::new(),
        once: once::stored_once(&program),
        uses: passes::uses(&program),
        assigned: HashSet::new(),
        direct: HashMap::new(),
        blocks: 0,
        regions: Vec::new(),
        cleared: HashSet::new(),
    };
    linker.whole(&arrays)?;
    let results = program.results.iter().map(|v| (*v, linker.place(*v), program.varying(*v))).collect();
    let (insts, calls, arrays) = (linker.insts, linker.calls.into(), linker.elements.into());
    Ok(Code { insts, calls, narrow, wide, cells, arrays, results, program })
}

impl<const N: usize> Linker<'_, N> {
    fn whole(&mut self, arrays: &[u32]) -> Res<()> {
        let mask = Mask { owner: Owner(0), slot: 0 };
        self.regions.push(Region { mask, label: None, ends: Vec::new() });
        self.block(&self.program.body, mask, arrays)?;
        let region = self.regions.pop();
        self.arrive(region.map(|r| r.ends).unwrap_or_default());
        Ok(())
    }

    /// The slot or cell of a value.
    fn place(&self, value: Value) -> u32 {
        match value {
            Value::Const(id) => id,
            Value::Reg(reg) => self.places[reg.0 as usize],
        }
    }

    fn push<K: Body<N>>(&mut self, d: u32, s: [u32; 4], n: [u32; 3]) {
        self.insts.push(Inst { run: exec::<K, N>(self.isa), d, s, n });
    }

    /// A slot with the lanes of a value: its own, or copy `at` of its cell.
    fn slot(&mut self, value: Value, at: u32) -> u32 {
        let place = self.place(value);
        if self.program.varying(value) {
            return place;
        }
        let scalar = self.program.scalar(value);
        let slot = if scalar.wide() { at } else { 1 + at };
        self.insts.push(Inst { run: ops::splat(scalar, self.isa), d: slot, s: [place, 0, 0, 0], n: [0; 3] });
        slot
    }

    /// The same for a part of an address, zero where there is none.
    fn index(&self, index: Option<Value>) -> (u32, bool) {
        index.map_or((self.zero, false), |v| (self.place(v), self.program.varying(v)))
    }

    fn block(&mut self, block: &Block, mask: Mask, arrays: &[u32]) -> Res<()> {
        self.find_direct(block, mask);
        let mut rest = &block[..];
        while let [stmt, after @ ..] = rest {
            rest = match elements::together(self.program, rest) {
                0 | 1 if self.chain(rest) || self.sum_up(rest) => &rest[2..],
                0 | 1 if self.compare_and_choose(rest, mask, arrays)? => &rest[2..],
                0 | 1 => {
                    self.statement(stmt, mask, arrays)?;
                    after
                }
                count => {
                    self.load_together(&rest[..count]);
                    &rest[count..]
                }
            };
            if self.cleared.remove(&mask.owner) {
                self.skip_empty(mask);
            }
        }
        Ok(())
    }

    /// Finds what in a block is written to where it would be copied to.
    fn find_direct(&mut self, block: &Block, mask: Mask) {
        let whole = |to: Reg| self.masks.declared.get(&to) == Some(&mask.owner);
        let (program, uses, assigned) = (self.program, &self.uses[..], &self.assigned);
        let found = direct::Targets { program, uses, assigned, whole: &whole }.of(block);
        self.direct.extend(found);
    }

    /// Links an operation and a function of nothing but its result as one step, if there is one for the two.
    fn chain(&mut self, block: &[Stmt]) -> bool {
        let [Stmt::Eval(first), Stmt::Eval(second), ..] = block else {
            return false;
        };
        let only = ops::chained(first, second) && self.uses[first.to.0 as usize] == 1;
        if !only || !self.program.varying(Value::Reg(first.to)) {
            return false;
        }
        let (ask, s) = self.operands(first);
        let Some(run) = ops::find_chain::<N>(first.op, second.op, ask) else {
            return false;
        };
        let d = self.result_place(second.to);
        // A result never lies where an operand does: one that takes the place of a variable may.
        if s.iter().zip(ask.varying).any(|(s, varying)| varying && *s == d) {
            return false;
        }
        self.insts.push(Inst { run, d, s, n: [0; 3] });
        true
    }

    /// Links a product of three and its addition to a register as one step.
    fn sum_up(&mut self, block: &[Stmt]) -> bool {
        let [Stmt::Eval(product), Stmt::Eval(sum), ..] = block else {
            return false;
        };
        let Op::Fused { first: Simple::Mul, second: Simple::Mul, .. } = product.op else {
            return false;
        };
        let added = Value::Reg(product.to);
        let only = self.program.varying(added) && self.uses[product.to.0 as usize] == 1;
        let Some(to) = self.direct.get(&sum.to).copied().filter(|_| only) else {
            return false;
        };
        match direct::in_place(sum, to) {
            Some((ops::InPlace::Add, others)) if others == [added] => {}
            _ => return false,
        }
        let (mut ask, mut s) = self.operands(product);
        if !ask.varying[0] {
            s.swap(0, 1);
            ask.varying.swap(0, 1);
        }
        let d = self.place(Value::Reg(to));
        // As in `chain`.
        let apart = s.iter().zip(ask.varying).all(|(s, varying)| !varying || *s != d);
        if !ask.varying[0] || !apart {
            return false;
        }
        self.insts.push(Inst { run: ops::add_products(ask), d, s, n: [0; 3] });
        true
    }

    /// Which operands of an operation are slots, and where they are.
    fn operands(&self, eval: &Eval) -> (Ask, [u32; 4]) {
        let mut ask = Ask { isa: self.isa, varying: [false; 4] };
        let mut s = [0; 4];
        for (at, arg) in eval.args.iter().enumerate() {
            (s[at], ask.varying[at]) = (self.place(*arg), self.program.varying(*arg));
        }
        (ask, s)
    }

    /// Where the result of an operation goes.
    fn result_place(&self, to: Reg) -> u32 {
        self.place(Value::Reg(self.direct.get(&to).copied().unwrap_or(to)))
    }

    fn statement(&mut self, stmt: &Stmt, mask: Mask, arrays: &[u32]) -> Res<()> {
        match stmt {
            Stmt::Eval(eval) => self.eval(eval, arrays),
            Stmt::Set { to, value } => {
                self.set(*to, *value, mask);
                Ok(())
            }
            Stmt::Store { place, value, .. } => self.store(*place, *value, mask, arrays),
            Stmt::Atomic(atomic) => self.atomic(atomic, mask),
            Stmt::Texture(access) => {
                self.texture(access, mask);
                Ok(())
            }
            Stmt::Subgroup(subgroup) => {
                self.subgroup(subgroup, mask);
                Ok(())
            }
            Stmt::If { condition, accept, reject } => {
                if self.program.varying(*condition) {
                    self.part(*condition, accept, reject, mask, arrays)
                } else {
                    self.choose(*condition, accept, reject, mask, arrays)
                }
            }
            Stmt::Loop { label, body, function, .. } => self.repeat(*label, body, *function, mask, arrays),
            Stmt::Scope { label, body } => self.scope(*label, body, mask, arrays),
            Stmt::Leave(label) => {
                self.leave(*label, mask);
                Ok(())
            }
            Stmt::Barrier { function, .. } => {
                self.push::<super::control::Barrier>(0, [mask.slot, 0, 0, 0], [*function, 0, 0]);
                Ok(())
            }
        }
    }

    /// What is not linked yet.
    fn refuse(&self, what: String) -> InterpError {
        let function = self.program.functions.first().cloned().unwrap_or_default();
        InterpError::Unsupported { what, function, at: None }
    }
}

/// Which file a scalar lies in.
fn wide(scalar: Scalar) -> bool {
    scalar.wide()
}
