//! The chain of means: four levels a pass, the steps between them in a workgroup's memory.
//!
//! Level 0 is the map's points, and is not kept; level `l` has half the rows and columns of the one before, rounded up. A
//! square that reaches over the map's sides is of what of it is within.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::Tokuyoshi15;
use crate::rsm::mean::{
    MapMean, map_mean_add, map_mean_nothing, map_mean_of, map_mean_pack, map_mean_share, map_mean_unpack,
};
use crate::rsm::point::MapPoint;
use lobe_codegen::prelude::*;

/// Where a level is in `map_means`.
#[kernel]
pub struct MapLevel {
    /// Its first mean; of level 0 its first point.
    pub first: u32,
    /// Means of a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

/// What of the chain a pass makes.
#[kernel]
pub struct ChainStep {
    /// Where positions are counted from.
    #[domain(-1e4..=1e4)]
    pub origin: Vec3,
    /// The level that is read.
    pub level: u32,
    /// Which lobes the means are of: [`crate::rsm::mean::OF_BOTH`] and its like.
    pub part: u32,
}

/// Whether a level has such a mean.
#[kernel]
pub fn is_within(level: MapLevel, column: u32, row: u32) -> bool {
    column < level.width && row < level.height
}

/// Where a mean is; a column and row beyond the level count as its last.
#[kernel]
pub fn place_in(level: MapLevel, column: u32, row: u32) -> u32 {
    level.first + min(row, level.height - 1) * level.width + min(column, level.width - 1)
}

/// A pass of the chain: of the level that is read, `$read` gives the mean at a place.
macro_rules! chain_pass {
    ($(#[$doc:meta])* $name:ident, [$($points:ident)?], |$at:ident, $step:ident, $means:ident| $read:expr) => {
        $(#[$doc])*
        #[kernel(workgroup_size(64))]
        pub fn $name(
            #[builtin(local_invocation_index)] index: u32,
            #[builtin(workgroup_id)] group: UVec3,
            #[uniform(0, 0)] $step: &ChainStep,
            #[storage(0, 1)] levels: &[MapLevel],
            $(#[storage(0, 2)] $points: &[MapPoint],)?
            #[storage(0, 3)] $means: &mut [MapMean],
            #[workgroup] tile: &mut [Vec4; 64],
        ) {
            let source = levels[$step.level as usize];
            // A workgroup makes 8 by 8 means of the next level, and what is above them.
            let next = levels[min($step.level + 1, levels.len() as u32 - 1) as usize];
            let across = (next.width + 7) / 8;
            let left = 8 * (group.x % across);
            let top = 8 * (group.x / across);
            let column = left + index % 8;
            let row = top + index / 8;
            let mut own = map_mean_nothing();
            for source_row in 2 * row..min(2 * row + 2, source.height) {
                for source_column in 2 * column..min(2 * column + 2, source.width) {
                    let $at = place_in(source, source_column, source_row);
                    own = map_mean_add(own, map_mean_share($read, 0.25));
                }
            }
            if is_within(next, column, row) {
                $means[place_in(next, column, row) as usize] = own;
            }
            // Neighbours of a row, then of a column: after both, every second mean of every second row is one of the level above.
            let above = min(levels.len() as u32 - min($step.level + 2, levels.len() as u32), 3);
            for halving in 0..2 * above {
                let apart = (1_u32 << (halving / 2)) << (3 * (halving % 2));
                // A part at a time, so that little memory is shared.
                let bundle = map_mean_pack(own);
                let mut theirs = bundle;
                for k in 0_u32..5 {
                    tile[index as usize] = bundle.parts[k as usize];
                    workgroup_barrier();
                    theirs.parts[k as usize] = tile[min(index + apart, 63) as usize];
                    workgroup_barrier();
                }
                own = map_mean_add(own, map_mean_unpack(theirs));
                if halving % 2 == 1 {
                    own = map_mean_share(own, 0.25);
                    let up = 1 + halving / 2;
                    let mask = (1_u32 << up) - 1;
                    let level = levels[($step.level + 1 + up) as usize];
                    let is_whole = ((index % 8) & mask) == 0 && ((index / 8) & mask) == 0;
                    if is_whole && is_within(level, column >> up, row >> up) {
                        $means[place_in(level, column >> up, row >> up) as usize] = own;
                    }
                }
            }
        }
    };
}

chain_pass!(
    /// Levels 1 to 4 of a map's points: a pass of 64 invocations for each 16 by 16 of them.
    chain_first_pass,
    [map_points],
    |at, chain_step, map_means| map_mean_of(map_points[at as usize], chain_step.origin, chain_step.part)
);

chain_pass!(
    /// The four levels after one that is there: a pass of 64 invocations for each 16 by 16 of its means.
    chain_pass,
    [],
    |at, chain_step, map_means| map_means[at as usize]
);
