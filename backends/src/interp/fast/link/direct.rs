//! Results that go straight to the register that is assigned from them.

use super::super::super::program::{Block, Eval, Op, Program, Reg, Stmt, Value};
use super::super::ops;
use std::collections::{HashMap, HashSet};

/// What may be written before the block assigns it.
pub(super) struct Targets<'a> {
    pub(super) program: &'a Program,
    /// How often each register is read.
    pub(super) uses: &'a [u32],
    /// Registers that were assigned before the block: they have a slot of their own by now.
    pub(super) assigned: &'a HashSet<Reg>,
    /// Whether the block assigns all lanes of a register.
    pub(super) whole: &'a dyn Fn(Reg) -> bool,
}

impl Targets<'_> {
    /// The operations of a block whose results are read by nothing but an assignment after them, with what is assigned.
    /// Between the two nobody reads or writes that.
    pub(super) fn of(&self, block: &Block) -> HashMap<Reg, Reg> {
        let mut found = HashMap::new();
        let mut computed: HashMap<Reg, (usize, &Eval)> = HashMap::new();
        let mut touched: HashMap<Reg, usize> = HashMap::new();
        for (at, stmt) in block.iter().enumerate() {
            match stmt {
                Stmt::Eval(eval) if operation(eval.op) => {
                    computed.insert(eval.to, (at, eval));
                }
                Stmt::Set { to, value: Value::Reg(value) } => {
                    let free = |begin: usize| touched.get(to).is_none_or(|last| *last <= begin);
                    let eval = computed.get(value).filter(|(begin, _)| free(*begin));
                    if eval.is_some_and(|(_, eval)| self.fits(eval, *to)) {
                        found.insert(*value, *to);
                    }
                }
                Stmt::If { .. } | Stmt::Loop { .. } | Stmt::Scope { .. } => computed.clear(),
                _ => {}
            }
            let mut touch = |reg: Reg| touched.insert(reg, at);
            stmt.operands(&mut |value| {
                if let Value::Reg(reg) = value {
                    touch(reg);
                }
            });
            stmt.targets().for_each(|to| {
                touch(to);
            });
        }
        found
    }

    fn fits(&self, eval: &Eval, to: Reg) -> bool {
        let Reg(at) = eval.to;
        let varying = |reg| self.program.varying(Value::Reg(reg));
        let alike = self.uses[at as usize] == 1 && varying(eval.to) == varying(to);
        alike && (!varying(to) || self.assigned.contains(&to) && (self.whole)(to) && self.apart(eval, to))
    }

    /// Whether an operation can write to a slot: one that it does not read, or reads as operations in place do.
    fn apart(&self, eval: &Eval, to: Reg) -> bool {
        !eval.args.contains(&Value::Reg(to)) || in_place(eval, to).is_some()
    }
}

/// What is neither load nor input nor address.
fn operation(op: Op) -> bool {
    !matches!(
        op,
        Op::Input(..) | Op::Index { .. } | Op::IndexWithin { .. } | Op::Length { .. } | Op::Load { .. }
    )
}

/// The operation in place on a register, and its other operands.
pub(super) fn in_place(eval: &Eval, to: Reg) -> Option<(ops::InPlace, Vec<Value>)> {
    let (op, at) = ops::in_place(eval.op)?;
    let to = Value::Reg(to);
    let place = at.iter().copied().find(|at| eval.args[*at] == to)?;
    let others: Vec<_> =
        eval.args.iter().enumerate().filter(|(at, _)| *at != place).map(|(_, v)| *v).collect();
    (!others.contains(&to)).then_some((op, others))
}
