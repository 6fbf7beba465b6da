//! Whether the order of workgroups can show in what a program leaves in its buffers.
//!
//! It cannot if each buffer that is written is either never read, or read and written by each invocation at a
//! place of its own, or changed by nothing but atomics that commute and whose former word nobody asks for.

use super::super::super::program::op::Input;
use super::super::super::program::{Block, Eval, Op, Place, Program, Reg, Stmt, Update, Value};
use std::collections::{HashMap, HashSet};

#[derive(Default)]
struct Uses {
    loads: HashSet<Place>,
    stores: HashSet<Place>,
    updates: bool,
    ordered: bool,
}

/// Whether workgroups may run in any order, or at once. `line`: they are numbered along one axis.
pub(super) fn free(program: &Program, line: bool) -> bool {
    let mut uses: HashMap<u32, Uses> = HashMap::new();
    let mut evals = HashMap::new();
    note(&program.body, &mut uses, &mut evals);
    uses.iter().all(|(buffer, uses)| {
        let shared = program.buffers[*buffer as usize].binding.is_some();
        let written = uses.updates || !uses.stores.is_empty();
        let plain = uses.loads.is_empty() || !written;
        let apart = plain && (!uses.updates || uses.stores.is_empty());
        let own = |p: &Place| line && is_own(p, &evals);
        let lonely = !uses.updates && uses.loads.iter().chain(&uses.stores).all(own);
        !shared || (!uses.ordered && (apart || lonely))
    })
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

/// Whether no two invocations mean this place: an element at the invocation's number.
fn is_own(place: &Place, evals: &HashMap<Reg, &Eval>) -> bool {
    let eval = |value: Option<Value>| match value {
        Some(Value::Reg(reg)) => evals.get(&reg).copied(),
        Some(Value::Const(_)) | None => None,
    };
    let index = eval(place.index()).filter(|e| matches!(e.op, Op::Index { .. }) && e.args.len() == 1);
    let number = index.and_then(|e| eval(e.args.first().copied()));
    number.is_some_and(|e| matches!(e.op, Op::Input(Input::GlobalInvocationId(0), _)))
}
