//! Sums of all texels before each: within blocks, and of blocks.

#[allow(unused_imports, reason = "citations link to them")]
use crate::references::HillisSteele86;
use lobe_codegen::prelude::*;

/// Numbers that an invocation adds up.
#[kernel]
pub const SCAN_EACH: u32 = 16;
/// Numbers of a block: 64 invocations'.
#[kernel]
pub const SCAN_BLOCK: u32 = 1024;

/// A pass that sums `$values` within blocks of [`SCAN_BLOCK`].
macro_rules! scan_pass {
    ($(#[$doc:meta])* $name:ident, $values:ident, $sums:ident, $totals:ident) => {
        $(#[$doc])*
        ///
        /// Source: [HillisSteele86] across invocations, one after the other within.
        #[kernel(workgroup_size(64))]
        pub fn $name(
            #[builtin(local_invocation_index)] index: u32,
            #[builtin(workgroup_id)] group: UVec3,
            #[storage(0, 0)] $values: &[Vec2],
            #[storage(0, 1)] $sums: &mut [Vec2],
            #[storage(0, 2)] $totals: &mut [Vec2],
            #[workgroup] partial: &mut [Vec2; 64],
        ) {
            let count = $values.len() as u32;
            let first = SCAN_BLOCK * group.x + SCAN_EACH * index;
            let mut own = Vec2::ZERO;
            for k in 0_u32..16 {
                if first + k < count {
                    own += $values[(first + k) as usize];
                }
            }
            partial[index as usize] = own;
            let mut back = 1_u32;
            for _ in 0_u32..6 {
                workgroup_barrier();
                let before = select(0_u32, index - min(back, index), index >= back);
                let added = select(Vec2::ZERO, partial[before as usize], index >= back);
                workgroup_barrier();
                partial[index as usize] += added;
                back *= 2;
            }
            workgroup_barrier();
            let mut sum = select(Vec2::ZERO, partial[(max(index, 1) - 1) as usize], index > 0);
            for k in 0_u32..16 {
                if first + k < count {
                    sum += $values[(first + k) as usize];
                    $sums[(first + k) as usize] = sum;
                }
            }
            if index == 63 && group.x < $totals.len() as u32 {
                $totals[group.x as usize] = partial[63];
            }
        }
    };
}

scan_pass!(
    /// Sums of the estimates of each block up to each: a pass of 64 invocations a block.
    scan_pass,
    estimates,
    sums,
    block_totals
);

scan_pass!(
    /// Sums of the blocks up to each: a pass of 64 invocations.
    scan_block_pass,
    block_totals,
    block_sums,
    all_totals
);
