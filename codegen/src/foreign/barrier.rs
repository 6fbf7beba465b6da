//! GLSL's `barrier()`, which holds up a workgroup: naga's front end makes it one of every kind, and its SPIR-V writer
//! then one of a subgroup.

use naga::{Barrier, Block, Module, Statement};

/// Makes each barrier one of the workgroup.
pub(super) fn settle(module: &mut Module) {
    let points = module.entry_points.iter_mut().map(|point| &mut point.function);
    let functions = module.functions.iter_mut().map(|(_, function)| function);
    functions.chain(points).for_each(|function| settle_block(&mut function.body));
}

fn settle_block(block: &mut Block) {
    for statement in block.iter_mut() {
        match statement {
            Statement::ControlBarrier(kinds) => kinds.remove(Barrier::SUB_GROUP),
            Statement::Block(inner) => settle_block(inner),
            Statement::If { accept, reject, .. } => {
                settle_block(accept);
                settle_block(reject);
            }
            Statement::Switch { cases, .. } => cases.iter_mut().for_each(|case| settle_block(&mut case.body)),
            Statement::Loop { body, continuing, .. } => {
                settle_block(body);
                settle_block(continuing);
            }
            _ => {}
        }
    }
}
