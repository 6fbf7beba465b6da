//! Computes once what branches that are no longer branches computed twice.

use super::super::program::{Args, Block, Op, Program, Reg, Stmt, Value};
use super::kept;
use std::collections::{HashMap, HashSet};

/// Replaces operations on the same operands by the first of them, where that has run.
pub(super) fn common(program: &mut Program) {
    let mut common = Common { kept: kept(program), known: HashMap::new(), same: HashMap::new() };
    common.block(&mut program.body);
    program.results.iter_mut().for_each(|value| *value = common.first(*value));
}

struct Common {
    /// Registers that change: what is computed of them holds for a while only.
    kept: HashSet<Reg>,
    known: HashMap<(Op, Args), Value>,
    /// What to read instead.
    same: HashMap<Value, Value>,
}

impl Common {
    /// What holds the same and was computed first.
    fn first(&self, value: Value) -> Value {
        self.same.get(&value).copied().unwrap_or(value)
    }

    fn block(&mut self, block: &mut Block) {
        let mut found = Vec::new();
        for stmt in block {
            let mut lasts = true;
            stmt.operands_mut(&mut |value| {
                *value = self.first(*value);
                lasts &= !matches!(value, Value::Reg(reg) if self.kept.contains(reg));
            });
            if let Stmt::Eval(eval) = stmt
                && lasts
            {
                let key = (eval.op, eval.args);
                match self.known.get(&key) {
                    Some(first) => {
                        self.same.insert(Value::Reg(eval.to), *first);
                    }
                    None => {
                        self.known.insert(key, Value::Reg(eval.to));
                        found.push(key);
                    }
                }
            }
            stmt.blocks_mut().into_iter().flatten().for_each(|inner| self.block(inner));
        }
        found.iter().for_each(|key| {
            self.known.remove(key);
        });
    }
}
