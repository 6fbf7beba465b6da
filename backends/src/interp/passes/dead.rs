//! Removes what nobody reads.

use super::super::program::{Block, Program, Reg, Stmt, Value};
use super::walk;

/// Removes computations without readers, and branches without statements.
pub(super) fn remove(program: &mut Program) {
    loop {
        let needed = needed(program);
        let mut body = std::mem::take(&mut program.body);
        let removed_branch = sweep(&mut body, &needed);
        program.body = body;
        if !removed_branch {
            return;
        }
    }
}

/// Registers that something with an effect depends on.
fn needed(program: &Program) -> Vec<bool> {
    let mut needed = vec![false; program.registers.len()];
    let mut sources = vec![Vec::new(); program.registers.len()];
    let mut open = Vec::new();
    let reg = |value| match value {
        Value::Reg(reg) => Some(reg),
        Value::Const(_) => None,
    };
    open.extend(program.results.iter().filter_map(|v| reg(*v)));
    walk(&program.body, &mut |stmt| match stmt {
        Stmt::Texture(access) if access.op.writes() => stmt.operands(&mut |v| open.extend(reg(v))),
        Stmt::Eval(_) | Stmt::Set { .. } | Stmt::Texture(_) | Stmt::Subgroup(_) => {
            for Reg(to) in stmt.targets() {
                stmt.operands(&mut |v| sources[to as usize].extend(reg(v)));
            }
        }
        Stmt::Store { .. }
        | Stmt::Atomic(_)
        | Stmt::If { .. }
        | Stmt::Loop { .. }
        | Stmt::Scope { .. }
        | Stmt::Leave(_)
        | Stmt::Barrier { .. } => stmt.operands(&mut |v| open.extend(reg(v))),
    });
    while let Some(Reg(at)) = open.pop() {
        if !std::mem::replace(&mut needed[at as usize], true) {
            open.append(&mut sources[at as usize]);
        }
    }
    needed
}

/// Whether a branch was removed, so that its condition may have become dead.
fn sweep(block: &mut Block, needed: &[bool]) -> bool {
    let mut removed = false;
    block.retain_mut(|stmt| {
        for inner in stmt.blocks_mut().into_iter().flatten() {
            removed |= sweep(inner, needed);
        }
        match stmt {
            Stmt::Eval(_) | Stmt::Set { .. } | Stmt::Subgroup(_) => {
                stmt.targets().any(|Reg(to)| needed[to as usize])
            }
            Stmt::Texture(access) => {
                access.to = access.to.map(|to| to.filter(|Reg(to)| needed[*to as usize]));
                access.op.writes() || access.to.iter().any(Option::is_some)
            }
            Stmt::If { accept, reject, .. } => {
                let empty = accept.is_empty() && reject.is_empty();
                removed |= empty;
                !empty
            }
            Stmt::Scope { body, .. } => !body.is_empty(),
            Stmt::Atomic(atomic) => {
                atomic.old = atomic.old.filter(|Reg(old)| needed[*old as usize]);
                true
            }
            Stmt::Store { .. } | Stmt::Loop { .. } | Stmt::Leave(_) | Stmt::Barrier { .. } => true,
        }
    });
    removed
}
