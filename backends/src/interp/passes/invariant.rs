//! Computes before a loop what is the same in all its rounds.

use super::super::program::{Block, Op, Program, Reg, Stmt, Value};
use super::walk;
use std::collections::HashSet;

/// Moves operations that every round repeats on the same operands to where their loop begins.
///
/// Those of branches within stay there: they may be needed in few rounds, or in none.
pub(super) fn invariant(program: &mut Program) {
    hoist(&mut program.body);
}

fn hoist(block: &mut Block) {
    let mut out = Block::with_capacity(block.len());
    for mut stmt in std::mem::take(block) {
        stmt.blocks_mut().into_iter().flatten().for_each(hoist);
        if let Stmt::Loop { body, .. } = &mut stmt {
            out.append(&mut repeated(body));
        }
        out.push(stmt);
    }
    *block = out;
}

/// Takes out of a loop's body what no round changes.
fn repeated(body: &mut Block) -> Block {
    let mut changing = HashSet::new();
    walk(body, &mut |stmt| changing.extend(stmt.targets()));
    let (mut before, mut rest) = (Block::new(), Block::with_capacity(body.len()));
    for stmt in std::mem::take(body) {
        if moves(&stmt, &changing) {
            stmt.targets().for_each(|to| {
                changing.remove(&to);
            });
            before.push(stmt);
        } else {
            rest.push(stmt);
        }
    }
    *body = rest;
    before
}

/// Whether a statement is an operation on what does not change. What memory holds may.
fn moves(stmt: &Stmt, changing: &HashSet<Reg>) -> bool {
    let Stmt::Eval(eval) = stmt else {
        return false;
    };
    let fixed = |value: &Value| !matches!(value, Value::Reg(reg) if changing.contains(reg));
    !matches!(eval.op, Op::Load { .. } | Op::Mark(..)) && eval.args.iter().all(fixed)
}
