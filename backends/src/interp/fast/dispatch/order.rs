//! Whether the order of workgroups can show in what a program leaves in its buffers.
//!
//! It cannot if each buffer that is written is either used by each invocation at a place of its own, the element
//! at its number, or changed by nothing but atomics that commute and whose former word nobody asks for.
//! Indices are clamped, so invocations beyond the last element share it: only those before have it to themselves.

use super::super::super::program::op::Input;
use super::super::super::program::{Block, Count, Eval, Op, Place, Program, Reg, Stmt, Update, Value};
use std::collections::{HashMap, HashSet};

#[derive(Default)]
struct Uses {
    loads: HashSet<Place>,
    stores: HashSet<Place>,
    updates: bool,
    ordered: bool,
}

/// Elements of an array, one for each invocation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Elements {
    pub(super) count: Count,
    pub(super) stride: u32,
}

/// The arrays whose elements invocations have to themselves: those with a number below the length of each may run in
/// any order, or at once. `None`: all in turn. `line`: invocations are numbered along one axis.
pub(super) fn free(program: &Program, line: bool) -> Option<Vec<Elements>> {
    let mut uses: HashMap<u32, Uses> = HashMap::new();
    let mut evals = HashMap::new();
    note(&program.body, &mut uses, &mut evals);
    let mut arrays = Vec::new();
    for (buffer, uses) in &uses {
        let shared = program.buffers[*buffer as usize].binding.is_some();
        let written = uses.updates || !uses.stores.is_empty();
        if !shared || !written {
            continue;
        }
        let places = || uses.loads.iter().chain(&uses.stores);
        if uses.updates {
            let commutes = !uses.ordered && places().next().is_none();
            commutes.then_some(())?;
        } else {
            for place in places() {
                arrays.push(own(place, &evals).filter(|_| line)?);
            }
        }
    }
    Some(arrays)
}

fn note<'p>(block: &'p Block, uses: &mut HashMap<u32, Uses>, evals: &mut HashMap<Reg, &'p Eval>) {
    for stmt in block {
        match stmt {
            Stmt::Eval(eval) => {
                evals.insert(eval.to, eval);
                if let Op::Load { place: place @ Place::Buffer { buffer, .. }, .. } = eval.op {
                    uses.entry(buffer).or_default().loads.insert(place);
                }
            }
            Stmt::Store { place: place @ Place::Buffer { buffer, .. }, .. } => {
                uses.entry(*buffer).or_default().stores.insert(*place);
            }
            Stmt::Atomic(atomic) => {
                if let Place::Buffer { buffer, .. } = atomic.place {
                    let uses = uses.entry(buffer).or_default();
                    uses.updates = true;
                    let swaps = matches!(atomic.fun, Update::Exchange | Update::CompareExchange);
                    uses.ordered |= swaps || atomic.old.is_some();
                }
            }
            Stmt::Store { place: Place::Lane { .. }, .. }
            | Stmt::Set { .. }
            | Stmt::If { .. }
            | Stmt::Loop { .. }
            | Stmt::Scope { .. }
            | Stmt::Leave(_)
            | Stmt::Barrier { .. } => {}
        }
        stmt.blocks().into_iter().flatten().for_each(|inner| note(inner, uses, evals));
    }
}

/// The array whose element at the invocation's number a place is or lies in.
fn own(place: &Place, evals: &HashMap<Reg, &Eval>) -> Option<Elements> {
    let eval = |value: Option<Value>| match value {
        Some(Value::Reg(reg)) => evals.get(&reg).copied(),
        Some(Value::Const(_)) | None => None,
    };
    let index = eval(place.index())?;
    let number = eval(index.args.first().copied())?;
    match (index.op, number.op) {
        (Op::Index { count, stride }, Op::Input(Input::GlobalInvocationId(0), _))
            if index.args.len() == 1 =>
        {
            Some(Elements { count, stride })
        }
        _ => None,
    }
}
