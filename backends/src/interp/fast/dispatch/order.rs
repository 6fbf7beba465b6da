//! Whether the order of workgroups can show in what a program leaves in its buffers.
//!
//! It cannot if each buffer that is written is either used by each invocation at a place of its own (`own`), or
//! changed by nothing but atomics that commute and whose former word nobody asks for.
//! Likewise for textures that are written: each invocation has a texel of its own, at its number.
//! Indices are clamped, so invocations beyond the last element share it: only those before have it to themselves.

use super::super::super::program::op::Input;
use super::super::super::program::texture::TextureOp;
use super::super::super::program::{
    Access, Block, Eval, Op, Place, Program, Reg, Scalar, Stmt, Update, Value,
};
use super::own::{Launch, Whose};
use std::collections::{HashMap, HashSet};

#[derive(Default)]
struct Uses {
    loads: HashSet<Place>,
    stores: HashSet<Place>,
    updates: bool,
    ordered: bool,
}

/// How many invocations, by number from the first on, may run in any order, or at once; the rest run in turn.
pub(super) fn free(program: &Program, launch: &Launch<'_>) -> usize {
    unordered(program, launch).unwrap_or(0)
}

fn unordered(program: &Program, launch: &Launch<'_>) -> Option<usize> {
    let mut uses: HashMap<u32, Uses> = HashMap::new();
    let (mut evals, mut texels) = (HashMap::new(), Vec::new());
    note(&program.body, &mut uses, &mut evals, &mut texels);
    let mut written = texels.iter().filter(|access| program.images[access.image as usize].written);
    written.all(|access| own_texel(access, &evals, launch)).then_some(())?;
    let mut free = usize::MAX;
    for (buffer, uses) in &uses {
        let shared = program.buffers[*buffer as usize].binding.is_some();
        let written = uses.updates || !uses.stores.is_empty();
        if !shared || !written {
            continue;
        }
        let mut places = uses.loads.iter().chain(&uses.stores);
        if uses.updates {
            let commutes = !uses.ordered && places.next().is_none();
            commutes.then_some(())?;
        } else {
            let whose = Whose { program, evals: &evals, launch };
            let owned = places.map(|place| whose.element(place)).collect::<Option<Vec<_>>>()?;
            // Elements of invocations and of workgroups in one buffer would be each other's.
            owned.iter().all(|o| o.owner == owned[0].owner).then_some(())?;
            free = owned.iter().map(|o| o.free).fold(free, usize::min);
        }
    }
    Some(free)
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

/// Whether each invocation uses another texel: its number along each wide axis is among the coordinates.
fn own_texel(access: &Access, evals: &HashMap<Reg, &Eval>, launch: &Launch<'_>) -> bool {
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
        && (0..3).all(|axis| launch.extent(axis) <= 1 || axes.contains(&axis))
        || matches!(access.op, TextureOp::Size | TextureOp::Levels | TextureOp::Layers | TextureOp::Samples)
}
