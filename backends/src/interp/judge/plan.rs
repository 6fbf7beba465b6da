//! What the blocks of a program change, found once: it is what two ways through them must join.

use super::super::program::{Block, Place, Program, Reg, Stmt};
use std::collections::{BTreeSet, HashMap};

/// What a block changes beside registers that are computed once.
#[derive(Debug, Clone, Default)]
pub(super) struct Changes {
    /// Kept registers.
    pub(super) kept: Vec<Reg>,
    /// Memory of each lane.
    pub(super) arrays: Vec<u32>,
}

impl Changes {
    /// The memory that either changes.
    pub(super) fn memory_with(&self, other: &Self) -> Self {
        let more = other.arrays.iter().filter(|a| !self.arrays.contains(a));
        Self { kept: Vec::new(), arrays: self.arrays.iter().chain(more).copied().collect() }
    }
}

/// The changes of each block, by its address in the program.
pub(super) struct Plan {
    blocks: HashMap<usize, Changes>,
    nothing: Changes,
}

#[derive(Default)]
struct Found {
    kept: BTreeSet<Reg>,
    arrays: BTreeSet<u32>,
}

impl Plan {
    pub(super) fn of(program: &Program) -> Self {
        let mut plan = Self { blocks: HashMap::new(), nothing: Changes::default() };
        plan.block(&program.body);
        plan
    }

    /// What `block` of the program changes.
    pub(super) fn changes(&self, block: &Block) -> &Changes {
        self.blocks.get(&address(block)).unwrap_or(&self.nothing)
    }

    fn block(&mut self, block: &Block) -> Found {
        let mut found = Found::default();
        for stmt in block {
            if let Stmt::Set { to, .. } = stmt {
                found.kept.insert(*to);
            } else if let Stmt::Store { place: Place::Lane { array, .. }, .. } = stmt {
                found.arrays.insert(*array);
            }
            for inner in stmt.blocks().into_iter().flatten() {
                let Found { kept, arrays } = self.block(inner);
                found.kept.extend(kept);
                found.arrays.extend(arrays);
            }
        }
        let changes = Changes {
            kept: found.kept.iter().copied().collect(),
            arrays: found.arrays.iter().copied().collect(),
        };
        self.blocks.insert(address(block), changes);
        found
    }
}

fn address(block: &Block) -> usize {
    std::ptr::from_ref(block).addr()
}
