//! Buffers whose elements are stored once and never read.

use super::super::super::passes;
use super::super::super::program::{Place, Program, Stmt};
use std::collections::{HashMap, HashSet};

/// The buffers that one store outside of loops is all that a program does with.
pub(super) fn stored_once(program: &Program) -> HashSet<u32> {
    // Stored, else used; what a loop repeats counts once more for each loop around it.
    let mut uses: HashMap<u32, [u32; 2]> = HashMap::new();
    let mut count = |stmt: &Stmt| {
        let (place, read) = match stmt {
            Stmt::Store { place, .. } => (Some(*place), 0),
            Stmt::Eval(eval) => (eval.op.place(), 1),
            Stmt::Atomic(atomic) => (Some(atomic.place), 1),
            _ => (None, 0),
        };
        if let Some(Place::Element { buffer, .. } | Place::Buffer { buffer, .. }) = place {
            uses.entry(buffer).or_default()[read] += 1;
        }
    };
    passes::walk(&program.body, &mut |stmt| {
        count(stmt);
        if let Stmt::Loop { body, .. } = stmt {
            passes::walk(body, &mut count);
        }
    });
    uses.into_iter().filter(|(_, uses)| *uses == [1, 0]).map(|(buffer, _)| buffer).collect()
}
