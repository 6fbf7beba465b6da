//! Whether the order of workgroups can show in what a program leaves in its buffers.
//!
//! It cannot if each buffer that is written is either used by each invocation at a place of its own, the element
//! at its number, or changed by nothing but atomics that commute and whose former word nobody asks for.
//! Likewise for textures that are written: each invocation has a texel of its own, at its number.
//! Indices are clamped, so invocations beyond the last element share it: only those before have it to themselves.

use super::super::super::program::op::Input;
use super::super::super::program::texture::TextureOp;
use super::super::super::program::{
    Access, Block, Count, Eval, Op, Place, Program, Reg, Scalar, Stmt, Update, Value,
};
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
/// any order, or at once. `None`: all in turn. `wide`: the axes along which there are several invocations.
pub(super) fn free(program: &Program, wide: [bool; 3]) -> Option<Vec<Elements>> {
    let mut uses: HashMap<u32, Uses> = HashMap::new();
    let (mut evals, mut texels) = (HashMap::new(), Vec::new());
    note(&program.body, &mut uses, &mut evals, &mut texels);
    let line = !wide[1] && !wide[2];
    let mut written = texels.iter().filter(|access| program.images[access.image as usize].written);
    written.all(|access| own_texel(access, &evals, wide)).then_some(())?;
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

fn note<'p>(
    block: &'p Block,
    uses: &mut HashMap<u32, Uses>,
    evals: &mut HashMap<Reg, &'p Eval>,
    texels: &mut Vec<&'p Access>,
) {
    for stmt in block {
        match stmt {
            Stmt::Eval(eval) => {
                evals.insert(eval.to, eval);
                if let Op::Load { place, .. } = eval.op
                    && let Some(buffer) = place.buffer()
                {
                    uses.entry(buffer).or_default().loads.insert(place);
                }
            }
            Stmt::Store { place, .. } => {
                if let Some(buffer) = place.buffer() {
                    uses.entry(buffer).or_default().stores.insert(*place);
                }
            }
            Stmt::Atomic(atomic) => {
                if let Some(buffer) = atomic.place.buffer() {
                    let uses = uses.entry(buffer).or_default();
                    uses.updates = true;
                    let swaps = matches!(atomic.fun, Update::Exchange | Update::CompareExchange);
                    uses.ordered |= swaps || atomic.old.is_some();
                }
            }
            Stmt::Texture(access) => texels.push(access),
            Stmt::Subgroup(_)
            | Stmt::Set { .. }
            | Stmt::If { .. }
            | Stmt::Loop { .. }
            | Stmt::Scope { .. }
            | Stmt::Leave(_)
            | Stmt::Barrier { .. } => {}
        }
        stmt.blocks().into_iter().flatten().for_each(|inner| note(inner, uses, evals, texels));
    }
}

/// The array whose element at the invocation's number a place is or lies in.
fn own(place: &Place, evals: &HashMap<Reg, &Eval>) -> Option<Elements> {
    let eval = |value: Option<Value>| match value {
        Some(Value::Reg(reg)) => evals.get(&reg).copied(),
        Some(Value::Const(_)) | None => None,
    };
    let is_number =
        |value| matches!(eval(value)?.op, Op::Input(Input::GlobalInvocationId(0), _)).then_some(());
    if let Place::Element { index, count, stride, .. } = *place {
        is_number(Some(index))?;
        return Some(Elements { count, stride });
    }
    let index = eval(place.index())?;
    is_number(index.args.first().copied())?;
    match index.op {
        Op::Index { count, stride } if index.args.len() == 1 => Some(Elements { count, stride }),
        _ => None,
    }
}

/// Whether each invocation uses another texel: its number along each wide axis is among the coordinates.
fn own_texel(access: &Access, evals: &HashMap<Reg, &Eval>, wide: [bool; 3]) -> bool {
    let number = |value: Value| {
        let Value::Reg(reg) = value else {
            return None;
        };
        let mut eval = *evals.get(&reg)?;
        if let (
            Op::Convert(Scalar::U32, Scalar::I32) | Op::Bitcast(Scalar::U32, Scalar::I32),
            [Value::Reg(of)],
        ) = (eval.op, &eval.args[..])
        {
            eval = *evals.get(of)?;
        }
        match eval.op {
            Op::Input(Input::GlobalInvocationId(axis), _) => Some(usize::from(axis)),
            _ => None,
        }
    };
    let coordinates = access.operands.place.into_iter().chain([access.operands.layer]).flatten();
    let axes: Vec<usize> = coordinates.filter_map(number).collect();
    matches!(access.op, TextureOp::Load | TextureOp::Store)
        && (0..3).all(|axis| !wide[axis] || axes.contains(&axis))
        || matches!(access.op, TextureOp::Size | TextureOp::Levels | TextureOp::Layers | TextureOp::Samples)
}
