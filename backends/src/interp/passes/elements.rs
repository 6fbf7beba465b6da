//! Addresses of array elements go into the loads and stores that use them, and loads of the same element come
//! together, so that `fast` can load them at once.

use super::super::program::{Block, Count, Op, Place, Program, Stmt, Value};
use super::{kept, walk};
use std::collections::HashMap;

/// Rewrites places of elements at varying indices.
pub(super) fn elements(program: &mut Program) {
    let known = indices(program);
    let mut body = std::mem::take(&mut program.body);
    rewrite(&mut body, program, &known);
    gather(&mut body);
    program.body = body;
}

/// What it takes to address an element: the index, the number of elements, the bytes of each.
type Index = (Value, Count, u32);

/// The registers that hold addresses of elements of arrays at the begin of memory. Their indices never change.
fn indices(program: &Program) -> HashMap<Value, Index> {
    let kept = kept(program);
    let mut known = HashMap::new();
    walk(&program.body, &mut |stmt| {
        if let Stmt::Eval(eval) = stmt
            && let (Op::Index { count, stride }, [index @ Value::Reg(reg)]) = (eval.op, &eval.args[..])
            && program.varying(*index)
            && !kept.contains(reg)
        {
            known.insert(Value::Reg(eval.to), (*index, count, stride));
        }
    });
    known
}

fn rewrite(block: &mut Block, program: &Program, known: &HashMap<Value, Index>) {
    let change = |place: &mut Place| {
        if let Place::Buffer { buffer, offset, index: Some(index) } = *place
            && let Some((index, count, stride)) = known.get(&index).copied()
        {
            *place = Place::Element { buffer, offset, index, count, stride };
        }
    };
    for stmt in block {
        match stmt {
            Stmt::Eval(eval) => {
                if let Op::Load { place, scalar, .. } = &mut eval.op
                    && scalar.is_word()
                {
                    change(place);
                }
            }
            Stmt::Store { place, value, .. } => {
                if program.scalar(*value).is_word() {
                    change(place);
                }
            }
            Stmt::Set { .. }
            | Stmt::Atomic(_)
            | Stmt::Texture(_)
            | Stmt::Subgroup(_)
            | Stmt::If { .. }
            | Stmt::Loop { .. }
            | Stmt::Scope { .. }
            | Stmt::Leave(_)
            | Stmt::Barrier { .. } => {}
        }
        stmt.blocks_mut().into_iter().flatten().for_each(|inner| rewrite(inner, program, known));
    }
}

/// What loads of one element have in common.
fn element(stmt: &Stmt) -> Option<(u32, Value, u32)> {
    match stmt {
        Stmt::Eval(eval) => match eval.op {
            Op::Load { place: Place::Element { buffer, index, .. }, epoch, .. } => {
                Some((buffer, index, epoch))
            }
            _ => None,
        },
        _ => None,
    }
}

/// Moves each load up to the first of its element in the block: no store lies between, or their epochs would differ.
fn gather(block: &mut Block) {
    let mut last: HashMap<_, usize> = HashMap::new();
    let mut out: Block = Block::with_capacity(block.len());
    for mut stmt in std::mem::take(block) {
        stmt.blocks_mut().into_iter().flatten().for_each(gather);
        let Some(key) = element(&stmt) else {
            out.push(stmt);
            continue;
        };
        let at = last.get(&key).map_or(out.len(), |at| at + 1);
        out.insert(at, stmt);
        last.values_mut().for_each(|other| *other += usize::from(*other >= at));
        last.insert(key, at);
    }
    *block = out;
}
