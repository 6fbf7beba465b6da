//! Negations go into what reads them: selects and branches swap their sides, a conjunction becomes `AndNot`.

use super::super::program::op::LogicOp;
use super::super::program::{Args, Block, Eval, Op, Program, Reg, Stmt, Value};
use super::kept;
use std::collections::{HashMap, HashSet};

pub(super) fn fold(program: &mut Program) {
    let kept = kept(program);
    Fold { kept, negated: HashMap::new() }.block(&mut program.body);
}

struct Fold {
    /// Registers that change: what negates them holds only where it is computed.
    kept: HashSet<Reg>,
    /// The result of a `Not` and its operand.
    negated: HashMap<Value, Value>,
}

impl Fold {
    fn block(&mut self, block: &mut Block) {
        for stmt in block {
            match stmt {
                Stmt::Eval(eval) => self.eval(eval),
                Stmt::If { condition, accept, reject } => {
                    if let Some(inner) = self.negated.get(condition) {
                        *condition = *inner;
                        std::mem::swap(accept, reject);
                    }
                }
                Stmt::Set { .. }
                | Stmt::Store { .. }
                | Stmt::Atomic(_)
                | Stmt::Texture(_)
                | Stmt::Subgroup(_)
                | Stmt::Loop { .. }
                | Stmt::Scope { .. }
                | Stmt::Leave(_)
                | Stmt::Barrier { .. } => {}
            }
            stmt.blocks_mut().into_iter().flatten().for_each(|inner| self.block(inner));
        }
    }

    fn eval(&mut self, eval: &mut Eval) {
        let args = eval.args;
        match (eval.op, &args[..]) {
            (Op::Logic(LogicOp::Not), [a]) => match self.negated.get(a) {
                Some(inner) => {
                    eval.op = Op::Copy(super::super::program::Scalar::Bool);
                    eval.args = Args::new(&[*inner]);
                }
                None if matches!(a, Value::Reg(reg) if self.kept.contains(reg)) => {}
                None => {
                    self.negated.insert(Value::Reg(eval.to), *a);
                }
            },
            (Op::Select(_), [condition, accept, reject]) => {
                if let Some(inner) = self.negated.get(condition) {
                    eval.args = Args::new(&[*inner, *reject, *accept]);
                }
            }
            (Op::Logic(LogicOp::And), [a, b]) => {
                if let Some(inner) = self.negated.get(b) {
                    (eval.op, eval.args) = (Op::Logic(LogicOp::AndNot), Args::new(&[*a, *inner]));
                } else if let Some(inner) = self.negated.get(a) {
                    (eval.op, eval.args) = (Op::Logic(LogicOp::AndNot), Args::new(&[*b, *inner]));
                }
            }
            _ => {}
        }
    }
}
