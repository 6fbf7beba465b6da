//! Rewrites of programs, each a file; [`for_lanes`] is their order for the executor on lanes.
//!
//! They keep every result, bit for bit. `dead` and `uniform` serve any executor; `within` spells out what `fast` has no
//! step for; `flatten`, `fold`,
//! `invariant`, `order`, `elements`, `fuse` and `horner` forget what a judge of decisions wants to know, and are for
//! speed alone.

mod common;
mod dead;
mod elements;
mod flatten;
mod fold;
mod fuse;
mod horner;
mod invariant;
mod order;
mod uniform;
mod within;

pub(super) use uniform::{Masks, Owner};

use super::program::{Block, Program, Reg, Stmt, Value};
use std::collections::HashSet;

/// Prepares a program for the executor on lanes. `packed` says that a batch may hold several workgroups.
pub(super) fn for_lanes(program: &mut Program, packed: bool) -> Masks {
    dead::remove(program);
    within::spell_out(program);
    flatten::flatten(program);
    fold::fold(program);
    common::common(program);
    dead::remove(program);
    invariant::invariant(program);
    uniform::classify(program, packed);
    order::order(program);
    elements::elements(program);
    fuse::fuse(program);
    dead::remove(program);
    horner::horner(program);
    dead::remove(program);
    uniform::classify(program, packed)
}

/// Calls `f` on each statement, outer ones first.
pub(super) fn walk<'a>(block: &'a Block, f: &mut impl FnMut(&'a Stmt)) {
    for stmt in block {
        f(stmt);
        stmt.blocks().into_iter().flatten().for_each(|inner| walk(inner, f));
    }
}

/// Registers that are assigned: what they hold changes.
fn kept(program: &Program) -> HashSet<Reg> {
    let mut kept = HashSet::new();
    walk(&program.body, &mut |stmt| {
        if let Stmt::Set { to, .. } = stmt {
            kept.insert(*to);
        }
    });
    kept
}

/// How often each register is read.
pub(super) fn uses(program: &Program) -> Vec<u32> {
    let mut uses = vec![0; program.registers.len()];
    let mut read = |value| {
        if let Value::Reg(Reg(at)) = value {
            uses[at as usize] += 1;
        }
    };
    walk(&program.body, &mut |stmt| stmt.operands(&mut read));
    program.results.iter().for_each(|v| read(*v));
    uses
}
